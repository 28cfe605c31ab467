"""Shapes: what an object is made of, how heavy it is, where a hand may take it, and what may rest on it."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from optimus.errors import ModelError
from optimus.se3 import Array, Pose, quat_from_matrix

SECTORS = 12
"""Bodies of revolution are made of that many equal ones: a turn by one changes nothing, in physics either."""

STANDS = 0.7
"""A thing whose axis is this near to the vertical stands, another lies: the cosine between the two."""

Vec3 = tuple[float, float, float]
Rgba = tuple[float, float, float, float]


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles: `vertices` `(n, 3)` [m] in the object's frame and `faces` `(m, 3)`. One and the same is equal to itself alone."""

    vertices: Array
    faces: NDArray[np.int32]

    @cached_property
    def digest(self) -> str:
        """Of its content."""
        return hashlib.sha256(self.vertices.tobytes() + self.faces.tobytes()).hexdigest()[:16]


@dataclass(frozen=True)
class Part:
    """One convex piece in the object's frame: a primitive (MuJoCo's half-size convention [m], position [m], quaternion wxyz), or
    the hull of a mesh."""

    kind: Literal["box", "cylinder", "sphere", "mesh"]
    size: tuple[float, ...] = ()
    pos: Vec3 = (0.0, 0.0, 0.0)
    quat: tuple[float, float, float, float] = (1.0, 0.0, 0.0, 0.0)
    mesh: Mesh | None = None

    def __post_init__(self) -> None:
        if not all(0.0 < size < np.inf for size in self.size):
            sizes = ", ".join(f"{size:.4g}" for size in self.size)
            raise ModelError(f"a {self.kind} of half-sizes {sizes} m: each has to be above zero")


@dataclass(frozen=True)
class Inertia:
    """Of a body: its centre of mass [m] and principal moments [kg m^2] about axes turned by `quat`, in the object's frame."""

    com: Vec3
    moments: Vec3
    quat: tuple[float, float, float, float]


@dataclass(frozen=True)
class Grasp:
    """Where the tcp goes to take an object, `object_from_tcp`; the tcp's z axis approaches, the fingers close along its y."""

    pos: Vec3
    quat: tuple[float, float, float, float]

    @property
    def pose(self) -> Pose:
        return Pose(np.array(self.pos), np.array(self.quat))


@dataclass(frozen=True)
class Surface:
    """A horizontal rectangle of the object's frame on which things may rest: height `z` and half-sizes [m]."""

    z: float
    half_x: float
    half_y: float


@dataclass(frozen=True)
class Shape:
    """An object type. The frame's origin is the centre of the bounding box, z up when it stands as it should."""

    kind: str
    parts: tuple[Part, ...]
    half_extents: Vec3
    mass: float
    rgba: Rgba
    grasps: tuple[Grasp, ...] = ()
    surface: Surface | None = None
    symmetric: bool = False
    """True for a body of revolution about z: its yaw means nothing."""
    friction: float = 1.0
    """Sliding friction against the pads and what it stands on."""
    look: Mesh | None = None
    """What is seen of it, where that is not its parts."""
    inertia: Inertia | None = None
    """None: the parts are of even weight."""
    verified: bool = False
    """Each grasp was tried as it stands, from above or leaning; otherwise a grasp may be turned about the line on which the fingers
    close."""

    def __post_init__(self) -> None:
        if not 0.0 < self.mass < np.inf:
            raise ModelError(f"a {self.kind} of {self.mass} kg: its mass has to be above zero")

    def above(self, rotation: Array) -> float:
        """How far its centre is above its lowest point when it is turned by `rotation` `(3, 3)` [m]: of the bounding box or, of a
        body of revolution, of the bounding cylinder."""
        if not self.symmetric:
            return float(np.abs(rotation[2]) @ np.array(self.half_extents))
        up = min(1.0, abs(float(rotation[2, 2])))
        return self.half_extents[0] * float(np.sqrt(1.0 - up * up)) + self.half_extents[2] * up

    def reach(self, rotation: Array) -> float:
        """The radius of the disc about its centre that it covers, seen from above, when it is turned by `rotation` `(3, 3)` [m]: of
        the bounding box or, of a body of revolution, of the bounding cylinder."""
        half = np.array(self.half_extents)
        if not self.symmetric:
            corners = [rotation[:2] @ (half * (x, y, 1.0)) for x in (-1.0, 1.0) for y in (-1.0, 1.0)]
            return max(float(np.hypot(*corner)) for corner in corners)
        radius, up = half[0], min(1.0, abs(float(rotation[2, 2])))
        out = half[2] * np.sqrt(1.0 - up * up)
        # the farthest point of the upper rim, at the cosine `c` from the way that the axis leans
        c = 1.0 if out * up >= radius * (1.0 - up * up) else out * up / (radius * (1.0 - up * up))
        return float(np.sqrt((out + radius * up * c) ** 2 + radius**2 * (1.0 - c * c)))

    def level(self, rotation: Array) -> float:
        """How nearly it stands, or lies, flat when it is turned by `rotation` `(3, 3)`: the cosine of what is missing."""
        if not self.symmetric:
            return float(np.abs(rotation[2]).max())
        up = min(1.0, abs(float(rotation[2, 2])))
        return max(up, float(np.sqrt(1.0 - up * up)))


def stands(pose: Pose) -> bool:
    """Whether a thing stands, or stands on its head, rather than lies on its side."""
    return abs(float(pose.matrix[2, 2])) > STANDS


def unrolled(pose: Pose) -> Pose:
    """Where a body of revolution lies, whatever its turn about its own axis, z: its second axis is level, so that fingers which
    shut along that one reach it from above."""
    axis = pose.matrix[:, 2]
    level = np.array([-axis[1], axis[0], 0.0]) / np.hypot(axis[0], axis[1])
    matrix = np.zeros((3, 3))
    matrix[:, 0], matrix[:, 1], matrix[:, 2] = np.cross(level, axis), level, axis
    return Pose.from_matrix(pose.pos, matrix)


def top_grasp(yaw: float, z: float, x: float = 0.0, y: float = 0.0) -> Grasp:
    """From straight above, tcp at height `z` of the object's frame, fingers closing along the direction `yaw` [rad]."""
    c, s = np.cos(yaw), np.sin(yaw)
    # columns: tcp x, y (closing direction), z (down)
    matrix = np.array([[-s, c, 0.0], [c, s, 0.0], [0.0, 0.0, -1.0]])
    w, qx, qy, qz = quat_from_matrix(matrix)
    return Grasp((x, y, z), (float(w), float(qx), float(qy), float(qz)))


def block(edge: float, rgba: Rgba, mass: float = 0.05) -> Shape:
    """A cube of the given edge length [m]."""
    half = edge / 2
    return Shape(
        kind="block",
        parts=(Part("box", (half, half, half)),),
        half_extents=(half, half, half),
        mass=mass,
        rgba=rgba,
        grasps=tuple(top_grasp(k * np.pi / 2, 0.0) for k in range(4)),
        surface=Surface(half, half, half),
    )


def cylinder(radius: float, height: float, rgba: Rgba, mass: float = 0.08) -> Shape:
    """An upright cylinder [m], taken from above across its diameter."""
    half = height / 2
    return Shape(
        kind="cylinder",
        parts=(Part("cylinder", (radius, half)),),
        half_extents=(radius, radius, half),
        mass=mass,
        rgba=rgba,
        grasps=tuple(top_grasp(k * np.pi / 8, max(0.0, half - 0.025)) for k in range(16)),
        surface=Surface(half, radius / np.sqrt(2), radius / np.sqrt(2)),
        symmetric=True,
    )


def cup(radius: float, height: float, rgba: Rgba, mass: float = 0.08, wall: float = 0.007, sides: int = 16) -> Shape:
    """An open vessel [m]: a floor and a ring of `sides` wall panels, taken from above across its mouth."""
    half = height / 2
    panel = Part("box", (wall / 2, radius * np.tan(np.pi / sides), half))
    walls = []
    for k in range(sides):
        angle = 2 * np.pi * k / sides
        centre = radius - wall / 2
        walls.append(
            Part(
                "box",
                panel.size,
                (float(centre * np.cos(angle)), float(centre * np.sin(angle)), 0.0),
                (float(np.cos(angle / 2)), 0.0, 0.0, float(np.sin(angle / 2))),
            )
        )
    floor = Part("cylinder", (radius - wall, wall), (0.0, 0.0, wall - half))
    return Shape(
        kind="cup",
        parts=(floor, *walls),
        half_extents=(radius, radius, half),
        mass=mass,
        rgba=rgba,
        # one grasp a pair of opposite panels, so that the pads meet flat faces
        grasps=tuple(top_grasp(2 * np.pi * k / sides, half - 0.025) for k in range(sides)),
        symmetric=True,
    )


def slab(half_x: float, half_y: float, thickness: float, rgba: Rgba) -> Shape:
    """A fixed plate (a table top, a platform) whose upper face carries things; half-sizes and thickness [m]."""
    half = thickness / 2
    return Shape(
        kind="slab",
        parts=(Part("box", (half_x, half_y, half)),),
        half_extents=(half_x, half_y, half),
        mass=1.0,
        rgba=rgba,
        surface=Surface(half, half_x, half_y),
    )
