"""Joint-space motion where straight tcp lines fail: the straight joint line first, then OMPL's RRT-Connect, shortcut."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
from ompl import base, geometric, util

from optimus.collision import CollisionChecker
from optimus.kinematics import Kinematics
from optimus.se3 import Array

QUERIES = 6000
"""Collision checks after which a search is given up: a count, not a time, so that a slow machine finds the same path."""
JOINT_STEP = 0.05
"""Largest joint change between checked configurations [rad]."""
SHORTCUTS = 60
"""Times that a stretch of the path found is tried to be replaced."""

util.setLogLevel(util.LOG_NONE)


def joint_line(start: Array, end: Array) -> Array:
    """`(T, dof)` from `start` to `end`, evenly spaced."""
    steps = max(1, int(np.ceil(np.abs(end - start).max() / JOINT_STEP)))
    return start + np.linspace(0.0, 1.0, steps + 1)[:, None] * (end - start)


def is_free(checker: CollisionChecker, path: Array) -> bool:
    """Whether every configuration of `path` is free; the middle ones first, where collisions are likelier."""
    order = np.argsort(np.abs(np.arange(len(path)) - len(path) / 2))
    return all(checker.check(path[i]) is None for i in order)


def connect(
    kinematics: Kinematics,
    checker: CollisionChecker,
    start: Array,
    end: Array,
    rng: np.random.Generator,
    queries: int = QUERIES,
    straight: bool = True,
) -> Array | None:
    """A free joint path `(T, dof)` from `start` to `end`, or None. Random only through `rng`. Without `straight`, neither is the
    straight line tried before nor are shortcuts after."""
    line = joint_line(start, end)
    if straight and is_free(checker, line):
        return line
    if checker.check(end) is not None or checker.check(start) is not None:
        return None
    found = _rrt_connect(kinematics, checker, start, end, rng, queries)
    return None if found is None else _shortcut(checker, found, rng, SHORTCUTS if straight else 0)


def _rrt_connect(
    kinematics: Kinematics, checker: CollisionChecker, start: Array, end: Array, rng: np.random.Generator, queries: int
) -> Array | None:
    dof = len(start)
    space = base.RealVectorStateSpace(dof)
    bounds = base.RealVectorBounds(dof)
    for i in range(dof):
        bounds.setLow(i, float(kinematics.low[i]))
        bounds.setHigh(i, float(kinematics.high[i]))
    space.setBounds(bounds)
    setup = geometric.SimpleSetup(space)
    asked = 0

    def is_valid(state: Any) -> bool:
        nonlocal asked
        asked += 1
        return checker.check(_read(state, dof)) is None

    setup.setStateValidityChecker(is_valid)
    setup.getSpaceInformation().setStateValidityCheckingResolution(0.01)
    ends = []
    for q in (start, end):
        state: Any = space.allocState()  # indexable, though OMPL's stubs do not say so
        for i in range(dof):
            state[i] = float(q[i])
        ends.append(state)
    setup.setStartAndGoalStates(ends[0], ends[1])
    # one seed a query: the same problem gives the same path, whatever was planned before it in this process
    util.RNG.setSeed(int(rng.integers(1, 2**31)))
    planner = geometric.RRTConnect(setup.getSpaceInformation())
    setup.setPlanner(planner)
    if not setup.solve(base.PlannerTerminationCondition(lambda: asked > queries)) or not setup.haveExactSolutionPath():
        return None
    states = setup.getSolutionPath().getStates()
    return np.array([_read(s, dof) for s in states])


def _read(state: Any, dof: int) -> Array:
    return np.array([state[i] for i in range(dof)])


def _shortcut(checker: CollisionChecker, corners: Array, rng: np.random.Generator, rounds: int) -> Array:
    """Replace stretches by free straight lines, then space the path evenly."""
    points = list(corners)
    for _ in range(rounds):
        if len(points) < 3:
            break
        i, j = sorted(rng.choice(len(points), 2, replace=False))
        if j - i > 1 and is_free(checker, joint_line(points[i], points[j])):
            points = points[: i + 1] + points[j:]
    lines = [joint_line(a, b) for a, b in pairwise(points)]
    return np.vstack([lines[0], *(line[1:] for line in lines[1:])])
