"""Ways about, where no straight one leads: by way of home, or where the sampling planner goes, and straight only at the end.

`corners` are poses of the tcp, the last of which is the goal; `straight` of the last lines through them stay lines."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from optimus.collision import Blocked
from optimus.motion import lines, sampling
from optimus.se3 import Array, Pose
from optimus.state import State

if TYPE_CHECKING:
    from optimus.skills.skill import Workspace

Path = tuple[Array, tuple[Pose, ...]]
"""Joint angles `(T, dof)` [rad] and the tcp's poses."""


def detour(
    workspace: Workspace, state: State, corners: list[Pose], straight: int, rng: np.random.Generator
) -> Path | None:
    """By way of home; else by joint motion to the corner where the last `straight` lines begin, then along these."""
    starts = before(workspace, state, corners[-straight - 1 :], rng)
    if not starts:
        return None
    for height in (workspace.home.pos[2], workspace.style.high):
        over = Pose(np.array([*workspace.home.pos[:2], height]), workspace.home.quat)
        known = lines.track(workspace.kinematics, workspace.checker, state.q, [over, *corners])
        if not isinstance(known, Blocked):
            return known
    return first(workspace, state, starts, corners[-straight:], rng)


def sampled(
    workspace: Workspace, state: State, corners: list[Pose], straight: int, rng: np.random.Generator
) -> Path | None:
    """By the sampling planner's path to where the last `straight` lines begin, then along these; None if it finds none."""
    return first(workspace, state, before(workspace, state, corners[-straight - 1 :], rng), corners[-straight:], rng)


def before(workspace: Workspace, state: State, corners: list[Pose], rng: np.random.Generator) -> list[Array]:
    """Configurations at the first of `corners` from which the lines through the others are free."""
    ends = workspace.settled(state, corners[-1], rng)
    return [q for q in (backwards(workspace, state, end, corners) for end in ends) if q is not None]


def first(
    workspace: Workspace, state: State, starts: list[Array], corners: list[Pose], rng: np.random.Generator
) -> Path | None:
    """By joints to the first of `starts` that is reached, and along the lines through `corners` from there."""
    for start in starts[: workspace.style.detours]:
        found = by_joints(workspace, state.q, start, corners, rng)
        if not isinstance(found, Blocked):
            return found
    return None


def backwards(workspace: Workspace, state: State, q: Array, corners: list[Pose]) -> Array | None:
    """The configuration at the first of `corners` from which the lines through the others lead to `q`, if they are free: looked
    for from the end, where there is least room."""
    workspace.checker.look_at(state)
    back = lines.track(workspace.kinematics, workspace.checker, q, corners[-2::-1])
    return None if isinstance(back, Blocked) else back[0][-1]


def by_joints(
    workspace: Workspace, q: Array, goal: Array, corners: list[Pose], rng: np.random.Generator
) -> Path | Blocked:
    """Like a free joint motion from `q` to `goal` and lines from there, but with the joints that the arm will have when its tcp
    is led along: what no pose tells, the null space, goes to home all the time."""
    path = sampling.connect(workspace.kinematics, workspace.checker, q, goal, rng, straight=workspace.style.motion == "straight")
    if path is None:
        return workspace.checker.check(goal) or lines.UNREACHABLE
    return lines.track(workspace.kinematics, workspace.checker, q, [*(workspace.kinematics.fk(p) for p in path[1:]), *corners])
