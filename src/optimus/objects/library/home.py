"""Boxes, books, candles, lamps, bells and trophies (millimetres)."""

from __future__ import annotations

from optimus.objects.library.entry import (
    BLUE,
    BROWN,
    CREAM,
    DARK_GREEN,
    GOLD,
    METAL,
    ORANGE,
    PAPER,
    PURPLE,
    RED,
    SKY,
    TAN,
    TEAL,
    WHITE,
    WOOD,
    YELLOW,
    colour,
    entry,
)
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
    hull,
    lathe,
    mirrored,
    move,
    offset,
    plate,
    polygon,
    rectangle,
    ring,
    star,
    sweep,
    turn,
)


def cardboard_box() -> Solid:
    """Its flaps meet under a strip of tape."""
    seams = move(box(90, 2.5, 10, 1), z=50) + mirrored(move(box(2.5, 90, 10, 1), x=39.5, z=51), (1, 0, 0))
    tape = box(77, 16, 53, 1) - box(60, 20, 49, 1)
    return box(75, 62, 52) - seams + tape - move(box(30, 90, 9, 1), z=26) + box(74, 61, 45)


def gift_box() -> Solid:
    """With a lid, ribbons and a bow."""
    ribbons = box(63, 14, 62, 1) + box(14, 63, 62, 1)
    loop = sweep(curve([(2, 0, 0), (14, 0, 12), (26, 0, 14), (29, 0, 6), (18, 0, 1), (2, 0, 0)], 4), ellipsoid(2.5, 7, 2.5, 8))
    bow = around(loop, 2) + turn(around(loop, 2), z=90).scale((0.8, 0.8, 0.8)) + ball(7, 16)
    return box(56, 56, 54) + move(box(61, 61, 18), z=40) + ribbons + move(bow, z=63)


def treasure_chest() -> Solid:
    def half_round(radius: float, length: float) -> Solid:
        lid = extrude(circle(radius), length).rotate((90, 0, 90)).translate((-length / 2, 0, 36))
        return lid.trim_by_plane((0, 0, 1), 37)

    bands = sum((move(half_round(27, 7) + box(7, 54, 39, 1), x=x) for x in (-27, 0, 27)), Solid())
    lock = move(box(14, 8, 18), y=-26, z=24) - move(turn(cylinder(2.5, 30, corner=0), x=90), z=33)
    return box(66, 48, 36) + half_round(24.5, 64) + move(box(68, 52, 6), z=33) + bands + lock


def milk_carton() -> Solid:
    roof = hull(move(box(60, 60, 4, 1), z=84), move(box(60, 8, 4, 1), z=112))
    spout = turn(cylinder(11, 12), x=45).translate((0, -18, 98))
    # 8 mm: fingers that meet on less than that chatter, and what they hold creeps out
    return box(60, 60, 88, 1.5) + roof + move(box(60, 8, 20, 1), z=112) + spout


def closed_book() -> Solid:
    """Lying, its spine round, its pages set back."""
    return _book(60, 86, 27)


def _book(width: float, length: float, height: float) -> Solid:
    covers = box(width, length, 6, 1.0) + move(box(width, length, 6, 1.0), z=height - 6)
    pages = box(width - 5, length - 8, height - 4, 1.0).translate((0, 0, 2))
    round_back = turn(cylinder(0.75 * height, length), x=90).translate((0.55 * height, length / 2, height / 2))
    spine = round_back ^ box(height, 2 * length, height, 1.0)
    return covers + pages + move(spine, x=0.2 * height - width / 2)


def open_book() -> Solid:
    page = curve([(0, 13), (7, 20), (18, 22), (44, 17)], 5)
    half = polygon([(0, 4), *[(x, z) for x, z in page], (45, 4)])
    pages = turn(extrude(half, 57), x=90).translate((0, 28.5, 0))
    ribbon = move(box(6, 57, 6, 1.5), x=10, z=17)
    return mirrored(pages, (1, 0, 0)) + box(98, 60, 7, 1) + ribbon


def book_stack() -> Solid:
    second, third = turn(_book(48, 62, 19), z=12), turn(_book(44, 58, 18), z=-8)
    return _book(52, 67, 21) + move(second, z=20) + move(third, y=2, z=38)


def pillar_candle() -> Solid:
    """Burning, with wax running down."""
    wax = cylinder(28, 74) - ellipsoid(22, 22, 6).translate((0, 0, 74))
    for angle, low in ((20, 30), (100, 50), (150, 18), (230, 42), (300, 26)):
        drop = sweep([(27, 0, 72), (28.5, 0, low)], 3.5) + ball(5, 16).translate((28.5, 0, low))
        wax += turn(drop, z=angle)
    flame = lathe([(0, 0), *curve([(3, 0), (9, 12), (6, 24), (2, 36)]), (0, 37)])
    return wax + move(cylinder(3, 16), z=62) + move(flame, z=72)


def candlestick() -> Solid:
    """A saucer with a ring to hold it by, and the candle in it."""
    saucer = lathe([(0, 0), (32, 0), (34, 4), (38, 12), (38, 15), (34, 15), *curve([(31, 9), (26, 6)]), (0, 6)], corner=1.0)
    socket = lathe([(0, 4), *curve([(16, 4), (12, 12), (15, 24)]), (15, 28), (0, 28)], corner=1)
    flame = lathe([(0, 0), *curve([(3, 0), (8, 11), (5, 20), (2, 32)]), (0, 33)])
    handle = turn(ring(13, 7), x=90).translate((46, 0, 18))
    return saucer + socket + cylinder(10.5, 88) + move(flame, z=86) + (handle - cylinder(34, 60))


def table_lamp() -> Solid:
    stem = curve([(24, 12), (8, 17), (7, 26), (15, 38), (19, 52), (12, 68), (7, 80)])
    foot = lathe([(0, 0), (30, 0), (30, 7), *stem, (7, 100), (0, 100)])
    shade = lathe([(0, 88), (38, 88), (24, 144), (0, 144)], corner=2)
    return foot + shade + move(cylinder(4.5, 12), z=142)


def lantern() -> Solid:
    bars = around(move(cylinder(3, 56), x=25, z=14), 6)
    roof = lathe([(0, 66), (32, 66), (32, 71), *curve([(28, 74), (16, 84), (13, 94)]), (13, 100), (0, 100)], corner=1.5)
    glass = lathe([(0, 14), *curve([(14, 14), (20, 40), (14, 68)]), (0, 68)])
    foot = cylinder(32, 10) + move(cylinder(29, 8), z=8)
    return foot + bars + glass + roof + turn(ring(15, 7), x=90).translate((0, 0, 111))


def hand_bell() -> Solid:
    dome = lathe([(0, 0), (36, 0), (36, 6), *curve([(31, 12), (23, 34), (19, 52), (10, 60)]), (0, 61)], corner=1.5)
    grip = lathe([(0, 58), *curve([(7, 58), (7, 68), (11, 90), (8, 108), (10, 118), (7, 126)]), (0, 128)])
    return dome + grip - cylinder(29, 5, corner=0)


def cow_bell() -> Solid:
    section = rectangle(62, 46, 12)
    outside = plate(section, 78, 3, 0.62)
    inside = extrude(offset(section, -6), 70, 0.6)
    loop = sweep(curve([(-14, 0, 74), (-13, 0, 92), (0, 0, 98), (13, 0, 92), (14, 0, 74)], 4), ellipsoid(4, 7, 4, 12))
    clapper = move(cylinder(4, 70), z=6) + ball(9, 24).translate((0, 0, 14))
    rivets = [turn(cylinder(3.5, 8), x=90).translate((x, -12, 62)) for x in (-13, 13)]
    return outside - inside + loop + clapper + sum(rivets, Solid())


def trophy_cup() -> Solid:
    plinth = box(54, 54, 18) + move(box(44, 44, 12), z=16)
    body = [*curve([(20, 28), (7, 36), (6, 50), (22, 64), (30, 92), (32, 112)]), (32, 116), (0, 116)]
    cup = lathe([(0, 26), *body], corner=1.5) - lathe([(0, 74), *curve([(8, 74), (20, 84), (26, 118)]), (0, 118)])
    handle = sweep(curve([(29, 0, 106), (46, 0, 110), (50, 0, 92), (38, 0, 72), (22, 0, 66)], 3), 4.0)
    return plinth + cup + (mirrored(handle, (1, 0, 0)) - lathe([(0, 74), (20, 84), (26, 118), (0, 118)]))


def star_trophy() -> Solid:
    plinth = lathe([(0, 0), (32, 0), (32, 12), (26, 14), (26, 28), (0, 28)], corner=1.5)
    stem = lathe([(0, 26), *curve([(14, 26), (6, 40), (8, 78)]), (0, 80)])
    front = turn(plate(star(5, 36, 17), 16, 2), x=90).translate((0, 8, 92))
    return plinth + stem + front


THINGS = (
    entry("box-1", "tan cardboard box", 0.12, PAPER, TAN, cardboard_box),
    entry("box-2", "red gift box with a bow", 0.12, PAPER, RED, gift_box),
    entry("box-3", "brown treasure chest", 0.25, WOOD, BROWN, treasure_chest),
    entry("box-4", "white milk carton", 0.3, PAPER, WHITE, milk_carton),
    entry("book-1", "blue book lying closed", 0.2, PAPER, BLUE, closed_book),
    entry("book-2", "cream open book", 0.15, PAPER, CREAM, open_book),
    entry("book-3", "dark green stack of three books", 0.35, PAPER, DARK_GREEN, book_stack),
    entry("candle-1", "yellow burning pillar candle", 0.2, PAPER, YELLOW, pillar_candle),
    entry("candle-2", "golden candlestick with a candle", 0.22, METAL, GOLD, candlestick),
    entry("lamp-1", "purple table lamp", 0.25, METAL, PURPLE, table_lamp, symmetric=True),
    entry("lamp-2", "teal lantern with a ring", 0.22, METAL, TEAL, lantern),
    entry("bell-1", "orange hand bell", 0.25, METAL, ORANGE, hand_bell, symmetric=True),
    entry("bell-2", "bronze cow bell", 0.25, METAL, colour("#8c6a2f"), cow_bell),
    entry("trophy-1", "golden trophy cup with two handles", 0.3, METAL, GOLD, trophy_cup),
    entry("trophy-2", "sky blue star trophy", 0.25, METAL, SKY, star_trophy),
)
