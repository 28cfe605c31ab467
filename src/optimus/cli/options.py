"""Options that several verbs share, each with one name and one help text. Nothing here imports more than the parser."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from tyro.conf import Positional, arg

if TYPE_CHECKING:
    from optimus.planner import Budget
    from optimus.robots import Robot

TaskName = Annotated[str, Positional, arg(metavar="TASK", help="a task's name; `optimus tasks` lists them")]
Dataset = Annotated[Path, Positional, arg(metavar="DATASET", help="a dataset's folder, from `optimus collect`")]
Datasets = Annotated[tuple[Path, ...], Positional, arg(metavar="DATASET", help="datasets' folders, from `optimus collect`")]
PresetName = Annotated[
    str,
    arg(
        metavar="PRESET",
        help="quick, quick-mlp, quick-rnn, quick-bet (minutes on a CPU), also taught where the objects are and where the hand goes "
        "next; quick-locating (the former alone); optimus-30m, optimus-60m, optimus-100m, bc-mlp, bc-rnn, bet (the paper's, with a "
        "ResNet-18 a camera); optimus-30m-locating (also taught both)",
    ),
]
RunFolder = Annotated[Path, Positional, arg(metavar="RUN", help="a policy's folder, from `optimus train`, or `pretrained:NAME`")]

RobotName = Annotated[str | None, arg(metavar="ROBOT", help="a robot's name or robot file; by default the task's own")]
ControlName = Annotated[
    str,
    arg(
        metavar="{osc,ik,joint}",
        help="how actions move the arm: osc (operational space), ik (the same actions by inverse kinematics), or joint",
    ),
]
FirstSeed = Annotated[int, arg(help="of the first attempt; the next ones follow")]
Workers = Annotated[int, arg(help="processes; 0 takes every core (no episode depends on it)")]
Backend = Annotated[
    Literal["local", "ray"],
    arg(help="where the workers are: here, or in Ray: the cluster that RAY_ADDRESS names, else one of its own"),
]
PlanningSeconds = Annotated[float | None, arg(help="CPU seconds that one plan may take, instead of a count of what it asks for")]
Json = Annotated[bool, arg(help="answer with one JSON object, the last line of standard output")]


PerturbName = Annotated[
    Literal["push", "slip"] | None,
    arg(help="once an episode, unforeseen: a thing that is not held is struck, or what is held slips (optimus.conditions)"),
]
Friction = Annotated[float, arg(help="a factor on the friction of everything, unforeseen")]
Mass = Annotated[float, arg(help="a factor on the mass of the movable things, unforeseen")]

ObjectsName = Annotated[
    str | None, arg(metavar="19|72|unseen|NAME,NAME|FOLDER", help="what to do the task with; `optimus objects` lists them")
]


def chosen_budget(seconds: float | None) -> Budget:
    """What a plan may cost."""
    from optimus.planner import Budget

    return Budget() if seconds is None else Budget(seconds, effort=None)


def chosen_robot(name: str | None) -> Robot | None:
    """The robot that takes the place of the task's own; None for that one."""
    from optimus.robots.catalogue import robot as robot_named

    return None if name is None else robot_named(name)
