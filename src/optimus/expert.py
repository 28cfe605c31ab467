"""`PlanFollower`: the agent that carries a plan out, looking only at what any agent sees."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from optimus.control import CONTROL_HZ, SCALE
from optimus.data.episode import Observation
from optimus.motion.lines import TURN_WEIGHT, distance
from optimus.motion.plan import Plan, Segment
from optimus.se3 import Array, Pose, error_between, interpolate, quat_from_rotvec, quat_mul


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
    patience: int = 12
    """Steps to wait for the tcp to arrive that well; after them, `arrived_late` will do."""
    arrived_late: float = 0.015
    """[m]"""
    passed: float = 0.035
    """A skill's last motion is over when the tcp is this near to its end, other motions when the target is there [m]."""
    finger_motion: float = 0.004
    """A gripper action counts as done only when the opening has changed by this much [m]."""


class _Path:
    """A segment's poses as a polyline, with the length up to each; turns count by `TURN_WEIGHT`, as in `distance`."""

    def __init__(self, segment: Segment) -> None:
        self.poses = segment.poses
        steps = [distance(a, b) for a, b in pairwise(self.poses)]
        self.at = np.concatenate([[0.0], np.cumsum(steps)])
        self.length = float(self.at[-1])
        self._points = np.array([self._point(pose) for pose in self.poses])

    def _point(self, pose: Pose) -> Array:
        """A pose as a point `(6,)`: position, and the turn from the end of the path in metres."""
        turn = error_between(pose, self.poses[-1])[3:]
        return np.concatenate([pose.pos, TURN_WEIGHT * turn])

    def pose(self, s: float) -> Pose:
        """The pose at length `s` [m]."""
        i = min(max(int(np.searchsorted(self.at, s, side="right")) - 1, 0), len(self.poses) - 1)
        if i == len(self.poses) - 1:
            return self.poses[-1]
        span = self.at[i + 1] - self.at[i]
        return interpolate(self.poses[i], self.poses[i + 1], float((s - self.at[i]) / max(span, 1e-9)))

    def _project(self, point: Array, s: float, window: float) -> tuple[float, float]:
        """Where on the path, within `window` [m] around `s`, a point of `point`'s dimensions is nearest, and how near."""
        first = max(0, int(np.searchsorted(self.at, s - window, side="right")) - 1)
        last = min(len(self.at) - 1, int(np.searchsorted(self.at, s + window)))
        points = self._points[first : last + 1, : len(point)]
        if last <= first:
            return s, float(np.linalg.norm(point - points[0]))
        starts, spans = points[:-1], np.diff(points, axis=0)
        offset = point - starts
        share = np.clip((offset * spans).sum(1) / np.maximum((spans**2).sum(1), 1e-12), 0.0, 1.0)
        gaps = ((offset - share[:, None] * spans) ** 2).sum(1)
        best = int(np.argmin(gaps))
        along = self.at[first + best] + share[best] * (self.at[first + best + 1] - self.at[first + best])
        return float(np.clip(along, s - window, s + window)), float(np.sqrt(gaps[best]))

    def nearest(self, target: Pose, s: float, window: float) -> float:
        """Where on the path, within `window` [m] around `s`, `target` is nearest: a function of the target, without steps,
        so that the label is one too."""
        return self._project(self._point(target), s, window)[0]

    def gap(self, tcp: Pose, s: float) -> float:
        """The geometric distance of the tcp from the path [m], whatever its lag along it."""
        return self._project(tcp.pos, s, 0.08)[1]


class PlanFollower:
    """Follows a plan's segments one by one. Its answer depends on where the target is on the path, not on the time: pushed off,
    it comes back to the nearest point of the path and goes on from there."""

    def __init__(self, plan: Plan, law: TimeLaw | None = None) -> None:
        self.plan, self.law = plan, law or TimeLaw()
        self._segments = plan.segments
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
    def steps_done(self) -> int:
        """How many skills are complete."""
        return sum(self._index > end for end in self._ends)

    @property
    def slack(self) -> float:
        """How much a push may matter now, 0 to 1: nothing while the gripper works, little right before it does, else all."""
        if self._path is None:
            return 0.0
        if self._segments[self._index].steady:
            return 0.0
        left = self._path.length - self._s
        return min(1.0, left / 0.10) if self._stops_at_end() else 1.0

    def _next_segment(self) -> None:
        self._index += 1
        self._s, self._waited = 0.0, 0
        segment = self.segment
        self._path = None if segment is None or segment.gripper_action else _Path(segment)

    def _stops_at_end(self) -> bool:
        following = self._segments[self._index + 1 : self._index + 2]
        return bool(following and following[0].gripper_action)

    def act(self, observation: Observation) -> NDArray[np.float32] | None:
        """The action `(7,)` for this observation; None when the plan is done."""
        tcp = Pose(observation["robot0_eef_pos"].astype(np.float64), _wxyz(observation["robot0_eef_quat"]))
        missing = observation["robot0_target_error"].astype(np.float64)
        target = Pose(tcp.pos + missing[:3], quat_mul(quat_from_rotvec(missing[3:]), tcp.quat))
        opening = float(np.abs(observation["robot0_gripper_qpos"]).sum())
        while self._finished(tcp, opening):
            self._next_segment()
            self._opening = opening
        segment = self.segment
        if segment is None:
            return None
        wanted = segment.end
        if self._path is None:
            self._waited += 1
        else:
            wanted = self._advance(self._path, target, segment.speed or self.law.speed)
            self.errors.append(self._path.gap(tcp, self._s))
        delta = np.clip(error_between(wanted, target) / SCALE, -1.0, 1.0)
        return np.array([*delta, 1.0 if segment.shut else -1.0], np.float32)

    def _advance(self, path: _Path, target: Pose, speed: float) -> Pose:
        law = self.law
        self._s = path.nearest(target, self._s, window=0.04)
        offset = error_between(target, path.pose(self._s))
        away = max(float(np.linalg.norm(offset[:3])), TURN_WEIGHT * float(np.linalg.norm(offset[3:])))
        if self._stops_at_end():
            speed = min(speed, law.slowest + law.braking * (path.length - self._s))
        speed *= max(0.0, 1.0 - away / law.patience_offset)
        self._s = min(path.length, self._s + speed / CONTROL_HZ)
        self._waited += self._s >= path.length
        on_path, left = path.pose(self._s), (1.0 - law.recovery) * offset
        return Pose(on_path.pos + left[:3], quat_mul(quat_from_rotvec(left[3:]), on_path.quat))

    def _finished(self, tcp: Pose, opening: float) -> bool:
        segment, law = self.segment, self.law
        if segment is None:
            return False
        if self._path is None:
            # somebody else may have had the last word on what was done: the fingers must really have moved
            return self._waited >= law.stall and abs(opening - self._opening) > law.finger_motion
        if self._s < self._path.length:
            return False
        if not self._stops_at_end():
            return self._index not in self._ends or distance(segment.end, tcp) < law.passed
        near = law.arrived if self._waited < law.patience else law.arrived_late
        return distance(segment.end, tcp) < near


def _wxyz(xyzw: NDArray[np.float32]) -> Array:
    x, y, z, w = xyzw.astype(np.float64)
    return np.array([w, x, y, z])
