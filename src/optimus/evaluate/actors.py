"""Who acts and where: the policy of a run folder, and the environment that it was trained for."""

from __future__ import annotations

from pathlib import Path

from optimus.conditions import USUAL, Conditions
from optimus.data.episode import IMAGE_SIZE
from optimus.data.store import EpisodeStore
from optimus.env import ManipulationEnv
from optimus.errors import CheckpointError, DatasetError
from optimus.learn import checkpoint
from optimus.learn.policy import PolicyInputs
from optimus.robots import Robot
from optimus.robots.catalogue import known_robots
from optimus.robots.catalogue import robot as robot_named
from optimus.scene import Camera
from optimus.tasks import task as task_named
from optimus.tasks import with_objects


def trained_robot(run: Path, asked: Robot | None = None) -> Robot | None:
    """The robot that the policy in `run` was trained with; None for the task's own. `CheckpointError` if another one is asked
    for, or none where only a robot file can tell."""
    inputs = checkpoint.load(run).inputs
    task = task_named(checkpoint.tasks_of(inputs.task)[0])
    if asked is None and inputs.robot in known_robots():
        asked = robot_named(inputs.robot)
    if task.robot_record(asked) != inputs.robot:
        have, wanted = task.robot_text(inputs.robot), task.robot_text(task.robot_record(asked))
        raise CheckpointError(f"{run} was trained with robot {have}, not {wanted}; name its own with --robot, or another run")
    return asked


def require_same_problems(run: Path, dataset: Path, task: str | None = None) -> None:
    """`DatasetError` if the states of `dataset` are those of another task or robot than the policy in `run` was trained with, or of
    another of its tasks than `task`."""
    inputs, store = checkpoint.load(run).inputs, EpisodeStore.open(dataset)
    if task is not None and store.task != task:
        raise DatasetError(f"{dataset} was collected with task = {store.task!r}, not {task!r}; name another")
    for what, have, fits in (
        ("task", store.task, checkpoint.tasks_of(inputs.task)),
        ("robot", store.robot, (inputs.robot,)),
    ):
        if have not in fits:
            wanted = " and ".join(map(repr, fits))
            raise DatasetError(f"{dataset} was collected with {what} = {have!r}, {run} trained with {wanted}; name another")


def policy_folder(run: Path, which: str) -> Path:
    """The run folder of the `last` or the `best` checkpoint of `run`; `CheckpointError` if that one has not been written."""
    folder = run / checkpoint.BEST_FOLDER if which == "best" else run
    checkpoint.read_config(folder)
    return folder


def environment(
    run: Path,
    inputs: PolicyInputs,
    robot: Robot | None = None,
    task: str | None = None,
    objects: str | None = None,
    conditions: Conditions = USUAL,
) -> ManipulationEnv:
    """Where the policy of that run folder and of those inputs acts: its task, its control, its gripper, and the images or the
    positions that it was trained on. `task` and `objects` as `Start` takes them."""
    name = with_objects(task_of(inputs.task, task, run), objects)
    height, width = inputs.frame or (0, IMAGE_SIZE)
    if height != width and not inputs.told:
        sizes = f"{height} x {width}" if inputs.frame else "several sizes"
        raise CheckpointError(f"{run} was trained on images of {sizes}, here they are square; play it where it was trained")
    views = {view["name"]: Camera.of(view) for view in inputs.views}
    return ManipulationEnv(
        conditions.of(task_named(name)),
        images=not inputs.told,
        control=inputs.control,
        robot=trained_robot(run, robot),
        positions=inputs.told,
        gripper=checkpoint.gripper_of(run),
        worlds=conditions.world,
        image_size=height,
        cameras=[views.get(name, name) for name in inputs.cameras],
    )


def task_of(trained: str, asked: str | None, run: Path) -> str:
    """Which task to do, the first where none is asked for; `CheckpointError` if the policy was not trained for it."""
    known = checkpoint.tasks_of(trained)
    if asked is not None and asked not in known:
        raise CheckpointError(f"{run} was trained for {', '.join(known)}, not for {asked!r}; name one of these")
    return asked or next(iter(known))
