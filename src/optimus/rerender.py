"""Images from stored states: the ones that collection would have rendered, or other views, sizes, depth, segmentation, looks.

Nothing is planned or simulated again, and nothing rewritten: what comes out is a dataset of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from optimus.appearance import randomise
from optimus.data.atomic import write_whole
from optimus.data.curate import CURATION_FILE
from optimus.data.episode import (
    DEPTH_SUFFIX,
    IMAGE_SIZE,
    IMAGE_SUFFIX,
    RENDERED,
    SEGMENTATION_SUFFIX,
    SEGMENTED,
    VIEWS,
    Episode,
)
from optimus.data.store import EpisodeStore
from optimus.env import RECORDED_STATE
from optimus.errors import DatasetError, UnknownNameError, require_at_least
from optimus.render import Rig, seen_names
from optimus.robots import Robot
from optimus.robots.catalogue import known_robots
from optimus.robots.catalogue import robot as robot_named
from optimus.scene import Camera
from optimus.tasks import task as task_named
from optimus.workers import finished
from optimus.world import World, compile_scene


@dataclass(frozen=True)
class RenderConfig:
    """Which images to make."""

    cameras: tuple[str, ...] = ()
    """Names of the scene's cameras, in order; empty: all, unless there are `views`."""
    views: tuple[Camera, ...] = ()
    """New ones, which come after those."""
    size: int = IMAGE_SIZE
    """Side of the images [pixels]."""
    depth: bool = False
    segmentation: bool = False
    randomise: int | None = None
    """A seed: every episode gets a look of its own."""

    def __post_init__(self) -> None:
        require_at_least(1, size=self.size)
        require_at_least(0, randomise=self.randomise)
        names = [*self.cameras, *(view.name for view in self.views)]
        if twice := sorted({name for name in names if names.count(name) > 1}):
            raise DatasetError(f"camera {', '.join(twice)} is named twice; name each once")

    def of(self, known: tuple[str, ...]) -> tuple[str, ...]:
        """The names of the images' cameras, where the scene has those `known`."""
        for name in self.cameras:
            if name not in known:
                raise UnknownNameError("camera", name, known)
        for view in self.views:
            if view.name in known:
                raise DatasetError(f"the scene has a camera {view.name!r} of its own; name the new view otherwise")
        chosen = self.cameras or (() if self.views else known)
        return (*chosen, *(view.name for view in self.views))

    def is_plain(self, known: tuple[str, ...]) -> bool:
        """Whether the images are those of collection."""
        return self.of(known) == known and replace(self, cameras=()) == RenderConfig()


def rerender(
    source: Path,
    out: Path,
    config: RenderConfig,
    workers: int = 0,
    robot: Robot | None = None,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> EpisodeStore:
    """A dataset in `out` with the episodes of `source` and the images that are asked for; goes on where it was stopped. `robot` is
    needed where `source` was collected with a robot file. Its curation goes along."""
    store = EpisodeStore.open(source)
    if out.resolve() == source.resolve():
        raise DatasetError(f"{out} is the dataset to render from; name another folder: datasets are never rewritten")
    if not store.seeds:
        raise DatasetError(f"{source} holds no episodes; collect some")
    robot, task = _robot_of(store, robot), task_named(store.task)
    if store.problems:
        store.require_problems(task.fingerprint(store.config["seed"], robot))
    known = compile_scene(task.problem(store.seeds[0], robot).scene).image_cameras
    about = {k: v for k, v in store.config.items() if k != RENDERED}
    if not config.is_plain(known):
        about[RENDERED] = asdict(config)
    made = EpisodeStore.create(out, store.task, config.of(known), about, store.problems)
    missing = sorted(set(store.seeds) - set(made.seeds))
    done = len(store.seeds) - len(missing)
    progress(done, len(store.seeds))
    for _ in finished([partial(_render, source, out, config, robot, seed) for seed in missing], workers):
        done += 1
        progress(done, len(store.seeds))
    if (source / CURATION_FILE).exists() and not (out / CURATION_FILE).exists():
        write_whole(out / CURATION_FILE, (source / CURATION_FILE).read_bytes())
    return made


def _robot_of(store: EpisodeStore, asked: Robot | None) -> Robot | None:
    task = task_named(store.task)
    if asked is None and store.robot in known_robots():
        asked = robot_named(store.robot)
    if task.robot_record(asked) != store.robot:
        have, wanted = task.robot_text(store.robot), task.robot_text(task.robot_record(asked))
        raise DatasetError(f"{store.path} was collected with robot {have}, not {wanted}; name its own with --robot")
    return asked


def _render(source: Path, out: Path, config: RenderConfig, robot: Robot | None, seed: int) -> None:
    """One episode, in a worker."""
    store = EpisodeStore.open(source)
    episode = store.read(seed)
    EpisodeStore.open(out).write(with_images(episode, config, robot))


def with_images(episode: Episode, config: RenderConfig, robot: Robot | None = None) -> Episode:
    """The same episode with the images asked for in place of those it has."""
    if episode.states is None:
        raise DatasetError(f"episode {episode.seed} has no states to render from; collect it again, or import them with it")
    world = _world(episode, config, robot)
    names = config.of(tuple(n for n in world.image_cameras if n not in {v.name for v in config.views}))
    rig = Rig(world, config.size)
    try:
        frames = [_frame(rig, data, names, config) for data in _each(world, episode.states)]
    finally:
        rig.close()
    kept = {name: array for name, array in episode.observations.items() if array.ndim == 2}
    images = {name: np.stack([frame[name] for frame in frames]) for name in frames[0]}
    info = {**episode.info, VIEWS: world.views, **({SEGMENTED: list(seen_names(world.scene))} if config.segmentation else {})}
    return replace(episode, observations={**kept, **images}, info=info)


def _world(episode: Episode, config: RenderConfig, robot: Robot | None) -> World:
    scene = task_named(episode.task).problem(episode.seed, robot).scene
    scene = replace(scene, cameras=(*scene.cameras, *config.views))
    if config.randomise is None:
        world = compile_scene(scene)
    else:
        rng = np.random.default_rng([config.randomise, episode.seed, 3])
        world = World(scene, lambda spec: randomise(spec, scene, rng))
    size = mujoco.mj_stateSize(world.model, RECORDED_STATE)
    if episode.states is not None and episode.states.shape[1] != size:
        raise DatasetError(
            f"episode {episode.seed} has {episode.states.shape[1]} numbers a state, its scene {size}; it is another version's"
        )
    return world


def _each(world: World, states: NDArray[np.float64]) -> Iterator[mujoco.MjData]:
    """The world's `MjData` in each of the states, as far as pictures need it."""
    data = mujoco.MjData(world.model)
    for state in states:
        mujoco.mj_setState(world.model, data, state, RECORDED_STATE)
        mujoco.mj_kinematics(world.model, data)
        mujoco.mj_comPos(world.model, data)
        mujoco.mj_camlight(world.model, data)
        yield data


def _frame(rig: Rig, data: mujoco.MjData, cameras: tuple[str, ...], config: RenderConfig) -> dict[str, NDArray[Any]]:
    seen: dict[str, NDArray[Any]] = {camera + IMAGE_SUFFIX: rig.image(data, camera) for camera in cameras}
    if config.depth:
        seen |= {camera + DEPTH_SUFFIX: rig.depth(data, camera) for camera in cameras}
    if config.segmentation:
        seen |= {camera + SEGMENTATION_SUFFIX: rig.segmentation(data, camera) for camera in cameras}
    return seen
