"""The physics state before every action of an episode: as recorded, or found again by doing once more what was done."""

from __future__ import annotations

import logging
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from optimus.data.episode import BINARY, TASKS_OWN
from optimus.data.episode_file import STATES, EpisodeHeader
from optimus.data.store import EpisodeStore
from optimus.env import ManipulationEnv
from optimus.errors import DatasetError, OptimusError
from optimus.robots import Robot
from optimus.robots.catalogue import robot as robot_named
from optimus.tasks import task as task_named

log = logging.getLogger(__name__)


def is_ours(task: str) -> bool:
    """Whether a data set's task is one of this program's, by what it is called: its own, or a module's."""
    try:
        return ":" in task or bool(task_named(task))
    except OptimusError:
        return False


def environment(store: EpisodeStore, robot: Robot | None = None) -> ManipulationEnv | None:
    """The environment that a data set was collected in, with that robot; None where its task is not one of this program's, or,
    which is logged, where what it takes is not here. `DatasetError` if the robot is another one."""
    if not is_ours(store.task):
        return None
    try:
        task = task_named(store.task)
        arm = robot or (None if store.robot == TASKS_OWN else robot_named(store.robot))
    except OptimusError as error:
        log.warning("without models and states that were not recorded: %s", error)
        return None
    if task.robot_record(arm) != store.robot:
        raise DatasetError(f"{store.path} was collected with robot {task.robot_text(store.robot)}, not {task.robot_record(arm)}")
    return _environment(task.name, store.control, arm, store.config.get("gripper", BINARY))


@lru_cache(maxsize=1)
def _environment(task: str, control: str, arm: object, gripper: str) -> ManipulationEnv:
    return ManipulationEnv(task_named(task), images=False, control=control, robot=arm, gripper=gripper)  # type: ignore[arg-type]


def states_of(header: EpisodeHeader, env: ManipulationEnv | None) -> NDArray[np.float64] | None:
    """`(T, 1 + nq + nv)`: time, qpos and qvel before each action, as robosuite flattens a state; None where nothing is known.

    An episode that did not record them is carried out again, which is exact: `DatasetError` if the objects are not at every step
    where they were (another version of the physics, another robot's file).
    """
    if STATES in header.arrays:
        return header.read(STATES)
    if env is None:
        return None
    objects, executed = header.read("objects"), header.read("executed")
    env.reset(seed=header.seed, options={"state": header.read("initial_state")})
    rows, places = [], []
    size = 1 + env.world.model.nq + env.world.model.nv  # how an integration state begins (mjtState's order)
    for action in executed:
        rows.append(env.snapshot()[:size])
        places.append(env.object_positions())
        env.step(action)
    off = float(np.abs(np.stack(places) - objects).max(initial=0.0))
    if off > 1e-5:
        raise DatasetError(
            f"{header.path}: carried out again, its objects come to lie up to {1000 * off:.1f} mm from where they were recorded; "
            "it was made by another version: export it with --no-states"
        )
    return np.stack(rows)
