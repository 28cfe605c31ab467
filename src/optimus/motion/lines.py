"""Straight lines of the tcp, tracked by the arm without a jump and checked for collision."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from optimus.collision import Blocked, CollisionChecker
from optimus.kinematics import Kinematics
from optimus.se3 import Array, Pose, error_between, interpolate

LINE_STEP = 0.015
"""Largest distance between waypoints [m]."""
TURN_WEIGHT = 0.2
"""A turn of one radian counts as this many metres of motion."""
RESPONSE = 0.1
"""What the controller smooths motions over, about [s]."""
SLOWEST = 0.03
"""No limit slows the tcp down further [m/s]: where it hardly moves, the joints take the time that the controller gives them."""
MAX_JOINT_STEP = 0.35
"""A larger change between waypoints is a jump to another arm configuration, not a motion [rad]."""

UNREACHABLE = Blocked("robot", "its joint limits")


def distance(a: Pose, b: Pose) -> float:
    """How far apart two poses are [m], a turn counted by `TURN_WEIGHT`."""
    error = error_between(a, b)
    return max(float(np.linalg.norm(error[:3])), TURN_WEIGHT * float(np.linalg.norm(error[3:])))


def track(
    kinematics: Kinematics, checker: CollisionChecker, q: Array, corners: Sequence[Pose]
) -> tuple[Array, tuple[Pose, ...]] | Blocked:
    """The joint path `(T, dof)` and its poses along the lines from the pose of `q` through `corners`; or what prevents it."""
    path, poses = [q], [kinematics.fk(q)]
    for corner in corners:
        start = poses[-1]
        steps = int(np.ceil(distance(start, corner) / LINE_STEP))
        for i in range(1, steps + 1):
            pose = interpolate(start, corner, i / steps)
            here = kinematics.refine(path[-1], pose)
            if here is None or np.abs(here - path[-1]).max() > MAX_JOINT_STEP:
                return UNREACHABLE
            blocked = checker.check(here)
            if blocked is not None:
                return blocked
            path.append(here)
            poses.append(pose)
    return np.array(path), tuple(poses)

def fastest(q: Array, poses: tuple[Pose, ...], limits: Array, at_most: float) -> float:
    """How fast the tcp may go along a path, `at_most` [m/s], so that no joint exceeds its limit `(dof,)` [rad/s] in the mean of any
    `RESPONSE`."""
    along = np.concatenate([[0.0], np.cumsum([distance(a, b) for a, b in pairwise(poses)])])
    speed = at_most
    for _ in range(6):  # the slower, the shorter the stretch over which speeds are averaged
        ends = np.minimum(np.searchsorted(along, along + RESPONSE * speed), len(along) - 1)
        turned, went = (np.abs(q[ends] - q) / limits).max(axis=1), along[ends] - along
        allowed = float(np.min(np.where(turned > 1e-6, went / np.maximum(turned, 1e-6), np.inf), initial=np.inf))
        if allowed >= speed:
            break
        speed = max(SLOWEST, min(allowed, 0.95 * speed))
    return speed
