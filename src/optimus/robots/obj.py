"""Triangle meshes in Wavefront OBJ files, with a normal at every corner: read, join, reduce, write."""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.spatial import KDTree

from optimus.errors import AssetError

AGGRESSION = 3.0  # of the simplifier: at its default of 7 smooth shells get dents
NEIGHBOURS = 12  # faces of the full mesh that may give a corner of the reduced one its normal
SAME_SIDE = 0.6  # cosine up to which they count as the same surface, so that edges stay sharp


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles with corner normals."""

    points: np.ndarray  # (n, 3) [m]
    faces: np.ndarray  # (m, 3) indices
    normals: np.ndarray  # (m, 3 corners, 3)

    @property
    def areas(self) -> np.ndarray:
        """Area of each face [m^2], (m,)."""
        return np.linalg.norm(self._cross(), axis=1) / 2

    @property
    def face_normals(self) -> np.ndarray:
        """Unit normal of each face, (m, 3)."""
        return _unit(self._cross())

    def _cross(self) -> np.ndarray:
        a, b, c = (self.points[self.faces[:, corner]] for corner in range(3))
        return np.cross(b - a, c - a)


def read(path: Path) -> Mesh:
    """Read an OBJ file; points at the same place become one. `AssetError` when it holds no triangles."""
    rows: dict[str, list[list[float]]] = {"v": [], "vn": []}
    corners: list[tuple[str, ...]] = []
    for line in path.read_text(encoding="utf-8").splitlines():
        kind, *words = line.split() or [""]
        if kind in rows:
            rows[kind].append([float(word) for word in words[:3]])
        elif kind == "f":
            corners += [(words[0], b, c) for b, c in itertools.pairwise(words[1:])]
    if not corners:
        raise AssetError(f"{path} holds no triangles")
    # "7", "7/2", "7//5" and "7/2/5" all start with the point and, if they name a normal, end with it
    index = np.array([[int(word.split("/")[0]) for word in face] for face in corners]) - 1
    # exports repeat a point once a face; joined up, the simplifier can collapse the edges between faces
    points, joined = np.unique(np.asarray(rows["v"]), axis=0, return_inverse=True)
    faces = joined.reshape(-1)[index]
    solid = (faces != np.roll(faces, 1, axis=1)).all(axis=1)
    if rows["vn"]:
        normal_index = np.array([[int(word.split("/")[-1]) for word in face] for face in corners]) - 1
        return Mesh(points, faces[solid], np.asarray(rows["vn"])[normal_index][solid])
    flat = Mesh(points, faces[solid], np.zeros((int(solid.sum()), 3, 3)))
    return Mesh(flat.points, flat.faces, np.repeat(flat.face_normals[:, None], 3, axis=1))


def join(meshes: Sequence[Mesh]) -> Mesh:
    """One mesh of all."""
    starts = np.cumsum([0, *(len(mesh.points) for mesh in meshes[:-1])])
    return Mesh(
        np.concatenate([mesh.points for mesh in meshes]),
        np.concatenate([mesh.faces + start for mesh, start in zip(meshes, starts, strict=True)]),
        np.concatenate([mesh.normals for mesh in meshes]),
    )


def reduce(mesh: Mesh, count: int) -> Mesh:
    """The mesh with about `count` faces, shaded like the full one: corners take their normals there."""
    import fast_simplification

    if len(mesh.faces) <= count:
        return mesh
    points, faces, *_ = fast_simplification.simplify(
        mesh.points, mesh.faces.astype(np.int32), target_count=count, agg=AGGRESSION
    )
    flat = Mesh(points, faces, np.zeros((len(faces), 3, 3)))
    own = np.repeat(flat.face_normals, 3, axis=0)
    # slightly inwards, so that a corner on an edge looks at its own face's side of it
    corners = (0.97 * points[faces] + 0.03 * points[faces].mean(axis=1, keepdims=True)).reshape(-1, 3)
    near = min(NEIGHBOURS, len(mesh.faces))
    _, index = KDTree(mesh.points[mesh.faces].mean(axis=1)).query(corners, k=near)
    index = np.asarray(index).reshape(len(corners), near)
    theirs = _unit(mesh.normals.mean(axis=1))[index]
    weights = mesh.areas[index] * (np.einsum("cki,ci->ck", theirs, own) > SAME_SIDE)
    shaded = np.einsum("ck,cki->ci", weights, theirs)
    lost = np.linalg.norm(shaded, axis=1) < 1e-12
    normals = np.where(lost[:, None], own, _unit(shaded))
    return Mesh(points, faces, normals.reshape(-1, 3, 3))


def write(mesh: Mesh, path: Path) -> None:
    """Write an OBJ file: points to a micrometre, normals to a thousandth."""
    normals, index = np.unique(mesh.normals.reshape(-1, 3).round(3), axis=0, return_inverse=True)
    lines = [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in mesh.points]
    lines += [f"vn {x:.3f} {y:.3f} {z:.3f}" for x, y, z in normals]
    for face, normal in zip(mesh.faces + 1, index.reshape(-1, 3) + 1, strict=True):
        lines.append("f " + " ".join(f"{a}//{b}" for a, b in zip(face, normal, strict=True)))
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def _unit(vectors: np.ndarray) -> np.ndarray:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-15)
