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

from optimus.data.episode import DOOR_ANGLES, GRIPPER, HAND, IMAGE_SUFFIX, OBJECT_POSITIONS, OBJECT_TURNS
from optimus.data.episode_file import OBSERVATION_PREFIX, STATES, EpisodeHeader, require_finite
from optimus.data.frames import Frames
from optimus.data.keyposes import keyposes
from optimus.data.store import EpisodeStore
from optimus.data.turns import as_columns, door_columns, doors_of, rotations_of, says_rotations
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
    ahead: int = 0
    """Labels of the steps after a frame that are given with its own."""
    images: bool = True
    """Cut from the images; if not, how the objects lie is given with the proprioception instead: their positions, and where every
    episode has its states how they are turned and how far doors are open."""

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
    """`(B, F, k, 3)` [m]; NaN for those that the scene of an episode does not have."""
    keyposes: NDArray[np.float32]
    """`(B, F, 12)`: where the hand goes next (`keyposes.py`); `(B, F, 0)` where nobody recorded the hand."""
    ahead: NDArray[np.float32]
    """`(B, F, ahead, n)`: the labels of the steps after each frame; after the last step, its own again."""


@dataclass(frozen=True, eq=False)
class Track:
    """One episode: where its images are, and arrays."""

    images: dict[str, Frames]
    proprioception: dict[str, NDArray[np.float32]]
    actions: NDArray[np.float32]
    weight: NDArray[np.float32]
    objects: NDArray[np.float32]
    keyposes: NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class Places:
    """Where B runs of F frames are."""

    tracks: NDArray[np.int64]
    """`(B,)`: the numbers of their tracks."""
    frames: NDArray[np.int64]
    """`(B, F)`: in their tracks; those before its first frame repeat that, those after its last repeat that."""
    inside: NDArray[np.bool_]
    """`(B, F)`: whether they are frames of their tracks, not repeats."""
    steps: NDArray[np.int64]
    """`(B, F)`: the same in the arrays of all tracks."""
    following: NDArray[np.int64]
    """`(B, F, ahead)`: the steps after each frame; after the last one, itself again."""


class Windows:
    """All windows of some episodes of a dataset, and of `extra` ones of other datasets with the same arrays."""

    def __init__(
        self, store: EpisodeStore, seeds: Sequence[int], config: WindowConfig, extra: Sequence[EpisodeHeader] = ()
    ) -> None:
        if not seeds:
            raise DatasetError(f"{store.path}: no episodes to take windows from; collect or curate again")
        self.config = config
        self.cameras, self.control, self.robot = store.cameras if config.images else (), store.control, store.robot
        self.views = store.views if config.images else ()
        headers = [*(store.header(seed) for seed in seeds), *extra]
        _require_same_shapes(headers)
        objects = max(header.arrays["objects"].shape[1] for header in headers)
        turned = not config.images and all(map(says_rotations, headers))
        doors = max(len(door_columns(header)) for header in headers) if turned else 0
        self.tracks = tuple(_track(header, self.cameras, config, objects, turned, doors) for header in headers)
        # A run may begin before its episode: the first labels are learned with a context of repeated first
        # frames, which is what the agent gives them. It may end after it: else the last labels, and the first,
        # would be in fewer runs than all others.
        self._ends = np.cumsum([len(t.actions) + config.windows - 1 for t in self.tracks])
        self.lengths = np.array([len(t.actions) for t in self.tracks])
        self.starts = np.cumsum(self.lengths) - self.lengths
        """Of each track, in the arrays of all."""
        joined = lambda arrays: np.concatenate(list(arrays))  # noqa: E731
        self.actions, self.weight, self.objects, self.keyposes = (
            joined(getattr(t, name) for t in self.tracks) for name in ("actions", "weight", "objects", "keyposes")
        )
        """Of all steps: labels `(labels, n)`, their weights `(labels,)`, positions of objects [m] `(labels, k, 3)`, NaN where an
        episode has fewer, and where the hand goes next `(labels, 12)`, or `(labels, 0)`."""
        self.proprioception = {name: joined(t.proprioception[name] for t in self.tracks) for name in self.tracks[0].proprioception}
        """All low-dimensional observations, name -> `(labels, n)`."""

    def __len__(self) -> int:
        """The number of different runs."""
        return int(self._ends[-1])

    @property
    def frame_shapes(self) -> dict[str, tuple[int, int]]:
        """Height and width of the images, by camera."""
        return {camera: (images.shape[1], images.shape[2]) for camera, images in self.tracks[0].images.items()}

    @property
    def labels(self) -> int:
        """The number of actions in all episodes."""
        return len(self.actions)

    def sample(self, rng: np.random.Generator, runs: int) -> Batch:
        """Runs drawn uniformly, each cropped anywhere (one offset per run and camera)."""
        indices = rng.integers(len(self), size=runs)
        return self.batch(indices, rng)

    def offsets(self, runs: int, rng: np.random.Generator | None = None) -> dict[str, NDArray[np.int64]]:
        """Camera name -> upper left corners of crops `(runs, 2)` [pixels], row and column; in the centre if there is no `rng`."""
        rooms = {camera: np.asarray(shape) - self.config.crop for camera, shape in self.frame_shapes.items()}
        if rng is None:
            return {camera: np.tile(room // 2, (runs, 1)) for camera, room in rooms.items()}
        return {camera: rng.integers(room + 1, size=(runs, 2)) for camera, room in rooms.items()}

    def shifts(self, offsets: dict[str, NDArray[np.int64]]) -> dict[str, NDArray[np.float32]]:
        """How far right and down of the centre such crops are; see `Batch`."""
        side, shapes = self.config.crop, self.frame_shapes
        centres = {camera: (np.asarray(shapes[camera]) - side) // 2 for camera in offsets}
        return {c: ((o - centres[c])[:, ::-1] / (side / 2)).astype(np.float32) for c, o in offsets.items()}

    def batch(self, indices: NDArray[np.integer[Any]] | Sequence[int], rng: np.random.Generator | None = None) -> Batch:
        """The runs of these indices; cropped in the centre if there is no `rng`."""
        places = self.places(np.asarray(indices))
        side, offsets = self.config.crop, self.offsets(len(indices), rng)
        images = {}
        for camera in self.cameras:
            out = np.empty((len(indices), self.config.frames, side, side, 3), np.uint8)
            for run, number, frames, corner in zip(out, places.tracks, places.frames, offsets[camera], strict=True):
                _copy(run, self.tracks[number].images[camera], corner, frames)
            images[camera] = out
        steps = places.steps
        return Batch(
            images=images,
            shifts=self.shifts(offsets),
            proprioception={name: values[steps] for name, values in self.proprioception.items()},
            actions=self.actions[steps],
            weight=self.weight[steps] * places.inside,
            objects=self.objects[steps],
            keyposes=self.keyposes[steps],
            ahead=self.actions[places.following],
        )

    def places(self, indices: NDArray[np.integer[Any]]) -> Places:
        """Where the runs of these indices are."""
        tracks = np.searchsorted(self._ends, indices, side="right")
        final = self.lengths[tracks, None] - 1
        last = final[:, 0] + self.config.windows - self._ends[tracks] + indices
        frames = last[:, None] + np.arange(1 - self.config.frames, 1)
        steps = self.starts[tracks, None] + frames.clip(0, final)
        ends = self.starts[tracks] + final[:, 0]
        following = steps[:, :, None] + np.arange(1, self.config.ahead + 1)
        return Places(tracks, frames, (frames >= 0) & (frames <= final), steps, following.clip(max=ends[:, None, None]))


def _copy(out: NDArray[np.uint8], source: Frames, corner: NDArray[np.integer[Any]], frames: NDArray[np.int64]) -> None:
    """`out[i]` becomes the crop at `corner` of frame `frames[i]`, for consecutive frames, or of the nearest that there is."""
    first, last = max(int(frames[0]), 0), min(int(frames[-1]), source.shape[0] - 1)
    before = first - int(frames[0])
    after = before + last - first + 1
    source.crop(out[before:after], first, corner)
    out[:before], out[after:] = out[before], out[after - 1]


def _track(
    header: EpisodeHeader, cameras: Sequence[str], config: WindowConfig, objects: int, turned: bool, doors: int
) -> Track:
    images = {}
    for camera in cameras:
        slot = header.arrays[OBSERVATION_PREFIX + camera + IMAGE_SUFFIX]
        if min(slot.shape[1:3]) < config.crop:
            raise DatasetError(f"{header.path}: images of {slot.shape[1:3]} are smaller than the crop of {config.crop}")
        images[camera] = Frames(header.path, slot)
    names = [n for n in header.observation_names if len(header.arrays[OBSERVATION_PREFIX + n].shape) == 2]
    low = {name: header.read(OBSERVATION_PREFIX + name) for name in names}
    actions, places = header.read("actions"), header.read("objects")
    for name, array in {**low, "actions": actions, "objects": places}.items():
        require_finite(array, header.path, name)
    places = np.pad(places, ((0, 0), (0, objects - places.shape[1]), (0, 0)), constant_values=np.nan)
    proprioception = {name: array.astype(np.float32) for name, array in low.items()}
    if not config.images:
        # a thing that a scene does not have is at the origin to who is told where things are
        proprioception[OBJECT_POSITIONS] = np.nan_to_num(places.reshape(len(places), -1))
        if turned:
            proprioception[OBJECT_TURNS] = _turns(header, objects)
        if doors:
            angles = doors_of(header)  # a door that a scene does not have is shut
            proprioception[DOOR_ANGLES] = np.pad(angles, ((0, 0), (0, doors - angles.shape[1]))).astype(np.float32)
    aims = np.empty((len(actions), 0), np.float32)
    if low.keys() >= HAND:
        aims = keyposes(actions[:, GRIPPER], low["robot0_eef_pos"], low["robot0_eef_quat"])
    return Track(images, proprioception, actions, _label_weight(actions[:, GRIPPER], config), places, aims)


def _turns(header: EpisodeHeader, objects: int) -> NDArray[np.float32]:
    """`(T, 6 objects)`: see `OBJECT_TURNS`; zeros for a thing that a scene does not have."""
    rotations, turns = rotations_of(header), np.zeros((header.steps, objects, 6), np.float32)
    assert rotations is not None, "asked of every episode before"
    turns[:, : rotations.shape[1]] = as_columns(rotations)
    return turns.reshape(len(turns), -1)


def _label_weight(gripper: NDArray[np.float32], config: WindowConfig) -> NDArray[np.float32]:
    """`(T,)`: `change_weight` within `change_reach` steps of a change of the gripper's label, 1 elsewhere."""
    weight = np.ones(len(gripper), np.float32)
    for step in np.flatnonzero(np.diff(gripper)) + 1:
        weight[max(step - config.change_reach, 0) : step + config.change_reach + 1] = config.change_weight
    return weight


_NOT_CUT = {"initial_state", STATES}
"""What windows have no use for."""


def _require_same_shapes(headers: list[EpisodeHeader]) -> None:
    """All episodes have the same arrays, of the same shapes but for the number of steps; other tasks may have other objects."""
    like = {header.task: header for header in reversed(headers)}
    for header in headers:
        for first, free in ((headers[0], {*_NOT_CUT, "objects"}), (like[header.task], _NOT_CUT)):
            expected, shapes = _step_shapes(first, free), _step_shapes(header, free)
            for name in sorted(expected.keys() | shapes.keys()):
                if expected.get(name) != shapes.get(name):
                    raise DatasetError(
                        f"{header.path}: {name} has shape {shapes.get(name)} a step, "
                        f"in {first.path.name} it has {expected.get(name)}; collect these apart"
                    )


def _step_shapes(header: EpisodeHeader, free: set[str]) -> dict[str, tuple[int, ...]]:
    """The shape of a step of every array but those that are `free`."""
    return {name: slot.shape[1:] for name, slot in header.arrays.items() if name not in free}
