"""Robots by name or by file."""

from __future__ import annotations

from pathlib import Path

from optimus.errors import RobotFileError, UnknownNameError
from optimus.robots.file import read_robot
from optimus.robots.panda import PANDA
from optimus.robots.robot import Robot


def known_robots() -> dict[str, Path | None]:
    """The names that need no path: the Panda, and the robot files that come with this package."""
    return {PANDA.name: None, **{path.stem: path for path in sorted(Path(__file__).parent.glob("*.toml"))}}


def robot(name: str) -> Robot:
    """The robot of that name, or of the robot file at that path; `UnknownNameError` lists the known names."""
    known = known_robots()
    if name not in known and not name.endswith(".toml"):
        raise UnknownNameError("robot", name, [*known, "a robot file (NAME.toml)"])
    if name in known:
        path = known[name]
        return PANDA if path is None else read_robot(path)
    mine = read_robot(Path(name))
    if mine.name in known and mine != robot(mine.name):  # records know a robot by its name
        raise RobotFileError(f"{name}: {mine.name!r} is another robot, that comes with this package; name yours otherwise")
    return mine
