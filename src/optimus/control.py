"""From an action to joint torques: the operational-space controller, its limits and its gains, in one place."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np

from optimus.se3 import Array, Pose, error_between, quat_from_rotvec, quat_mul
from optimus.world import World

CONTROL_HZ = 20
POSITION_SCALE = 0.05
"""An action of 1 moves the target by this much a step [m]."""
ROTATION_SCALE = 0.5
"""... and turns it by this much [rad]."""
SCALE = np.array([POSITION_SCALE] * 3 + [ROTATION_SCALE] * 3)


@dataclass(frozen=True)
class OscConfig:
    """Gains and limits of `OperationalSpace`."""

    kp: float = 400.0
    """Stiffness [1/s^2], position and rotation alike; damping is critical."""
    null_kp: float = 10.0
    """Stiffness of the pull towards home in the null space [1/s^2]."""
    max_gap: float = 0.06
    """The target stays within this distance of the tcp [m], so that pressing on something does not wind it up."""
    max_turn: float = 0.6
    """... and within this angle [rad]."""
    low: tuple[float, float, float] = (0.15, -0.55, 0.005)
    """The target's box [m]: below it the fingertips would meet the table."""
    high: tuple[float, float, float] = (0.85, 0.55, 0.65)


class OperationalSpace:
    """Khatib's operational-space law with the full (coupled) task inertia and a null-space pull towards home.

    The action moves a *target* pose, which the law pulls the tcp to; source of the law: Khatib, "A unified approach for motion
    and force control of robot manipulators: the operational space formulation" (1987).
    """

    def __init__(self, world: World, config: OscConfig | None = None) -> None:
        self.world = world
        self.config = config or OscConfig()
        self._jacp = np.zeros((3, world.model.nv))
        self._jacr = np.zeros((3, world.model.nv))
        self._mass = np.zeros((world.model.nv, world.model.nv))
        self._limits = np.array(world.scene.robot.torque_limits)
        self._damping = world.model.dof_damping[world.arm_dof].ravel().copy()
        self.target = Pose.of()

    def reset(self, data: mujoco.MjData) -> None:
        """Aim at where the tcp is."""
        self.target = self.world.tcp(data)

    def move_target(self, action: Array, data: mujoco.MjData) -> None:
        """Shift the target by `action` `(6,)` in [-1, 1] (delta position, delta rotation vector, base frame)."""
        c, tcp = self.config, self.world.tcp(data)
        delta = np.clip(action, -1.0, 1.0) * SCALE
        wanted = Pose(self.target.pos + delta[:3], quat_mul(quat_from_rotvec(delta[3:]), self.target.quat))
        gap = error_between(wanted, tcp)
        distance, angle = float(np.linalg.norm(gap[:3])), float(np.linalg.norm(gap[3:]))
        pos = tcp.pos + gap[:3] * min(1.0, c.max_gap / max(distance, 1e-9))
        turn = gap[3:] * min(1.0, c.max_turn / max(angle, 1e-9))
        quat = quat_mul(quat_from_rotvec(turn), tcp.quat)
        self.target = Pose(np.clip(pos, c.low, c.high), quat / np.linalg.norm(quat))

    def target_error(self, data: mujoco.MjData) -> Array:
        """Target minus tcp, `(6,)` [m, rad], base frame."""
        return error_between(self.target, self.world.tcp(data))

    def torque(self, data: mujoco.MjData) -> Array:
        """Joint torques `(dof,)` [N m], after `mj_step1`."""
        c, w = self.config, self.world
        mujoco.mj_jacSite(w.model, data, self._jacp, self._jacr, w.tcp_site)
        jac = np.concatenate([self._jacp[:, w.arm_dof], self._jacr[:, w.arm_dof]])
        mujoco.mj_fullM(w.model, data, self._mass)
        mass = self._mass[np.ix_(w.arm_dof, w.arm_dof)]
        qvel = data.qvel[w.arm_dof]
        mass_inv = np.linalg.inv(mass)
        mass_inv_jt = mass_inv @ jac.T
        task_mass = np.linalg.inv(jac @ mass_inv_jt + 1e-3 * np.eye(6))
        wrench = task_mass @ (c.kp * self.target_error(data) - 2.0 * np.sqrt(c.kp) * (jac @ qvel))
        relax = mass @ (c.null_kp * (w.home - data.qpos[w.arm_qpos]) - 2.0 * np.sqrt(c.null_kp) * qvel)
        # what of it moves the tcp is taken out again (dynamically consistent projection)
        relax = relax - jac.T @ (task_mass @ (mass_inv_jt.T @ relax))
        torque = jac.T @ wrench + relax + data.qfrc_bias[w.arm_dof] + self._damping * qvel
        return np.clip(torque, -self._limits, self._limits)
