"""Where a parallel hand could take a mesh: pairs of opposite faces, sampled, with the hand from above or leaning."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

import numpy as np
import trimesh

from optimus.objects.shapes import Grasp
from optimus.se3 import Array, quat_from_matrix

STEEP, ROUND, LEVEL = 0.75, 0.40, 0.15
"""Faces are met from the side: their normals' z component is below the first; below the second they may, below the third they do
count as upright."""
CONE = np.cos(np.radians(25.0))
"""The far face's normal is within 25 degrees of the line on which the fingers close."""
NARROWEST, CLEARANCE = 0.004, 0.010
"""A thing is at least this thick where it is taken, and the open hand wider by this [m]."""
TIP, GAP, RAISED = 0.012, 0.005, 0.009
"""Fingers end this far beyond the tcp, and stay this far above the ground; for that, the tcp is raised so much at most [m]."""
TILTS = tuple(np.radians((0.0, -30.0, -45.0, -60.0, -75.0, -90.0)))
"""Turns of the hand about the line on which the fingers close, from pointing straight down to level [rad]."""


@dataclass(frozen=True)
class Candidate:
    """A grasp that geometry allows, and its features for choosing diverse ones."""

    grasp: Grasp
    merit: float
    """The smaller the better: distance of the pinch from the centre of mass [m], and how far from opposite the faces are."""

    @property
    def lean(self) -> float:
        """See `lean_of`."""
        return lean_of(self.grasp)

    @property
    def features(self) -> Array:
        """`(6,)`: place in units of 2 cm, direction of the closing line and of the approach in units of half a radian."""
        x, y, z = self.grasp.pos
        approach = self.grasp.pose.matrix[:, 2]
        return np.array([x / 0.02, y / 0.02, z / 0.02, *(2.0 * approach)])


def candidates(
    mesh: trimesh.Trimesh, com: Array, width: float, points_and_pairs: tuple[int, int], rng: np.random.Generator
) -> list[Candidate]:
    """Grasps of `mesh` (object's frame [m], z up as it stands) for a hand that opens to `width` [m], from so many points of its
    surface and of the pairs of faces found there. The pads lie flat against the faces, so that a flared wall is not turned by
    being taken."""
    count, most = points_and_pairs
    sampled = trimesh.sample.sample_surface(mesh, count, seed=int(rng.integers(2**31)))
    points, faces = np.asarray(sampled[0]), np.asarray(sampled[1])
    normals = mesh.face_normals[faces]
    side = np.abs(normals[:, 2]) < STEEP
    points, inward = points[side], -normals[side]
    slope = np.abs(inward[:, 2])
    # what is round is also taken level, whichever way its facets lie
    points, inward = np.concatenate([points, points[slope < ROUND]]), np.concatenate([inward, inward[slope < ROUND]])
    level = np.concatenate([slope < LEVEL, np.ones((slope < ROUND).sum(), bool)])
    inward[level, 2] = 0.0
    inward /= np.linalg.norm(inward, axis=1, keepdims=True)
    hits, rays, far = mesh.ray.intersects_location(points + 1e-4 * inward, inward, multiple_hits=True)
    thick = np.linalg.norm(hits - points[rays], axis=1)
    opposite = np.einsum("ij,ij->i", mesh.face_normals[far], inward[rays])
    fits = np.flatnonzero((opposite > CONE) & (thick > NARROWEST) & (thick < width - CLEARANCE))
    found: list[Candidate] = []
    for i in np.sort(rng.permutation(fits)[:most]):
        middle, axis = (points[rays[i]] + hits[i]) / 2, inward[rays[i]]
        for tilt, flip in product(TILTS, (1.0, -1.0)):
            found.append(_candidate(middle, flip * axis, tilt, com, float(opposite[i]), float(mesh.bounds[0, 2])))
    return found


def _candidate(middle: Array, axis: Array, tilt: float, com: Array, opposite: float, ground: float) -> Candidate:
    """The hand with the tcp in the middle between two faces, or a little higher if the fingertips would meet the ground."""
    down = np.array([0.0, 0.0, -1.0])
    down -= (down @ axis) * axis
    down /= np.linalg.norm(down)
    # columns: tcp x, y (closing), z (approaching)
    approach = np.cos(tilt) * down + np.sin(tilt) * np.cross(axis, down)
    matrix = np.column_stack([np.cross(axis, approach), axis, approach])
    w, x, y, z = (float(v) for v in quat_from_matrix(np.asarray(matrix, float)))
    low = middle[2] - TIP * abs(float(approach[2])) - ground
    pos = middle - approach * max(0.0, min(RAISED, GAP - low))
    away = float(np.linalg.norm((middle - com)[:2])) + 0.3 * abs(float(middle[2] - com[2]))
    at = (float(pos[0]), float(pos[1]), float(pos[2]))
    return Candidate(Grasp(at, (w, x, y, z)), away + 0.1 * (1.0 - opposite))


def lean_of(grasp: Grasp) -> float:
    """How far a hand leans from pointing straight down, in the object's frame [rad]."""
    return float(np.arccos(np.clip(-grasp.pose.matrix[2, 2], -1.0, 1.0)))


def diverse(found: list[Candidate], count: int) -> list[Candidate]:
    """Up to `count` of them, the best first, each far from those before it: greedy, farthest first, less `merit`."""
    if not found:
        return []
    features, merits = np.array([c.features for c in found]), 20.0 * np.array([c.merit for c in found])
    chosen = [int(merits.argmin())]
    apart = np.linalg.norm(features - features[chosen[0]], axis=1)
    while len(chosen) < min(count, len(found)):
        chosen.append(int((np.minimum(apart, 3.0) - merits).argmax()))
        apart = np.minimum(apart, np.linalg.norm(features - features[chosen[-1]], axis=1))
        apart[chosen] = -np.inf
    return [found[i] for i in chosen]
