"""`Scene`: what there is, where it stands and what sees it, as plain data."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from optimus.errors import ModelError
from optimus.objects.shapes import Shape, Vec3
from optimus.robots import Robot
from optimus.se3 import Array, Pose, quat_from_rotvec

ROOF_FROM, ROOF_TO = 0.02, 0.45
"""What is this much above a point is over it, and within a hand's and a wrist's length [m]."""
HAND_REACH = 0.10
"""A hand at a bar reaches this far beyond it [m]."""


@dataclass(frozen=True)
class Fixture:
    """A thing that never moves."""

    name: str
    shape: Shape
    pos: Vec3
    yaw: float = 0.0
    door: str | None = None
    """What its surface lies behind, if anything does: it is reached only while that door is open."""
    words: str = ""
    """What people call it, a noun phrase without its article; empty: its name."""

    @property
    def pose(self) -> Pose:
        return Pose.of(self.pos, (0.0, 0.0, self.yaw))

    @cached_property
    def boxes(self) -> tuple[tuple[Array, Array], ...]:
        """The lower and upper corner `(3,)` [m] of each part's bounding box, base frame."""
        found = []
        for part in self.shape.parts:
            turn = self.pose @ Pose(np.array(part.pos), np.array(part.quat))
            if part.mesh is not None:
                points = turn.transform(part.mesh.vertices)
                found.append((points.min(0), points.max(0)))
                continue
            size = {"box": part.size, "cylinder": (part.size[0], part.size[0], part.size[-1]), "sphere": (part.size[0],) * 3}
            half = np.abs(turn.matrix) @ np.array(size[part.kind])
            found.append((turn.pos - half, turn.pos + half))
        return tuple(found)


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
    words: str = ""
    """What people call it, a noun phrase without its article; empty: what is known of its shape, or colour and kind."""

WRIST_CAMERA = "robot0_eye_in_hand"
"""The robot's own, as observations name it."""


@dataclass(frozen=True)
class Camera:
    """A fixed camera: where it stands and what it looks at, in the base frame [m]; vertical field of view [deg]."""

    name: str
    pos: Vec3
    target: Vec3
    fovy: float = 45.0

    def __post_init__(self) -> None:
        if not np.isfinite([*self.pos, *self.target, self.fovy]).all() or not 0 < self.fovy < 180:
            raise ModelError(f"camera {self.name!r}: positions are numbers [m], the field of view is between 0 and 180 degrees")
        if np.allclose(self.pos, self.target, atol=1e-6):
            raise ModelError(f"camera {self.name!r} stands at what it looks at; let it look elsewhere")

    @classmethod
    def of(cls, record: Mapping[str, Any]) -> Camera:
        """The inverse of `dataclasses.asdict`, from parsed JSON."""
        (x, y, z), (tx, ty, tz) = record["pos"], record["target"]
        return cls(record["name"], (x, y, z), (tx, ty, tz), record["fovy"])


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

    def __post_init__(self) -> None:
        things = Counter(thing.name for thing in (*self.fixtures, *self.movables, *self.doors))
        if twice := sorted(name for name, times in things.items() if times > 1):
            raise ModelError(f"a scene's things have names of their own; of one name there is more than one: {', '.join(twice)}")
        if "" in things:
            raise ModelError("a scene's things have names of their own; one has none")
        eyes = Counter([WRIST_CAMERA, *(c.name for c in self.cameras)])
        if twice := sorted(name for name, times in eyes.items() if times > 1):
            raise ModelError(f"of the name {twice[0]!r} there is more than one camera; name the new one otherwise")
        for fixture in self.fixtures:
            if fixture.door is not None and fixture.door not in (doors := [door.name for door in self.doors]):
                raise ModelError(f"{fixture.name} is behind the door {fixture.door}; the scene's are {', '.join(doors) or 'none'}")

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

    def top_along(self, fixture: Fixture, start: Array, end: Array, margin: float) -> float:
        """The height [m] of the highest part of `fixture` within `margin` [m] of the level way from `start` to `end`; the floor's
        (0) without one."""
        samples = np.linspace(start[:2], end[:2], 12)
        tops = [0.0]
        for low, high in fixture.boxes:
            gaps = np.maximum(np.maximum(low[:2] - samples, samples - high[:2]), 0.0)
            if np.linalg.norm(gaps, axis=1).min() <= margin:
                tops.append(float(high[2]))
        return max(tops)

    def is_roofed(self, point: Array, margin: float) -> bool:
        """Whether some fixture is overhead, within `margin` [m] sideways and so low that a hand from above would meet it."""
        return any(
            np.all(point[:2] > low[:2] - margin)
            and np.all(point[:2] < high[:2] + margin)
            and ROOF_FROM < low[2] - point[2] < ROOF_TO
            for fixture in self.fixtures
            for low, high in fixture.boxes
        )

    def is_covered(self, point: Array, margin: float, support: str) -> bool:
        """Whether another fixture than `support` stands on `point`, or within `margin` [m] of it."""
        return any(
            np.all(point[:2] > low[:2] - margin) and np.all(point[:2] < high[:2] + margin)
            for low, high in self.standing_at(point[2], support)
        )

    def standing_at(self, height: float, support: str) -> list[tuple[Array, Array]]:
        """The boxes (see `Fixture.boxes`) of other fixtures than `support` that are as high as what stands at that height [m]."""
        boxes = (box for fixture in self.fixtures if fixture.name != support for box in fixture.boxes)
        return [(low, high) for low, high in boxes if low[2] - 0.05 < height < high[2] - 1e-3]

    def in_swing(self, point: Array, radius: float, support: str) -> bool:
        """Whether a thing of `radius` [m] at `point` would be in the way of a door, or of the hand that pulls it. What lies behind
        a door is not."""
        for door in self.doors:
            if self.door_before(support) == door.name:
                continue
            local = door.pose(0.0).inverse.transform(point)
            reach = door.shape.half_extents[1] * 2 + HAND_REACH + radius
            # towards the arm is -x of the door's frame; a hand's breadth behind the hinge's line still counts
            if float(np.hypot(*local[:2])) < reach and local[0] < 0.0 and local[1] * np.sign(door.bar.pos[1]) > -HAND_REACH:
                return True
        return False
