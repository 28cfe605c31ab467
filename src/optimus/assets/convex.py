"""Convex pieces of a mesh: what physics and collision checks see of it."""

from __future__ import annotations

import numpy as np
import trimesh

from optimus.errors import AssetError

CONVEX = 0.98
"""A mesh that fills this much of its hull is taken for convex."""
TOLERANCE = 0.001
"""What a surface may be moved to be simpler [m]."""
CONCAVITY, MOST = 0.05, 32
"""CoaCD's threshold, and the most pieces it may make."""
ITERATIONS, RESOLUTION, COARSE = 60, 1000, 400
"""Of its search, of its samples, and the faces that it is given: a fifth of the time of its own settings, for pieces as close."""
FOOT = 0.0015
"""What is nearer to the ground than this stands on it [m]."""
SECTORS = 12
"""Of a body of revolution: its walls are then at most 3.4 % of the radius from round."""
LEAST_VOLUME = 1e-9
"""Smaller pieces are left out [m^3]."""


def convex_pieces(mesh: trimesh.Trimesh, symmetric: bool = False) -> list[trimesh.Trimesh]:
    """Hulls whose union is nearly `mesh` (watertight, [m]): approximate convex decomposition (Wei et al., CoaCD, 2022).
    `symmetric`: a body of revolution about z."""
    if mesh.volume > CONVEX * mesh.convex_hull.volume:
        return [mesh.convex_hull]
    return _turned(mesh) if symmetric else _footed(_decomposed(mesh, "off"), float(mesh.bounds[0, 2]))


def union_of_pieces(mesh: trimesh.Trimesh) -> trimesh.Trimesh:
    """A closed surface about what `mesh`, which is not closed, seems to enclose."""
    return trimesh.boolean.union(_decomposed(mesh, "on"))


def _decomposed(mesh: trimesh.Trimesh, preprocessing: str) -> list[trimesh.Trimesh]:
    import coacd

    mesh = _coarser(mesh)
    coacd.set_log_level("error")
    pieces = coacd.run_coacd(
        coacd.Mesh(mesh.vertices, mesh.faces),
        threshold=CONCAVITY,
        max_convex_hull=MOST,
        preprocess_mode=preprocessing,
        mcts_iterations=ITERATIONS,
        resolution=RESOLUTION,
        seed=0,
    )
    hulls = [trimesh.Trimesh(np.asarray(v), np.asarray(f)).convex_hull for v, f in pieces if _is_solid(np.asarray(v))]
    kept = [hull for hull in hulls if hull.volume > LEAST_VOLUME]
    if not kept:
        raise AssetError("its convex pieces have no volume")
    return kept


def _coarser(mesh: trimesh.Trimesh) -> trimesh.Trimesh:
    """About `COARSE` faces, if it stays closed: decomposition takes time by the face, and its pieces are coarser anyway."""
    if len(mesh.faces) <= COARSE:
        return mesh
    coarse = mesh.simplify_quadric_decimation(face_count=COARSE)
    if coarse.is_watertight or not mesh.is_watertight:
        return coarse
    import manifold3d

    solid = manifold3d.Manifold(manifold3d.Mesh(np.asarray(mesh.vertices, np.float32), np.asarray(mesh.faces, np.uint32)))
    kept = solid.simplify(TOLERANCE).to_mesh()
    closed = trimesh.Trimesh(np.asarray(kept.vert_properties)[:, :3], np.asarray(kept.tri_verts))
    return closed if 0 < len(closed.faces) < len(mesh.faces) else mesh


def _is_solid(points: np.ndarray) -> bool:
    return len(points) >= 4 and np.linalg.matrix_rank(points - points.mean(axis=0), tol=1e-6) == 3


def _footed(pieces: list[trimesh.Trimesh], low: float) -> list[trimesh.Trimesh]:
    """The pieces with what is nearly on the ground put there: a thing shall not rock on feet of uneven length."""
    feet = []
    for piece in pieces:
        points = piece.vertices.copy()
        points[points[:, 2] < low + FOOT, 2] = low
        feet.append(trimesh.convex.convex_hull(points))
    return feet


def _turned(mesh: trimesh.Trimesh) -> list[trimesh.Trimesh]:
    """Pieces of a body of revolution about z: those of one sector, all the way around. Its yaw means nothing in physics either."""
    sector = trimesh.boolean.intersection([mesh, _wedge(np.pi / SECTORS, 2 * float(np.abs(mesh.bounds).max()))])
    pieces = [sector.convex_hull] if sector.volume > CONVEX * sector.convex_hull.volume else _decomposed(sector, "off")
    turns = [trimesh.transformations.rotation_matrix(2 * np.pi * k / SECTORS, [0, 0, 1]) for k in range(SECTORS)]
    return [piece.copy().apply_transform(turn) for turn in turns for piece in pieces]


def _wedge(half: float, size: float) -> trimesh.Trimesh:
    """What lies within `half` [rad] of the half-plane of positive x, out to `size` [m]."""
    x, y = size, size * float(np.tan(half))
    outline = ((0.0, 0.0), (x, y), (x, -y))
    return trimesh.convex.convex_hull(np.array([(*point, z) for point in outline for z in (-size, size)]))
