"""`Robot`: the names and numbers of one arm with a parallel gripper."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from optimus.objects.shapes import Vec3

Quat = tuple[float, float, float, float]
"""wxyz"""

GRIPPER_PREFIX = "gripper/"
"""Before every name of a gripper that has a model of its own."""


@dataclass(frozen=True)
class Mount:
    """A gripper that has a model of its own: which, and where its root goes on the arm."""

    model: str
    """Its URDF or MJCF file."""
    body: str
    """The arm's body that carries it."""
    pos: Vec3 = (0.0, 0.0, 0.0)
    """Its root in that body's frame [m]."""
    quat: Quat = (1.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Robot:
    """One arm with a two-finger gripper; plain data, so that scenes can be compared and cached by value."""

    name: str
    source: str
    """Its model: a URDF or MJCF file, or `menagerie:NAME` (see `optimus.robots.model`)."""
    joints: tuple[str, ...]
    fingers: tuple[str, str]
    """The finger joints."""
    finger_bodies: tuple[str, str]
    hand: str
    """The body that the tcp and the wrist camera are fixed to."""
    tcp: Vec3
    """The tool centre point in the hand's frame [m]; z approaches, the fingers close along y."""
    home: tuple[float, ...]
    """The reset configuration [rad], the null-space reference and the seed of every IK."""
    torque_limits: tuple[float, ...]
    """[N m]"""
    speed_limits: tuple[float, ...]
    """[rad/s]"""
    finger_open: tuple[float, float]
    """Where the finger joints are when the hand is open [m]."""
    camera_pos: Vec3
    """The wrist camera in the hand's frame [m]."""
    camera_target: Vec3
    """What it looks at, in the hand's frame [m]."""
    finger_shut: tuple[float, float] = (0.0, 0.0)
    """... and when the fingertips meet [m]."""
    gripper_actuator: str | None = None
    """What drives the fingers; None: an actuator of our own each."""
    actuator_travel: tuple[float, float] = (0.0, 0.0)
    """Its length in MuJoCo's sense when the hand is shut and when it is open [m]."""
    pad_pos: Vec3 | None = None
    """Centre of the fingertip pad, one box a finger, in the finger's frame [m]; None keeps the model's own."""
    pad_half: Vec3 = (0.0, 0.0, 0.0)
    """Its half-sizes [m]."""
    camera_fovy: float = 72.0
    tcp_quat: Quat = (1.0, 0.0, 0.0, 0.0)
    """The tool's orientation in the hand's frame."""
    base_pos: Vec3 = (0.0, 0.0, 0.0)
    """Where the robot's root stands in the base frame of the scene [m]: x forward, the table's top is z = 0."""
    base_quat: Quat = (1.0, 0.0, 0.0, 0.0)
    mount: Mount | None = None
    """The gripper's own model, if the arm's does not include one."""
    ik: Literal["panda", "numeric"] = "numeric"
    """How inverse kinematics finds where to start: in closed form, or from a spread of configurations."""
    untouching: tuple[tuple[str, str], ...] = ()
    """Pairs of bodies whose contacts are left out."""

    @property
    def finger_travel(self) -> float:
        """How far each finger opens from shut [m]."""
        return abs(self.finger_open[0] - self.finger_shut[0])

    @property
    def finger_signs(self) -> tuple[float, float]:
        """+1 for a finger joint that grows as the hand opens, -1 for one that shrinks."""
        first, second = (1.0 if o > s else -1.0 for o, s in zip(self.finger_open, self.finger_shut, strict=True))
        return first, second
