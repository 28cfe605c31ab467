"""Images from stored states: the collected ones to the bit, and others that agree with the geometry and with one another."""

from pathlib import Path

import numpy as np
import pytest

from optimus.collect import CollectConfig, collect
from optimus.data.curate import CurationConfig, curate, load_curation
from optimus.data.frustum import project
from optimus.data.store import EpisodeStore
from optimus.data.windows import WindowConfig, Windows
from optimus.errors import DatasetError, UnknownNameError
from optimus.learn.sources import crop_of
from optimus.rerender import RenderConfig, rerender, with_images
from optimus.scene import Camera
from synthetic import make_episode


def files(folder: Path) -> dict[str, bytes]:
    return {p.name: p.read_bytes() for p in sorted((folder / "episodes").iterdir())}


@pytest.fixture(scope="module")
def states(tmp_path_factory: pytest.TempPathFactory) -> EpisodeStore:
    """Three episodes of stack without images, curated."""
    folder = tmp_path_factory.mktemp("states")
    collect(CollectConfig("stack", folder, 3, workers=1, images=False))
    curate(folder)
    return EpisodeStore.open(folder)


def test_the_collected_images_come_out_exactly(states: EpisodeStore, tmp_path: Path) -> None:
    collect(CollectConfig("stack", tmp_path / "collected", 3, workers=1))
    made = rerender(states.path, tmp_path / "rendered", RenderConfig(), workers=1)
    assert files(tmp_path / "rendered") == files(tmp_path / "collected")
    assert load_curation(made.path) == load_curation(states.path)
    again = rerender(tmp_path / "collected", tmp_path / "again", RenderConfig(cameras=("robot0_eye_in_hand",)), workers=1)
    for seed in states.seeds:
        a, b = (EpisodeStore.open(tmp_path / d).read(seed).observations for d in ("collected", "again"))
        np.testing.assert_array_equal(a["robot0_eye_in_hand_image"], b["robot0_eye_in_hand_image"])
    assert again.cameras == ("robot0_eye_in_hand",)


def test_scenes_that_differ_from_seed_to_seed_come_out_exactly(tmp_path: Path) -> None:
    for images in (True, False):
        collect(CollectConfig("shelf-receptacle", tmp_path / str(images), 1, seed=5, workers=1, images=images))
    rerender(tmp_path / "False", tmp_path / "rendered", RenderConfig(), workers=1)
    assert files(tmp_path / "rendered") == files(tmp_path / "True")


def test_it_goes_on_where_it_was_stopped(states: EpisodeStore, tmp_path: Path) -> None:
    made = rerender(states.path, tmp_path / "a", RenderConfig(size=20), workers=1)
    whole = files(made.path)
    made.episode_path(states.seeds[1]).unlink()
    told: list[tuple[int, int]] = []
    rerender(states.path, tmp_path / "a", RenderConfig(size=20), workers=1, progress=lambda *done: told.append(done))
    assert told == [(2, 3), (3, 3)] and files(made.path) == whole
    with pytest.raises(DatasetError, match="rendered"):
        rerender(states.path, tmp_path / "a", RenderConfig(size=21), workers=1)
    assert (crop_of([made.path]), crop_of([states.path])) == (18, 76)  # a policy sees as large a share of each size


def test_depth_segmentation_and_projection_agree(states: EpisodeStore) -> None:
    """In a new view: where the pinhole says a cube is, its number is in the segmentation and its distance in the depth."""
    view = Camera("side", (1.1, 0.5, 0.4), (0.5, 0.0, 0.02), 40.0)
    size, episode = 120, states.read(states.seeds[0])
    made = with_images(episode, RenderConfig(views=(view,), size=size, depth=True, segmentation=True))
    assert made.cameras == ("side",) and made.observations["side_image"].shape == (len(made), size, size, 3)
    segmentation, depth = made.observations["side_segmentation"][0], made.observations["side_depth"][0]
    for i, name in enumerate(made.object_names):
        right, up, distance = project(made.objects[0, i], made.info["views"]["side"])
        row, column = np.array([1 - up, 1 + right]) / 2 * size
        rows, columns = np.nonzero(segmentation == 1 + made.info["segmented"].index(name))
        assert len(rows) > 20
        np.testing.assert_allclose([rows.mean(), columns.mean()], [row - 0.5, column - 0.5], atol=2.0)
        np.testing.assert_allclose(depth[rows, columns].mean(), distance, atol=0.03)
    assert set(np.unique(segmentation)) >= {1, 2, 1 + made.info["segmented"].index("robot")}


def test_a_look_is_a_function_of_its_seed_and_leaves_geometry_alone(states: EpisodeStore) -> None:
    episode = states.read(states.seeds[0])
    config = RenderConfig(randomise=3, segmentation=True)
    one, same, other = (with_images(episode, RenderConfig(randomise=s, segmentation=True)) for s in (3, 3, 4))
    plain = with_images(episode, RenderConfig(segmentation=True))
    image = "agentview_image"
    np.testing.assert_array_equal(one.observations[image], same.observations[image])
    for different in (other, plain, with_images(states.read(states.seeds[1]), config)):
        length = min(len(one), len(different))
        changed = np.abs(one.observations[image][:length].astype(int) - different.observations[image][:length])
        assert changed.mean() > 5
    moved = np.subtract(one.info["views"]["agentview"]["pos"], plain.info["views"]["agentview"]["pos"])
    assert 0 < np.linalg.norm(moved) < 0.1
    np.testing.assert_array_equal(one.actions, episode.actions)
    seen = [np.unique(e.observations["agentview_segmentation"][0]).tolist() for e in (one, plain)]
    assert seen[0] == seen[1]


def test_the_first_cube_stays_red(states: EpisodeStore) -> None:
    """An instruction that names a colour stays true."""
    for seed in range(5):
        made = with_images(states.read(states.seeds[0]), RenderConfig(randomise=seed, segmentation=True))
        mask = made.observations["agentview_segmentation"][0] == 1
        red, green, blue = made.observations["agentview_image"][0][mask].astype(float).mean(axis=0)
        assert red > 1.5 * max(green, blue)


def test_training_reads_what_was_rendered(states: EpisodeStore, tmp_path: Path) -> None:
    made = rerender(states.path, tmp_path, RenderConfig(depth=True, segmentation=True, randomise=1), workers=1)
    curate(states.path)
    rerender(states.path, tmp_path, RenderConfig(depth=True, segmentation=True, randomise=1), workers=1)
    assert load_curation(tmp_path) == load_curation(states.path)
    mine = curate(tmp_path, CurationConfig(validation_share=0.5))
    rerender(states.path, tmp_path, RenderConfig(depth=True, segmentation=True, randomise=1), workers=1)
    assert load_curation(tmp_path) == mine != load_curation(states.path)
    (states.path / "curation.json").unlink()
    batch = Windows(made, made.seeds, WindowConfig()).sample(np.random.default_rng(0), 2)
    assert set(batch.images) == set(made.cameras)
    assert set(batch.proprioception) == {n for n, a in states.read(states.seeds[0]).observations.items() if a.ndim == 2}


def test_bad_input_is_named(states: EpisodeStore, tmp_path: Path) -> None:
    with pytest.raises(UnknownNameError, match="agentview"):
        rerender(states.path, tmp_path / "a", RenderConfig(cameras=("front",)))
    with pytest.raises(DatasetError, match="never rewritten"):
        rerender(states.path, states.path, RenderConfig())
    with pytest.raises(DatasetError, match="of its own"):
        rerender(states.path, tmp_path / "a", RenderConfig(views=(Camera("agentview", (1, 0, 1), (0, 0, 0)),)))
    with pytest.raises(DatasetError, match="no states"):
        with_images(make_episode(3, task="stack"), RenderConfig())
