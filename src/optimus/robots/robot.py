"""`Robot`: the names and numbers of one arm with a parallel gripper."""

from __future__ import annotations

from dataclasses import dataclass

from optimus.objects.shapes import Vec3


@dataclass(frozen=True)
class Robot:
    """One arm with a two-finger gripper; plain data, so that scenes can be compared and cached by value."""

    name: str
    source: str
    """Which model to load (see `optimus.robots.model_path`)."""
    joints: tuple[str, ...]
    fingers: tuple[str, str]
    """The finger joints; both grow as the hand opens."""
    finger_bodies: tuple[str, str]
    hand: str
    """The body that the tcp and the wrist camera are fixed to."""
    tcp: Vec3
    """The tool centre point in the hand's frame [m]; z approaches, the fingers close along y."""
    home: tuple[float, ...]
    """The reset configuration [rad], the null-space reference and the seed of every IK."""
    torque_limits: tuple[float, ...]
    speed_limits: tuple[float, ...]
    """[rad/s]"""
    finger_travel: float
    """How far each finger opens from shut [m]."""
    gripper_actuator: str
    pad_pos: Vec3
    """Centre of the fingertip pad, one box a finger, in the finger's frame [m]."""
    pad_half: Vec3
    """Its half-sizes [m]."""
    camera_pos: Vec3
    """The wrist camera in the hand's frame [m]."""
    camera_target: Vec3
    """What it looks at, in the hand's frame [m]."""
    camera_fovy: float = 72.0
