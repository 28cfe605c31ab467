"""Where things stood at first, seen from above: what the policy was taught about, and where it failed."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from optimus.report.data import Starts

MARGIN = 0.02
"""Around the outermost start [m]."""
TICK = 0.1
"""Between two lines of the grid [m]."""
SIZE = 240
"""Of the longer side of a picture, in its own units."""


def coverage(starts: Starts) -> str:
    """An SVG: a dot a demonstration, a ring a held-out one, a cross where the policy failed. Up is away from the arm."""
    points = [*starts.learned, *starts.held_out, *starts.failed]
    if not points:
        return ""
    low = [min(p[i] for p in points) - MARGIN for i in (0, 1)]
    high = [max(p[i] for p in points) + MARGIN for i in (0, 1)]
    scale = SIZE / max(h - b for h, b in zip(high, low, strict=True))

    def place(point: tuple[float, float]) -> tuple[float, float]:
        return (high[1] - point[1]) * scale, (high[0] - point[0]) * scale

    width, height = (high[1] - low[1]) * scale, (high[0] - low[0]) * scale
    marks = _grid(low, high, scale) + "".join(_dot(*place(p), "learned") for p in starts.learned)
    marks += "".join(_dot(*place(p), "held-out") for p in starts.held_out) + "".join(_cross(*place(p)) for p in starts.failed)
    counts = f"{len(starts.learned)} starts learned from, {len(starts.held_out)} held out, {len(starts.failed)} failed"
    said = f"{starts.thing}: {counts}"
    box = f'viewBox="0 0 {width:.1f} {height:.1f}"'
    return f'<svg class="starts" role="img" aria-label="{escape(said, quote=True)}" {box}>{marks}</svg>'


def _dot(x: float, y: float, kind: str) -> str:
    return f'<circle class="{kind}" cx="{x:.1f}" cy="{y:.1f}" r="3"/>'


def _cross(x: float, y: float) -> str:
    return f'<path class="failed" d="M{x - 4:.1f} {y - 4:.1f}l8 8m0 -8l-8 8"/>'


def _grid(low: Sequence[float], high: Sequence[float], scale: float) -> str:
    """A line each ten centimetres, with its distance from the arm's base."""
    lines = ""
    for k in range(int(low[1] // TICK) + 1, int(high[1] // TICK) + 1):
        x = (high[1] - k * TICK) * scale
        lines += f'<path class="grid-line" d="M{x:.1f} 0V{(high[0] - low[0]) * scale:.1f}"/>'
        lines += f'<text x="{x + 2:.1f}" y="{(high[0] - low[0]) * scale - 3:.1f}">y {k * TICK:.1f} m</text>'
    for k in range(int(low[0] // TICK) + 1, int(high[0] // TICK) + 1):
        y = (high[0] - k * TICK) * scale
        lines += f'<path class="grid-line" d="M0 {y:.1f}H{(high[1] - low[1]) * scale:.1f}"/>'
        lines += f'<text x="2" y="{y - 3:.1f}">x {k * TICK:.1f} m</text>'
    return lines
