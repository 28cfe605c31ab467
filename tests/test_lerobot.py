"""LeRobotDataset v3.0, read as its documentation says: by pyarrow and FFmpeg alone, without the code that wrote it."""

from __future__ import annotations

import io
import json
from pathlib import Path
from typing import Any

import imageio.v3 as iio
import numpy as np
import pyarrow.parquet as pq
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays
from PIL import Image

from optimus.data.curate import curate, load_curation
from optimus.data.store import EpisodeStore
from optimus.errors import DatasetError, StorageError
from optimus.exchange.lerobot import LerobotConfig, export_lerobot, statistics, tables
from optimus.exchange.lerobot.write import MARKER
from optimus.exchange.video import psnr
from synthetic import CAMERAS, make_dataset, make_episode

STATE = ("robot0_eef_pos", "robot0_eef_quat", "robot0_gripper_qpos", "robot0_target_error")


def read(root: Path, kind: str) -> list[dict[str, Any]]:
    return [row for path in sorted((root / kind).glob("chunk-*/file-*.parquet")) for row in pq.read_table(path).to_pylist()]


def expected_order(store: EpisodeStore) -> tuple[int, ...]:
    curation = load_curation(store.path)
    return (*curation.train, *curation.validation)


@pytest.mark.parametrize("images", [False, True])
def test_a_reader_finds_every_frame(tmp_path: Path, images: bool) -> None:
    store = make_dataset(tmp_path / "data", 6, 12)
    said = export_lerobot(store.path, tmp_path / "out", LerobotConfig(images=images))
    info = json.loads((tmp_path / "out/meta/info.json").read_text())
    episodes, frames = read(tmp_path / "out", "meta/episodes"), read(tmp_path / "out", "data")
    seeds = expected_order(store)
    assert info["codebase_version"] == "v3.0" and info["total_episodes"] == len(episodes) == len(seeds)
    assert info["total_frames"] == len(frames) == said["frames"] and [f["index"] for f in frames] == list(range(len(frames)))
    train = len(load_curation(store.path).train)
    assert info["splits"] == {"train": f"0:{train}", "validation": f"{train}:{len(seeds)}"}
    tasks = {row["task_index"]: row["task"] for row in pq.read_table(tmp_path / "out/meta/tasks.parquet").to_pylist()}
    for row, seed in zip(episodes, seeds, strict=True):
        episode, mine = store.read(seed), frames[row["dataset_from_index"] : row["dataset_to_index"]]
        assert row["length"] == len(mine) == len(episode) and row["tasks"] == [tasks[mine[0]["task_index"]]] == ["square"]
        assert np.array_equal([f["action"] for f in mine], episode.actions)
        assert np.array_equal([f["observation.state"] for f in mine], np.concatenate([episode.observations[n] for n in STATE], 1))
        assert np.allclose([f["timestamp"] for f in mine], np.arange(len(episode)) / info["fps"])
        assert [f["next.done"] for f in mine] == [False] * (len(mine) - 1) + [True] and mine[-1]["next.reward"] == 1.0
        for camera in CAMERAS:
            seen, truth = _images(tmp_path / "out", info, row, mine, camera), episode.observations[f"{camera}_image"]
            if images:
                assert np.array_equal(seen, truth)
            else:  # noise, so that a frame in another's place would show
                assert psnr(float(np.mean((seen.astype(float) - truth) ** 2))) > said["videos"][camera]["worst_frame_db"] - 1
    for key, feature in info["features"].items():
        assert key in frames[0] or feature["dtype"] == "video"


def _images(root: Path, info: dict, row: dict, frames: list[dict], camera: str) -> np.ndarray:
    key = f"observation.images.{camera}"
    if info["features"][key]["dtype"] == "image":
        return np.stack([np.asarray(Image.open(io.BytesIO(f[key]["bytes"]))) for f in frames])
    place = {n: row[f"videos/{key}/{n}"] for n in ("chunk_index", "file_index")}
    film = iio.imread(root / info["video_path"].format(video_key=key, **place))  # FFmpeg's own program
    first, last = (round(row[f"videos/{key}/{t}_timestamp"] * info["fps"]) for t in ("from", "to"))
    return film[first:last]


def test_depth_is_no_number_of_the_state(tmp_path: Path) -> None:
    store = EpisodeStore.create(tmp_path / "data", "square", CAMERAS, {"position_scale": 1.0})
    for seed in range(4):
        episode = make_episode(seed, 12)
        depth = {"front_depth": np.zeros((12, 8, 8), np.float32)}
        store.write(make_episode(seed, 12, observations={**episode.observations, **depth}))
    curate(store.path)
    assert export_lerobot(store.path, tmp_path / "out", LerobotConfig(images=True))["left_out"] == ["front_depth"]
    widths = {len(row["observation.state"]) for row in read(tmp_path / "out", "data")}
    assert widths == {sum(store.read(0).observations[name].shape[1] for name in STATE)}


@pytest.mark.parametrize(("settings", "rate"), [(None, 20), ({"control_freq": None}, 20), ({"control_freq": 10.0}, 10)])
def test_the_rate_is_that_of_the_demonstrations(settings: dict[str, Any] | None, rate: int, tmp_path: Path) -> None:
    store = make_dataset(tmp_path / "data", 2, 5, {"env_args": {"env_kwargs": settings}})
    export_lerobot(store.path, tmp_path / "out", LerobotConfig(images=True, everything=True))
    assert json.loads((tmp_path / "out" / MARKER).read_text())["fps"] == rate


def test_a_rate_that_the_format_cannot_tell_is_refused(tmp_path: Path) -> None:
    store = make_dataset(tmp_path / "data", 4, 12, {"env_args": {"env_kwargs": {"control_freq": 12.5}}})
    with pytest.raises(DatasetError, match=r"12\.5 steps a second"):
        export_lerobot(store.path, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_statistics_are_those_of_the_arrays(tmp_path: Path) -> None:
    store = make_dataset(tmp_path / "data", 5, 10)
    export_lerobot(store.path, tmp_path / "out")
    said = json.loads((tmp_path / "out/meta/stats.json").read_text())
    episodes = [store.read(seed) for seed in expected_order(store)]
    _check(said["action"], np.concatenate([e.actions for e in episodes]))
    for camera in CAMERAS:
        pixels = np.concatenate([e.observations[f"{camera}_image"] for e in episodes]).reshape(-1, 3) / 255
        found = said[f"observation.images.{camera}"]
        assert np.shape(found["mean"]) == (3, 1, 1) and found["count"] == [sum(map(len, episodes))]
        _check(found, pixels)
    for row, episode in zip(read(tmp_path / "out", "meta/episodes"), episodes, strict=True):
        _check({k.rsplit("/", 1)[1]: v for k, v in row.items() if k.startswith("stats/action/")}, episode.actions)


def _check(found: dict[str, list], values: np.ndarray) -> None:
    flat = {name: np.ravel(value) for name, value in found.items()}
    assert np.allclose(flat["mean"], values.mean(0, dtype=np.float64), atol=1e-9)
    assert np.allclose(flat["std"], values.astype(np.float64).std(0), atol=1e-7)
    for name, share in (("min", 0), ("q01", 0.01), ("q10", 0.1), ("q50", 0.5), ("q90", 0.9), ("q99", 0.99), ("max", 1)):
        assert np.allclose(flat[name], np.quantile(values, share, axis=0), atol=1e-6), name


@settings(max_examples=30)
@given(st.lists(arrays.arrays(np.uint8, (2, 3, 5, 3)), min_size=1, max_size=4))
def test_image_statistics_of_any_pixels(parts: list[np.ndarray]) -> None:
    """From histograms that add up, against numpy's of all pixels at once."""
    counts = sum(statistics.histogram(part) for part in parts)
    assert isinstance(counts, np.ndarray)
    _check(statistics.of_images(counts, 2 * len(parts)), np.concatenate(parts).reshape(-1, 3) / 255)


def test_files_end_where_they_are_full_and_readers_follow(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tables, "DATA_BYTES", 1)
    monkeypatch.setattr(tables, "CHUNKS", 2)
    monkeypatch.setattr("optimus.exchange.lerobot.cameras.VIDEO_BYTES", 1)
    store = make_dataset(tmp_path / "data", 6, 12)
    said = export_lerobot(store.path, tmp_path / "out")
    info, frames = json.loads((tmp_path / "out/meta/info.json").read_text()), read(tmp_path / "out", "data")
    assert (tmp_path / "out/data/chunk-001/file-001.parquet").exists() and said["videos"]["front"]["psnr_db"] > 30
    for row, seed in zip(read(tmp_path / "out", "meta/episodes"), expected_order(store), strict=True):
        table = tmp_path / "out" / info["data_path"].format(chunk_index=row["data/chunk_index"], file_index=row["data/file_index"])
        assert {r["episode_index"] for r in pq.read_table(table).to_pylist()} == {row["episode_index"]}
        seen = _images(tmp_path / "out", info, row, frames, "front")
        assert len(seen) == row["length"] and np.abs(seen - store.read(seed).observations["front_image"].astype(float)).mean() < 8


def test_instructions_become_tasks(tmp_path: Path) -> None:
    store = EpisodeStore.create(tmp_path / "data", "square", CAMERAS, {})
    told = ["put it there", "put it here", "put it there", ""]
    for seed, words in enumerate(told):
        store.write(make_episode(seed, 5, info={"instruction": words} if words else {}))
    assert export_lerobot(store.path, tmp_path / "out")["instructions"] == 3
    rows = read(tmp_path / "out", "meta/episodes")
    assert [row["tasks"] for row in rows] == [["put it there"], ["put it here"], ["put it there"], ["square"]]
    with pytest.raises(StorageError, match="--overwrite"):
        export_lerobot(store.path, tmp_path / "out")
    with pytest.raises(StorageError, match=r"meta/info\.json"):
        export_lerobot(store.path, tmp_path, LerobotConfig(overwrite=True))
    export_lerobot(store.path, tmp_path / "out", LerobotConfig(overwrite=True, images=True))
    assert not (tmp_path / "out/videos").exists() and sorted(p.name for p in tmp_path.iterdir()) == ["data", "out"]
