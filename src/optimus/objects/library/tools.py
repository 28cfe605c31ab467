"""Hammers, magnets and weights (millimetres)."""

from __future__ import annotations

import numpy as np

from optimus.objects.library.entry import BLACK, BLUE, GREY, METAL, RED, RUBBER, SILVER, TAN, WOOD, entry
from optimus.objects.solids import (
    Section,
    Solid,
    ball,
    box,
    circle,
    curve,
    cylinder,
    ellipsoid,
    hull,
    lathe,
    mirrored,
    move,
    plate,
    polygon,
    rectangle,
    soften,
    sweep,
    turn,
)


def _grip() -> Solid:
    """A handle lying along +x, 104 mm long, thicker where the hand goes."""
    return hull(box(40, 13, 20, 3), move(box(30, 17, 22, 3), x=30)) + hull(
        move(box(40, 16, 22, 3), x=38), move(box(30, 20, 24, 4), x=68), move(box(14, 17, 22, 4), x=84)
    )


def claw_hammer() -> Solid:
    """Lying on its side: the striking face towards -y, the two claws bent back towards +y."""
    claws = polygon([(-11, -6), (11, -6), *curve([(11, 4), (9, 16), (17, 34)], 6), *curve([(10, 36), (-6, 24), (-11, 6)], 6)])
    head = plate(soften(claws, 2), 26, 3)
    neck = move(box(15, 22, 24, 3), y=-14, z=1)
    face = turn(cylinder(13, 12), x=90).translate((0, -18, 13))
    notch = hull(move(box(60, 2, 1, 0.4), y=42, z=12.5), turn(box(60, 8, 1, 0.4), z=0).translate((0, 42, 12.5)))
    split = hull(move(box(50, 4, 9, 1), x=8, y=38, z=8.5), move(box(8, 2, 3, 1), x=2, y=14, z=11.5))
    return head + neck + face + move(_grip(), x=8) - split - notch


def ball_hammer() -> Solid:
    """Lying on its side, one end of its head a ball."""
    face = lathe([(0, 0), (14, 0), (14, 14), (9, 20), (9, 30), (12, 34), (12, 44), (7, 50), (0, 50)], corner=1.5)
    head = turn(face, x=90).translate((0, 25, 0)) + ball(13, 24).translate((0, -28, 0)) + move(cylinder(12, 28, corner=1), z=-14)
    return move(head, z=13).trim_by_plane((0, 0, 1), 0) + move(_grip(), x=6)


def mallet() -> Solid:
    """Standing on its head."""
    head = hull(box(76, 46, 36, 4), move(box(66, 46, 6, 3), z=38))
    handle = lathe([(0, 30), (10, 30), *curve([(10, 60), (11, 95), (9, 118), (11, 128)]), (0, 130)], corner=2)
    return head + handle + move(cylinder(15, 8), z=42)


def horseshoe_magnet() -> Solid:
    """Lying flat, its two tips a little thicker."""
    section = (circle(31) - circle(15)) ^ rectangle(80, 40, at=(0, 20))
    section += rectangle(16, 30, at=(-23, -14)) + rectangle(16, 30, at=(23, -14))
    tips = mirrored(move(box(18, 14, 26), x=23, y=-23), (1, 0, 0))
    return plate(section, 24, 2) + tips


def standing_magnet() -> Solid:
    """Upright on its two legs, square-shouldered."""
    section = soften(polygon([(-32, 0), (-32, 74), (32, 74), (32, 0), (14, 0), (14, 54), (-14, 54), (-14, 0)]), 6)
    feet = mirrored(move(box(20, 30, 18, 2), x=23), (1, 0, 0))
    return turn(plate(section, 24, 2.5), x=90).translate((0, 12, 0)) + feet


def bar_magnet() -> Solid:
    """Lying, N and S raised on its two halves."""
    n = sweep([(-6, -8, 0), (-6, 8, 0), (6, -8, 0), (6, 8, 0)], 2.2)
    s = sweep(curve([(6, 6, 0), (0, 8.5, 0), (-5.5, 5, 0), (0, 0, 0), (5.5, -5, 0), (0, -8.5, 0), (-6, -6, 0)], 3), 2.2)
    waist = box(6, 60, 40, 1) - move(box(10, 27, 22, 1), z=2)
    return box(116, 30, 26, 3) - waist + move(n, x=-30, z=26) + move(s, x=30, z=26)


def dumbbell() -> Solid:
    """Its heads are hexagons that lie on a face."""
    head = turn(plate(hexagon(23), 34, 3), y=90)
    bar = turn(lathe([(0, -32), *curve([(9, -32), (10.5, -10), (10.5, 10), (9, 32)]), (0, 32)]), y=90)
    return mirrored(move(head, x=24), (1, 0, 0)) + bar


def hexagon(apothem: float) -> Section:
    """With two of its sides across x."""
    angles = np.radians(30 + 60 * np.arange(6))
    radius = apothem / np.cos(np.pi / 6)
    return polygon([(float(radius * np.cos(a)), float(radius * np.sin(a))) for a in angles])


def kettlebell() -> Solid:
    body = ellipsoid(32, 32, 30).translate((0, 0, 27)).trim_by_plane((0, 0, 1), 0)
    handle = sweep(curve([(-22, 0, 44), (-27, 0, 66), (-20, 0, 84), (0, 0, 88), (20, 0, 84), (27, 0, 66), (22, 0, 44)], 4), 7.5)
    return body + handle


THINGS = (
    entry("hammer-1", "black claw hammer", 0.3, RUBBER, BLACK, claw_hammer),
    entry("hammer-2", "grey ball hammer", 0.3, METAL, GREY, ball_hammer),
    entry("hammer-3", "tan mallet standing on its head", 0.28, WOOD, TAN, mallet),
    entry("magnet-1", "red horseshoe magnet lying flat", 0.15, METAL, RED, horseshoe_magnet),
    entry("magnet-2", "blue magnet standing on two legs", 0.16, METAL, BLUE, standing_magnet),
    entry("magnet-3", "silver bar magnet with two letters", 0.18, METAL, SILVER, bar_magnet),
    entry("weight-1", "black hexagonal dumbbell", 0.35, RUBBER, BLACK, dumbbell),
    entry("weight-2", "red kettlebell", 0.35, RUBBER, RED, kettlebell),
)
