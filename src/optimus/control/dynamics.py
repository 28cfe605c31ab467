"""What the laws of control share: the arm's own Jacobian and inertia, and the torques that keep it from falling."""

from __future__ import annotations

import mujoco
import numpy as np

from optimus.se3 import Array
from optimus.world import World, run_of


class ArmDynamics:
    """The arm alone, out of a model that also holds fingers and free things. Every query reads `data` after `mj_step1`."""

    def __init__(self, world: World) -> None:
        self.world = world
        nv = world.model.nv
        self._jac, self._mass = np.zeros((6, nv)), np.zeros((nv, nv))
        self._jacp, self._jacr = self._jac[:3], self._jac[3:]
        self._arm = run_of(world.arm_dof)
        self._high = np.array(world.scene.robot.torque_limits)
        self._low = -self._high
        self._damping = world.model.dof_damping[world.arm_dof].ravel().copy()

    def q(self, data: mujoco.MjData) -> Array:
        """Joint positions `(dof,)` [rad]."""
        return data.qpos[self.world.arm_qpos]

    def qvel(self, data: mujoco.MjData) -> Array:
        """Joint speeds `(dof,)` [rad/s]."""
        return data.qvel[self.world.arm_dof]

    def jacobian(self, data: mujoco.MjData) -> Array:
        """Of the tcp `(6, dof)`: velocity [m/s], then angular velocity [rad/s], base frame, for joint speeds of 1 rad/s."""
        mujoco.mj_jacSite(self.world.model, data, self._jacp, self._jacr, self.world.tcp_site)
        return self._jac[:, self._arm].copy()

    def mass(self, data: mujoco.MjData) -> Array:
        """Joint-space inertia `(dof, dof)` [kg m^2]."""
        mujoco.mj_fullM(self.world.model, data, self._mass)
        return self._mass[self._arm][:, self._arm].copy()

    def torque(self, pull: Array, data: mujoco.MjData) -> Array:
        """`pull` `(dof,)` [N m] with gravity, Coriolis forces and joint damping compensated, within the robot's limits."""
        torque = pull + data.qfrc_bias[self.world.arm_dof] + self._damping * self.qvel(data)
        return np.minimum(np.maximum(torque, self._low), self._high)
