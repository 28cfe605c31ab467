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
MAX_JOINT_STEP = 0.22
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
    for _ in range(8):  # the slower, the shorter the stretch over which speeds are averaged
        over = _furthest_turned(along, q / limits, RESPONSE * speed) / RESPONSE
        if over <= 1.0 or speed <= SLOWEST:
            break
        speed = max(SLOWEST, 0.98 * speed / over)
    return speed


def _furthest_turned(along: Array, q: Array, window: float) -> float:
    """The most that a joint changes over any stretch of `window` of a path `q` `(T, dof)` that is linear between `along` `(T,)`."""
    begin = np.concatenate([along, along - window])  # between these, the change is linear too
    ends = [np.array([np.interp(at, along, joint) for joint in q.T]) for at in (begin, begin + window)]
    return float(np.abs(ends[1] - ends[0]).max(initial=0.0))
