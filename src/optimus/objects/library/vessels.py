"""Vases, bottles, cans and jars (millimetres)."""

from __future__ import annotations

from optimus.objects.library.entry import (
    BLUE,
    CLAY,
    CREAM,
    DARK_GREEN,
    GLAZED,
    GREY,
    METAL,
    PLASTIC,
    PURPLE,
    RED,
    SILVER,
    SKY,
    TEAL,
    TERRACOTTA,
    WHITE,
    colour,
    entry,
)
from optimus.objects.solids import (
    Solid,
    arc,
    around,
    box,
    curve,
    cylinder,
    extrude,
    hull,
    lathe,
    mirrored,
    move,
    offset,
    plate,
    rectangle,
    ring,
    star,
    sweep,
    turn,
    vessel,
)


def bellied_vase() -> Solid:
    return vessel([(0, 0), *curve([(22, 0), (31, 28), (35, 52), (26, 84), (16, 108), (16, 126), (25, 146)])])


def twisted_vase() -> Solid:
    section = rectangle(42, 42, 6)
    outside = extrude(section, 140, 1.3, 75, 20)
    return outside - extrude(offset(section, -6), 140, 1.3, 75, 20).trim_by_plane((0, 0, 1), 8)


def amphora() -> Solid:
    profile = curve([(15, 13), (27, 42), (34, 72), (26, 100), (14, 116), (21, 140)], 3)
    body = vessel([(0, 0), (24, 0), (24, 5), *profile], segments=32)
    handle = sweep(curve([(15, 0, 128), (34, 0, 132), (42, 0, 112), (32, 0, 84)], 3), 4.5)
    return body + mirrored(handle, (1, 0, 0))


def wine_bottle() -> Solid:
    neck = [*curve([(31, 86), (28, 98), (16, 112), (12, 124)]), (11, 144), (13.5, 144), (13.5, 156), (0, 156)]
    return lathe([(0, 0), (31, 0), *neck], corner=2)


def soda_bottle() -> Solid:
    """Waisted, its lower half fluted, with a milled cap."""
    body = lathe([(0, 0), *curve([(25, 0), (30, 10), (30, 34), (25, 52), (29, 76), (27, 98), (13, 124), (12, 136)], 4), (0, 136)])
    flute = sweep(curve([(33, 0, 2), (34, 0, 24), (28.5, 0, 50)], 3), 5.0)
    cap = extrude(star(20, 14.5, 13.3), 16)
    return body - around(flute, 8) + move(cylinder(16, 5), z=127) + move(cap, z=133)


def spray_bottle() -> Solid:
    body = hull(plate(rectangle(62, 42, 16), 58, 3), move(cylinder(14, 8), z=82))
    head = hull(move(box(36, 20, 14), x=6, z=114), move(box(44, 18, 8), x=-2, z=122), move(box(20, 18, 8), x=-8, z=106))
    trigger = sweep(curve([(16, 0, 116), (24, 0, 100), (20, 0, 86)], 4), move(box(7, 12, 7), z=-3.5))
    nozzle = turn(cylinder(7, 14), y=90).translate((22, 0, 121))
    return body + move(cylinder(15, 26), z=86) + head + trigger + nozzle


def soap_dispenser() -> Solid:
    body = plate(rectangle(56, 56, 10), 88, 4)
    collar = move(cylinder(16, 14), z=86) + move(cylinder(6, 40), z=96)
    spout = sweep(curve([(-8, 0, 134), (10, 0, 135), (30, 0, 132), (38, 0, 122)], 4), 6.0)
    return body + collar + move(cylinder(14, 12), z=128) + spout


def soda_can() -> Solid:
    body = lathe([(0, 0), (24, 0), (32, 10), (32, 98), (26, 112), (26, 116), (0, 116)], corner=1.5)
    opener = plate(rectangle(28, 14, 6.5), 5, 1.5) - move(cylinder(4, 10), x=8, z=-1)
    return body - move(cylinder(23, 10), z=112) + move(opener, x=4, z=111)


def food_tin() -> Solid:
    """Ribbed, its lid half rolled back."""
    ribs = curve([(31 - 2 * (k % 2), 18 + 5 * k) for k in range(11)], 4)
    body = lathe([(0, 0), (32.5, 0), (32.5, 5), (31, 7), *ribs, (31, 79), (32.5, 81), (32.5, 86), (0, 86)])
    ring_pull = move(ring(6.5, 5), z=2.5)
    return body - move(cylinder(28, 10), z=83) + move(ring_pull, x=14, z=82) + move(box(12, 8, 5), x=4, z=82)


def paint_can() -> Solid:
    body = cylinder(31, 76) + move(ring(30.5, 5), z=4) + move(ring(30.5, 5), z=73)
    lid = move(cylinder(27, 12), z=70) - move(cylinder(21, 10), z=78)
    ears = mirrored(turn(cylinder(7, 6), y=90).translate((29, 0, 60)), (1, 0, 0))
    bail = sweep([(x, 0, 60 + 1.35 * z) for x, _, z in arc(34, 0, 180, 16)], 3.0)
    return body + lid + ears + bail


def jam_jar() -> Solid:
    body = lathe([(0, 0), (31, 0), *curve([(31, 60), (30, 68), (25, 74)]), (25, 78), (0, 78)], corner=3)
    lid = extrude(star(28, 28.5, 27.2), 16) + cylinder(26, 18)
    return body + move(lid, z=76)


def cookie_jar() -> Solid:
    body = lathe([(0, 0), *curve([(24, 0), (31, 22), (32, 48), (26, 74)]), (0, 74)])
    lid = lathe([(0, 72), (30, 72), (30, 78), *curve([(27, 82), (14, 90), (7, 93)]), (0, 94)], corner=1.5)
    knob = cylinder(8, 26, 12.5)
    return body + lid + move(knob, z=84)


THINGS = (
    entry("vase-1", "teal bellied vase", 0.25, GLAZED, TEAL, bellied_vase, symmetric=True),
    entry("vase-2", "purple twisted vase", 0.25, GLAZED, PURPLE, twisted_vase),
    entry("vase-3", "terracotta amphora with two handles", 0.26, CLAY, TERRACOTTA, amphora),
    entry("bottle-1", "dark green wine bottle", 0.3, GLAZED, DARK_GREEN, wine_bottle, symmetric=True),
    entry("bottle-2", "brown cola bottle with a cap", 0.25, PLASTIC, colour("#5a2f22"), soda_bottle),
    entry("bottle-3", "sky blue spray bottle", 0.2, PLASTIC, SKY, spray_bottle),
    entry("bottle-4", "white soap dispenser", 0.25, PLASTIC, WHITE, soap_dispenser),
    entry("can-1", "red soda can", 0.3, METAL, RED, soda_can),
    entry("can-2", "silver ribbed food tin", 0.3, METAL, SILVER, food_tin),
    entry("can-3", "grey paint can with a bail", 0.3, METAL, GREY, paint_can),
    entry("jar-1", "cream jam jar with a screw lid", 0.28, GLAZED, CREAM, jam_jar),
    entry("jar-2", "blue cookie jar with a knob on its lid", 0.3, GLAZED, BLUE, cookie_jar, symmetric=True),
)
