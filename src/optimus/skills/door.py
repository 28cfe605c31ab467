"""Open and Close: take a door by its bar and swing it. The hand is free to turn about the bar: held rigidly to the door, hardly any
arm could follow it through a right angle."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from optimus.collision import Blocked
from optimus.logic import Facts, Operator
from optimus.motion.lines import MAX_JOINT_STEP, UNREACHABLE
from optimus.motion.plan import Segment
from optimus.predicates import HandEmpty, Open, Shut
from optimus.scene import Door, Scene
from optimus.se3 import Pose, quat_from_matrix, quat_from_rotvec, quat_mul
from optimus.skills.skill import Refinement, Workspace, gripper_action
from optimus.state import State

SWING_STEP = 0.05
"""Between the waypoints of a swing [rad]."""
OPEN_TO, SHUT_AT = 1.65, 0.0
"""Where a door is left [rad]."""
MOST_TURN = np.radians(75.0)
"""The hand stays within this of the door's normal: further round, the fingers would slip off the bar [rad]."""
PULL_SPEED = 0.20
"""[m/s]; a swing of 1.65 rad at 0.45 m takes some four seconds."""
STANDOFF = 0.12
"""The hand approaches and leaves a bar along this stretch [m]."""
YAWS = tuple(np.radians((0.0, -20.0, 20.0, -45.0, 45.0, -65.0, 65.0)))
PITCHES = tuple(np.radians((0.0, 25.0)))


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


class _Swing:
    """What Open and Close share."""

    name: ClassVar[str]
    target: ClassVar[float]

    def refine(
        self, workspace: Workspace, state: State, args: tuple[str, ...], rng: np.random.Generator
    ) -> Iterator[Refinement]:
        door = workspace.scene.door(args[0])
        for grip in self._grips(workspace, door, state.doors[door.name]):
            start = grip.pose(door, state.doors[door.name])
            back = start.shifted(-STANDOFF * start.matrix[:, 2])
            reach = workspace.travel("reach", state, [back, start], False, rng, straight=1)
            if reach is None:
                continue
            taken = replace(state, q=reach.q[-1], tcp=start, opening=2 * door.bar.radius)
            swing = self._swing(workspace, taken, door)
            if isinstance(swing, Blocked):
                workspace.failures.append(("swing", swing))
                continue
            end, angle = swing.end, float(swing.doors[door.name][-1])
            left = replace(taken, q=swing.q[-1], tcp=end, opening=workspace.open_width).swung(door.name, angle)
            away = end.shifted(-STANDOFF * end.matrix[:, 2])
            retreat = workspace.travel("retreat", left, [away], False, rng)
            if retreat is None:
                continue
            after = replace(left, q=retreat.q[-1], tcp=away)
            close, let_go = gripper_action("close", reach.q[-1], start, True), gripper_action("open", swing.q[-1], end, False)
            yield (reach, close, swing, let_go, retreat), after

    def _grips(self, workspace: Workspace, door: Door, angle: float) -> list[_Grip]:
        grips = [_Grip(yaw, pitch, roll) for pitch in PITCHES for yaw in YAWS for roll in (0.0, np.pi)]
        return sorted(grips, key=lambda g: round(workspace.turn_from_home(g.pose(door, angle)), 6))

    def _swing(self, workspace: Workspace, state: State, door: Door) -> Segment | Blocked:
        """The arm's path with the door in its hand, from where it is to the target."""
        begin = state.doors[door.name]
        steps = max(2, int(np.ceil(abs(self.target - begin) / SWING_STEP)))
        angles = np.linspace(begin, self.target, steps + 1)
        bar_in_door, path, poses = np.array(door.bar.pos), [state.q], [state.tcp]
        for angle in angles[1:]:
            point = door.pose(float(angle)).transform(bar_in_door)
            q = workspace.kinematics.turn_about(path[-1], Pose(point, poses[-1].quat))
            if q is None or np.abs(q - path[-1]).max() > MAX_JOINT_STEP:
                return UNREACHABLE
            pose = workspace.kinematics.fk(q)
            normal = door.pose(float(angle)).matrix[:, 0]
            heading = pose.matrix[:2, 2] / np.linalg.norm(pose.matrix[:2, 2])
            if heading @ normal[:2] < np.cos(MOST_TURN):
                return UNREACHABLE
            workspace.checker.look_at(state.swung(door.name, float(angle)), pulled=door.name)
            blocked = workspace.checker.check(q)
            if blocked is not None:
                return blocked
            path.append(q)
            poses.append(Pose(point, pose.quat))
        return Segment(
            "swing", np.array(path), tuple(poses), True, speed=PULL_SPEED, steady=True, doors={door.name: angles}
        )


class OpenDoor(_Swing):
    """open(door)"""

    name: ClassVar[str] = "open"
    target: ClassVar[float] = OPEN_TO

    def operators(self, scene: Scene, facts: Facts) -> Iterator[Operator]:
        for door in (d.name for d in scene.doors):
            yield Operator(
                skill=self.name,
                args=(door,),
                needs=frozenset({HandEmpty()}),
                adds=frozenset({Open(door), HandEmpty()}),
                deletes=frozenset({Shut(door)}),
            )


class CloseDoor(_Swing):
    """close(door)"""

    name: ClassVar[str] = "close"
    target: ClassVar[float] = SHUT_AT

    def operators(self, scene: Scene, facts: Facts) -> Iterator[Operator]:
        for door in (d.name for d in scene.doors):
            yield Operator(
                skill=self.name,
                args=(door,),
                needs=frozenset({HandEmpty()}),
                adds=frozenset({Shut(door), HandEmpty()}),
                deletes=frozenset({Open(door)}),
            )

