"""Convex pieces of a mesh: what physics and collision checks see of it."""

from __future__ import annotations

import numpy as np
import trimesh

from optimus.errors import AssetError

CONVEX = 0.98
"""A mesh that fills this much of its hull is taken for convex."""
CONCAVITY, MOST = 0.04, 24
"""CoaCD's threshold, and the most pieces it may make."""
MOST_VERTICES = 48
"""Of a piece."""
LEAST_VOLUME = 1e-9
"""Smaller pieces are left out [m^3]."""


def convex_pieces(mesh: trimesh.Trimesh) -> list[trimesh.Trimesh]:
    """Hulls whose union is nearly `mesh` (watertight, [m]): approximate convex decomposition (Wei et al., CoaCD, 2022)."""
    if mesh.volume > CONVEX * mesh.convex_hull.volume:
        return [_simpler(mesh.convex_hull)]
    return [_simpler(hull) for hull in _decomposed(mesh, "off")]


def union_of_pieces(mesh: trimesh.Trimesh) -> trimesh.Trimesh:
    """A closed surface about what `mesh`, which is not closed, seems to enclose."""
    return trimesh.boolean.union(_decomposed(mesh, "on"))


def _decomposed(mesh: trimesh.Trimesh, preprocessing: str) -> list[trimesh.Trimesh]:
    import coacd

    coacd.set_log_level("error")
    pieces = coacd.run_coacd(
        coacd.Mesh(mesh.vertices, mesh.faces), threshold=CONCAVITY, max_convex_hull=MOST, preprocess_mode=preprocessing, seed=0
    )
    hulls = [trimesh.Trimesh(np.asarray(v), np.asarray(f)).convex_hull for v, f in pieces]
    kept = [hull for hull in hulls if hull.volume > LEAST_VOLUME]
    if not kept:
        raise AssetError("its convex pieces have no volume")
    return kept


def _simpler(hull: trimesh.Trimesh) -> trimesh.Trimesh:
    """The same hull with at most `MOST_VERTICES` vertices: those that stick out furthest in evenly spread directions."""
    if len(hull.vertices) <= MOST_VERTICES:
        return hull
    i = np.arange(MOST_VERTICES) + 0.5
    polar, around = np.arccos(1 - 2 * i / MOST_VERTICES), np.pi * (1 + 5**0.5) * i
    directions = np.column_stack([np.cos(around) * np.sin(polar), np.sin(around) * np.sin(polar), np.cos(polar)])
    axes = np.vstack([np.eye(3), -np.eye(3)])  # the bounding box stays as it is
    outermost = np.unique((np.vstack([axes, directions]) @ hull.vertices.T).argmax(axis=1))
    return trimesh.convex.convex_hull(hull.vertices[outermost])
