"""`PlanFollower`: the agent that carries a plan out, looking only at what any agent sees."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from optimus.control import CONTROL_HZ, JOINT_SCALE, SCALE, require_control
from optimus.data.episode import BINARY, CONTINUOUS, Observation
from optimus.errors import UnknownNameError, require_at_least, require_finite
from optimus.motion.lines import distance
from optimus.motion.path import JointPath, Path, PosePath
from optimus.motion.plan import Plan, Segment
from optimus.se3 import Array, Pose, quat_from_rotvec, quat_mul


@dataclass(frozen=True)
class TimeLaw:
    """How fast, as a function of where the arm is on its path: fast along it, slow towards a grasp or a release."""

    speed: float = 0.35
    """[m/s]; a turn of one radian counts as `lines.TURN_WEIGHT` metres."""
    slowest: float = 0.04
    """... at the end of a path [m/s]."""
    braking: float = 4.0
    """Near the end the speed grows by this much a metre [1/s]."""
    arrived: float = 0.006
    """The tcp has arrived within this distance [m]."""
    recovery: float = 0.4
    """Off its path, the expert makes good this share of the offset each step."""
    patience_offset: float = 0.03
    """... and goes on along the path only as far as it is nearer to it than this [m]: align first, then descend."""
    stall: int = 5
    """Steps for which the gripper alone acts."""
    gripper: Literal["binary", "continuous"] = "binary"
    """The gripper is told to be open or shut, or where to be: over the stall, from one to the other. `ManipulationEnv` has to
    understand it the same way."""
    patience: int = 12
    """Steps to wait for the tcp to arrive that well; after them, `arrived_late` will do."""
    arrived_late: float = 0.015
    """[m]"""
    passed: float = 0.035
    """A skill's last motion is over when the tcp is this near to its end, other motions when the target is there [m]."""
    finger_motion: float = 0.004
    """A gripper action counts as done only when the opening has changed by this much [m]."""

    def __post_init__(self) -> None:
        if self.gripper not in (BINARY, CONTINUOUS):
            raise UnknownNameError("gripper", self.gripper, (BINARY, CONTINUOUS))
        require_at_least(0, stall=self.stall)
        require_at_least(self.slowest, speed=self.speed)
        require_finite(speed=self.speed)


class Steering(Protocol):
    """How a plan is followed under one kind of control: what its target is, and the path of a segment for it."""

    @property
    def scale(self) -> Array | float:
        """What an action of 1 stands for [m, rad]."""
        ...

    def target(self, observation: Observation) -> Array:
        """The controller's target, from what is seen."""
        ...

    def path(self, segment: Segment) -> Path:
        """The segment, for such targets."""
        ...


class PoseSteering:
    """The target is a pose `(7,)`, as `PosePath` takes it."""

    scale = SCALE

    def target(self, observation: Observation) -> Array:
        tcp, missing = tcp_of(observation), observation["robot0_target_error"].astype(np.float64)
        return np.concatenate([tcp.pos + missing[:3], quat_mul(quat_from_rotvec(missing[3:]), tcp.quat)])

    def path(self, segment: Segment) -> Path:
        return PosePath(segment)


class JointSteering:
    """The target is a configuration `(dof,)` [rad]."""

    scale = JOINT_SCALE

    def target(self, observation: Observation) -> Array:
        return observation["robot0_joint_pos"].astype(np.float64) + observation["robot0_joint_target_error"]

    def path(self, segment: Segment) -> Path:
        return JointPath(segment)


STEERING: dict[str, Steering] = {"osc": PoseSteering(), "ik": PoseSteering(), "joint": JointSteering()}
"""By control."""


class PlanFollower:
    """Follows a plan's segments one by one. Its answer depends on where the target is on the path, not on the time: pushed off,
    it comes back to the nearest point of the path and goes on from there."""

    def __init__(self, plan: Plan, law: TimeLaw | None = None, control: str = "osc") -> None:
        self.plan, self.law = plan, law or TimeLaw()
        self._steering = STEERING[require_control(control)]
        self._segments = plan.segments
        self._paths = [self._steering.path(segment) for segment in self._segments]
        self._ends = [int(n) - 1 for n in np.cumsum([len(step.segments) for step in plan.steps])]
        """The index of each skill's last segment."""
        self._index = -1
        self._opening = 0.0
        """Between the fingers when the present segment began [m]."""
        self.errors: list[float] = []
        """Distance of the tcp from the planned path at each step of motion [m]."""
        self._next_segment()

    @property
    def segment(self) -> Segment | None:
        """What it is doing; None when the plan is done."""
        return self._segments[self._index] if self._index < len(self._segments) else None

    @property
    def _path(self) -> Path:
        return self._paths[self._index]

    @property
    def steps_done(self) -> int:
        """How many skills are complete."""
        return sum(self._index > end for end in self._ends)

    @property
    def progress(self) -> float:
        """How far it is along the present segment [m]."""
        return self._s

    def slack(self, steady: float) -> float:
        """How much a push may matter now, 0 to 1: nothing while the gripper works, little right before it does, `steady` while it
        has hold of what is not free to come along, else all."""
        segment = self.segment
        if segment is None or segment.gripper_action:
            return 0.0
        left, most = self._path.length - self._s, steady if segment.steady else 1.0
        return most * (min(1.0, left / 0.10) if self._stops_at_end() else 1.0)

    def _next_segment(self) -> None:
        self._index += 1
        self._s, self._waited = 0.0, 0

    def _stops_at_end(self) -> bool:
        following = self._segments[self._index + 1 : self._index + 2]
        return bool(following and following[0].gripper_action)

    def act(self, observation: Observation) -> NDArray[np.float32] | None:
        """The action for this observation, the gripper last; None when the plan is done."""
        tcp, target = tcp_of(observation), self._steering.target(observation)
        opening = float(np.abs(observation["robot0_gripper_qpos"]).sum())
        while self._finished(tcp, opening):
            self._next_segment()
            self._opening = opening
        segment = self.segment
        if segment is None:
            return None
        if segment.gripper_action:
            # the stall is counted from when the fingers move: the gripper may be late
            late = self._waited == 1 and self.law.gripper == BINARY and not self._moved(opening)
            self._waited += not late
            delta = self._path.delta(target, self._path.length)
        else:
            delta = self._advance(target, tcp, min(segment.speed, self.law.speed))
            self.errors.append(self._gap(tcp))
        arm = np.clip(delta / self._steering.scale, -1.0, 1.0)
        return np.array([*arm, self._gripper(segment)], np.float32)

    def _moved(self, opening: float) -> bool:
        """Whether the fingers have opened or shut since the present segment began."""
        return abs(opening - self._opening) > self.law.finger_motion

    def _gripper(self, segment: Segment) -> float:
        """What the gripper is told: -1 open, 1 shut."""
        told = 1.0 if segment.shut else -1.0
        if self.law.gripper == "binary" or not segment.gripper_action:
            return told
        return told * min(1.0, 2.0 * self._waited / max(self.law.stall, 1) - 1.0)

    def _gap(self, tcp: Pose) -> float:
        """The distance of the tcp from the planned path [m]: it may still be on the last stretch of the segment before."""
        here = self._path.gap(tcp, self._s)
        before = self._paths[self._index - 1] if self._index > 0 else None
        return here if before is None else min(here, before.gap(tcp, before.length))

    def _advance(self, target: Array, tcp: Pose, speed: float) -> Array:
        """Go on along the path as the law says; the change of the target, in SI units."""
        law, path = self.law, self._path
        self._s = path.nearest(target, self._s, window=0.04)
        offset = path.offset(target, self._s)
        if self._stops_at_end():
            speed = min(speed, law.slowest + law.braking * (path.length - self._s))
        speed *= max(0.0, 1.0 - path.away(offset, tcp, self._s) / law.patience_offset)
        self._s = min(path.length, self._s + speed / CONTROL_HZ)
        self._waited += self._s >= path.length
        return path.delta(target, self._s, (1.0 - law.recovery) * offset)

    def _finished(self, tcp: Pose, opening: float) -> bool:
        segment, law = self.segment, self.law
        if segment is None:
            return False
        if segment.gripper_action:
            # somebody else may have had the last word on what was done: the fingers must really have moved
            return self._waited >= law.stall and self._moved(opening)
        if self._s < self._path.length:
            return False
        if not self._stops_at_end():
            return self._index not in self._ends or distance(segment.end, tcp) < law.passed
        near = law.arrived if self._waited < law.patience else law.arrived_late
        return distance(segment.end, tcp) < near


def tcp_of(observation: Observation) -> Pose:
    """`base_from_tcp`, as it is seen."""
    x, y, z, w = observation["robot0_eef_quat"].astype(np.float64)
    return Pose(observation["robot0_eef_pos"].astype(np.float64), np.array([w, x, y, z]))
