"""`Scene`: what there is, where it stands and what sees it, as plain data."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from optimus.objects.shapes import Shape, Vec3
from optimus.robots import Robot
from optimus.se3 import Pose, quat_from_rotvec


@dataclass(frozen=True)
class Fixture:
    """A thing that never moves."""

    name: str
    shape: Shape
    pos: Vec3
    yaw: float = 0.0
    door: str | None = None
    """What its surface lies behind, if anything does: it is reached only while that door is open."""

    @property
    def pose(self) -> Pose:
        return Pose.of(self.pos, (0.0, 0.0, self.yaw))


@dataclass(frozen=True)
class Bar:
    """A round upright bar to pull a door by: its middle in the door's frame, radius and length [m]."""

    pos: Vec3
    radius: float
    length: float


@dataclass(frozen=True)
class Door:
    """A panel on an upright hinge. The door's frame has its origin on the hinge's axis; shut, it is turned like the base frame."""

    name: str
    shape: Shape
    hinge: Vec3
    bar: Bar
    turns: float
    """+1 or -1: about which sense of the vertical it opens."""
    widest: float = 1.8
    """How far it opens [rad]."""

    def pose(self, angle: float) -> Pose:
        """`base_from_door` when it is open by `angle` [rad]."""
        return Pose(np.array(self.hinge), quat_from_rotvec((0.0, 0.0, self.turns * angle)))


@dataclass(frozen=True)
class Movable:
    """A thing that can be picked up."""

    name: str
    shape: Shape


@dataclass(frozen=True)
class Camera:
    """A fixed camera: where it stands and what it looks at, in the base frame [m]; vertical field of view [deg]."""

    name: str
    pos: Vec3
    target: Vec3
    fovy: float = 45.0


@dataclass(frozen=True)
class Scene:
    """Everything that a model is built from. The base frame is the world frame; the table's top is z = 0."""

    robot: Robot
    fixtures: tuple[Fixture, ...]
    movables: tuple[Movable, ...]
    cameras: tuple[Camera, ...]
    doors: tuple[Door, ...] = ()
    low: Vec3 = (0.15, -0.55, 0.005)
    """The box that the hand's target stays in [m]: below it the fingertips would meet the table."""
    high: Vec3 = (0.85, 0.55, 0.65)

    def shape_of(self, name: str) -> Shape:
        for thing in (*self.movables, *self.fixtures):
            if thing.name == name:
                return thing.shape
        raise KeyError(name)

    @cached_property
    def movable_names(self) -> tuple[str, ...]:
        return tuple(m.name for m in self.movables)

    @cached_property
    def fixture_poses(self) -> dict[str, Pose]:
        return {f.name: f.pose for f in self.fixtures}

    def door(self, name: str) -> Door:
        """The door of that name; KeyError without one."""
        return {d.name: d for d in self.doors}[name]

    def door_before(self, support: str) -> str | None:
        """The door that the support's surface lies behind, if any."""
        return next((f.door for f in self.fixtures if f.name == support), None)
