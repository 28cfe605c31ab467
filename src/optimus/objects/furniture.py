"""Furniture built from its sizes: a shelf of rungs, a box with a door on a hinge, a bin."""

from __future__ import annotations

from optimus.objects.shapes import Part, Rgba, Shape, Surface, Vec3

BOARD = 0.02
"""Thickness of a shelf's boards [m]."""
WALL = 0.01
"""Thickness of the walls of boxes and bins [m]."""


def board(depth: float, width: float, rgba: Rgba) -> Shape:
    """One rung of a shelf, depth along x and width along y [m]; things rest on its upper face."""
    half = (depth / 2, width / 2, BOARD / 2)
    return Shape("board", (Part("box", half),), half, 1.0, rgba, surface=Surface(half[2], half[0], half[1]))


def uprights(depth: float, width: float, height: float, rgba: Rgba) -> Shape:
    """The two sides of a shelf and its top, which nothing rests on [m]."""
    side = (depth / 2, BOARD / 2, height / 2)
    top = Part("box", (depth / 2, width / 2 + BOARD, BOARD / 2), (0.0, 0.0, height / 2 - BOARD / 2))
    sides = [Part("box", side, (0.0, s * (width / 2 + BOARD / 2), 0.0)) for s in (1.0, -1.0)]
    return Shape("uprights", (*sides, top), (depth / 2, width / 2 + BOARD, height / 2), 1.0, rgba)


def box_open_in_front(depth: float, width: float, height: float, rgba: Rgba) -> Shape:
    """A box (outer sizes along x, y and z [m]) without its face on the -x side; things rest on its floor."""
    hx, hy, hz, w = depth / 2, width / 2, height / 2, WALL / 2
    parts = (
        Part("box", (hx, hy, w), (0.0, 0.0, w - hz)),
        Part("box", (hx, hy, w), (0.0, 0.0, hz - w)),
        Part("box", (hx, w, hz), (0.0, hy - w, 0.0)),
        Part("box", (hx, w, hz), (0.0, w - hy, 0.0)),
        Part("box", (w, hy, hz), (hx - w, 0.0, 0.0)),
    )
    return Shape("box", parts, (hx, hy, hz), 1.0, rgba, surface=Surface(WALL - hz, hx - WALL, hy - WALL))


def panel(width: float, height: float, rgba: Rgba, towards: float, bar: Vec3, bar_length: float) -> Shape:
    """A door's panel and the two posts of its bar, in the door's frame: it reaches from the hinge along y * `towards` [m]."""
    face = Part("box", (WALL / 2, width / 2, height / 2), (0.0, towards * width / 2, 0.0))
    post = (abs(bar[0]) / 2, 0.006, 0.006)
    posts = [Part("box", post, (bar[0] / 2, bar[1], bar[2] + s * (bar_length / 2 - 0.006))) for s in (1.0, -1.0)]
    return Shape("panel", (face, *posts), (WALL / 2, width / 2, height / 2), 1.0, rgba)


def bin_of(edge: float, height: float, rgba: Rgba) -> Shape:
    """A square bin with its mouth up (outer sizes [m]); things rest on its floor."""
    half, hz, w = edge / 2, height / 2, WALL / 2
    parts = [Part("box", (half, half, w), (0.0, 0.0, w - hz))]
    parts += [Part("box", (w, half, hz), (s * (half - w), 0.0, 0.0)) for s in (1.0, -1.0)]
    parts += [Part("box", (half, w, hz), (0.0, s * (half - w), 0.0)) for s in (1.0, -1.0)]
    inner = half - WALL
    return Shape("bin", tuple(parts), (half, half, hz), 1.0, rgba, surface=Surface(WALL - hz, inner, inner))
