"""A data set as a LeRobotDataset v3.0 (huggingface.co/docs/lerobot/lerobot-dataset-v3), written without LeRobot.

    meta/info.json                               features, counts, splits, where files are
    meta/stats.json                              statistics of every feature over all frames
    meta/tasks.parquet                           instructions, by number
    meta/episodes/chunk-000/file-000.parquet     a row an episode: length, instruction, files, offsets, statistics, seed
    data/chunk-000/file-000.parquet              a row a frame; many episodes a file
    videos/observation.images.<camera>/chunk-000/file-000.mp4

`observation.state` is what the arm knows of itself, its parts one after another; the objects' positions are not in it. `action` is
the label. Episodes to train on come first, then those to validate on, then any others: `splits` says where they are.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from optimus.control import CONTROL_HZ
from optimus.data.atomic import make_folder, require_free, write_json, written_aside
from optimus.data.episode import IMAGE_SUFFIX, TASKS_OWN
from optimus.data.episode_file import OBSERVATION_PREFIX, EpisodeHeader, read_episode
from optimus.data.store import EpisodeStore
from optimus.errors import DatasetError
from optimus.exchange import video
from optimus.exchange.lerobot import statistics
from optimus.exchange.lerobot.cameras import VIDEO_BYTES, VIDEO_PATH, CameraFiles
from optimus.exchange.lerobot.tables import CHUNKS, DATA_BYTES, DATA_PATH, FrameTable, place, write_episodes, write_tasks
from optimus.exchange.selection import Selection, environment_settings, instruction_of, select
from optimus.exchange.states import environment
from optimus.robots import Robot

VERSION = "v3.0"
MARKER = "meta/info.json"
STATE, ACTION, IMAGES = "observation.state", "action", "observation.images."
SCALARS = {
    "timestamp": "float32",
    "frame_index": "int64",
    "episode_index": "int64",
    "index": "int64",
    "task_index": "int64",
    "next.reward": "float32",
    "next.done": "bool",
    "next.success": "bool",
}
"""The features with one number a frame; the first five are LeRobot's own, the others what its simulated data sets have besides."""


@dataclass(frozen=True)
class LerobotConfig:
    """How to write the folder."""

    everything: bool = False
    """Also the episodes that curation dropped."""
    images: bool = False
    """Images as PNG within the tables, exactly as they are, in place of videos."""
    crf: int = 12
    """Of the videos: x264's constant rate factor, smaller is better and larger."""
    overwrite: bool = False
    robot: Robot | None = None
    """That of the data set, where a robot file says which."""


def export_lerobot(
    dataset: Path, out: Path, config: LerobotConfig | None = None, progress: Callable[[int, int], None] = lambda done, of: None
) -> dict[str, Any]:
    """Write the data set, whole or not at all; `progress(done, all)` counts episodes. The answer says how good the videos are."""
    config = config or LerobotConfig()
    require_free(out, config.overwrite, MARKER)
    selection = _in_order(select(dataset, config.everything))
    with written_aside(out, config.overwrite, MARKER) as root:
        writer = _Writer(root, selection, config)
        try:
            for number, header in enumerate(selection.headers):
                writer.add(header)
                progress(number + 1, len(selection.headers))
            quality = writer.finish()
        finally:
            writer.close()
    counts = {"episodes": len(selection.headers), "frames": selection.steps, "instructions": len(writer.tasks)}
    return {"folder": str(out), **counts, "splits": _splits(selection), "videos": quality, "left_out": _left_out(selection)}


def _left_out(selection: Selection) -> list[str]:
    """Observations that are neither numbers of the state nor images: distances and segmentation."""
    first = selection.headers[0]
    flat = {name for name in first.observation_names if len(first.arrays[OBSERVATION_PREFIX + name].shape) == 2}
    return sorted(name for name in {*first.observation_names} - flat if not name.endswith(IMAGE_SUFFIX))


def _rate(store: EpisodeStore) -> int:
    """Steps a second, as another program's file says; `DatasetError` where they are none that the format can tell."""
    told = environment_settings(store.config.get("env_args")).get("control_freq") or CONTROL_HZ
    if not isinstance(told, (int, float)) or told != int(told) or told < 1:
        raise DatasetError(f"{store.path} has {told!r} steps a second; LeRobot's format has whole ones, 1 or more")
    return int(told)


def _in_order(selection: Selection) -> Selection:
    """Training first, then validation, then the others."""

    def rank(header: EpisodeHeader) -> tuple[bool, bool, int]:
        return header.seed not in selection.train, header.seed not in selection.validation, header.seed

    return Selection(selection.store, tuple(sorted(selection.headers, key=rank)), selection.train, selection.validation)


def _splits(selection: Selection) -> dict[str, str]:
    """Ranges of episodes; all of them to train on where there was no curation."""
    train, held_out = len(selection.train), len(selection.validation)
    if not train:
        return {"train": f"0:{len(selection.headers)}"}
    return {"train": f"0:{train}", "validation": f"{train}:{train + held_out}"}


class _Writer:
    """A folder in the making."""

    def __init__(self, root: Path, selection: Selection, config: LerobotConfig) -> None:
        self.root, self.selection, self.config = root, selection, config
        store = selection.store
        self.fps = _rate(store)
        self.env = environment(store, config.robot)
        self.frames = FrameTable(root)
        make_folder(root / "meta")
        self.cameras = {c: CameraFiles(root, IMAGES + c, self.fps, config.crf) for c in store.cameras if not config.images}
        self.tasks: dict[str, int] = {}
        self.rows: list[dict[str, Any]] = []
        self.features: dict[str, dict[str, Any]] = {}
        self._numbers: list[dict[str, NDArray[Any]]] = []
        self._histograms: dict[str, NDArray[np.int64]] = {}
        self._index = 0

    def add(self, header: EpisodeHeader) -> None:
        """One episode: its frames, videos and row."""
        episode = read_episode(header)
        low = {k: a for k, a in episode.observations.items() if a.ndim == 2}  # neither images nor depth
        images = {c: episode.observations[c + IMAGE_SUFFIX] for c in episode.cameras}
        features = _features(low, episode.actions, images, self.config.images)
        self.features = self.features or features
        if features != self.features:
            raise DatasetError(f"{header.path}: its arrays are not those of the episodes before it; collect these apart")
        told = instruction_of(header, self.env)
        steps, task = len(episode), self.tasks.setdefault(told, len(self.tasks))
        numbers = {STATE: np.concatenate(list(low.values()), axis=1), ACTION: episode.actions}
        numbers |= self._scalars(steps, task, episode.success)
        in_table = {IMAGES + c: [_png(image) for image in a] for c, a in images.items()} if self.config.images else {}
        file = self.frames.add(numbers, in_table)
        row: dict[str, Any] = {"episode_index": len(self.rows), "tasks": [told], "length": steps, "seed": header.seed}
        row |= {f"data/{key}": value for key, value in place(file).items()}
        row |= {"dataset_from_index": self._index, "dataset_to_index": self._index + steps}
        for camera, files in self.cameras.items():
            row |= files.add(images[camera])
        self.rows.append(row | self._statistics(numbers, images))
        self._index += steps

    def _scalars(self, steps: int, task: int, success: bool) -> dict[str, NDArray[Any]]:
        last = np.arange(steps) == steps - 1
        values = {
            "timestamp": np.arange(steps) / self.fps,
            "frame_index": np.arange(steps),
            "episode_index": np.full(steps, len(self.rows)),
            "index": self._index + np.arange(steps),
            "task_index": np.full(steps, task),
            "next.reward": last & success,
            "next.done": last,
            "next.success": last & success,
        }
        return {name: values[name].astype(dtype) for name, dtype in SCALARS.items()}

    def _statistics(self, numbers: dict[str, NDArray[Any]], images: dict[str, NDArray[np.uint8]]) -> dict[str, list]:
        """Of this episode, as columns of its row; what is needed for those of all is kept."""
        self._numbers.append(numbers)
        found = {name: statistics.of_numbers(values) for name, values in numbers.items()}
        for camera, array in images.items():
            counts, key = statistics.histogram(array), IMAGES + camera
            self._histograms[key] = self._histograms.get(key, 0) + counts
            found[key] = statistics.of_images(counts, len(array))
        return {f"stats/{feature}/{name}": value for feature, values in found.items() for name, value in values.items()}

    def finish(self) -> dict[str, dict[str, float]]:
        """Close the files, compare the videos with what went into them, and write what is known of the whole."""
        self.frames.close()
        quality = {}
        for camera, files in self.cameras.items():
            files.close()
            quality[camera] = files.compare(self._originals(camera))
            self.features[IMAGES + camera]["info"] = video.facts(files.path(0))
        write_episodes(self.root, self.rows)
        write_tasks(self.root, list(self.tasks))
        together = {n: statistics.of_numbers(np.concatenate([c[n] for c in self._numbers])) for n in self._numbers[0]}
        together |= {key: statistics.of_images(counts, self._index) for key, counts in self._histograms.items()}
        write_json(self.root / "meta" / "stats.json", together)
        write_json(self.root / MARKER, self._info())
        return quality

    def close(self) -> None:
        """Let go of the files, in whatever state they are."""
        for files in (self.frames, *self.cameras.values()):
            with suppress(OSError, ValueError):
                files.close()

    def _originals(self, camera: str) -> Iterator[NDArray[np.uint8]]:
        for header in self.selection.headers:
            yield from header.read(f"{OBSERVATION_PREFIX}{camera}{IMAGE_SUFFIX}")

    def _info(self) -> dict[str, Any]:
        store = self.selection.store
        robot = self.env.world.scene.robot.name if self.env is not None else None
        return {
            "codebase_version": VERSION,
            "robot_type": robot if store.robot == TASKS_OWN else store.robot,
            "total_episodes": len(self.rows),
            "total_frames": self._index,
            "total_tasks": len(self.tasks),
            "chunks_size": CHUNKS,
            "data_files_size_in_mb": DATA_BYTES // 2**20,
            "video_files_size_in_mb": VIDEO_BYTES // 2**20,
            "fps": self.fps,
            "splits": _splits(self.selection),
            "data_path": DATA_PATH,
            "video_path": VIDEO_PATH if self.cameras else None,
            "features": self.features,
        }


def _features(
    low: dict[str, NDArray[Any]], actions: NDArray[np.float32], images: dict[str, NDArray[np.uint8]], in_table: bool
) -> dict[str, dict[str, Any]]:
    """What a frame is made of: type, shape and names, as `info.json` says it."""
    state = [f"{name}.{i}" for name, array in low.items() for i in range(array.shape[1])]
    action = [f"action.{i}" for i in range(actions.shape[1])]
    found: dict[str, dict[str, Any]] = {
        STATE: {"dtype": "float32", "shape": [len(state)], "names": state},
        ACTION: {"dtype": "float32", "shape": [len(action)], "names": action},
    }
    for camera, array in images.items():
        shape, kind = list(array.shape[1:]), "image" if in_table else "video"
        found[IMAGES + camera] = {"dtype": kind, "shape": shape, "names": ["height", "width", "channels"]}
    return found | {name: {"dtype": dtype, "shape": [1], "names": None} for name, dtype in SCALARS.items()}


def _png(image: NDArray[np.uint8]) -> bytes:
    buffer = io.BytesIO()
    Image.fromarray(image).save(buffer, "PNG")
    return buffer.getvalue()
