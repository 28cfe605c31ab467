"""Open and Close: take a door by its bar and swing it. The hand is free to turn about the bar: held rigidly to the door, hardly any
arm could follow it through a right angle."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import ClassVar

import numpy as np

from optimus.logic import Facts, Operator, Predicate
from optimus.motion.chain import Edge, smoothest_chain
from optimus.motion.lines import UNREACHABLE
from optimus.motion.plan import Segment
from optimus.predicates import HandEmpty, Open, Shut
from optimus.scene import Door, Scene
from optimus.se3 import Array, Pose, quat_from_matrix, quat_from_rotvec, quat_mul
from optimus.skills.skill import Refinement, Workspace, gripper_action
from optimus.state import State

KNOT, SWING_STEP = 0.21, 0.05
"""Between the angles at which the arm's configuration is chosen, and between the waypoints of a swing [rad]."""
LONGEST_STEP = 0.8
"""No joint turns further from one chosen configuration to the next [rad]."""
SMOOTH_STEP = 0.2
"""Nor from one waypoint to the next: more is a turn of the elbow in which the hand would stray from the bar [rad]."""
OPEN_TO, SHUT_AT = 1.45, 0.0
"""Where a door is left [rad]."""
PULL_SPEED = 0.20
"""[m/s]; a swing of 1.45 rad at 0.45 m takes some four seconds."""
STANDOFF = 0.12
"""The hand approaches and leaves a bar along this stretch [m]."""
YAWS = tuple(np.radians((-60.0, -40.0, -20.0, 0.0, 20.0, 40.0, 60.0)))
"""Of the hand against the door's normal [rad]: further round, the fingers would slip off the bar."""
ATTITUDES = tuple((pitch, roll) for pitch in np.radians((0.0, 25.0)) for roll in (np.pi, 0.0))
"""Pitch of the hand and which way up it is [rad]; both stay as they are during a swing."""
REPAIRS = 12
"""Chains tried where the motion between two chosen configurations turns out to be blocked."""


@dataclass(frozen=True)
class _Grip:
    """How a hand takes an upright bar: its yaw against the door's normal, its pitch down [rad], and which way up it is."""

    yaw: float
    pitch: float
    roll: float

    def pose(self, door: Door, angle: float) -> Pose:
        """`base_from_tcp` at the bar of a door open by `angle` [rad]."""
        frame = door.pose(angle)
        # columns: tcp x (up, or down), y (closing, level), z (approaching: into the door)
        hand = np.array([[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0]])
        turn = quat_mul(quat_from_rotvec((0.0, 0.0, self.yaw)), quat_from_rotvec((0.0, self.pitch, 0.0)))
        about = quat_mul(quat_from_matrix(hand), quat_from_rotvec((0.0, 0.0, self.roll)))
        return Pose(frame.transform(np.array(door.bar.pos)), quat_mul(frame.quat, quat_mul(turn, about)))


@dataclass(frozen=True, eq=False)
class _Choices:
    """The free configurations `(n, dof)` [rad] at one angle of the door, and the hand's yaw in each [rad]."""

    angle: float
    q: Array
    yaws: list[float]


class _Swing:
    """What Open and Close share."""

    name: ClassVar[str]
    target: ClassVar[float]

    def refine(
        self, workspace: Workspace, state: State, args: tuple[str, ...], rng: np.random.Generator
    ) -> Iterator[Refinement]:
        door = workspace.scene.door(args[0])
        begin = state.doors[door.name]
        angles = np.linspace(begin, self.target, max(2, int(np.ceil(abs(self.target - begin) / KNOT)) + 1))
        grasping, wide = replace(state, opening=2 * door.bar.radius), replace(state, opening=workspace.open_width)
        for pitch, roll in ATTITUDES:
            # at both ends the hand is open for a while
            hands = [wide, *[grasping] * (len(angles) - 2), wide]
            layers = [_choices(workspace, h, door, float(a), pitch, roll) for h, a in zip(hands, angles, strict=True)]
            forbidden: set[Edge] = set()
            far = [float(np.square(q - state.q).sum()) for q in layers[0].q]
            for _ in range(REPAIRS):
                chain = smoothest_chain([layer.q for layer in layers], LONGEST_STEP, forbidden, np.array(far))
                if chain is None:
                    break
                start = layers[0].q[chain[0]]
                reach = _reach(workspace, state, door, _Grip(layers[0].yaws[chain[0]], pitch, roll), start, float(begin), rng)
                if reach is None:
                    far[chain[0]] = np.inf  # another way to begin
                    continue
                swing = _swing(workspace, replace(grasping, q=reach.q[-1]), door, layers, chain, (pitch, roll))
                if isinstance(swing, int):
                    forbidden.add((swing, chain[swing], chain[swing + 1]))
                    continue
                found = _whole(workspace, state, door, reach, swing, rng)
                if found is not None:
                    yield found
                far[chain[0]] = np.inf

    def operators_for(self, scene: Scene, makes: Predicate, undoes: Predicate) -> Iterator[Operator]:
        for door in (d.name for d in scene.doors):
            yield Operator(
                skill=self.name,
                args=(door,),
                needs=frozenset({HandEmpty()}),
                adds=frozenset({makes(door), HandEmpty()}),
                deletes=frozenset({undoes(door)}),
            )


def _choices(workspace: Workspace, state: State, door: Door, angle: float, pitch: float, roll: float) -> _Choices:
    """Every free way for the arm to hold the bar of the door at `angle`, over the hand's yaws."""
    workspace.checker.look_at(state.swung(door.name, angle), pulled=door.name)
    found, yaws = [], []
    for yaw in YAWS:
        for q in workspace.kinematics.ways(_Grip(yaw, pitch, roll).pose(door, angle), state.q):
            blocked = workspace.checker.check(q)
            if blocked is None:
                found.append(q)
                yaws.append(yaw)
            else:
                workspace.failures.append(("swing", blocked))
    if not found:
        workspace.failures.append(("swing", UNREACHABLE))
    return _Choices(angle, np.array(found).reshape(-1, len(state.q)), yaws)


def _reach(
    workspace: Workspace, state: State, door: Door, grip: _Grip, q: Array, angle: float, rng: np.random.Generator
) -> Segment | None:
    start = grip.pose(door, angle)
    return workspace.travel_to("reach", state, q, start.shifted(-STANDOFF * start.matrix[:, 2]), rng)


def _swing(
    workspace: Workspace, state: State, door: Door, layers: list[_Choices], chain: list[int], attitude: tuple[float, float]
) -> Segment | int:
    """The motion through the chosen poses of the hand, beginning as the arm is in `state`; or the number of the stretch that is
    blocked."""
    begin = layers[0].angle
    path, angles = [state.q], [begin]
    poses = [_Grip(layers[0].yaws[chain[0]], *attitude).pose(door, begin)]
    for k, (here, there) in enumerate(pairwise(zip(layers, chain, strict=True))):
        ends = np.array([(layer.angle, layer.yaws[i]) for layer, i in (here, there)])
        steps = max(1, int(np.ceil(abs(ends[1, 0] - ends[0, 0]) / SWING_STEP)))
        for share in np.linspace(0.0, 1.0, steps + 1)[1:]:
            angle, yaw = (float(v) for v in (1 - share) * ends[0] + share * ends[1])
            pose = _Grip(yaw, *attitude).pose(door, angle)
            q = workspace.kinematics.refine(path[-1], pose)
            if q is None or np.abs(q - path[-1]).max() > SMOOTH_STEP:
                return k
            workspace.checker.look_at(state.swung(door.name, angle), pulled=door.name)
            if workspace.checker.check(q) is not None:
                return k
            path.append(q)
            poses.append(pose)
            angles.append(angle)
    doors = {door.name: np.array(angles)}
    swing = workspace.motion("swing", np.array(path), tuple(poses), True, PULL_SPEED)
    return replace(swing, steady=True, doors=doors)


def _whole(
    workspace: Workspace, state: State, door: Door, reach: Segment, swing: Segment, rng: np.random.Generator
) -> Refinement | None:
    """A swing with its approach and its retreat; None, and an entry in `failures`, if the hand cannot leave."""
    end, angle = swing.end, float(swing.doors[door.name][-1])
    left = replace(state, q=swing.q[-1], tcp=end, opening=workspace.open_width).swung(door.name, angle)
    workspace.checker.look_at(left, pulled=door.name)
    blocked = workspace.checker.check(swing.q[-1])
    if blocked is not None:
        workspace.failures.append(("let go", blocked))
        return None
    away = end.shifted(-STANDOFF * end.matrix[:, 2])
    retreat = workspace.travel("retreat", left, [away], False, rng)
    if retreat is None:
        return None
    close, let_go = gripper_action("close", reach.q[-1], reach.end, True), gripper_action("open", swing.q[-1], end, False)
    return (reach, close, swing, let_go, retreat), replace(left, q=retreat.q[-1], tcp=away)


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
