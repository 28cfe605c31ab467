"""Forward and inverse kinematics of the arm, on the scene's own model with scratch data."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import frankik
import mujoco
import numpy as np

from optimus.se3 import Array, Pose, error_between
from optimus.world import World

POSITION_TOLERANCE = 2e-4
"""[m]"""
ROTATION_TOLERANCE = 2e-3
"""[rad]"""


class Kinematics:
    """The arm's kinematics. Holds one scratch `MjData`; not to be shared between threads."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.home = world.home
        self.low, self.high = world.arm_range[:, 0] + 0.02, world.arm_range[:, 1] - 0.02
        self._data = mujoco.MjData(world.model)
        self._jacp = np.zeros((3, world.model.nv))
        self._jacr = np.zeros((3, world.model.nv))
        self._analytic = world.scene.robot.ik == "panda"

    def fk(self, q: Array) -> Pose:
        """`base_from_tcp` at `q` `(dof,)` [rad]."""
        self._data.qpos[self.world.arm_qpos] = q
        mujoco.mj_kinematics(self.world.model, self._data)
        return self.world.tcp(self._data)

    def jacobian(self) -> Array:
        """The tcp's Jacobian `(6, dof)` [m/rad; rad/rad], base frame, at the configuration of the last `fk`."""
        model, data = self.world.model, self._data
        mujoco.mj_comPos(model, data)
        mujoco.mj_jacSite(model, data, self._jacp, self._jacr, self.world.tcp_site)
        return np.vstack([self._jacp[:, self.world.arm_dof], self._jacr[:, self.world.arm_dof]])

    def within_limits(self, q: Array) -> bool:
        return bool(np.all(q >= self.low) and np.all(q <= self.high))

    def refine(self, q: Array, target: Pose, iterations: int = 12) -> Array | None:
        """The solution near `q`: damped least squares, drawn towards home in the null space; None if it does not converge."""
        q = q.copy()
        for _ in range(iterations):
            error = error_between(target, self.fk(q))
            if np.linalg.norm(error[:3]) < POSITION_TOLERANCE and np.linalg.norm(error[3:]) < ROTATION_TOLERANCE:
                return q if self.within_limits(q) else None
            jac = self.jacobian()
            gain = jac.T @ np.linalg.inv(jac @ jac.T + 1e-5 * np.eye(6))
            relax = self.home - q
            step = gain @ error + 0.05 * (relax - gain @ (jac @ relax))
            q = q + np.clip(step, -0.3, 0.3)
        return None

    def solutions(self, target: Pose, near: Array) -> Iterator[Array]:
        """Every known way to reach `target` (`base_from_tcp`): first the one that follows from `near`, then by distance to it
        and to home. Each is checked against the model's own forward kinematics and the joint limits."""
        local = self.refine(near, target)
        if local is not None:
            yield local
        for q in self._seeds(target, near):
            solution = self.refine(q, target, iterations=6)
            if solution is not None and (local is None or np.abs(solution - local).max() > 0.05):
                yield solution

    def _seeds(self, target: Pose, near: Array) -> Sequence[Array]:
        """Starting points for `refine`: closed form over a sweep of the redundant joint, else a fixed spread about home."""
        if self._analytic:
            seeds = self._panda_seeds(target)
        else:
            rng = np.random.default_rng(0)
            seeds = [np.clip(self.home + rng.normal(0, 0.6, self.home.shape), self.low, self.high) for _ in range(16)]
        return sorted(seeds, key=lambda q: float(np.abs(q - near).sum() + 0.3 * np.abs(q - self.home).sum()))

    def _panda_seeds(self, target: Pose) -> list[Array]:
        # frankik's `ik` takes the flange: the hand's origin, turned by +45 degrees about z
        tcp_from_hand = Pose.of(-np.array(self.world.scene.robot.tcp))
        flange = target @ tcp_from_hand @ Pose.of(rotvec=(0.0, 0.0, np.pi / 4))
        matrix = np.eye(4)
        matrix[:3, :3], matrix[:3, 3] = flange.matrix, flange.pos
        found = []
        for q7 in np.linspace(self.low[6], self.high[6], 24):
            rows = frankik.ik_full(matrix, self.home, float(q7), False)  # pyright: ignore[reportArgumentType]
            found += [row for row in rows if np.isfinite(row).all() and self.within_limits(row)]
        return found
