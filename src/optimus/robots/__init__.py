"""Known robots, and robot files."""

from optimus.robots.panda import PANDA
from optimus.robots.robot import Robot

__all__ = ["PANDA", "Robot"]
