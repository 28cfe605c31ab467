"""A target pose that actions move: what operational-space and inverse-kinematics control have in common."""

from __future__ import annotations

from typing import ClassVar

import mujoco
import numpy as np

from optimus.control.controller import POSITION_SCALE, ROTATION_SCALE, SCALE
from optimus.se3 import Array, Pose, error_between, quat_from_rotvec, quat_mul
from optimus.world import World

MAX_GAP = 0.06
"""The target stays within this distance of the tcp [m], so that pressing on something does not wind it up."""
MAX_TURN = 0.6
"""... and within this angle [rad]."""


class PoseTarget:
    """Actions `(6,)` in [-1, 1]: delta position and delta rotation vector of the target, base frame."""

    size = 6
    scales: ClassVar[dict[str, float]] = {"position_scale": POSITION_SCALE, "rotation_scale": ROTATION_SCALE}

    def __init__(self, world: World) -> None:
        self.world = world
        self.target = Pose.of()
        """`base_from_tcp`, within the scene's box."""

    def reset(self, data: mujoco.MjData) -> None:
        """Aim at where the tcp is."""
        self.target = self.world.tcp(data)

    def move_target(self, action: Array, data: mujoco.MjData) -> None:
        """Shift the target by `action` `(6,)` in [-1, 1] (delta position, delta rotation vector, base frame)."""
        tcp, scene = self.world.tcp(data), self.world.scene
        delta = np.clip(action, -1.0, 1.0) * SCALE
        wanted = Pose(self.target.pos + delta[:3], quat_mul(quat_from_rotvec(delta[3:]), self.target.quat))
        gap = error_between(wanted, tcp)
        distance, angle = float(np.linalg.norm(gap[:3])), float(np.linalg.norm(gap[3:]))
        pos = tcp.pos + gap[:3] * min(1.0, MAX_GAP / max(distance, 1e-9))
        turn = gap[3:] * min(1.0, MAX_TURN / max(angle, 1e-9))
        quat = quat_mul(quat_from_rotvec(turn), tcp.quat)
        self.target = Pose(np.clip(pos, scene.low, scene.high), quat / np.linalg.norm(quat))

    def target_error(self, data: mujoco.MjData) -> Array:
        """Target minus tcp, `(6,)` [m, rad], base frame."""
        return error_between(self.target, self.world.tcp(data))

    def proprioception(self, data: mujoco.MjData) -> dict[str, Array]:
        """The target's error `(6,)` [m, rad]."""
        return {"robot0_target_error": self.target_error(data)}

    def action_for(self, twist: Array, data: mujoco.MjData) -> Array:
        """The action `(6,)` that moves the target by `twist` `(6,)` [m, rad]."""
        return twist / SCALE
