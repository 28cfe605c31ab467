"""Known robots, and where their models are."""

from pathlib import Path

from optimus.errors import UnknownNameError
from optimus.robots.menagerie import fetch
from optimus.robots.panda import PANDA
from optimus.robots.robot import Robot

ROBOTS: dict[str, Robot] = {PANDA.name: PANDA}


def robot(name: str) -> Robot:
    """The robot of that name; `UnknownNameError` lists the known ones."""
    if name not in ROBOTS:
        raise UnknownNameError("robot", name, ROBOTS)
    return ROBOTS[name]


def model_path(robot: Robot) -> Path:
    """The robot's MJCF file, fetched and verified on first use."""
    return fetch(robot.source) / "panda.xml"


__all__ = ["PANDA", "ROBOTS", "Robot", "model_path", "robot"]
