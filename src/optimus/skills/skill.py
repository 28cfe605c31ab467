"""What a skill is: its meaning (needs, adds, deletes) beside its geometry (a lazy stream of ways to do it)."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from itertools import islice
from typing import ClassVar, Protocol, TypeVar

import numpy as np

from optimus.collision import Blocked, CollisionChecker
from optimus.kinematics import Kinematics
from optimus.logic import Facts, Operator
from optimus.motion import lines
from optimus.motion.plan import Segment
from optimus.scene import Scene
from optimus.se3 import Array, Pose, error_between
from optimus.skills import about, roof
from optimus.skills.style import Style
from optimus.state import State
from optimus.world import World

T = TypeVar("T")

FASTEST = 0.5
"""No plan is for a faster tcp than this [m/s]."""
FINGER_STEPS = 5
"""Openings that are looked at, from shut to open."""
SPEED_SHARE = 0.9
"""Of the joints' speed limits, what a plan makes use of."""


class OutOfTime(Exception):
    """Planning has used up its time; caught by the planner."""


@dataclass(frozen=True)
class Purpose:
    """What a thing is picked up for: the support it goes to, and whether it could be put there from a state in which it is held."""

    support: str
    possible: Callable[[State], bool]


@dataclass(frozen=True)
class Way:
    """How the hand comes to a goal and leaves it: through `corners`, the last of which is the goal."""

    corners: list[Pose]
    straight: int = 1
    """So many of the last lines stay lines: no detour may replace them."""
    out: list[Pose] | None = None
    """Under a roof: through what the hand leaves, till it is under the open sky. None: it leaves straight up."""


@dataclass(eq=False)
class Workspace:
    """What skills plan with: the compiled world, its kinematics and collision checker, and what failed so far."""

    world: World
    style: Style = field(default_factory=Style)
    failures: list[tuple[str, Blocked]] = field(default_factory=list)
    """`(stage, what was in the way)`, newest last: the planner learns from it."""
    purpose: Purpose | None = None
    """Of the skill that is being refined, as far as it is known."""
    crowded: bool = False
    """Whether something else is to be put later where the skill that is being refined puts its thing."""

    missed: list[tuple[str, Pose]] = field(default_factory=list)
    """Grasps that came up empty: the thing, and `object_from_tcp`."""

    deadline: float = np.inf
    """CPU time of this process [s] after which queries raise `OutOfTime`."""
    most: float = np.inf
    """Effort after which they do, too: a count, not a time, so that a slow machine plans as a fast one does."""

    def __post_init__(self) -> None:
        self.kinematics = Kinematics(self.world)
        self.checker = CollisionChecker(self.world)
        self.home = self.kinematics.fk(self.world.home)

    def require_time(self) -> None:
        """`OutOfTime` after the deadline, or after too much effort."""
        if self.effort > self.most or time.process_time() > self.deadline:
            raise OutOfTime

    @property
    def effort(self) -> int:
        """Poses and collisions asked for so far: some 40 to 70 us of CPU each."""
        return self.kinematics.effort + self.checker.effort

    @property
    def scene(self) -> Scene:
        return self.world.scene

    @property
    def open_width(self) -> float:
        return 2 * self.scene.robot.finger_travel

    def transit_height(self, state: State, goal: Pose) -> float:
        """The tcp height [m] for sideways motion to `goal`: clear of every movable and of the fixtures along the way, with
        whatever hangs below the tcp."""
        held = state.held
        tops = [0.0]
        tops += [self.top_of(state, n) for n in state.poses if held is None or n != held.name]
        tops += [self.scene.top_along(f, state.tcp.pos, goal.pos, self.style.corridor) for f in self.scene.fixtures]
        hanging = 0.0
        if held is not None:
            hanging = state.tcp.pos[2] - (2 * state.poses[held.name].pos[2] - self.top_of(state, held.name))
        return max(tops) + hanging + self.style.transit_clearance

    def top_of(self, state: State, name: str) -> float:
        """The height of a movable's highest point [m], by its bounding box."""
        pose = state.poses[name]
        return float(pose.pos[2]) + self.scene.shape_of(name).above(pose.matrix)

    def motion(self, name: str, q: Array, poses: tuple[Pose, ...], shut: bool, speed: float = FASTEST) -> Segment:
        """A segment no faster than the joints allow, nor than `speed` [m/s]."""
        limits = SPEED_SHARE * np.array(self.scene.robot.speed_limits)
        return Segment(name, q, poses, shut, speed=lines.fastest(q, poses, limits, speed))

    def travel(
        self, name: str, state: State, corners: list[Pose], shut: bool, rng: np.random.Generator, straight: int | None = None
    ) -> Segment | None:
        """A motion from `state` along straight lines through `corners`. With `straight`, the sampling planner may replace all but
        that many of the last lines when they are blocked. None, and an entry in `failures`, when there is no way."""
        self.require_time()
        self.checker.look_at(state)
        free = straight is not None and len(corners) > straight
        found = about.sampled(self, state, corners, straight or 0, rng) if free and self.style.motion == "sampled" else None
        found = found or lines.track(self.kinematics, self.checker, state.q, corners)
        if isinstance(found, Blocked) and free:
            found = about.detour(self, state, corners, straight or 0, rng) or found
        if isinstance(found, Blocked):
            self.failures.append((name, found))
            return None
        return self.motion(name, found[0], found[1], shut)

    def travel_to(self, name: str, state: State, q: Array, before: Pose, rng: np.random.Generator) -> Segment | None:
        """An empty-handed motion from `state` to the tcp's pose at `q`: about by joints to where the tcp is at `before`, then
        along a straight line. None, and an entry in `failures`, when there is no way."""
        self.require_time()
        self.checker.look_at(state)
        line = lines.track(self.kinematics, self.checker, q, [before])
        found = line if isinstance(line, Blocked) else about.by_joints(self, state.q, line[0][-1], [self.kinematics.fk(q)], rng)
        if isinstance(found, Blocked):
            self.failures.append((name, found))
            return None
        return self.motion(name, found[0], found[1], False)

    def settled(self, state: State, goal: Pose, rng: np.random.Generator | None = None) -> Iterator[Array]:
        """Free configurations at `goal` in which the arm would stay, with whatever it holds in `state`. If there is none, why is
        added to `failures`."""
        self.require_time()
        blocked: Blocked | None = lines.UNREACHABLE
        solutions = self.kinematics.solutions(goal, state.q)
        if rng is not None and self.style.ik == "random":
            known = list(solutions)
            solutions = (known[i] for i in rng.permutation(len(known)))
        for q in self.kinematics.settled(islice(solutions, self.style.postures), goal):
            self.checker.look_at(state)
            found = self.checker.check(q)
            if found is None:
                blocked = None
                yield q
            elif blocked is not None:
                blocked = found
        if blocked is not None:
            self.failures.append(("fit", blocked))

    def ways(self, state: State, goal: Pose) -> Iterator[Way]:
        """From `state` to `goal`: over everything and straight down under the open sky; from the front under a roof, and there
        only ways that are free as far as the open sky."""
        if not roof.is_under(self.scene, goal):
            yield Way(self._over_and_down(state, goal, self.transit_height(state, goal)))
            return
        ways = [self._into(state, goal, out) for out in roof.ways_out(self.scene, goal)]
        for q in self.settled(state, goal):
            for way in list(ways):
                if about.backwards(self, state, q, way.corners[-way.straight - 1 :]) is not None:
                    ways.remove(way)
                    yield way

    def _into(self, state: State, goal: Pose, out: list[Pose]) -> Way:
        into = [*reversed(out), goal]
        if state.held is not None:  # what is held comes in above its place, and is then put down
            into = [*reversed(self._above(goal, out)), goal]
        return Way(into, straight=len(into) - 1, out=out)

    def _above(self, goal: Pose, out: list[Pose], share: float = 1.0) -> list[Pose]:
        """Corners from `goal` through `out` for a hand that holds something, which is to touch nothing on the way: as high as the
        style says, or a share of that."""
        off = goal.shifted((0.0, 0.0, share * self.style.lift_off))
        return [off, *(pose.shifted((0.0, 0.0, share * self.style.hop)) for pose in out)]

    def approaches(
        self, name: str, state: State, goals: Iterable[Pose], shut: bool, rng: np.random.Generator
    ) -> Iterator[tuple[Way, Segment]]:
        """Motions to any of `goals`, the first ones first, each with the way that it takes. Ways about are long: of a few goals the
        straight ones are tried before."""
        blocked: list[Way] = []
        for number, goal in enumerate(goals, 1):
            for way in self.ways(state, goal):
                motion = self.travel(name, state, way.corners, shut, rng, way.straight if self.style.motion == "sampled" else None)
                if motion is None:
                    blocked.append(way)
                else:
                    yield way, motion
            if number % self.style.at_once == 0:
                yield from self._ways_about(name, state, blocked, shut, rng)
                blocked = []
        yield from self._ways_about(name, state, blocked, shut, rng)

    def _ways_about(
        self, name: str, state: State, blocked: list[Way], shut: bool, rng: np.random.Generator
    ) -> Iterator[tuple[Way, Segment]]:
        for way in blocked:
            motion = self.travel(name, state, way.corners, shut, rng, way.straight)
            if motion is not None:
                yield way, motion

    def ways_back(self, state: State, goal: Pose, way: Way) -> Iterator[list[Pose]]:
        """Corners by which the hand leaves `goal`, with whatever it holds in `state`: under a roof, half as high as usual where
        there is no room for more."""
        if way.out is None:
            least = self.style.approach if state.held is not None else self.style.retreat
            yield [goal.shifted((0.0, 0.0, max(self.transit_height(state, goal) - goal.pos[2], least)))]
        elif state.held is None:
            yield way.out
        else:
            yield self._above(goal, way.out)
            yield self._above(goal, way.out, 0.5)

    def _over_and_down(self, state: State, goal: Pose, height: float) -> list[Pose]:
        """Corners of the usual way: straight up to `height` (never down), across while turning, straight down to `goal`."""
        start = state.tcp
        corners = []
        if start.pos[2] < height - 1e-6:
            corners.append(start.shifted((0.0, 0.0, height - start.pos[2])))
        top = max(height, goal.pos[2] + self.style.approach)
        corners.append(Pose(np.array([goal.pos[0], goal.pos[1], top]), goal.quat))
        return [*corners, goal]

    def fits(self, state: State, goal: Pose) -> bool:
        """Whether the arm can stay at `goal` at all, with whatever it holds in `state`; if not, why is added to `failures`."""
        return next(self.settled(state, goal), None) is not None

    def fingers_move(self, state: State, q: Array) -> bool:
        """Whether the fingers can open and shut about what is held in `state`, the arm at `q`: they may stand astride a wall, open
        on both sides of it. If not, why is added to `failures`."""
        for opening in np.linspace(0.0, self.open_width, FINGER_STEPS):
            self.checker.look_at(replace(state, opening=float(opening)))
            blocked = self.checker.check(q)
            if blocked is not None:
                self.failures.append(("fingers", blocked))
                return False
        return True

    def hand_is_free(self, state: State, goal: Pose) -> bool:
        """Whether the hand is free at `goal` with the arm in the first configuration that reaches it: one check, where `fits` makes
        up to a dozen."""
        self.checker.look_at(state)
        q = next(self.kinematics.solutions(goal, state.q), None)
        return q is not None and self.checker.check(q) is None

    def order(self, items: list[T], rng: np.random.Generator) -> list[T]:
        """As they are, or in random order if the style says so."""
        return [items[i] for i in rng.permutation(len(items))] if self.style.grasps == "random" else items

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
