"""Pitchers, pots, teapots, plants in their pots, and baskets (millimetres)."""

from __future__ import annotations

from optimus.objects.library.entry import (
    BLACK,
    BLUE,
    BROWN,
    CLAY,
    GLAZED,
    GREEN,
    METAL,
    ORANGE,
    PINK,
    PLASTIC,
    SILVER,
    TAN,
    WOOD,
    YELLOW,
    colour,
    entry,
)
from optimus.objects.solids import (
    Solid,
    arc,
    around,
    ball,
    box,
    curve,
    cylinder,
    ellipsoid,
    extrude,
    hull,
    lathe,
    mirrored,
    move,
    offset,
    plate,
    rectangle,
    ring,
    sweep,
    taper,
    turn,
    union,
    vessel,
)


def _beak(reach: float, z: float, grow: float) -> Solid:
    """What a spout fills at a rim of height z: from the wall below to a lip at x = `reach`; larger by `grow` on all sides."""
    low = ball(6 + grow, 16).translate((reach - 22, 0, z - 38))
    throat = move(cylinder(15 + grow, 20, corner=0), x=reach - 26, z=z - 12)
    lip = move(cylinder(4 + grow, 14, corner=0), x=reach - 4, z=z - 6)
    return hull(low, throat, lip)


def jug() -> Solid:
    profile = [(0, 0), *curve([(25, 0), (33, 22), (34, 45), (24, 86), (25, 110)])]
    outside = lathe([*profile, (0, 110)]) + _beak(38, 110, 5)
    inside = lathe([(0, 6), *curve([(20, 6), (28, 24), (29, 45), (19, 86), (20, 130)]), (0, 130)]) + _beak(38, 110, 0)
    handle = sweep(curve([(-24, 0, 98), (-44, 0, 98), (-52, 0, 74), (-44, 0, 48), (-32, 0, 38)], 5), ellipsoid(4.5, 7, 4.5, 12))
    return (outside + handle - inside).trim_by_plane((0, 0, -1), -110)


def tall_pitcher() -> Solid:
    """Conical, with an angular handle."""
    outside = lathe([(0, 0), (32, 0), (24, 135), (0, 135)], corner=2) + _beak(38, 137, 5)
    inside = lathe([(0, 7), (26, 7), (19, 135), (19, 160), (0, 160)]) + _beak(38, 137, 0)
    handle = sweep([(-23, 0, 118), (-50, 0, 112), (-44, 0, 36), (-30, 0, 30)], move(box(8, 13, 8), z=-4))
    return (outside + handle - inside).trim_by_plane((0, 0, -1), -135)


def stock_pot() -> Solid:
    body = vessel([(0, 0), (33, 0), (33, 52)]) + (move(ring(32, 6), z=50) - cylinder(29, 80))
    handle = sweep([(31, -14, 36), (44, -12, 36), (47, -7, 36), (47, 7, 36), (44, 12, 36), (31, 14, 36)], 4.5)
    return body + mirrored(handle, (1, 0, 0)) - move(cylinder(28, 80), z=10)


def saucepan() -> Solid:
    body = vessel([(0, 0), (31, 0), (33, 6), (33, 46)], wall=5)
    grip = sweep([(29, 0, 36), (41, 0, 37)], 5.0) + hull(
        turn(box(16, 10, 30), y=90).translate((39, 0, 38)), turn(box(18, 14, 10), y=90).translate((80, 0, 39))
    )
    return body + grip - move(cylinder(28, 60), z=8)


def casserole() -> Solid:
    """Oval, lidded, solid."""
    body = plate(rectangle(88, 62, 30), 40, 4) + move(plate(rectangle(92, 64, 31.5), 7, 2), z=36)
    lid = hull(move(plate(rectangle(84, 58, 28), 6, 2), z=40), move(plate(rectangle(40, 24, 11), 6, 2), z=50))
    knob = cylinder(10, 28, 12.5, 3)
    ear = box(16, 28, 8).translate((48, 0, 28))
    return body + lid + move(knob, z=54) + mirrored(ear, (1, 0, 0))


def round_teapot() -> Solid:
    body = lathe([(0, 0), (22, 0), (22, 4), *curve([(25, 6), (32, 30), (28, 52), (16, 62)]), (0, 63)], corner=1.0)
    lid = lathe([(0, 58), (18, 58), (18, 63), *curve([(16, 65), (10, 69)]), (0, 71)]) + ball(7, 24).translate((0, 0, 75))
    spout = taper(curve([(20, 0, 22), (40, 0, 30), (46, 0, 50), (57, 0, 63)], 4), 13, 4.5)
    handle = sweep([(-28 + 1.1 * x, 0, 34 + z) for x, _, z in arc(20, 75, 285, 14)], ellipsoid(4.5, 6, 4.5, 12))
    return (body + lid + spout + handle).scale((0.85, 0.85, 0.85))


def hooped_teapot() -> Solid:
    """Low and straight, its handle an arch above."""
    body = lathe([(0, 0), (30, 0), (32, 6), (32, 46), (24, 56), (0, 56)], corner=2)
    lid = move(cylinder(19, 6), z=55) + move(cylinder(7, 8), z=60)
    spout = taper([(27, 0, 22), (48, 0, 48), (58, 0, 52)], 10, 5)
    arch = sweep([(x, 0, 48 + 1.6 * z) for x, _, z in arc(27, 0, 180, 14)], box(8, 13, 8, 1.5))
    return body + lid + spout + arch


def _flower_pot(height: float) -> Solid:
    return cylinder(22, height, 29) + move(cylinder(32, 14), z=height - 12) - move(cylinder(27, 20), z=height - 5)


def cactus() -> Solid:
    section = sum((rectangle(34, 7, 3.2).rotate(30 * k) for k in range(6)), rectangle(26, 26, 12))
    trunk = extrude(section, 70) ^ lathe([(0, 0), *curve([(15, 0), (17.5, 34), (14, 58), (5, 69)]), (0, 70)])
    arm = sweep(curve([(12, 0, 24), (27, 0, 27), (29, 0, 36), (29, 0, 52)], 4), 6.5)
    other = sweep(curve([(-12, 0, 34), (-25, 0, 37), (-27, 0, 44), (-27, 0, 60)], 4), 6.0)
    return _flower_pot(46) + move(trunk + arm + other, z=40)


def succulent() -> Solid:
    """A rosette of thick leaves."""
    leaves = ball(12, 16).translate((0, 0, 4))
    for count, length, tilt, phase in ((9, 34, 22, 0), (7, 29, 48, 25), (5, 24, 72, 10)):
        middle, tip = ellipsoid(6, 9, 4, 12).translate((0.6 * length, 0, 1)), ball(2.5, 8).translate((length, 0, 3))
        leaf = hull(ball(4, 12), middle, tip)
        leaves += around(turn(leaf, y=-tilt), count).rotate((0, 0, phase))
    return _flower_pot(50) + move(leaves, z=50)


def _tub(width: float, depth: float, height: float, corner: float, flare: float, wall: float = 5.0) -> Solid:
    """A bin with rounded corners [mm at its foot], wider above by the factor `flare`."""
    section = rectangle(width, depth, corner)
    inside = extrude(offset(section, -wall), height, flare).trim_by_plane((0, 0, 1), wall)
    return plate(section, height, 1.5, flare).trim_by_plane((0, 0, -1), -height + 1.6) - inside


def picnic_basket() -> Solid:
    body = _tub(84, 46, 52, 8, 1.12)
    bands = [move(plate(rectangle(f * 86, f * 49, 9), 6, 2), z=z) for z, f in ((12, 1.03), (28, 1.06), (44, 1.10))]
    woven = bands[0] + bands[1] + bands[2] - extrude(rectangle(74, 36, 4), 80, 1.15)
    handle = sweep([(1.02 * x, 0, 44 + 1.6 * z) for x, _, z in arc(44, 0, 180, 18)], move(box(6, 12, 6), z=-3))
    return body + woven + handle


def round_basket() -> Solid:
    """Coiled, with an arched handle."""
    profile = [(0, 0), *curve([(26, 0), (38, 18), (42, 44)])]
    coils = [ring(r, 8, 6).translate((0, 0, z)) for r, z in ((31, 6), (36, 15), (39.5, 24), (40.5, 33), (41, 42))]
    inside = lathe([(0, 6), *curve([(22, 6), (33, 20), (37, 60)]), (0, 60)])
    handle = sweep([(x, 0, 40 + 1.7 * z) for x, _, z in arc(40, 0, 180, 12)], box(8, 14, 8, 1.5))
    return vessel(profile) + sum(coils, Solid()) - inside + handle


def laundry_basket() -> Solid:
    """Slotted, with two holes to carry it by."""
    body = _tub(72, 48, 76, 12, 1.18)
    slot = box(7, 200, 34).translate((0, 0, 12))
    sides = union(*(move(slot, x=x) for x in (-28, -14, 0, 14, 28)))
    ends = turn(union(*(move(slot, x=x) for x in (-13, 0, 13))), z=90)
    holes = turn(box(26, 200, 12, 4), z=90).translate((0, 0, 54))
    rim = move(plate(rectangle(90, 62, 16) - rectangle(74, 46, 9), 8, 2), z=68)
    return body - sides - ends - holes + rim


THINGS = (
    entry("pitcher-1", "yellow jug with a spout", 0.3, GLAZED, YELLOW, jug),
    entry("pitcher-2", "silver conical pitcher", 0.3, METAL, SILVER, tall_pitcher),
    entry("pot-1", "silver stock pot with two handles", 0.35, METAL, SILVER, stock_pot),
    entry("pot-2", "black saucepan with a long handle", 0.3, METAL, BLACK, saucepan),
    entry("pot-3", "orange oval casserole with a lid", 0.35, METAL, ORANGE, casserole),
    entry("teapot-1", "pink round teapot", 0.3, GLAZED, PINK, round_teapot),
    entry("teapot-2", "black teapot with a handle above", 0.32, METAL, BLACK, hooped_teapot),
    entry("plant-1", "green cactus in a pot", 0.2, CLAY, GREEN, cactus),
    entry("plant-2", "light green succulent in a pot", 0.2, CLAY, colour("#8dbb6a"), succulent),
    entry("basket-1", "brown picnic basket with a handle", 0.1, WOOD, BROWN, picnic_basket),
    entry("basket-2", "tan round basket with a handle", 0.09, WOOD, TAN, round_basket),
    entry("basket-3", "blue laundry basket with slots", 0.1, PLASTIC, BLUE, laundry_basket),
)
