"""Mugs, cups and bowls (millimetres)."""

from __future__ import annotations

from optimus.objects.library.entry import (
    BLUE,
    BROWN,
    CREAM,
    GLAZED,
    GOLD,
    GREEN,
    METAL,
    PAPER,
    PINK,
    RED,
    SKY,
    WHITE,
    WOOD,
    entry,
)
from optimus.objects.solids import (
    Solid,
    arc,
    ball,
    box,
    circle,
    curve,
    cylinder,
    ellipsoid,
    extrude,
    lathe,
    move,
    offset,
    plate,
    rectangle,
    ring,
    sweep,
    vessel,
)


def round_handled_mug() -> Solid:
    handle = sweep(curve([(31, 0, 68), (48, 0, 67), (56, 0, 44), (46, 0, 21), (31, 0, 19)], 4), ellipsoid(4, 5.5, 4, 12))
    return vessel([(0, 0), (32, 0), (32, 85)]) + handle


def square_handled_mug() -> Solid:
    bead = move(box(8, 12, 8), z=-4)
    handle = sweep([(29, 0, 64), (54, 0, 64), (54, 0, 22), (27, 0, 22)], bead)
    return vessel([(0, 0), (26, 0), (32, 80)]) + handle


def barrel_mug() -> Solid:
    body = vessel([(0, 0), *curve([(25, 0), (31, 30), (31, 52), (27, 82)])])
    handle = sweep(curve([(28, 0, 72), (46, 0, 76), (52, 0, 58), (44, 0, 34), (30, 0, 22)], 4), 4.5)
    hoops = move(ring(30, 5), z=20) + move(ring(30, 5), z=62)
    return body + handle + (hoops - cylinder(26, 100))


def beer_mug() -> Solid:
    """Its outside is fluted, its handle a thick strap."""
    flutes = circle(28)
    for k in range(12):
        flutes += circle(6.5, (26, 0)).rotate(30 * k)
    body = extrude(flutes, 84).translate((0, 0, 8)) + cylinder(32.5, 12) + move(cylinder(32.5, 12), z=88)
    handle = sweep([(30, 0, 84), (50, 0, 84), (58, 0, 76), (58, 0, 36), (50, 0, 26), (30, 0, 24)], ellipsoid(5, 8, 5, 16))
    return body - move(cylinder(25.5, 100), z=8) + (handle - cylinder(27, 120))


def paper_cup() -> Solid:
    sleeve = lathe([(0, 24), (27.2, 25), (30.6, 62), (0, 63)], corner=1)
    return vessel([(0, 0), (23, 0), (31, 90)]) + move(ring(30, 5.5), z=89) + (sleeve - cylinder(24.5, 100, 30.5))


def goblet() -> Solid:
    bowl = curve([(6, 46), (22, 56), (30, 76), (29, 112)])
    outside = lathe([(0, 0), (29, 0), (29, 4), *curve([(22, 7), (7, 16), (5.5, 28), (6, 46)]), *bowl[1:], (0, 112)], corner=1.5)
    knot = ellipsoid(9.5, 9.5, 6).translate((0, 0, 32))
    return outside + knot - lathe([(0, 61), *curve([(8, 62), (20, 69), (25, 82), (24, 114)]), (0, 114)])


def teacup() -> Solid:
    body = vessel([(0, 0), (18, 0), (18, 5), *curve([(20, 7), (28, 20), (32, 38), (33, 54)])])
    handle = sweep([(31 + 0.95 * x, 0, 36 + z) for x, _, z in arc(14, 110, -110, 14)], ellipsoid(4, 5, 4, 12))
    return body + (handle - cylinder(27, 80, 29))


def footed_bowl() -> Solid:
    return vessel([(0, 0), (21, 0), (21, 6), *curve([(24, 9), (36, 18), (43, 33), (45, 52)])], wall=5)


def dog_bowl() -> Solid:
    """Wider at its foot, so that no dog overturns it."""
    bone = sweep([(-9, 0, 0), (9, 0, 0)], 4.0)
    for x in (-11, 11):
        bone += ball(5.0, 16).translate((x, 0, 4)) + ball(5.0, 16).translate((x, 0, -4))
    body = lathe([(0, 0), (38, 0), (32, 40), (0, 40)], corner=3) - lathe([(0, 8), *curve([(20, 8), (24, 14), (26, 42)]), (0, 42)])
    return body + move(bone, y=-34.5, z=20)


def square_bowl() -> Solid:
    outside = plate(rectangle(62, 62, 14), 52, edge=3, top=1.4)
    return outside - move(extrude(offset(rectangle(62, 62, 14), -6), 50, 1.45), z=7)


THINGS = (
    entry("mug-1", "blue mug with a round handle", 0.24, GLAZED, BLUE, round_handled_mug),
    entry("mug-2", "white mug with a square handle", 0.22, GLAZED, WHITE, square_handled_mug),
    entry("mug-3", "brown barrel mug with two hoops", 0.2, WOOD, BROWN, barrel_mug),
    entry("mug-4", "golden fluted beer mug", 0.32, GLAZED, GOLD, beer_mug),
    entry("cup-1", "red paper cup with a sleeve", 0.04, PAPER, RED, paper_cup, symmetric=True),
    entry("cup-2", "golden goblet with a knotted stem", 0.2, METAL, GOLD, goblet, symmetric=True),
    entry("cup-3", "pink teacup", 0.14, GLAZED, PINK, teacup),
    entry("bowl-1", "sky blue bowl on a foot", 0.22, GLAZED, SKY, footed_bowl, symmetric=True),
    entry("bowl-2", "green dog bowl with a bone on it", 0.18, GLAZED, GREEN, dog_bowl),
    entry("bowl-3", "cream square bowl", 0.24, GLAZED, CREAM, square_bowl),
)
