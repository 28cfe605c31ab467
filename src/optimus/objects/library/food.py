"""Fruit (millimetres). Each has a flat spot beneath, so that it stays where it is put."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from optimus.objects.library.entry import PAPER, PURPLE, RED, YELLOW, colour, entry
from optimus.objects.solids import (
    Solid,
    around,
    ball,
    curve,
    ellipsoid,
    extrude,
    grounded,
    hull,
    lathe,
    move,
    polygon,
    sweep,
    turn,
    union,
)


def _leaf(length: float, width: float, segments: int = 12) -> Solid:
    """Along +x from the origin."""
    tip = ball(2.2, 4).translate((length, 0, 0))
    return hull(ball(2.2, 4), ellipsoid(0.3 * length, width / 2, 2.2, segments).translate((length / 2, 0, 0)), tip)


def apple() -> Solid:
    flesh = [(9, 0), (22, 6), (30, 26), (30.5, 40), (22, 55), (10, 56), (3, 49)]
    stem = sweep(curve([(0, 0, 44), (1, 0, 56), (5, 0, 66)], 4), 2.6)
    leaf = turn(_leaf(26, 14), y=-5).translate((2, 0, 58))
    return lathe([(0, 0), *curve(flesh), (0, 48)]) + stem + leaf


def pear() -> Solid:
    flesh = [(9, 0), (24, 6), (32, 26), (27, 46), (16, 64), (13, 78), (8, 87)]
    stem = sweep(curve([(0, 0, 82), (0, 0, 92), (5, 0, 104)], 4), 2.8)
    leaf = turn(_leaf(24, 13), y=-30, z=140).translate((0, 0, 88))
    return lathe([(0, 0), *curve(flesh), (0, 88)]) + stem + leaf


def banana() -> Solid:
    """Lying on its side, its skin in ten flats."""
    bends = np.radians(np.linspace(-52, 52, 15))
    radii = 3.5 + 12.5 * np.clip(np.cos(bends * 1.62), 0, 1) ** 0.5
    rings = []
    for angle, radius in zip(bends, radii, strict=True):
        slice_ = lathe([(0, -0.5), (radius, -0.5), (radius, 0.5), (0, 0.5)], segments=10)
        rings.append(turn(slice_, x=90, z=float(np.degrees(angle))).translate((68 * np.cos(angle), 68 * np.sin(angle), 0.0)))
    stem = hull(rings[-1], ball(4.5, 12).translate((68 * np.cos(1.08), 68 * np.sin(1.08), 0)))
    return grounded(union(*(hull(a, b) for a, b in pairwise(rings)), stem), 3.0)


def pineapple() -> Solid:
    """A body of scales under a tuft of leaves."""
    body = ellipsoid(28, 28, 38, 20).translate((0, 0, 36))
    scale = extrude(polygon([(-7, 0), (0, -8.5), (8, 0), (0, 8.5)]), 3.0, 0.55)
    for row in range(6):
        z = 9 + 10.5 * row
        radius = 28 * np.sqrt(1 - ((z - 36) / 38) ** 2)
        lean = float(np.degrees(np.arctan2((z - 36) / 38**2, radius / 28**2)))
        body += around(turn(scale, y=90 - lean).translate((radius - 1.2, 0, z)), 10).rotate((0, 0, 18 * (row % 2)))
    leaves = Solid()
    for count, length, tilt, phase in ((7, 34, 46, 0), (5, 42, 64, 25), (3, 48, 80, 10)):
        leaves += around(turn(_leaf(length, 13, 4), y=-tilt), count).rotate((0, 0, phase))
    return grounded(body + ball(12, 16).translate((0, 0, 72)) + move(leaves, z=72), 3.5)


def grapes() -> Solid:
    """A bunch lying down, its tip towards +x."""
    places = []
    for column, (x, count) in enumerate(((-34, 2), (-21, 3), (-8, 3), (5, 3), (18, 2), (31, 1))):
        places += [(x, 13.5 * (k - (count - 1) / 2), 11.0) for k in range(count)]
        places += [(x + 6, 13.5 * (k - (count - 2) / 2), 23.0) for k in range(max(0, count - 1 - column // 4))]
    berries = union(*(ball(10.5, 14).translate(place) for place in places))
    stem = sweep(curve([(-22, 0, 22), (-42, 0, 24), (-54, 0, 30)], 4), 3.0)
    core = sweep([(-30, 0, 15), (20, 0, 14)], ellipsoid(6, 12, 6, 12))
    return grounded(berries + core + stem, 2.0)


THINGS = (
    entry("fruit-1", "red apple", 0.16, PAPER, RED, apple),
    entry("fruit-2", "green pear", 0.17, PAPER, colour("#b3bf45"), pear),
    entry("fruit-3", "yellow banana", 0.12, PAPER, YELLOW, banana),
    entry("fruit-4", "amber pineapple", 0.3, PAPER, colour("#d08f2e"), pineapple),
    entry("fruit-5", "purple bunch of grapes", 0.2, PAPER, PURPLE, grapes),
)
