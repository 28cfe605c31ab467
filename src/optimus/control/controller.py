"""What every way of control is, and what an action of 1 means to it."""

from __future__ import annotations

from typing import ClassVar, Protocol

import mujoco
import numpy as np

from optimus.se3 import Array

CONTROL_HZ = 20
"""Actions a second [1/s]."""
POSITION_SCALE = 0.05
"""An action of 1 moves the target pose by this much a step [m]."""
ROTATION_SCALE = 0.5
"""... and turns it by this much [rad]."""
SCALE = np.array([POSITION_SCALE] * 3 + [ROTATION_SCALE] * 3)
"""Both, as the arm's part of an action has them `(6,)` [m, rad]."""
JOINT_SCALE = 0.15
"""An action of 1 moves a joint's target by this much a step [rad]: 3 rad/s, somewhat more than the arm can do."""


class Controller(Protocol):
    """Pulls the arm to a target that actions move. An action is the arm's part `(size,)`, in [-1, 1], and then the gripper's
    one number, which is none of the controller's business."""

    name: ClassVar[str]
    size: int
    """Of the arm's part of an action."""
    scales: ClassVar[dict[str, float]]
    """What an action of 1 stands for, by the name that a dataset records it under [m or rad]."""

    def reset(self, data: mujoco.MjData) -> None:
        """Aim at where the arm is."""
        ...

    def move_target(self, action: Array, data: mujoco.MjData) -> None:
        """Shift the target by the arm's part of an action `(size,)`, and no further than the arm can be expected to follow."""
        ...

    def target_error(self, data: mujoco.MjData) -> Array:
        """Target minus where the arm is, `(size,)` in SI units."""
        ...

    def torque(self, data: mujoco.MjData) -> Array:
        """Joint torques `(dof,)` [N m], within the robot's limits, after `mj_step1`."""
        ...

    def proprioception(self, data: mujoco.MjData) -> dict[str, Array]:
        """What an agent is told of the arm beside tcp and fingers, so that its answer can be a function of what it sees."""
        ...

    def action_for(self, twist: Array, data: mujoco.MjData) -> Array:
        """The arm's part of an action `(size,)`, unclipped, that moves the tcp by `twist` `(6,)` [m, rad], base frame."""
        ...
