"""What a plan is made of: segments (how the arm moves), steps (one skill each), and the two ways planning can end."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from optimus.logic import Operator
from optimus.se3 import Array, Pose
from optimus.state import State


@dataclass(frozen=True, eq=False)
class Segment:
    """One motion, or one action of the gripper on the spot.

    `q` `(T, dof)` [rad] is the collision-checked path, from where the arm is to where it ends; `poses` `(T,)` are its tcp poses,
    `base_from_tcp`. A gripper action has T = 1. `shut` is what the gripper is told meanwhile.
    """

    name: str
    q: Array
    poses: tuple[Pose, ...]
    shut: bool
    gripper_action: bool = False
    speed: float = np.inf
    """The follower goes no faster than this here [m/s]; turns count as in `lines.distance`."""
    steady: bool = False
    """Pushes are to be gentle here: the hand has hold of something that is not free to come along."""
    doors: dict[str, Array] = field(default_factory=dict)
    """How far each door that is moved by it is open at each waypoint, `(T,)` [rad]."""

    @property
    def end(self) -> Pose:
        return self.poses[-1]


@dataclass(frozen=True, eq=False)
class Step:
    """One skill of a plan, with its motions and the state they lead to."""

    operator: Operator
    segments: tuple[Segment, ...]
    after: State


@dataclass(frozen=True, eq=False)
class Plan:
    """A solved problem: steps in order; `stats` says what planning cost."""

    start: State
    steps: tuple[Step, ...]
    stats: dict[str, Any]

    @property
    def skeleton(self) -> tuple[str, ...]:
        """The skills' names in order."""
        return tuple(step.operator.skill for step in self.steps)

    @property
    def segments(self) -> tuple[Segment, ...]:
        return tuple(segment for step in self.steps for segment in step.segments)


@dataclass(frozen=True)
class Infeasible:
    """No plan was found: why, at which skill, with which objects, and what was in the way."""

    reason: str
    skill: str = ""
    objects: tuple[str, ...] = ()
    blockers: tuple[str, ...] = ()

    def __str__(self) -> str:
        where = f" at {self.skill}({', '.join(self.objects)})" if self.skill else ""
        by = f", in the way: {', '.join(self.blockers)}" if self.blockers else ""
        return f"{self.reason}{where}{by}"
