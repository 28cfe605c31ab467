"""`State`: a kinematic snapshot of the world, in numpy alone."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from optimus.se3 import Array, Pose


@dataclass(frozen=True, eq=False)
class Held:
    """What the hand holds: the movable's name and `tcp_from_object`."""

    name: str
    tcp_from_object: Pose


@dataclass(frozen=True, eq=False)
class State:
    """Where everything is. Planning makes such states; `World.state` reads one off a running simulation.

    `q` `(dof,)` [rad]; `opening` is the distance between the fingers [m]; `poses` are `base_from_object`; `touched` are the
    movables in contact with the robot; `speeds` [m/s] are zero where not given (a planned state is at rest); `tcp` is
    `base_from_tcp`; `doors` says how far each is open [rad].
    """

    q: Array
    opening: float
    poses: dict[str, Pose]
    tcp: Pose
    held: Held | None = None
    touched: frozenset[str] = frozenset()
    speeds: dict[str, float] = field(default_factory=dict)
    doors: dict[str, float] = field(default_factory=dict)

    def swung(self, door: str, angle: float) -> State:
        """The same state with one door open by `angle` [rad]."""
        return replace(self, doors={**self.doors, door: angle})

    def moved(self, name: str, pose: Pose) -> State:
        """The same state with one movable elsewhere."""
        return replace(self, poses={**self.poses, name: pose})
