"""Things about the house, made of a few convex parts each: a basket, a vase, a magnet."""

from __future__ import annotations

import numpy as np

from optimus.objects.shapes import Grasp, Part, Rgba, Shape, top_grasp
from optimus.se3 import quat_from_matrix


def basket(length: float, width: float, height: float, rgba: Rgba, mass: float = 0.08, wall: float = 0.006) -> Shape:
    """An open box [m] with an arched handle across its length, taken by the handle or, across the width, by its walls."""
    hx, hy, hz, w = length / 2, width / 2, height / 2, wall / 2
    rim = 0.55 * height
    """Height of the walls; the handle stands on them."""
    low = rim / 2 - hz
    parts = (
        Part("box", (hx, hy, w), (0.0, 0.0, w - hz)),
        Part("box", (w, hy, rim / 2), (hx - w, 0.0, low)),
        Part("box", (w, hy, rim / 2), (w - hx, 0.0, low)),
        Part("box", (hx, w, rim / 2), (0.0, hy - w, low)),
        Part("box", (hx, w, rim / 2), (0.0, w - hy, low)),
        Part("box", (w, 0.008, hz - rim / 2), (hx - w, 0.0, rim / 2)),
        Part("box", (w, 0.008, hz - rim / 2), (w - hx, 0.0, rim / 2)),
        Part("box", (hx, 0.008, 0.008), (0.0, 0.0, hz - 0.008)),
    )
    by_the_handle = [top_grasp(s * np.pi / 2, hz - 0.010) for s in (1, -1)]
    grasps = (*by_the_handle, *(_from_its_side(s) for s in (1.0, -1.0)))
    return Shape("basket", parts, (hx, hy, hz), mass, rgba, grasps=grasps)


def _from_its_side(closing: float) -> Grasp:
    """Through the middle from +y, the fingers closing along +z or -z: from above where it lies on its other side, which leaves the
    handle too low for a hand."""
    # columns: tcp x, y (closing direction), z (approaching)
    matrix = np.array([[closing, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, closing, 0.0]])
    w, x, y, z = quat_from_matrix(matrix).tolist()
    return Grasp((0.0, 0.0, 0.0), (w, x, y, z))


def vase(radius: float, neck: float, height: float, rgba: Rgba, mass: float = 0.10) -> Shape:
    """A belly, a narrower neck and a rim [m]; taken across the neck."""
    half = height / 2
    belly, upper = 0.55 * height, 0.45 * height
    parts = (
        Part("cylinder", (0.8 * radius, 0.1 * height), (0.0, 0.0, 0.1 * height - half)),
        Part("cylinder", (radius, (belly - 0.1 * height) / 2), (0.0, 0.0, 0.1 * height + (belly - 0.1 * height) / 2 - half)),
        Part("cylinder", (neck, upper / 2), (0.0, 0.0, half - upper / 2)),
    )
    grasps = tuple(top_grasp(k * np.pi / 8, half - 0.02) for k in range(16))
    return Shape("vase", parts, (radius, radius, half), mass, rgba, grasps=grasps, symmetric=True)


def magnet(length: float, width: float, height: float, rgba: Rgba, mass: float = 0.08) -> Shape:
    """A horseshoe lying flat [m]: two legs along x and the bridge that joins them; taken across a leg or the bridge."""
    hx, hy, hz = length / 2, width / 2, height / 2
    thick = width / 6
    """Half the width of a leg."""
    parts = (
        Part("box", (hx, thick, hz), (0.0, hy - thick, 0.0)),
        Part("box", (hx, thick, hz), (0.0, thick - hy, 0.0)),
        Part("box", (thick, hy, hz), (thick - hx, 0.0, 0.0)),
    )
    bridge = [top_grasp(s * np.pi / 2 + np.pi / 2, 0.0, x=thick - hx) for s in (1, -1)]
    across = [top_grasp(s * np.pi / 2, 0.0, x=-hx / 3) for s in (1, -1)] if width <= 0.07 else []
    return Shape("magnet", parts, (hx, hy, hz), mass, rgba, grasps=(*across, *bridge))
