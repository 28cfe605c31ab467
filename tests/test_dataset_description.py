"""What `optimus dataset` says of a data set is what was put into it; its page stands alone; its film is the episode."""

from __future__ import annotations

import base64
import io
import json
import re
from collections import Counter
from pathlib import Path

import imageio.v3 as iio
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

from optimus.data.describe import CELLS, _coverage, describe
from optimus.data.episode import Episode
from optimus.data.store import EpisodeStore
from optimus.errors import DatasetError, StorageError
from optimus.report import charts
from optimus.report.dataset_page import MOMENTS, TILE, contact_sheet, render_dataset
from optimus.report.film import write_episode_film
from synthetic import CAMERAS, make_dataset, make_episode
from test_report import Outline


@pytest.fixture(scope="module")
def store(tmp_path_factory: pytest.TempPathFactory) -> EpisodeStore:
    """Seven curated episodes of two lengths, some with words, and two failures."""
    folder = tmp_path_factory.mktemp("described")
    made = make_dataset(folder / "data", 5, 12)
    for seed in (5, 6):
        about = {"instruction": "push <it>", "words": {"square": "the red square"}, "retries": seed - 5, "perturbed": True}
        made.write(make_episode(seed, 15, info=about, skeleton=("push",)))
    made.write_failure(7, "no plan: pick(square): blocked")
    made.write_failure(8, "no plan: place(square): blocked")
    return made


def test_the_figures_are_those_of_the_episodes(store: EpisodeStore) -> None:
    about = describe(store.path)
    episodes = [store.read(seed) for seed in store.seeds]
    assert (about.episodes, about.steps) == (7, sum(map(len, episodes))) and about.lengths == (12,) * 5 + (15,) * 2
    assert about.skeletons == {"pick place": 5, "push": 2} and about.failures == {"no plan": 2}
    assert about.objects == {"square": 5, "the red square": 2} and about.instructions == {"push <it>": 2}
    assert (about.perturbed, about.retried) == (2, 1) and about.cameras == dict.fromkeys(CAMERAS, (84, 84, 3))
    assert sum(about.split.values()) == 7 and about.split["came after the curation"] == 2
    actions = np.concatenate([e.actions for e in episodes])
    for column, spread in zip(actions.T, about.actions, strict=True):
        assert spread.mean == pytest.approx(column.mean(), abs=1e-6) and spread.sd == pytest.approx(column.std(), abs=1e-6)
        binned = Counter(min(19, int((float(v) + 1) / 0.1 + 1e-6)) for v in column)
        assert sum(spread.histogram) == len(column) and spread.histogram[19] == binned[19]
    assert about.actions[6].saturated == 1.0
    assert about.imitability is None, "a step is compared with five other episodes; five are kept in all"
    first = np.array([e.objects[0, 0, :2] for e in episodes])
    assert np.allclose(about.starts["square"].low, first.min(0)) and np.allclose(about.starts["square"].high, first.max(0))


def test_even_starts_reach_as_many_cells_as_expected() -> None:
    rng = np.random.default_rng(0)
    found = [_coverage(rng.uniform(-0.1, 0.1, (40, 3))) for _ in range(200)]
    assert np.mean([c.cells for c in found]) == pytest.approx(found[0].expected_cells, rel=0.05)
    assert _coverage(np.zeros((9, 3))).cells == 1 < CELLS


def test_the_page_stands_alone_and_says_it_all(store: EpisodeStore) -> None:
    page = render_dataset(store, describe(store.path))
    outline = Outline()
    outline.feed(page)
    assert outline.open == [] and outline.sections == ["sheets", "counts", "starts", "actions", "settings"]
    assert all(source.startswith("data:image/png") for source in outline.sources) and len(outline.sources) == len(CAMERAS)
    assert "<script" not in page and "push &lt;it&gt;" in page and "prefers-color-scheme: dark" in page
    assert all(text in outline.text for text in ("pick place", "the red square", "no plan"))
    sheet = np.asarray(Image.open(io.BytesIO(base64.b64decode(outline.sources[0].partition(",")[2]))))
    assert sheet.shape[0] == MOMENTS * (TILE + 2) - 2


def test_a_contact_sheet_shows_the_episodes(store: EpisodeStore) -> None:
    headers = store.headers()[:3]
    sheet = np.asarray(Image.open(io.BytesIO(contact_sheet(headers, "front"))))
    for column, header in enumerate(headers):
        left = column * (TILE + 2)
        images = header.read("obs.front_image")
        assert np.array_equal(sheet[:TILE, left : left + TILE], images[0])
        assert np.array_equal(sheet[-TILE:, left : left + TILE], images[-1])


def test_the_film_is_the_episode(store: EpisodeStore, tmp_path: Path) -> None:
    episode = store.read(5)
    assert write_episode_film(episode, tmp_path / "5.mp4") == len(episode) == 15
    frames = iio.imread(tmp_path / "5.mp4")
    seen = frames[:, 2::4, 2::4].astype(float)  # one pixel of each enlarged one
    shown = np.concatenate([episode.observations[f"{c}_image"] for c in CAMERAS], axis=2)
    assert seen.shape == shown.shape and np.abs(seen - shown).mean() < 6
    with pytest.raises(StorageError, match="--overwrite"):
        write_episode_film(episode, tmp_path / "5.mp4")
    blind = make_episode(0, 3, cameras=())
    with pytest.raises(DatasetError, match="no images"):
        write_episode_film(blind, tmp_path / "blind.mp4")


@settings(max_examples=30)
@given(st.lists(st.tuples(st.floats(-1, 1), st.floats(-1, 1)), min_size=1, max_size=20))
def test_places_are_drawn_as_the_robot_sees_them(places: list[tuple[float, float]]) -> None:
    """Within the frame, +x up and +y left."""
    svg = charts.from_above({"thing": places})
    left, top, width, height = (float(v) for v in re.search(r'viewBox="([^"]+)"', svg)[1].split())  # type: ignore[index]
    dots = [(float(x), float(y)) for x, y in re.findall(r'cx="([^"]+)" cy="([^"]+)"', svg)]
    for (x, y), (across, down) in zip(places, dots, strict=True):
        assert left <= across <= left + width and top <= down <= top + height
        assert across == pytest.approx(-y, abs=1e-3) and down == pytest.approx(-x, abs=1e-3)


def test_a_folder_that_is_none_or_is_empty_says_so(tmp_path: Path) -> None:
    with pytest.raises(DatasetError, match="not a dataset"):
        describe(tmp_path)
    EpisodeStore.create(tmp_path / "empty", "square", CAMERAS, {})
    with pytest.raises(DatasetError, match="no episodes"):
        describe(tmp_path / "empty")


def test_older_episodes_without_words_are_read(store: EpisodeStore) -> None:
    header = store.header(0)
    assert "instruction" not in header.info and "words" not in header.info
    assert isinstance(store.read(0), Episode) and json.dumps(header.info) == "{}"
