"""How the expert moves, in numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from optimus.errors import UnknownNameError

ORDERS = ("fixed", "random")
MOTIONS = ("straight", "sampled")


@dataclass(frozen=True)
class Style:
    """How the expert moves: the imitation-friendly defaults, each by name, so that ablations can change one."""

    transit_clearance: float = 0.06
    """Sideways motion happens this far above everything that stands about [m]."""
    approach: float = 0.06
    """The straight last stretch before a grasp or a release [m]."""
    retreat: float = 0.09
    """The straight way back from a release [m]: the hand is clear of the thing (`HAND_CLEAR`) even while the arm lags behind."""
    corridor: float = 0.15
    """Fixtures this near to the way sideways are passed over [m]."""
    hop: float = 0.04
    """Under a roof, what is held is carried this far above its support [m]."""
    lift_off: float = 0.02
    """... after it has been lifted straight up by this [m]."""
    high: float = 0.45
    """Where the straight way is blocked, one by way of home is tried, and one above home at this height [m]."""
    postures: int = 12
    """Arm configurations looked at for a pose."""
    detours: int = 4
    """... and so many of them tried, where the straight way is blocked."""
    at_once: int = 6
    """Of so many grasps or releases the straight ways are tried before the ways about."""
    grasps: Literal["fixed", "random"] = "fixed"
    """Take grasps and placements in a fixed order, or at random (the paper's randomised planner)."""
    ik: Literal["fixed", "random"] = "fixed"
    """Take the arm's ways to reach a pose by their distance, or at random. Straight ways go on from where the arm is: this tells
    only where one of them is replaced, or all are (`motion`)."""
    motion: Literal["straight", "sampled"] = "straight"
    """Try straight ways first, or go where the sampling planner's own path goes, without shortcuts; the last stretch is straight in
    any case."""

    def __post_init__(self) -> None:
        for name, valid in (("grasps", ORDERS), ("ik", ORDERS), ("motion", MOTIONS)):
            if getattr(self, name) not in valid:
                raise UnknownNameError(name, getattr(self, name), valid)
