"""Joint control: a joint target that actions move, and the impedance law that holds the arm at it."""

from __future__ import annotations

from typing import ClassVar

import mujoco
import numpy as np

from optimus.control.controller import JOINT_SCALE
from optimus.control.dynamics import ArmDynamics
from optimus.se3 import Array
from optimus.world import World

KP = 400.0
"""Stiffness [1/s^2], of every joint alike; damping is critical."""
MAX_LEAD = 0.2
"""A joint's target stays within this much of the joint [rad]: pressing on something does not wind it up, and no joint is
pulled along faster than MAX_LEAD sqrt(KP) / 2 = 2 rad/s."""

DAMPING = 1e-4
"""Of the least squares by which a motion of the tcp becomes one of the joints."""


class JointImpedance:
    """Every joint a critically damped spring to its target, of the same frequency whatever it carries: the springs' pull is
    passed through the arm's full inertia, and gravity, Coriolis forces and the joints' own damping are compensated."""

    def __init__(self, world: World) -> None:
        self._arm = ArmDynamics(world)

    def torque(self, data: mujoco.MjData, target: Array) -> Array:
        """Joint torques `(dof,)` [N m] towards `target` `(dof,)` [rad], after `mj_step1`."""
        arm = self._arm
        wanted = KP * (target - arm.q(data)) - 2.0 * np.sqrt(KP) * arm.qvel(data)
        return arm.torque(arm.mass(data) @ wanted, data)


class JointTarget:
    """Actions `(dof,)` in [-1, 1]: delta of the joint target, in units of `JOINT_SCALE`."""

    name: ClassVar[str] = "joint"
    scales: ClassVar[dict[str, float]] = {"joint_scale": JOINT_SCALE}

    def __init__(self, world: World) -> None:
        self.world = world
        self.size = len(world.arm_qpos)
        self.target = world.home.copy()
        """`(dof,)` [rad], within the joints' limits."""
        self._law, self._arm = JointImpedance(world), ArmDynamics(world)

    def reset(self, data: mujoco.MjData) -> None:
        """Aim at where the joints are."""
        self.target = self._arm.q(data).copy()

    def move_target(self, action: Array, data: mujoco.MjData) -> None:
        """Shift the target by `action` `(dof,)` in [-1, 1]."""
        q, limits = self._arm.q(data), self.world.arm_range
        wanted = self.target + np.clip(action, -1.0, 1.0) * JOINT_SCALE
        self.target = np.clip(np.clip(wanted, q - MAX_LEAD, q + MAX_LEAD), limits[:, 0], limits[:, 1])

    def target_error(self, data: mujoco.MjData) -> Array:
        """Target minus joint positions, `(dof,)` [rad]."""
        return self.target - self._arm.q(data)

    def torque(self, data: mujoco.MjData) -> Array:
        """Joint torques `(dof,)` [N m], after `mj_step1`."""
        return self._law.torque(data, self.target)

    def proprioception(self, data: mujoco.MjData) -> dict[str, Array]:
        """Where the joints are, and the target's error, each `(dof,)` [rad]."""
        return {"robot0_joint_pos": self._arm.q(data).copy(), "robot0_joint_target_error": self.target_error(data)}

    def action_for(self, twist: Array, data: mujoco.MjData) -> Array:
        """The smallest action `(dof,)` that moves the tcp by `twist` `(6,)` [m, rad], to first order."""
        jac = self._arm.jacobian(data)
        return jac.T @ np.linalg.solve(jac @ jac.T + DAMPING * np.eye(6), twist) / JOINT_SCALE
