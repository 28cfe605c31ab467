"""How the expert moves, in numbers."""

from __future__ import annotations

from dataclasses import dataclass


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
    shuffle: bool = False
    """Take grasps and placements in random order (the paper's randomised planner) instead of a fixed one."""
