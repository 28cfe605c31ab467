"""A plan as pictures in time: where everything is at each moment, from the motions alone."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from optimus.expert import TimeLaw
from optimus.motion.lines import distance
from optimus.motion.plan import Plan, Segment
from optimus.replay import Replay
from optimus.scene import Scene
from optimus.se3 import Array

RATE = 20.0
"""Moments a second."""
GRIPPER_SECONDS = 0.25
"""For which the gripper alone acts."""


@dataclass(frozen=True, eq=False)
class Moment:
    """At `seconds` from the start, step `step` (from 0) is in its segment `segment`; `qpos` `(nq,)` says where everything is.
    `key` marks the end of what the gripper does, and of a step."""

    seconds: float
    step: int
    segment: str
    qpos: Array
    key: bool = False


def timeline(plan: Plan, scene: Scene, law: TimeLaw | None = None) -> list[Moment]:
    """The plan at 20 moments a second, at the speed that `law` and its segments allow; where the expert slows down before a
    grasp, this does not."""
    replay, moments, now = Replay(scene, plan.start), [], 0.0
    speed = (law or TimeLaw()).speed
    for number, step in enumerate(plan.steps):
        for i, segment in enumerate(step.segments):
            took = _seconds(segment, speed)
            times = np.linspace(0.0, took, max(2, round(took * RATE) + 1))
            for passed, at in zip(times, _waypoints(segment, times / took), strict=True):
                replay.place(segment, float(at))
                moments.append(Moment(now + float(passed), number, segment.name, replay.qpos))
            now += took
            replay.finish(segment)
            last = i == len(step.segments) - 1
            moments.append(Moment(now, number, segment.name, replay.qpos, key=segment.gripper_action or last))
    return moments


def _ways(segment: Segment) -> Array:
    """How far along the tcp is at each waypoint `(T,)` [m], turns counting as in `lines.distance`, and joints a little so that a
    turn of the arm about the tcp takes its time."""
    tcp = [distance(a, b) for a, b in pairwise(segment.poses)]
    joints = 0.1 * np.linalg.norm(np.diff(segment.q, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(np.maximum(tcp, joints))])


def _seconds(segment: Segment, speed: float) -> float:
    if segment.gripper_action:
        return GRIPPER_SECONDS
    return max(1 / RATE, float(_ways(segment)[-1]) / min(speed, segment.speed))


def _waypoints(segment: Segment, shares: Array) -> Array:
    """Fractional indices of the waypoints at those shares of the way, `(n,)`."""
    ways = _ways(segment)
    if ways[-1] <= 0:
        return np.zeros(len(shares))
    return np.interp(shares * ways[-1], ways, np.arange(len(ways)))
