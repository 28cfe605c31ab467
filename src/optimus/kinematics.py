"""Forward and inverse kinematics of the arm, on the scene's own model with scratch data."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from typing import Protocol

import frankik
import mujoco
import numpy as np

from optimus.se3 import Array, Pose
from optimus.world import World, run_of

POSITION_TOLERANCE = 2e-4
"""[m]"""
ROTATION_TOLERANCE = 2e-3
"""[rad]"""
DAMPING = 1e-5 * np.eye(6)
NULL_SPACE_GAIN = 0.05
"""Of the way home, in each step of the descent."""
LONGEST_STEP = 0.3
"""Of a joint in each step of the descent [rad]."""
DIFFERENT = 0.05
"""Configurations further apart than this in some joint are different ways [rad]."""

SETTLING, SETTLING_GAIN = 8, 0.35
"""So many steps, with such a share of the way home in each, until the null space has come to rest: as near to it as 14 steps of a
fifth, nine times in ten within 0.11 rad."""
AT_EASE = 0.08
"""The arm does not settle nearer to a joint's limit than this [rad]: the controllers keep off it."""

STARTS, DESCENT = 60, 40
"""The numeric search descends from this many configurations at most, by this many steps each."""
PATIENCE = 12
"""... and ends early when this many in a row have led to nothing new after something was found."""
KNOWN = 8
"""... having begun with this many of its latest finds."""


def solved(matrix: Array, right: Array) -> Array:
    """`x` of `matrix @ x = right` `(n,)`, the matrix `(n, n)` symmetric and positive definite, which is overwritten: MuJoCo's own
    Cholesky takes a third of `numpy.linalg.solve`'s time for such small ones."""
    found = np.empty_like(right)
    mujoco.mju_cholFactor(matrix, 0.0)
    mujoco.mju_cholSolve(found, matrix, right)
    return found


class Kinematics:
    """The arm's kinematics. Holds one scratch `MjData`; not to be shared between threads."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.home = world.home
        self.low, self.high = world.arm_range[:, 0] + 0.02, world.arm_range[:, 1] - 0.02
        self._data = mujoco.MjData(world.model)
        self._arm_qpos, self._arm_dof = run_of(world.arm_qpos), run_of(world.arm_dof)
        # views: each look-up of `data`'s own is a microsecond
        self._qpos = self._data.qpos
        self._pos, self._matrix = self._data.site_xpos[world.tcp_site], self._data.site_xmat[world.tcp_site]
        self._jac = np.zeros((6, world.model.nv))
        self._jacp, self._jacr = self._jac[:3], self._jac[3:]
        self._error, self._turn = np.zeros(6), np.zeros(4)
        self.effort = 0
        """Poses asked for so far in search of solutions, of the model or of a closed form."""
        self._ways: Ways = PandaWays(self) if world.scene.robot.ik == "panda" else NumericWays(self)

    def fk(self, q: Array) -> Pose:
        """`base_from_tcp` at `q` `(dof,)` [rad]."""
        self._qpos[self._arm_qpos] = q
        mujoco.mj_kinematics(self.world.model, self._data)
        return self.world.tcp(self._data)

    def jacobian(self) -> Array:
        """The tcp's Jacobian `(6, dof)` [m/rad; rad/rad], base frame, at the configuration of the last `fk`."""
        model, data = self.world.model, self._data
        mujoco.mj_comPos(model, data)
        mujoco.mj_jacSite(model, data, self._jacp, self._jacr, self.world.tcp_site)
        return self._jac[:, self._arm_dof].copy()

    @cached_property
    def span(self) -> tuple[Array, float]:
        """A point of the arm's first joint `(3,)` [m], and how far from it the tcp is at most [m]: with all that lies between them
        stretched out."""
        model, tcp = self.world.model, self.world.tcp_site
        joints = [int(j) for j in model.dof_jntid[self.world.arm_dof]]
        far, body = float(np.linalg.norm(model.site_pos[tcp])), int(model.site_bodyid[tcp])
        while body != model.jnt_bodyid[joints[0]]:
            far, body = far + float(np.linalg.norm(model.body_pos[body])), int(model.body_parentid[body])
        far += sum(2.0 * float(np.linalg.norm(model.jnt_pos[j])) for j in joints)
        slides = [j for j in joints if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_SLIDE]
        far += sum(float(np.ptp(model.jnt_range[j])) for j in slides)
        self.fk(self.home)
        return self._data.xanchor[joints[0]].copy(), far

    def within_limits(self, q: Array) -> bool:
        return bool((q >= self.low).all() and (q <= self.high).all())

    def _missing(self, q: Array, target: Pose) -> Array:
        """`error_between(target, fk(q))`, by MuJoCo's own quaternions: it is the inner loop of planning."""
        error, turn = self._error, self._turn
        self.effort += 1
        self._qpos[self._arm_qpos] = q
        mujoco.mj_kinematics(self.world.model, self._data)
        mujoco.mju_mat2Quat(turn, self._matrix)
        mujoco.mju_negQuat(turn, turn)
        mujoco.mju_mulQuat(turn, target.quat, turn)
        mujoco.mju_quat2Vel(error[3:], turn, 1.0)
        np.subtract(target.pos, self._pos, out=error[:3])
        return error

    def refine(self, q: Array, target: Pose, iterations: int = 12) -> Array | None:
        """The solution near `q`: damped least squares, drawn towards home in the null space; None if it does not converge."""
        q = q.copy()
        for _ in range(iterations):
            error = self._missing(q, target)
            moved, turned = error[:3], error[3:]
            if moved @ moved < POSITION_TOLERANCE**2 and turned @ turned < ROTATION_TOLERANCE**2:
                return q if self.within_limits(q) else None
            q += self._step(q, error, NULL_SPACE_GAIN)
        return None

    def _step(self, q: Array, error: Array, homewards: float) -> Array:
        """The damped least-squares step that makes up for the tcp's `error` at `q`, and this share of the way home as far as that
        does not move the tcp."""
        jac, relax = self.jacobian(), homewards * (self.home - q)
        # `dot` and not `@`: half the time for what is as small as this
        found = solved(jac.dot(jac.T) + DAMPING, error - jac.dot(relax))
        return np.maximum(np.minimum(found.dot(jac) + relax, LONGEST_STEP), -LONGEST_STEP)

    def settled(self, solutions: Iterable[Array], target: Pose) -> Iterator[Array]:
        """Where the arm comes to when its tcp stays at `target` and its null space goes home, from each of `solutions`: each such
        configuration once, and none in which a joint is near its limit, where it can hardly follow."""
        passed = np.zeros((0, len(self.home)))
        for solution in solutions:
            q, path = solution, [solution]
            for _ in range(SETTLING):
                q = q + self._step(q, self._missing(q, target), SETTLING_GAIN)
                path.append(q)
                if len(passed) and np.abs(passed - q).max(axis=1).min() < DIFFERENT:
                    break  # from here it goes where an earlier one went
            else:
                found = self.refine(q, target)
                if found is not None and (found > self.low + AT_EASE).all() and (found < self.high - AT_EASE).all():
                    yield found
            passed = np.concatenate([passed, path])

    def ways(self, target: Pose, near: Array) -> list[Array]:
        """Configurations that reach `target` or nearly so, one a way of doing it, in no order; `refine` makes them exact."""
        return self._ways.starts(target, near)

    def solutions(self, target: Pose, near: Array) -> Iterator[Array]:
        """Every known way to reach `target` (`base_from_tcp`): first the one that follows from `near`, then by distance to it
        and to home. Each is checked against the model's own forward kinematics and the joint limits."""
        local = self.refine(near, target)
        if local is not None:
            yield local
        for q in sorted(self.ways(target, near), key=lambda q: float(np.abs(q - near).sum() + 0.3 * np.abs(q - self.home).sum())):
            solution = self.refine(q, target, iterations=6)
            if solution is not None and (local is None or np.abs(solution - local).max() > DIFFERENT):
                yield solution


class Ways(Protocol):
    """Inverse kinematics of one kind of arm."""

    def starts(self, target: Pose, near: Array) -> list[Array]:
        """Configurations `(dof,)` that reach `target` or nearly so, one a way of doing it, in no order."""
        ...


class PandaWays:
    """In closed form over a sweep of the redundant joint."""

    def __init__(self, kinematics: Kinematics) -> None:
        self._kinematics = kinematics

    def starts(self, target: Pose, near: Array) -> list[Array]:
        k = self._kinematics
        robot = k.world.scene.robot
        # frankik's `ik` takes the flange as the arm's foot sees it: the hand's origin, turned by +45 degrees about z
        foot, tcp_from_hand = Pose(np.array(robot.base_pos), np.array(robot.base_quat)), Pose.of(-np.array(robot.tcp))
        flange = foot.inverse @ target @ tcp_from_hand @ Pose.of(rotvec=(0.0, 0.0, np.pi / 4))
        matrix = np.eye(4)
        matrix[:3, :3], matrix[:3, 3] = flange.matrix, flange.pos
        found = []
        for q7 in np.linspace(k.low[6], k.high[6], 24):
            k.effort += 1
            rows = frankik.ik_full(matrix, k.home, float(q7), False)  # pyright: ignore[reportArgumentType]
            found += [row for row in rows if np.isfinite(row).all() and k.within_limits(row)]
        return found


def evenly_spread(count: int, dimensions: int) -> Array:
    """Points `(count, dimensions)` that fill the unit cube without gaps, the same ones every time: the additive recurrence whose
    steps are the powers of the generalised golden ratio (Roberts, 2018)."""
    ratio = 1.0
    for _ in range(60):  # the root of x^(d + 1) = x + 1
        ratio = (1.0 + ratio) ** (1.0 / (dimensions + 1))
    steps = ratio ** -np.arange(1.0, dimensions + 1)
    return (0.5 + np.outer(np.arange(1, count + 1), steps)) % 1.0


class NumericWays:
    """Descent from configurations that led somewhere before, from the other postures of what it finds, and from a fixed spread."""

    def __init__(self, kinematics: Kinematics) -> None:
        self._kinematics = kinematics
        self._known: list[Array] = []
        # continuous joints turn further than any posture needs
        low = np.maximum(kinematics.low, kinematics.home - np.pi)
        high = np.minimum(kinematics.high, kinematics.home + np.pi)
        self._spread = low + evenly_spread(STARTS, len(low)) * (high - low)

    def starts(self, target: Pose, near: Array) -> list[Array]:
        found: list[Array] = []
        fruitless = 0
        for start in [near, self._kinematics.home, *self._known, *self._spread]:
            new = self._add(found, start, target)
            if new:
                self._add(found, self._turned_over(found[-1]), target)
            fruitless = 0 if new else fruitless + 1
            if found and fruitless >= PATIENCE:
                break
        self._known = (found + self._known)[:KNOWN]
        return found

    def _add(self, found: list[Array], start: Array, target: Pose) -> bool:
        solution = self._kinematics.refine(start, target, iterations=DESCENT)
        if solution is None:
            return False
        solution = self._unwound(solution)
        if any(np.abs(solution - other).max() < DIFFERENT for other in found):
            return False
        found.append(solution)
        return True

    def _unwound(self, q: Array) -> Array:
        """The same posture with every joint within half a turn of home, where the limits allow."""
        k = self._kinematics
        wound = q - 2 * np.pi * np.round((q - k.home) / (2 * np.pi))
        return wound if k.within_limits(wound) else q

    def _turned_over(self, q: Array) -> Array:
        """About where the same pose is reached with a spherical wrist turned over; the descent does the rest."""
        half = np.where(q[[-3, -1]] < self._kinematics.home[[-3, -1]], np.pi, -np.pi)
        return np.array([*q[:-3], q[-3] + half[0], -q[-2], q[-1] + half[1]])
