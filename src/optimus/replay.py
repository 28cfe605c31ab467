"""`Replay`: the world as it follows from a start and motions alone, on a model of its own; no declared state is believed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import lru_cache

import mujoco
import numpy as np

from optimus.motion.plan import Segment
from optimus.scene import Scene
from optimus.se3 import Array, Pose
from optimus.state import Held, State
from optimus.world import World

OPENING_STEP = 0.002
"""The fingers shut in steps of this until they meet something from both sides [m]."""
TOUCH = 0.001
"""A contact shallower than this is no collision [m]."""
SUPPORT_TOUCH = 0.003
"""Likewise between the thing in the hand and what it is taken off or put on, into which its weight has pressed it [m]."""


@dataclass(frozen=True)
class Contact:
    """Two things that meet (`robot` for any of its links), in alphabetical order, and how deep [m]."""

    a: str
    b: str
    depth: float


@lru_cache(maxsize=4)
def _own_world(scene: Scene) -> World:
    """Compiled apart from the planner's, so that nothing which was done to that one is believed."""
    return World(scene)


class Replay:
    """Motions carried out one after another, kinematically. `state` is what they have led to so far."""

    def __init__(self, scene: Scene, start: State) -> None:
        self.world, self.state = _own_world(scene), start
        self._data = mujoco.MjData(self.world.model)
        self._gripped: int | None = None if start.held is None else self.world.body_ids[start.held.name]
        """The body between the fingers."""
        self._swung: frozenset[int] = frozenset()
        """The doors that the present motion swings."""

    def place(self, segment: Segment, at: float) -> Pose:
        """Bring the world to waypoint `at` of `segment`, fractions being between two: the arm, the fingers, the doors that swing,
        and what is held, which follows the hand. Everything else stays where it was left. Gives `base_from_tcp`."""
        world, data = self.world, self._data
        world.write_qpos(data, replace(self.state, q=_between(segment.q, at), doors=self._doors(segment, at)))
        mujoco.mj_kinematics(world.model, data)
        tcp = world.tcp(data)
        if self.state.held is not None:
            pose, address = tcp @ self.state.held.tcp_from_object, world.movable_qpos[self.state.held.name]
            data.qpos[address : address + 7] = [*pose.pos, *pose.quat]
            mujoco.mj_kinematics(world.model, data)
        self._swung = frozenset(world.body_ids[name] for name in segment.doors)
        return tcp

    @property
    def qpos(self) -> Array:
        """MuJoCo's positions `(nq,)` where the world was last placed."""
        return self._data.qpos.copy()

    def _doors(self, segment: Segment, at: float) -> dict[str, float]:
        """How far each door is open [rad]: as it was left, unless the segment swings it."""
        return {**self.state.doors, **{name: float(_between(angles, at)) for name, angles in segment.doors.items()}}

    def finish(self, segment: Segment) -> None:
        """Let `state` be the end of a motion, or of what the gripper did."""
        if segment.gripper_action:
            self._work_gripper(segment)
        tcp = self.place(segment, len(segment.q) - 1)
        poses = {name: self.world.object_pose(self._data, name) for name in self.state.poses}
        doors = self._doors(segment, len(segment.q) - 1)
        self.state = replace(self.state, q=segment.q[-1], tcp=tcp, poses=poses, doors=doors)

    def _work_gripper(self, segment: Segment) -> None:
        """Shut the fingers until something is between them, or open them wide."""
        self._gripped = None
        if not segment.shut:
            self.state = replace(self.state, held=None, opening=2 * self.world.scene.robot.finger_travel)
            return
        tcp = self.state.tcp
        steps = int(np.ceil(self.state.opening / OPENING_STEP)) + 1
        for opening in np.linspace(self.state.opening, 0.0, steps):
            self.state = replace(self.state, opening=float(opening))
            tcp = self.place(segment, 0)
            mujoco.mj_collision(self.world.model, self._data)
            self._gripped = self._between_fingers()
            if self._gripped is not None:
                break
        name = None if self._gripped is None else self.world.body_names.get(self._gripped)
        if name in self.state.poses:
            self.state = replace(self.state, held=Held(name, tcp.inverse @ self.state.poses[name]))

    def _between_fingers(self) -> int | None:
        """The body that both fingers touch, if there is one."""
        touching: dict[int, set[int]] = {}
        for a, b, _ in self._pairs():
            for finger, other in ((a, b), (b, a)):
                if finger in self.world.finger_bodies and other not in self.world.robot_bodies:
                    touching.setdefault(other, set()).add(finger)
        return next((body for body, fingers in sorted(touching.items()) if len(fingers) == 2), None)

    def _pairs(self) -> Iterator[tuple[int, int, float]]:
        """Bodies in contact as of the last collision detection, and how deep [m]."""
        contact, n = self._data.contact, self._data.ncon
        bodies = self.world.model.geom_bodyid[contact.geom[:n]]
        for (a, b), gap in zip(bodies, contact.dist[:n], strict=True):
            yield int(a), int(b), -float(gap)

    def collisions(self, supports: tuple[str, ...]) -> Iterator[Contact]:
        """What meets that should not, where the world was last placed; the thing in the hand may touch `supports`."""
        mujoco.mj_collision(self.world.model, self._data)
        for a, b, depth in self._pairs():
            if depth > self._allowed(a, b, supports):
                first, second = sorted((self._name(a), self._name(b)))
                yield Contact(first, second, depth)

    def _allowed(self, a: int, b: int, supports: tuple[str, ...]) -> float:
        """How deep two bodies may meet [m]."""
        world, moved = self.world, self._swung | ({self._gripped} - {None})
        if not {a, b} & (world.robot_bodies | moved):
            return np.inf  # none of the robot's doing
        fingers = {*world.finger_bodies}
        if {a, b} & fingers and {a, b} <= fingers | moved:
            return np.inf
        if self._gripped in (a, b):
            other = world.body_names.get(b if a == self._gripped else a)
            return SUPPORT_TOUCH if other in supports else TOUCH
        return TOUCH

    def _name(self, body: int) -> str:
        return self.world.body_names.get(body, "robot" if body in self.world.robot_bodies else "world")


def _between(values: Array, at: float) -> Array:
    """The row of `values` `(T, ...)` at a fractional index."""
    i = min(int(at), len(values) - 1)
    return values[i] if i == at else values[i] + (at - i) * (values[i + 1] - values[i])
