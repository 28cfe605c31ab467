"""Solids: what the library's objects are made of. All lengths here are millimetres, z is up, angles are degrees.

Solids are joined with `+`, cut with `-` and intersected with `^`; `mesh` turns the result into metres.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from manifold3d import CrossSection, FillRule, JoinType, Manifold, OpType

if TYPE_CHECKING:
    import trimesh

Solid = Manifold
Section = CrossSection
Point = tuple[float, float]
Point3 = tuple[float, float, float]

FINENESS = (0.05, 0.1, 0.15, 0.2, 0.25)
"""Triangles that the surface can do without, give or take this much, are merged away [mm]: the first that leaves few enough."""
MOST_FACES = 3600
SOLE = 0.2
"""So much is cut off flat beneath every object: merging leaves an underside uneven [mm]."""
SEGMENTS = 36
"""Sides of a round thing."""


def mesh(solid: Solid) -> trimesh.Trimesh:
    """The solid in metres, standing on z = 0."""
    import trimesh

    tried = (solid.simplify(tolerance) for tolerance in FINENESS)
    light = next((one for one in tried if one.num_tri() <= MOST_FACES), solid)
    triangles = grounded(light, SOLE).to_mesh64()
    vertices = np.asarray(triangles.vert_properties)[:, :3] / 1000.0
    return trimesh.Trimesh(vertices, np.asarray(triangles.tri_verts, dtype=np.int64), process=False)


# ---- sections: figures in the plane ----


def polygon(points: Sequence[Sequence[float]]) -> Section:
    """The inside of a closed line."""
    return CrossSection([np.asarray(points, dtype=np.float64)], FillRule.EvenOdd)


def circle(radius: float, at: Point = (0.0, 0.0)) -> Section:
    return CrossSection.circle(radius, SEGMENTS).translate(at)


def rectangle(width: float, depth: float, corner: float = 0.0, at: Point = (0.0, 0.0)) -> Section:
    """Width along x, depth along y, centred on `at`, its corners rounded."""
    return soften(CrossSection.square((width, depth), center=True), corner).translate(at)


def star(points: int, outer: float, inner: float) -> Section:
    """A star, one of its points towards +y."""
    angles = np.pi / 2 + np.arange(2 * points) * np.pi / points
    radii = np.tile([outer, inner], points)
    return polygon([(float(r * np.cos(a)), float(r * np.sin(a))) for r, a in zip(radii, angles, strict=True)])


def soften(section: Section, radius: float) -> Section:
    """With its outer corners rounded off."""
    return offset(offset(section, -radius), radius) if radius else section


def fillet(section: Section, radius: float) -> Section:
    """With its inner corners rounded out."""
    return offset(offset(section, radius), -radius)


def offset(section: Section, distance: float) -> Section:
    """Grown by a distance on all sides, or shrunk by a negative one."""
    return section.offset(distance, JoinType.Round, 2.0, 24)


def curve(points: Sequence[Sequence[float]], steps: int = 6) -> list[tuple[float, ...]]:
    """A smooth line through all the points (Catmull-Rom), with so many steps between two of them; in two or three dimensions."""
    p = np.asarray(points, dtype=float)
    p = np.vstack([2 * p[0] - p[1], p, 2 * p[-1] - p[-2]])
    t = (np.arange(steps) / steps)[:, None]
    spans = []
    for a, b, c, d in zip(p[:-3], p[1:-2], p[2:-1], p[3:], strict=True):
        spans.append(b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a))))
    return [tuple(row) for row in np.vstack([*spans, p[-2:-1]]).tolist()]


# ---- bodies of revolution ----


def lathe(profile: Sequence[Sequence[float]], segments: int = SEGMENTS, corner: float = 0.0) -> Solid:
    """A line of (radius, z) from the lower end of the axis to the upper one, turned about z; its outer corners rounded off."""
    return Manifold.revolve(soften(_outline(profile), corner).simplify(FINENESS[1]), segments)


def vessel(profile: Sequence[Sequence[float]], wall: float = 5.0, segments: int = SEGMENTS, rim: float = 1.8) -> Solid:
    """As `lathe`, but hollow and open above: its wall is so thick everywhere, its edges rounded off."""
    r, z = profile[-1]
    hollow = offset(_outline([*profile, (r, z + 4 * wall)]), -wall)
    return Manifold.revolve(soften(_outline(profile) - hollow, rim).simplify(FINENESS[1]), segments)


def _outline(profile: Sequence[Sequence[float]]) -> Section:
    """Both halves of a lathe's section, so that softening leaves the axis alone."""
    right = [(float(r), float(z)) for r, z in profile]
    return polygon(right + [(-r, z) for r, z in reversed(right)])


def cylinder(radius: float, height: float, top: float | None = None, corner: float = 1.5) -> Solid:
    """Upright on z = 0, with softened edges; a cone where `top`, its upper radius, differs."""
    return lathe([(0, 0), (radius, 0), (radius if top is None else top, height), (0, height)], corner=corner)


def ball(radius: float, segments: int = SEGMENTS) -> Solid:
    """About the origin."""
    return Manifold.sphere(radius, segments)


def ellipsoid(x: float, y: float, z: float, segments: int = SEGMENTS) -> Solid:
    """About the origin, with these half-axes."""
    return ball(1.0, segments).scale((x, y, z))


def ring(radius: float, thickness: float, sides: int = 12) -> Solid:
    """A torus about z, its middle line in the plane z = 0; so many sides has its section."""
    return Manifold.revolve(CrossSection.circle(thickness / 2, sides).translate((radius, 0.0)), SEGMENTS)


# ---- bodies along a line ----


def sweep(path: Sequence[Sequence[float]], bead: Solid | float) -> Solid:
    """What a bead (a convex solid, or the radius of a ball) fills on its way along a path."""
    solid = bead if isinstance(bead, Solid) else ball(bead, 12)
    return _strung([solid.translate(_point(point)) for point in path])


def taper(path: Sequence[Sequence[float]], start: float, end: float) -> Solid:
    """What a ball fills on its way along a path, while its radius goes from one to the other."""
    radii = np.linspace(start, end, len(path))
    return _strung([ball(float(r), 12).translate(_point(point)) for r, point in zip(radii, path, strict=True)])


def _point(point: Sequence[float]) -> Point3:
    x, y, z = point
    return (float(x), float(y), float(z))


def _strung(beads: list[Solid]) -> Solid:
    return union(*(Manifold.batch_hull([a, b]) for a, b in pairwise(beads)))


def hull(*solids: Solid) -> Solid:
    """The convex hull of them all."""
    return Manifold.batch_hull(solids)


def arc(radius: float, start: float, end: float, steps: int = 12) -> list[Point3]:
    """Points of a circle about the origin in the plane of x and z, from one angle to another (0 is +x, 90 is +z)."""
    angles = np.radians(np.linspace(start, end, steps + 1))
    return [(float(radius * np.cos(a)), 0.0, float(radius * np.sin(a))) for a in angles]


# ---- bodies of one section ----


def extrude(section: Section, height: float, top: float = 1.0, twist: float = 0.0, steps: int = 0) -> Solid:
    """Upright on z = 0; scaled on the way to the top, and twisted, in so many steps."""
    return Manifold.extrude(section, height, steps, twist, (top, top))


def plate(section: Section, height: float, edge: float = 2.0, top: float = 1.0) -> Solid:
    """As `extrude`, with all its edges rounded off."""
    # the Minkowski sum takes the longer, the more corners there are
    inner = extrude(offset(section, -edge).simplify(FINENESS[1]), height - 2 * edge, top)
    return inner.translate((0, 0, edge)).minkowski_sum(ball(edge, 8))


def box(x: float, y: float, z: float, edge: float = 2.0) -> Solid:
    """Standing on z = 0 about the z axis, with rounded edges."""
    half = (x / 2 - edge, y / 2 - edge)
    corners = [(i * half[0], j * half[1], k) for i in (-1, 1) for j in (-1, 1) for k in (edge, z - edge)]
    return hull(*(ball(edge, 16).translate(corner) for corner in corners))


# ---- putting them together ----


def union(*solids: Solid) -> Solid:
    return Manifold.batch_boolean(list(solids), OpType.Add)


def around(solid: Solid, count: int) -> Solid:
    """So many copies of it, evenly about z."""
    return union(*(solid.rotate((0, 0, 360 * k / count)) for k in range(count)))


def mirrored(solid: Solid, axis: Point3 = (0.0, 1.0, 0.0)) -> Solid:
    """Together with its mirror image."""
    return solid + solid.mirror(axis)


def move(solid: Solid, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Solid:
    return solid.translate((x, y, z))


def turn(solid: Solid, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Solid:
    """About the axes x, then y, then z."""
    return solid.rotate((x, y, z))


def grounded(solid: Solid, cut: float = 0.0) -> Solid:
    """Moved onto z = 0, after so much of its underside is cut off flat."""
    low = solid.bounding_box()[2] + cut
    return solid.trim_by_plane((0, 0, 1), low).translate((0, 0, -low))
