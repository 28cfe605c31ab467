"""Windows of consecutive frames for training, cut from the episode files themselves.

Images stay on disk as uint8, and only what is asked for is read (`frames.py`). Low-dimensional arrays are small and are held
in memory.

The unit of sampling is a *run*: `windows` consecutive windows of `context` frames each, which share their
frames, so that `windows + context - 1` frames are encoded once and not `windows * context`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from optimus.data.episode import GRIPPER, IMAGE_SUFFIX
from optimus.data.episode_file import OBSERVATION_PREFIX, EpisodeHeader, require_finite
from optimus.data.frames import Frames
from optimus.data.store import EpisodeStore
from optimus.errors import DatasetError


@dataclass(frozen=True)
class WindowConfig:
    """How windows are cut."""

    context: int = 8
    """Frames that the policy sees."""
    windows: int = 1
    """Consecutive windows in a run."""
    crop: int = 76
    """Side of the square cut out of each image [pixels]: anywhere in training, in the centre otherwise."""
    change_weight: float = 1.0
    """Weight of the labels near an opening or closing of the gripper; all others weigh 1."""
    change_reach: int = 2
    """How many steps before and after such a change count as near."""

    @property
    def frames(self) -> int:
        """Frames in a run."""
        return self.windows + self.context - 1


@dataclass(frozen=True, eq=False)
class Batch:
    """B runs of F frames."""

    images: dict[str, NDArray[np.uint8]]
    """Camera name -> `(B, F, crop, crop, 3)`."""
    shifts: dict[str, NDArray[np.float32]]
    """Camera name -> `(B, 2)`: how far right and down of the centre the crop is [half sides of the crop]."""
    proprioception: dict[str, NDArray[np.float32]]
    """Name -> `(B, F, n)`."""
    actions: NDArray[np.float32]
    """`(B, F, n)`: the label of each frame."""
    weight: NDArray[np.float32]
    """`(B, F)`: weight of each label; 0 where the frame only repeats the first one of its episode."""
    objects: NDArray[np.float32]
    """`(B, F, k, 3)` [m]."""


@dataclass(frozen=True, eq=False)
class _Track:
    """One episode: where its images are, and arrays."""

    images: dict[str, Frames]
    proprioception: dict[str, NDArray[np.float32]]
    actions: NDArray[np.float32]
    weight: NDArray[np.float32]
    objects: NDArray[np.float32]


class Windows:
    """All windows of some episodes of a dataset, and of `extra` ones of other datasets with the same arrays."""

    def __init__(
        self, store: EpisodeStore, seeds: Sequence[int], config: WindowConfig, extra: Sequence[EpisodeHeader] = ()
    ) -> None:
        if not seeds:
            raise DatasetError(f"{store.path}: no episodes to take windows from; collect or curate again")
        self.config = config
        self.cameras, self.control, self.robot = store.cameras, store.control, store.robot
        headers = [*(store.header(seed) for seed in seeds), *extra]
        _require_same_shapes(headers)
        self._tracks = [_track(header, store.cameras, config) for header in headers]
        # A run may begin before its episode: the first labels are learned with a context of repeated first
        # frames, which is what the agent gives them.
        self._ends = np.cumsum([max(len(t.actions) - config.windows + 1, 1) for t in self._tracks])

    def __len__(self) -> int:
        """The number of different runs."""
        return int(self._ends[-1])

    @property
    def labels(self) -> int:
        """The number of actions in all episodes."""
        return sum(len(t.actions) for t in self._tracks)

    @property
    def actions(self) -> NDArray[np.float32]:
        """All labels, `(labels, n)`."""
        return np.concatenate([t.actions for t in self._tracks])

    @property
    def objects(self) -> NDArray[np.float32]:
        """All positions of objects [m], `(labels, k, 3)`."""
        return np.concatenate([t.objects for t in self._tracks])

    @property
    def proprioception(self) -> dict[str, NDArray[np.float32]]:
        """All low-dimensional observations, name -> `(labels, n)`."""
        names = self._tracks[0].proprioception
        return {name: np.concatenate([t.proprioception[name] for t in self._tracks]) for name in names}

    def sample(self, rng: np.random.Generator, runs: int) -> Batch:
        """Runs drawn uniformly, each cropped anywhere (one offset per run and camera)."""
        indices = rng.integers(len(self), size=runs)
        return self.batch(indices, rng)

    def batch(self, indices: NDArray[np.integer[Any]] | Sequence[int], rng: np.random.Generator | None = None) -> Batch:
        """The runs of these indices; cropped in the centre if there is no `rng`."""
        places = [self._place(int(i)) for i in indices]
        side = self.config.crop
        images, shifts = {}, {}
        for camera in self.cameras:
            room = np.asarray(self._tracks[0].images[camera].shape[1:3]) - side
            offsets = np.tile(room // 2, (len(places), 1)) if rng is None else rng.integers(room + 1, size=(len(places), 2))
            out = np.empty((len(places), self.config.frames, side, side, 3), np.uint8)
            for run, (track, frames), corner in zip(out, places, offsets, strict=True):
                _copy(run, track.images[camera], corner, frames)
            images[camera] = out
            shifts[camera] = ((offsets - room // 2)[:, ::-1] / (side / 2)).astype(np.float32)
        weight = np.stack([np.where(frames < 0, 0, track.weight[frames.clip(0)]) for track, frames in places])
        names = self._tracks[0].proprioception
        return Batch(
            images=images,
            shifts=shifts,
            proprioception={n: np.stack([t.proprioception[n][f.clip(0)] for t, f in places]) for n in names},
            actions=np.stack([track.actions[frames.clip(0)] for track, frames in places]),
            weight=weight.astype(np.float32),
            objects=np.stack([track.objects[frames.clip(0)] for track, frames in places]),
        )

    def _place(self, index: int) -> tuple[_Track, NDArray[np.int64]]:
        """The episode of a run and its frames, some of them negative: those repeat the first frame."""
        number = int(np.searchsorted(self._ends, index, side="right"))
        track = self._tracks[number]
        last = len(track.actions) - 1
        end = last - (int(self._ends[number]) - 1 - index)
        return track, np.arange(end - self.config.frames + 1, end + 1)


def _copy(out: NDArray[np.uint8], source: Frames, corner: NDArray[np.integer[Any]], frames: NDArray[np.int64]) -> None:
    """`out[i]` becomes the crop at `corner` of frame `max(frames[i], 0)`, for consecutive frames."""
    before = min(max(-int(frames[0]), 0), len(frames) - 1)
    source.crop(out[before:], int(frames[0]) + before, corner)
    if before:
        out[:before] = out[before]


def _track(header: EpisodeHeader, cameras: Sequence[str], config: WindowConfig) -> _Track:
    images = {}
    for camera in cameras:
        slot = header.arrays[OBSERVATION_PREFIX + camera + IMAGE_SUFFIX]
        if min(slot.shape[1:3]) < config.crop:
            raise DatasetError(f"{header.path}: images of {slot.shape[1:3]} are smaller than the crop of {config.crop}")
        images[camera] = Frames(header.path, slot)
    names = [n for n in header.observation_names if len(header.arrays[OBSERVATION_PREFIX + n].shape) == 2]
    low = {name: header.read(OBSERVATION_PREFIX + name) for name in names}
    actions, objects = header.read("actions"), header.read("objects")
    for name, array in {**low, "actions": actions, "objects": objects}.items():
        require_finite(array, header.path, name)
    proprioception = {name: array.astype(np.float32) for name, array in low.items()}
    return _Track(images, proprioception, actions, _label_weight(actions[:, GRIPPER], config), objects)


def _label_weight(gripper: NDArray[np.float32], config: WindowConfig) -> NDArray[np.float32]:
    """`(T,)`: `change_weight` within `change_reach` steps of a change of the gripper's label, 1 elsewhere."""
    weight = np.ones(len(gripper), np.float32)
    for step in np.flatnonzero(np.diff(gripper)) + 1:
        weight[max(step - config.change_reach, 0) : step + config.change_reach + 1] = config.change_weight
    return weight


_NOT_CUT = {"initial_state", "states"}
"""What windows have no use for."""


def _require_same_shapes(headers: list[EpisodeHeader]) -> None:
    """All episodes have the same arrays, of the same shapes but for the number of steps."""
    first = headers[0]
    expected = {n: s.shape[1:] for n, s in first.arrays.items() if n not in _NOT_CUT}
    for header in headers:
        shapes = {n: s.shape[1:] for n, s in header.arrays.items() if n not in _NOT_CUT}
        for name in sorted(expected.keys() | shapes.keys()):
            if expected.get(name) != shapes.get(name):
                raise DatasetError(
                    f"{header.path}: {name} has shape {shapes.get(name)} a step, "
                    f"in {first.path.name} it has {expected.get(name)}; collect these apart"
                )
