"""Open and Close: take a door by its bar and swing it. The hand is free to turn about the bar: held rigidly to the door, hardly any
arm could follow it through a right angle."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice, pairwise, product
from typing import ClassVar

import numpy as np

from optimus.logic import Facts, Operator, Predicate
from optimus.motion.lines import UNREACHABLE
from optimus.motion.plan import Segment
from optimus.predicates import HandEmpty, Open, Shut
from optimus.scene import Door, Scene
from optimus.se3 import Array, Pose, quat_from_matrix, quat_from_rotvec, quat_mul
from optimus.skills.skill import Refinement, Workspace, gripper_action
from optimus.state import State

KNOT, SWING_STEP = 0.21, 0.05
"""Between the angles at which the hand's yaw is chosen, and between the waypoints of a swing [rad]."""
SMOOTH_STEP = 0.2
"""No joint turns further from one waypoint to the next [rad]: in a sudden turn of the elbow the hand would stray from the bar."""
OPEN_TO, SHUT_AT = 1.45, 0.0
"""Where a door is left [rad]."""
PULL_SPEED = 0.20
"""[m/s]; a swing of 1.45 rad at 0.45 m takes some four seconds."""
STANDOFF = 0.12
"""The hand approaches and leaves a bar along this stretch [m]."""
YAWS: tuple[float, ...] = tuple(np.radians(np.arange(-60.0, 61.0, 15.0)).tolist())
"""Of the hand against the door's normal [rad]: further round, the fingers would slip off the bar."""
YAW_COST = 0.3
"""A turn of the hand about the bar counts as that of this many joints."""
ATTITUDES = tuple((pitch, roll) for pitch in np.radians((0.0, 25.0)) for roll in (np.pi, 0.0))
"""Pitch of the hand and which way up it is [rad]; both stay as they are during a swing."""
REACHES = 4
"""Arm configurations tried at a bar, where the straight way to it is blocked."""


@dataclass(frozen=True, eq=False)
class _Pull:
    """A way to swing a door as far as it has been followed: how the hand came to the bar, the arm `(dof,)` [rad] and the hand's yaw
    [rad] at each waypoint so far, and what that cost."""

    reach: Segment
    path: tuple[Array, ...]
    yaws: tuple[float, ...]
    cost: float


@dataclass(frozen=True, eq=False)
class _Puller:
    """Looks for ways to swing a door from `state` with the hand at one attitude: its pitch down [rad], and which way up it is."""

    workspace: Workspace
    state: State
    door: Door
    pitch: float
    roll: float

    def hand(self, yaw: float, angle: float) -> Pose:
        """`base_from_tcp` at the bar of the door open by `angle`, turned by `yaw` against the door's normal [rad]."""
        frame = self.door.pose(angle)
        turn = quat_mul(quat_from_rotvec((0.0, 0.0, yaw)), self._attitude)
        return Pose(frame.transform(np.array(self.door.bar.pos)), quat_mul(frame.quat, turn))

    @cached_property
    def _attitude(self) -> Array:
        """The hand's orientation `(4,) wxyz` at a door that is shut, at no yaw."""
        # columns: tcp x (up, or down), y (closing, level), z (approaching: into the door)
        axes = np.array([[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0]])
        pitched = quat_mul(quat_from_rotvec((0.0, self.pitch, 0.0)), quat_from_matrix(axes))
        return quat_mul(pitched, quat_from_rotvec((0.0, 0.0, self.roll)))

    def swings(self, stretches: list[Array], straight: bool, rng: np.random.Generator) -> Iterator[Refinement]:
        """Whole swings through `stretches` of angles [rad], the cheapest first: dynamic programming over the hand's yaw, each way
        followed as the controller will do it, null space and all. `straight`: how the hand comes to the bar."""
        pulls = self._reaches(straight, rng)
        for stretch in stretches:
            pulls = self._carried_on(stretch, pulls)
        angles = np.concatenate([stretches[0][:1], *[stretch[1:] for stretch in stretches]])
        for pull in sorted(pulls, key=lambda p: p.cost):
            found = self._whole(angles, pull, rng)
            if found is not None:
                yield found

    def _reaches(self, straight: bool, rng: np.random.Generator) -> list[_Pull]:
        """Ways for the open hand to come to the bar, one a yaw at most: straight, or about by joints."""
        found = []
        for yaw in YAWS:
            reach = self._straight_to(yaw, rng) if straight else self._about_to(yaw, rng)
            if reach is not None:
                turned = float(np.square(reach.q[-1] - self.state.q).sum())
                found.append(_Pull(reach, (reach.q[-1],), (yaw,), turned))
        return found

    def _straight_to(self, yaw: float, rng: np.random.Generator) -> Segment | None:
        goal = self.hand(yaw, self.state.doors[self.door.name])
        return self.workspace.travel("reach", self.state, [_before(goal), goal], False, rng)

    def _about_to(self, yaw: float, rng: np.random.Generator) -> Segment | None:
        goal = self.hand(yaw, self.state.doors[self.door.name])
        for q in islice(self.workspace.kinematics.solutions(goal, self.state.q), REACHES):
            reach = self.workspace.travel_to("reach", self.state, q, _before(goal), rng)
            if reach is not None:
                return reach
        return None

    def _carried_on(self, angles: Array, pulls: list[_Pull]) -> list[_Pull]:
        """The pulls carried on through `angles` [rad], the hand turning about the bar or not: for every yaw it can end with, the
        one that costs least."""
        best: dict[int, _Pull] = {}
        for pull in pulls:
            i = YAWS.index(pull.yaws[-1])
            for j in range(max(0, i - 1), min(len(YAWS), i + 2)):
                longer = self._followed(angles, pull, YAWS[j])
                if longer is not None and (j not in best or longer.cost < best[j].cost):
                    best[j] = longer
        return [best[j] for j in sorted(best)]

    def _followed(self, angles: Array, pull: _Pull, yaw: float) -> _Pull | None:
        kinematics, checker = self.workspace.kinematics, self.workspace.checker
        path, yaws = list(pull.path), list(pull.yaws)
        grasping = replace(self.state, opening=2 * self.door.bar.radius)
        for angle, now in zip(angles[1:].tolist(), np.linspace(yaws[-1], yaw, len(angles))[1:].tolist(), strict=True):
            q = kinematics.refine(path[-1], self.hand(now, angle))
            if q is None or np.abs(q - path[-1]).max() > SMOOTH_STEP:
                self.workspace.failures.append(("swing", UNREACHABLE))
                return None
            checker.look_at(grasping.swung(self.door.name, angle), pulled=self.door.name)
            blocked = checker.check(q)
            if blocked is not None:
                self.workspace.failures.append(("swing", blocked))
                return None
            path.append(q)
            yaws.append(now)
        moved = float(np.square(path[-1] - pull.path[-1]).sum()) + YAW_COST * (yaw - pull.yaws[-1]) ** 2
        return _Pull(pull.reach, tuple(path), (*yaws[:-1], yaw), pull.cost + moved)

    def _whole(self, angles: Array, pull: _Pull, rng: np.random.Generator) -> Refinement | None:
        """A swing with its approach and its retreat; None, and an entry in `failures`, if the hand cannot leave."""
        workspace, reach, q = self.workspace, pull.reach, np.array(pull.path)
        poses = tuple(self.hand(yaw, angle) for yaw, angle in zip(pull.yaws, angles.tolist(), strict=True))
        swing = workspace.motion("swing", q, poses, True, PULL_SPEED)
        swing = replace(swing, steady=True, doors={self.door.name: angles})
        left = replace(self.state, q=q[-1], tcp=swing.end, opening=workspace.open_width)
        left = left.swung(self.door.name, float(angles[-1]))
        workspace.checker.look_at(left, pulled=self.door.name)
        blocked = workspace.checker.check(q[-1])
        if blocked is not None:
            workspace.failures.append(("let go", blocked))
            return None
        away = _before(swing.end)
        retreat = workspace.travel("retreat", left, [away], False, rng)
        if retreat is None:
            return None
        close, let_go = gripper_action("close", q[0], reach.end, True), gripper_action("open", q[-1], swing.end, False)
        return (reach, close, swing, let_go, retreat), replace(left, q=retreat.q[-1], tcp=away)


def _before(goal: Pose) -> Pose:
    """Where the hand comes to a bar from, and goes to."""
    return goal.shifted(-STANDOFF * goal.matrix[:, 2])


class _Swing:
    """What Open and Close share."""

    name: ClassVar[str]
    target: ClassVar[float]

    def refine(
        self, workspace: Workspace, state: State, args: tuple[str, ...], rng: np.random.Generator
    ) -> Iterator[Refinement]:
        door = workspace.scene.door(args[0])
        knots = _evenly(state.doors[door.name], self.target, KNOT)
        stretches = [_evenly(a, b, SWING_STEP) for a, b in pairwise(knots.tolist())]
        if _barred(workspace, state, door, np.concatenate(stretches)):
            return
        for straight, (pitch, roll) in product((True, False), ATTITUDES):
            yield from _Puller(workspace, state, door, pitch, roll).swings(stretches, straight, rng)

    def operators_for(self, scene: Scene, makes: Predicate, undoes: Predicate) -> Iterator[Operator]:
        for door in (d.name for d in scene.doors):
            yield Operator(
                skill=self.name,
                args=(door,),
                needs=frozenset({HandEmpty()}),
                adds=frozenset({makes(door), HandEmpty()}),
                deletes=frozenset({undoes(door)}),
            )


def _evenly(begin: float, end: float, step: float) -> Array:
    """From `begin` to `end`, both included, no further apart than `step`."""
    return np.linspace(begin, end, max(2, int(np.ceil(abs(end - begin) / step)) + 1))


def _barred(workspace: Workspace, state: State, door: Door, angles: Array) -> bool:
    """Whether something stands in the door's own way, however the arm may take it; if so, it is added to `failures`."""
    for angle in angles.tolist():
        workspace.checker.look_at(state.swung(door.name, angle), pulled=door.name)
        blocked = workspace.checker.check(state.q)
        if blocked is not None and "robot" not in (blocked.a, blocked.b):
            workspace.failures.append(("swing", blocked))
            return True
    return False


class OpenDoor(_Swing):
    """open(door)"""

    name: ClassVar[str] = "open"
    target: ClassVar[float] = OPEN_TO

    def operators(self, scene: Scene, facts: Facts) -> Iterator[Operator]:
        return self.operators_for(scene, Open, Shut)


class CloseDoor(_Swing):
    """close(door)"""

    name: ClassVar[str] = "close"
    target: ClassVar[float] = SHUT_AT

    def operators(self, scene: Scene, facts: Facts) -> Iterator[Operator]:
        return self.operators_for(scene, Shut, Open)
