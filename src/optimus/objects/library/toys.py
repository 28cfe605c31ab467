"""Chessmen, balls, blocks and toys (millimetres)."""

from __future__ import annotations

from optimus.objects.library.entry import BLACK, BLUE, GREEN, ORANGE, PLASTIC, RED, RUBBER, SILVER, TEAL, WHITE, WOOD, YELLOW, entry
from optimus.objects.solids import (
    Solid,
    around,
    ball,
    box,
    circle,
    curve,
    cylinder,
    ellipsoid,
    extrude,
    grounded,
    hull,
    lathe,
    mirrored,
    move,
    plate,
    polygon,
    ring,
    soften,
    turn,
)


def pawn() -> Solid:
    foot = [(0, 0), (26, 0), (26, 8), (22, 12), (24, 16), *curve([(20, 20), (11, 36), (8, 58)]), (17, 60), (17, 65), (0, 65)]
    return lathe(foot, corner=1.5) + ball(17).translate((0, 0, 78))


def rook() -> Solid:
    foot = [(0, 0), (28, 0), (28, 8), (24, 12), (26, 17), *curve([(22, 21), (17, 42), (16, 66)]), (24, 72), (24, 96), (0, 96)]
    notches = around(move(box(30, 9, 20, 1), x=16, z=86), 6)
    return lathe(foot, corner=1.5) - move(cylinder(16, 20), z=84) - notches


def basketball() -> Solid:
    groove = ring(31, 4)
    bow = move(ring(24, 4), z=21)
    sides = turn(bow, y=90) + turn(bow, y=-90)
    return grounded(turn(ball(31) - groove - turn(groove, x=90) - sides, x=25, y=15), 1.6)


def bowling_ball() -> Solid:
    holes = [turn(move(cylinder(5, 30, corner=0), z=18), x=x, y=y) for x, y in ((12, 22), (-16, 22), (0, -4))]
    return grounded(ball(32) - sum(holes, Solid()), 1.6)


def studded_brick() -> Solid:
    studs = [move(cylinder(7.5, 8), x=x, y=y, z=37) for x in (-22, 0, 22) for y in (-11, 11)]
    return box(67, 44, 40, 1.5) + sum(studs, Solid())


def arch_block() -> Solid:
    section = soften(polygon([(-34, 0), (-34, 50), (34, 50), (34, 0)]), 1) - circle(18)
    return turn(plate(section, 34, 2), x=90).translate((0, 17, 0))


def duck() -> Solid:
    body = hull(ellipsoid(34, 25, 20).translate((0, 0, 20)), ball(4, 12).translate((-42, 0, 40)))
    head = ball(20).translate((18, 0, 54))
    beak = hull(ellipsoid(6, 11, 4, 16).translate((34, 0, 51)), ellipsoid(4, 7, 3, 16).translate((44, 0, 50)))
    wing = hull(ellipsoid(16, 4, 10, 16).translate((0, 24, 24)), ball(3, 12).translate((-24, 22, 33)))
    eye = mirrored(ball(3.5, 12).translate((31, 13.5, 60)))
    return grounded(body + head + beak + mirrored(wing) + eye, 2.0)


def car() -> Solid:
    body = hull(move(box(104, 46, 16, 4), z=9), move(box(96, 44, 20, 5), z=9))
    cabin = hull(move(box(62, 44, 6, 3), x=-6, z=24), move(box(38, 38, 6, 3), x=-8, z=42))
    windows = mirrored(hull(move(box(46, 4, 2, 0.5), x=-7, y=22, z=30), move(box(34, 4, 2, 0.5), x=-8, y=20, z=41)))
    wheel = turn(cylinder(12, 10), x=90) - turn(cylinder(5, 3, corner=0), x=90).translate((0, -8, 0))
    wheels = [mirrored(wheel.translate((x, -19, 12))) for x in (-31, 31)]
    lights = mirrored(turn(cylinder(5, 6), y=90).translate((49, 15, 20)))
    return body + cabin - windows + lights + sum(wheels, Solid())


def boat() -> Solid:
    """With a wheelhouse and a funnel."""
    deck = [(-52, -23), (20, -23), *curve([(20, -23), (42, -14), (56, 0), (42, 14), (20, 23)], 4), (-52, 23)]
    keel = soften(polygon([(0.82 * x, 0.78 * y) for x, y in deck]), 4)
    shell = hull(plate(keel, 6, 2), move(plate(soften(polygon(deck), 4), 6, 2), z=26))
    deck_well = move(extrude(polygon([(0.86 * x, 0.8 * y) for x, y in deck]), 20), z=27)
    house = move(box(44, 28, 26), x=-18, z=24) + move(box(50, 32, 6), x=-18, z=48)
    porthole = turn(cylinder(5, 6, corner=0), x=90).translate((-8, -11, 38))
    portholes = mirrored(porthole + move(porthole, x=-20))
    funnel = move(cylinder(9, 28), x=-22, z=50) + move(ring(9, 5), x=-22, z=72)
    return shell - deck_well + house - portholes + funnel


def rocket() -> Solid:
    body = lathe([(0, 12), *curve([(15, 12), (23, 44), (21, 84), (11, 114), (2, 132)]), (0, 133)])
    fin = turn(plate(polygon([(0, 52), (20, 40), (36, 14), (36, 0), (24, 0), (14, 20), (0, 20)]), 8, 2), x=90).translate((4, 4, 0))
    window = turn(ring(9, 5), x=90).translate((0, -22, 78)) + turn(cylinder(9, 8), x=90).translate((0, -13, 78))
    return body + around(fin, 4).rotate((0, 0, 45)) + window + lathe([(0, 4), (13, 4), (10, 16), (0, 16)])


THINGS = (
    entry("chess-1", "black chess pawn", 0.1, WOOD, BLACK, pawn, symmetric=True),
    entry("chess-2", "white chess rook", 0.14, WOOD, WHITE, rook),
    entry("ball-1", "orange basketball", 0.12, RUBBER, ORANGE, basketball),
    entry("ball-2", "blue bowling ball", 0.3, PLASTIC, BLUE, bowling_ball),
    entry("block-1", "red brick with six studs", 0.1, PLASTIC, RED, studded_brick),
    entry("block-2", "green arch block", 0.14, WOOD, GREEN, arch_block),
    entry("toy-1", "yellow rubber duck", 0.08, RUBBER, YELLOW, duck),
    entry("toy-2", "teal toy car", 0.15, PLASTIC, TEAL, car),
    entry("toy-3", "white toy boat with a funnel", 0.14, WOOD, WHITE, boat),
    entry("toy-4", "silver toy rocket", 0.13, PLASTIC, SILVER, rocket),
)
