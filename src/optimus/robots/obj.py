"""Triangle meshes in Wavefront OBJ files, with a normal at every corner: read, join, reduce, write."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

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
    """Read an OBJ file of triangles; points at the same place become one. `AssetError` when it is not one."""
    text = path.read_text(encoding="utf-8").splitlines()
    try:
        places, directions = _rows(text, "v").astype(float), _rows(text, "vn").astype(float)
        # a corner is "7", "7/2", "7//5" or "7/2/5": its point comes first, its normal (if any) last
        corners = _rows([line.replace("/", " ") for line in text if line.startswith("f ")], "f").astype(int)
        corners = corners.reshape(len(corners), 3, -1) - 1
    except ValueError as error:
        raise AssetError(f"{path} is not an OBJ file of triangles: {error}") from error
    if not len(corners):
        raise AssetError(f"{path} holds no triangles")
    # exports repeat a point once a face; joined up, the simplifier can collapse the edges between faces
    points, joined = np.unique(places, axis=0, return_inverse=True)
    faces = joined.reshape(-1)[corners[:, :, 0]]
    solid = (faces != np.roll(faces, 1, axis=1)).all(axis=1)
    mesh = Mesh(points, faces[solid], np.zeros((int(solid.sum()), 3, 3)))
    if len(directions):
        return replace(mesh, normals=directions[corners[:, :, -1]][solid])
    return replace(mesh, normals=np.repeat(mesh.face_normals[:, None], 3, axis=1))


def _rows(lines: Sequence[str], kind: str) -> np.ndarray:
    """The words after `kind` in the lines that start with it, one row a line."""
    chosen = [line.removeprefix(f"{kind} ") for line in lines if line.startswith(f"{kind} ")]
    if not chosen:
        return np.empty((0, 3), dtype="U1")
    return np.array(" ".join(chosen).split()).reshape(len(chosen), -1)


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
    from scipy.spatial import KDTree  # it takes half a second to load, and few need it

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
