"""What a skill is: its meaning (needs, adds, deletes) beside its geometry (a lazy stream of ways to do it)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import ClassVar, Protocol, TypeVar

import numpy as np

from optimus.collision import Blocked, CollisionChecker
from optimus.kinematics import Kinematics
from optimus.logic import Facts, Operator
from optimus.motion import lines, sampling
from optimus.motion.plan import Segment
from optimus.scene import Scene
from optimus.se3 import Array, Pose, error_between
from optimus.state import State
from optimus.world import World

T = TypeVar("T")


@dataclass(frozen=True)
class Style:
    """How the expert moves: the imitation-friendly defaults, each by name, so that ablations can change one."""

    transit_clearance: float = 0.06
    """Sideways motion happens this far above everything that stands about [m]."""
    approach: float = 0.06
    """The straight last stretch before a grasp or a release [m]."""
    retreat: float = 0.09
    """The straight way back from a release [m]: the hand is clear of the thing (`HAND_CLEAR`) even while the arm lags behind."""
    shuffle: bool = False
    """Take grasps and placements in random order (the paper's randomised planner) instead of a fixed one."""


@dataclass(eq=False)
class Workspace:
    """What skills plan with: the compiled world, its kinematics and collision checker, and what failed so far."""

    world: World
    style: Style = field(default_factory=Style)
    failures: list[tuple[str, Blocked]] = field(default_factory=list)
    """`(stage, what was in the way)`, newest last: the planner learns from it."""

    def __post_init__(self) -> None:
        self.kinematics = Kinematics(self.world)
        self.checker = CollisionChecker(self.world)
        self.home = self.kinematics.fk(self.world.home)

    @property
    def scene(self) -> Scene:
        return self.world.scene

    @property
    def open_width(self) -> float:
        return 2 * self.scene.robot.finger_travel

    def transit_height(self, state: State) -> float:
        """The tcp height [m] for sideways motion: clear of all that stands, with whatever hangs below the tcp."""
        held = state.held
        tops = [0.0]
        tops += [self.top_of(state, n) for n in state.poses if held is None or n != held.name]
        tops += [f.pos[2] + f.shape.half_extents[2] for f in self.scene.fixtures]
        hanging = 0.0
        if held is not None:
            hanging = state.tcp.pos[2] - (2 * state.poses[held.name].pos[2] - self.top_of(state, held.name))
        return max(tops) + hanging + self.style.transit_clearance

    def top_of(self, state: State, name: str) -> float:
        """The height of a movable's highest point [m], by its bounding box."""
        pose = state.poses[name]
        return float(pose.pos[2] + np.abs(pose.matrix[2]) @ np.array(self.scene.shape_of(name).half_extents))

    def travel(
        self, name: str, state: State, corners: list[Pose], shut: bool, rng: np.random.Generator, via: bool = False
    ) -> Segment | None:
        """A motion from `state` along straight lines through `corners`. With `via`, the sampling planner may replace all but
        the last of these lines when they are blocked. None, and an entry in `failures`, when there is no way."""
        self.checker.look_at(state)
        found = lines.track(self.kinematics, self.checker, state.q, corners)
        if isinstance(found, Blocked) and via:
            detour = self._detour(state.q, corners, rng)
            found = detour if detour is not None else found
        if isinstance(found, Blocked):
            self.failures.append((name, found))
            return None
        return Segment(name, found[0], found[1], shut)

    def _detour(self, q: Array, corners: list[Pose], rng: np.random.Generator) -> tuple[Array, tuple[Pose, ...]] | None:
        """By joint motion to the last corner but one, then the last line."""
        for goal in self.kinematics.solutions(corners[-2], q):
            last = lines.track(self.kinematics, self.checker, goal, corners[-1:])
            if isinstance(last, Blocked):
                continue
            path = sampling.connect(self.kinematics, self.checker, q, goal, rng)
            if path is not None:
                poses = tuple(self.kinematics.fk(p) for p in path)
                return np.vstack([path, last[0][1:]]), (*poses, *last[1][1:])
        return None

    def over_and_down(self, state: State, goal: Pose, height: float) -> list[Pose]:
        """Corners of the usual way: straight up to `height` (never down), across while turning, straight down to `goal`."""
        start = state.tcp
        corners = []
        if start.pos[2] < height - 1e-6:
            corners.append(start.shifted((0.0, 0.0, height - start.pos[2])))
        top = max(height, goal.pos[2] + self.style.approach)
        corners.append(Pose(np.array([goal.pos[0], goal.pos[1], top]), goal.quat))
        return [*corners, goal]

    def order(self, items: list[T], rng: np.random.Generator) -> list[T]:
        """As they are, or shuffled if the style says so."""
        return [items[i] for i in rng.permutation(len(items))] if self.style.shuffle else items

    def turn_from_home(self, pose: Pose) -> float:
        """How far `pose` is turned away from the hand's home orientation [rad]."""
        return float(np.linalg.norm(error_between(pose, self.home)[3:]))


Refinement = tuple[tuple[Segment, ...], State]


class Skill(Protocol):
    """One kind of action. `refine` lazily yields ways to do it from `state`, best first, with the state each leads to."""

    name: ClassVar[str]

    def operators(self, scene: Scene, facts: Facts) -> Iterator[Operator]:
        """The ground operators of this skill in a scene."""
        ...

    def refine(
        self, workspace: Workspace, state: State, args: tuple[str, ...], rng: np.random.Generator
    ) -> Iterator[Refinement]: ...


def gripper_action(name: str, q: Array, pose: Pose, shut: bool) -> Segment:
    """Open or shut the gripper on the spot."""
    return Segment(name, q[None], (pose,), shut, gripper_action=True)
