"""Control by inverse kinematics: the target pose becomes a joint target, which the joint impedance law holds."""

from __future__ import annotations

from typing import ClassVar

import mujoco
import numpy as np

from optimus.control.joint import JointImpedance
from optimus.control.pose_target import PoseTarget
from optimus.kinematics import Kinematics
from optimus.se3 import Array, error_between
from optimus.world import World

ITERATIONS = 4
"""Of the differential IK, each step of control."""
DAMPING = 1e-4
"""Of its least squares: near a singularity the joints stay slow and the tcp gives way."""
NULL_SHARE = 0.1
"""Share of the way home that the joint target takes in the null space, each step of control."""
MAX_STEP = 0.2
"""Largest change of a joint in one iteration [rad]."""


class InverseKinematics(PoseTarget):
    """Damped differential IK from where the arm is, drawn towards home in the null space and kept within the joint limits.

    It starts anew from the arm's own joints at each step of control, so that the target pose is all there is to remember.
    """

    name: ClassVar[str] = "ik"

    def __init__(self, world: World) -> None:
        super().__init__(world)
        self._kinematics = Kinematics(world)
        self._law = JointImpedance(world)
        self.joint_target = world.home.copy()
        """`(dof,)` [rad]"""

    def reset(self, data: mujoco.MjData) -> None:
        """Aim at where the arm is."""
        super().reset(data)
        self.joint_target = data.qpos[self.world.arm_qpos].copy()

    def move_target(self, action: Array, data: mujoco.MjData) -> None:
        """Shift the target pose by `action` `(6,)` in [-1, 1], and solve for the joints."""
        super().move_target(action, data)
        self.joint_target = self._solve(data.qpos[self.world.arm_qpos].copy())

    def _solve(self, q: Array) -> Array:
        """The joint target `(dof,)` [rad] for the target pose, from `q`."""
        kinematics = self._kinematics
        relax = NULL_SHARE * (kinematics.home - q)
        for _ in range(ITERATIONS):
            error = error_between(self.target, kinematics.fk(q))
            jac = kinematics.jacobian()
            gain = jac.T @ np.linalg.inv(jac @ jac.T + DAMPING * np.eye(6))
            step = gain @ error + relax - gain @ (jac @ relax)
            relax = np.zeros_like(q)  # the iterations that follow bring the tcp back to where it curved off
            q = np.clip(q + np.clip(step, -MAX_STEP, MAX_STEP), kinematics.low, kinematics.high)
        return q

    def torque(self, data: mujoco.MjData) -> Array:
        """Joint torques `(dof,)` [N m], after `mj_step1`."""
        return self._law.torque(data, self.joint_target)
