"""What is seen of a MuJoCo model, as triangles: one mesh a body and colour, in the body's frame."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass

import mujoco
import numpy as np
import trimesh
from numpy.typing import NDArray

from optimus.se3 import Array

SEEN_GROUPS = 3
"""MuJoCo draws the geom groups below this one; those from it on are for collisions."""
PLANE = 2.0
"""Half the edge of what is shown of an endless plane [m]."""

Colour = tuple[float, float, float, float]
Geom = mujoco.mjtGeom


@dataclass(frozen=True, eq=False)
class Surface:
    """Triangles of one colour: `vertices` `(n, 3)` [m] in the frame of body `body`, `faces` `(m, 3)`."""

    body: int
    colour: Colour
    vertices: Array
    faces: NDArray[np.int32]


def surfaces(model: mujoco.MjModel) -> list[Surface]:
    """Everything of `model` that is drawn, parts of one body and colour together."""
    parts: dict[tuple[int, Colour], list[trimesh.Trimesh]] = defaultdict(list)
    for geom in _seen(model):
        mesh = _mesh(model, geom)
        turn = np.empty(9)
        mujoco.mju_quat2Mat(turn, model.geom_quat[geom])
        mesh.vertices = mesh.vertices @ turn.reshape(3, 3).T + model.geom_pos[geom]
        parts[int(model.geom_bodyid[geom]), _colour(model, geom)].append(mesh)
    return [_joined(body, colour, meshes) for (body, colour), meshes in parts.items()]


def _joined(body: int, colour: Colour, meshes: list[trimesh.Trimesh]) -> Surface:
    offsets = np.cumsum([0, *(len(m.vertices) for m in meshes)])
    faces = [m.faces + offset for m, offset in zip(meshes, offsets[:-1], strict=True)]
    return Surface(body, colour, np.concatenate([m.vertices for m in meshes]), np.concatenate(faces).astype(np.int32))


def _seen(model: mujoco.MjModel) -> Iterator[int]:
    for geom in range(model.ngeom):
        if model.geom_group[geom] < SEEN_GROUPS and _colour(model, geom)[3] > 0:
            yield geom


def _colour(model: mujoco.MjModel, geom: int) -> Colour:
    material = int(model.geom_matid[geom])
    r, g, b, a = model.geom_rgba[geom] if material < 0 else model.mat_rgba[material]
    return (float(r), float(g), float(b), float(a))


def _mesh(model: mujoco.MjModel, geom: int) -> trimesh.Trimesh:
    """The geom's triangles in its own frame; MuJoCo's sizes are half-sizes."""
    kind, size = Geom(model.geom_type[geom]), model.geom_size[geom]
    if kind == Geom.mjGEOM_MESH:
        return _stored(model, int(model.geom_dataid[geom]))
    if kind == Geom.mjGEOM_BOX:
        return trimesh.creation.box(2 * size)
    if kind == Geom.mjGEOM_PLANE:
        half = np.where(size[:2] > 0, size[:2], PLANE)
        return trimesh.creation.box((2 * half[0], 2 * half[1], 0.002), trimesh.transformations.translation_matrix((0, 0, -0.001)))
    if kind == Geom.mjGEOM_CYLINDER:
        return trimesh.creation.cylinder(size[0], 2 * size[1], sections=32)
    if kind == Geom.mjGEOM_CAPSULE:
        return trimesh.creation.capsule(2 * size[1], size[0], count=[16, 16])
    ball = trimesh.creation.icosphere(3)
    ball.vertices = ball.vertices * (size if kind == Geom.mjGEOM_ELLIPSOID else size[0])
    return ball


def _stored(model: mujoco.MjModel, mesh: int) -> trimesh.Trimesh:
    vertex, vertices = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
    face, faces = model.mesh_faceadr[mesh], model.mesh_facenum[mesh]
    points = model.mesh_vert[vertex : vertex + vertices].astype(np.float64)
    return trimesh.Trimesh(points, model.mesh_face[face : face + faces].copy(), process=False)
