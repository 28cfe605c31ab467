"""Operational-space control: the tcp pulled to a target pose, in the coordinates of the task."""

from __future__ import annotations

import math
from typing import ClassVar

import mujoco
import numpy as np

from optimus.control.dynamics import ArmDynamics
from optimus.control.pose_target import PoseTarget
from optimus.kinematics import solved
from optimus.se3 import Array
from optimus.world import World

KP = 400.0
"""Stiffness [1/s^2], position and rotation alike."""
DAMPING = 2.0 * math.sqrt(KP)
"""Critical [1/s]."""
NULL_KP = 30.0
"""Stiffness of the pull towards home in the null space [1/s^2]: as quick as plans suppose (`kinematics.NULL_SPACE_GAIN`)."""
NULL_DAMPING = 2.0 * math.sqrt(NULL_KP)
"""Critical [1/s]."""

LIMIT_MARGIN, LIMIT_KP = 0.15, 400.0
"""Nearer to a joint's limit than this [rad], the null space pushes it away with this stiffness [1/s^2]: a joint at its limit can no
longer follow the tcp."""

TASK_EASE, NULL_EASE = 1e-3, 1e-5 * np.eye(6)
"""Added to what is solved for, so that near a singularity the arm gives way [1/kg, and none]."""


class OperationalSpace(PoseTarget):
    """Khatib's operational-space law with the full (coupled) task inertia and a null-space pull towards home.

    The action moves a *target* pose, which the law pulls the tcp to; source of the law: Khatib, "A unified approach for motion
    and force control of robot manipulators: the operational space formulation" (1987).
    """

    name: ClassVar[str] = "osc"

    def __init__(self, world: World) -> None:
        super().__init__(world)
        self._arm = ArmDynamics(world)
        self._low, self._high = world.arm_range[:, 0] + LIMIT_MARGIN, world.arm_range[:, 1] - LIMIT_MARGIN

    def torque(self, data: mujoco.MjData) -> Array:
        """Joint torques `(dof,)` [N m], after `mj_step1`."""
        arm = self._arm
        jac, mass, q, qvel = arm.jacobian(data), arm.mass(data), arm.q(data), arm.qvel(data)
        pull = self._relaxation(q, qvel)
        # straight home in the joints' own measure, as plans have it, not weighted by inertia
        home = pull - jac.T @ solved(jac @ jac.T + NULL_EASE, jac @ pull)
        # the last term: what of it moves the tcp is taken out again (dynamically consistent projection)
        twist = KP * self.target_error(data) - DAMPING * (jac @ qvel) - jac @ home
        # Khatib's J^T (J M^-1 J^T + ease)^-1 is M (J^T J + ease M)^-1 J^T: one matrix to factorise, and none to invert
        drawn = solved(jac.T @ jac + TASK_EASE * mass, jac.T @ twist)
        return arm.torque(mass @ (drawn + home), data)

    def _relaxation(self, q: Array, qvel: Array) -> Array:
        """Joint accelerations `(dof,)` [rad/s^2] for the null space: towards home, away from the joints' limits, damped."""
        off_limits = np.minimum(np.maximum(q, self._low), self._high) - q
        return NULL_KP * (self.world.home - q) + LIMIT_KP * off_limits - NULL_DAMPING * qvel
