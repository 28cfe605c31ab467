"""Paths to follow: a segment's waypoints as a polyline, by length, in the coordinates of what is steered along it."""

from __future__ import annotations

from itertools import pairwise
from typing import Protocol

import numpy as np

from optimus.motion.lines import TURN_WEIGHT, distance
from optimus.motion.plan import Segment
from optimus.se3 import Array, Pose, error_between, interpolate, quat_from_rotvec, quat_mul

JOINT_WEIGHT = 0.2
"""A joint's turn of one radian counts as this many metres, of a path or off it, where the tcp itself moves less than that."""


class Path(Protocol):
    """A segment for a target of one kind. Lengths `s` are in metres, from 0 to `length`."""

    length: float

    def nearest(self, target: Array, s: float, window: float) -> float:
        """Where on the path, within `window` [m] around `s`, `target` is nearest: a function of the target, without steps,
        so that the label is one too."""
        ...

    def offset(self, target: Array, s: float) -> Array:
        """What `target` is off by from the path at `s`, in SI units."""
        ...

    def away(self, offset: Array, tcp: Pose, s: float) -> float:
        """How far off the path the arm is sent, or is, near `s` [m]; `offset` is the target's."""
        ...

    def delta(self, target: Array, s: float, offset: Array | None = None) -> Array:
        """What brings `target` onto the path at `s`, or as far off it as `offset` says, in SI units."""
        ...

    def gap(self, tcp: Pose, s: float) -> float:
        """The geometric distance of the tcp from the path [m], whatever its lag along it."""
        ...


class Polyline:
    """Points `(T, n)` and the length up to each `(T,)` [m]."""

    def __init__(self, points: Array, at: Array) -> None:
        self.points, self.at = points, at

    def place(self, s: float) -> tuple[int, float]:
        """The stretch that the length `s` [m] lies in, and the share of it that is behind; the last point is a stretch of 0."""
        i = min(max(int(np.searchsorted(self.at, s, side="right")) - 1, 0), len(self.at) - 1)
        if i == len(self.at) - 1:
            return i, 0.0
        return i, float((s - self.at[i]) / max(self.at[i + 1] - self.at[i], 1e-9))

    def project(self, point: Array, s: float, window: float) -> tuple[float, float]:
        """Where on the path, within `window` [m] around `s`, a point of `point`'s dimensions is nearest, and how near."""
        first = max(0, int(np.searchsorted(self.at, s - window, side="right")) - 1)
        last = min(len(self.at) - 1, int(np.searchsorted(self.at, s + window)))
        points = self.points[first : last + 1, : len(point)]
        if last <= first:
            return s, float(np.linalg.norm(point - points[0]))
        starts, spans = points[:-1], np.diff(points, axis=0)
        offset = point - starts
        share = np.clip((offset * spans).sum(1) / np.maximum((spans**2).sum(1), 1e-12), 0.0, 1.0)
        gaps = ((offset - share[:, None] * spans) ** 2).sum(1)
        best = int(np.argmin(gaps))
        along = self.at[first + best] + share[best] * (self.at[first + best + 1] - self.at[first + best])
        return float(np.clip(along, s - window, s + window)), float(np.sqrt(gaps[best]))


def _lengths(steps: list[float]) -> Array:
    return np.concatenate([[0.0], np.cumsum(steps)])


class PosePath:
    """For a target pose, given as `(7,)`: position [m] and quaternion wxyz. Turns count by `TURN_WEIGHT`, as in `distance`."""

    def __init__(self, segment: Segment) -> None:
        self.poses = segment.poses
        steps = [distance(a, b) for a, b in pairwise(self.poses)]
        self._line = Polyline(np.array([self._point(pose) for pose in self.poses]), _lengths(steps))
        self.length = float(self._line.at[-1])

    def _point(self, pose: Pose) -> Array:
        """A pose as a point `(6,)`: position, and the turn from the end of the path in metres."""
        turn = error_between(pose, self.poses[-1])[3:]
        return np.concatenate([pose.pos, TURN_WEIGHT * turn])

    def _pose(self, s: float) -> Pose:
        i, share = self._line.place(s)
        return self.poses[i] if i == len(self.poses) - 1 else interpolate(self.poses[i], self.poses[i + 1], share)

    def nearest(self, target: Array, s: float, window: float) -> float:
        return self._line.project(self._point(Pose(target[:3], target[3:])), s, window)[0]

    def offset(self, target: Array, s: float) -> Array:
        """`(6,)` [m, rad], base frame."""
        return error_between(Pose(target[:3], target[3:]), self._pose(s))

    def away(self, offset: Array, tcp: Pose, s: float) -> float:
        return max(float(np.linalg.norm(offset[:3])), TURN_WEIGHT * float(np.linalg.norm(offset[3:])))

    def delta(self, target: Array, s: float, offset: Array | None = None) -> Array:
        """`(6,)` [m, rad], base frame."""
        wanted = self._pose(s)
        if offset is not None:
            wanted = Pose(wanted.pos + offset[:3], quat_mul(quat_from_rotvec(offset[3:]), wanted.quat))
        return error_between(wanted, Pose(target[:3], target[3:]))

    def gap(self, tcp: Pose, s: float) -> float:
        return self._line.project(tcp.pos, s, 0.08)[1]


class JointPath:
    """For a joint target `(dof,)` [rad]. Its length is that of the tcp's way, and more only where joints turn and it hardly
    moves (`JOINT_WEIGHT`): the same law of speed serves both kinds of path, and no joint is hurried."""

    def __init__(self, segment: Segment) -> None:
        turns = np.abs(np.diff(segment.q, axis=0)).max(axis=1, initial=0.0)
        ways = [distance(a, b) for a, b in pairwise(segment.poses)]
        at = _lengths([max(way, JOINT_WEIGHT * float(turn)) for way, turn in zip(ways, turns, strict=True)])
        self._line = Polyline(segment.q, at)
        self._tcp = Polyline(np.array([p.pos for p in segment.poses]), at)
        self.length = float(at[-1])

    def _q(self, s: float) -> Array:
        i, share = self._line.place(s)
        q = self._line.points
        return q[i] if i == len(q) - 1 else q[i] + share * (q[i + 1] - q[i])

    def nearest(self, target: Array, s: float, window: float) -> float:
        return self._line.project(target, s, window)[0]

    def offset(self, target: Array, s: float) -> Array:
        """`(dof,)` [rad]"""
        return target - self._q(s)

    def away(self, offset: Array, tcp: Pose, s: float) -> float:
        # the joints alone do not tell how far off they send the tcp, nor whether it matters to it at all
        return max(JOINT_WEIGHT * float(np.linalg.norm(offset)), self.gap(tcp, s))

    def delta(self, target: Array, s: float, offset: Array | None = None) -> Array:
        """`(dof,)` [rad]"""
        return self._q(s) - target if offset is None else self._q(s) + offset - target

    def gap(self, tcp: Pose, s: float) -> float:
        return self._tcp.project(tcp.pos, s, 0.08)[1]
