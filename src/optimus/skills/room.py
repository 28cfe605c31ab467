"""Room on a support: what things cover, seen from above, as convex outlines."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from optimus.objects.shapes import Shape, Surface, stands, unrolled
from optimus.predicates import pose_of
from optimus.scene import Scene
from optimus.se3 import Array, Pose
from optimus.state import State

MARGIN = 0.015
"""Kept from a surface's edge, and between things [m]."""
LEVEL = 0.98
"""What lies this flat covers a rectangle: the cosine between an axis of it and the vertical."""
ROUND = 16
"""Sides of what stands for a circle."""
SPACING, FINE = 0.05, 0.025
"""Between the candidate spots of a surface, and where room is short [m]; the outermost ones are besides."""
AMPLE = 0.25
"""A surface with more than this to every side [m] is large."""


def outline(shape: Shape, pose: Pose) -> Array:
    """Corners `(n, 2)` [m] of what a thing covers, seen from above, in order: a rectangle, or a circle about a body of revolution
    that stands and about what leans."""
    is_round = shape.symmetric and stands(pose)
    if shape.symmetric and not is_round:
        pose = unrolled(pose)
    up = int(np.abs(pose.matrix[2]).argmax())
    if is_round or abs(pose.matrix[2, up]) < LEVEL:
        angles = 2 * np.pi * np.arange(ROUND) / ROUND
        radius = shape.reach(pose.matrix) / np.cos(np.pi / ROUND)
        return pose.pos[:2] + radius * np.column_stack([np.cos(angles), np.sin(angles)])
    a, b = ((pose.matrix * np.array(shape.half_extents))[:2, i] for i in range(3) if i != up)
    return pose.pos[:2] + np.array([a + b, b - a, -a - b, a - b])


def gap(a: Array, b: Array) -> float:
    """How far apart two convex outlines are [m], or somewhat less: by the line, along a side of either, that parts them best."""
    return max(_along_sides(a, b), _along_sides(b, a))


def _along_sides(a: Array, b: Array) -> float:
    edges = np.roll(a, -1, axis=0) - a
    normals = np.column_stack([edges[:, 1], -edges[:, 0]]) / np.linalg.norm(edges, axis=1)[:, None]
    outwards = np.sign(((a - a.mean(0)) * normals).sum(1))[:, None] * normals
    return float(((outwards @ b.T).min(1) - (outwards * a).sum(1)).max())


def obstacles(scene: Scene, state: State, thing: str, support: str, height: float) -> list[Array]:
    """Outlines of what `thing` has to keep clear of on `support`, at that height [m]: other things, and fixtures on it."""
    others = [outline(scene.shape_of(n), pose) for n, pose in state.poses.items() if n != thing]
    return others + [_rectangle(low, high) for low, high in scene.standing_at(height, support)]


def is_free(scene: Scene, support: str, covered: Array, height: float, others: Sequence[Array]) -> bool:
    """Whether the outline `covered` on `support`, at that height [m], is clear of `others`, and of doors."""
    if any(gap(covered, other) < MARGIN for other in others):
        return False
    return not any(scene.in_swing(np.array([*corner, height]), MARGIN, support) for corner in covered)


def _rectangle(low: Array, high: Array) -> Array:
    return np.array([(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])])


def standing_on(scene: Scene, state: State, support: str) -> list[str]:
    """The things whose middle is over the support's surface."""
    surface, frame = scene.shape_of(support).surface, pose_of(scene, state, support)
    at = {name: frame.inverse.transform(pose.pos) for name, pose in state.poses.items() if name != support}
    if surface is None:
        return []
    return [n for n, p in at.items() if abs(p[0]) <= surface.half_x and abs(p[1]) <= surface.half_y and p[2] > surface.z]


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
