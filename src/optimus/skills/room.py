"""Room on a support: what things cover, seen from above, as discs; a long thing is a row of them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from optimus.objects.shapes import STANDS, Shape, Surface, unrolled
from optimus.scene import Scene
from optimus.se3 import Array, Pose
from optimus.state import State

MARGIN = 0.015
"""Kept from a surface's edge, and between things [m]."""
LEVEL = 0.98
"""What lies this flat is as wide and as long as its sides: the cosine between an axis of it and the vertical."""
MOST = 8
"""Discs of one thing."""
SPACING, FINE = 0.05, 0.025
"""Between the candidate spots of a surface, and where room is short [m]; the outermost ones are besides."""
AMPLE = 0.25
"""A surface with more than this to every side [m] is large."""


def sides(shape: Shape, pose: Pose) -> tuple[Array, Array] | None:
    """Half the sides that a thing shows from above, the longer one first, as vectors `(2,)` [m]; None of one that leans, and of one
    that is about as wide as long."""
    if shape.symmetric and abs(pose.matrix[2, 2]) < STANDS:
        pose = unrolled(pose)
    axes = pose.matrix * np.array(shape.half_extents)
    up = int(np.abs(pose.matrix[2]).argmax())
    short, long = sorted((axes[:2, i] for i in range(3) if i != up), key=lambda v: float(v @ v))
    if abs(pose.matrix[2, up]) < LEVEL or long @ long < 2.0 * (short @ short):
        return None
    return long, short


def discs(shape: Shape, pose: Pose) -> Array:
    """Discs that cover a thing, seen from above: rows `x, y, radius` [m]."""
    found = sides(shape, pose)
    if found is None:
        return np.array([[*pose.pos[:2], shape.reach(pose.matrix)]])
    long, short = found
    count = min(MOST, int(np.ceil(np.sqrt((long @ long) / (short @ short)) - 1e-6)))
    along = (2.0 * np.arange(count) + 1.0) / count - 1.0
    radius = np.hypot(*long) / count, np.hypot(*short)
    return np.column_stack([pose.pos[:2] + along[:, None] * long, np.full(count, np.hypot(*radius))])


def is_free(scene: Scene, state: State, thing: str, support: str, covered: Array, height: float) -> bool:
    """Whether discs that `thing` is to cover on `support`, at that height, are clear of all other things, of what else stands
    there, and of doors."""
    for other, pose in state.poses.items():
        if other != thing and _least_gap(covered, discs(scene.shape_of(other), pose)) < MARGIN:
            return False
    points = [(np.array([x, y, height]), r) for x, y, r in covered]
    return not any(scene.is_covered(p, r + MARGIN, support) or scene.in_swing(p, r, support) for p, r in points)


def _least_gap(a: Array, b: Array) -> float:
    apart = np.linalg.norm(a[:, None, :2] - b[None, :, :2], axis=2)
    return float((apart - a[:, None, 2] - b[None, :, 2]).min())


def is_large(scene: Scene, support: str) -> bool:
    """Whether there is always another spot on it."""
    surface = scene.shape_of(support).surface
    return surface is not None and min(surface.half_x, surface.half_y) > AMPLE


def grid(surface: Surface, insets: Sequence[float] | Array, home: Array, spacing: float = SPACING) -> list[tuple[float, float]]:
    """Points of a surface that far in from its edges along x and along y: first the one nearest to `home` `(3,)` that has `AMPLE`
    about it, or the middle of a smaller surface, then outwards. All in the surface's frame [m]."""
    spans, centre = [], []
    for half, at, inset in ((surface.half_x, home[0], insets[0]), (surface.half_y, home[1], insets[1])):
        n, outermost = max(0, int((half - inset) / spacing)), max(0.0, half - inset)
        spans.append(sorted({k * spacing for k in range(-n, n + 1)} | {-outermost, outermost}))
        ample = max(0.0, half - AMPLE)
        centre.append(min(max(float(at), -ample), ample))
    points = [(x, y) for x in spans[0] for y in spans[1]]
    return sorted(points, key=lambda p: (round(float(np.hypot(p[0] - centre[0], p[1] - centre[1])), 6), p))
