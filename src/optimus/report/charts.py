"""Curves and bars as inline SVG, in colours of the page's style sheet, so that they follow dark mode."""

import io
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape
from itertools import cycle
from typing import TYPE_CHECKING

from optimus.report.data import Interval

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# what is drawn with, and the colour of the page that replaces it
INK, FRAME, FIRST, SECOND = "#010203", "#010204", "#010205", "#010206"
OTHERS = ("#2e8b57", "#8c5aaa", "#c2453a", "#8a8a2b")
"""Of further curves; they are seen on light and dark."""
PAINT = {INK: "currentColor", FRAME: "var(--line)", FIRST: "var(--first)", SECOND: "var(--second)"}


@dataclass(frozen=True)
class Panel:
    """One set of axes: what is drawn over the training step."""

    title: str
    curves: Mapping[str, str]  # label -> key in the training log
    from_zero: bool = True


PANELS = (
    Panel(
        "Loss (negative log likelihood)",
        {"training": "loss", "held out": "held_out_likelihood"},
        from_zero=False,
    ),
    Panel("Held-out error of the commanded position [mm]", {"held out": "held_out_action_error_mm"}),
    Panel("Held-out error of located objects [mm]", {"held out": "held_out_location_error_mm"}),
    Panel("Held-out error of where the hand goes next [mm]", {"held out": "held_out_aim_error_mm"}),
    Panel("Training speed [labels/s]", {"training": "labels_per_second"}),
)


def curves(panel: Panel, metrics: Sequence[Mapping[str, float]]) -> str:
    """An SVG of the panel, or nothing where the log has none of its keys."""
    series = {label: [(line["step"], line[key]) for line in metrics if key in line] for label, key in panel.curves.items()}
    return lines(panel, series) if any(series.values()) else ""


def lines(panel: Panel, series: Mapping[str, Sequence[tuple[float, float]]]) -> str:
    """An SVG of labelled points `(step, value)`, each series in its colour."""
    from matplotlib import rc_context
    from matplotlib.figure import Figure

    with rc_context({"svg.fonttype": "none", "svg.hashsalt": panel.title, "font.family": "sans-serif"}):
        figure = Figure(figsize=(5.4, 2.8), layout="constrained")
        axes = figure.add_subplot()
        for color, (label, points) in zip(cycle((FIRST, SECOND, *OTHERS)), series.items(), strict=False):
            if points:
                x, y = zip(*points, strict=True)
                marker = "o" if len(points) < 25 else ""
                axes.plot(x, y, color=color, linewidth=1.8, label=label, marker=marker, markersize=3)
        if panel.from_zero:
            axes.set_ylim(bottom=0)
        _dress(axes)
        text = io.StringIO()
        figure.savefig(text, format="svg", transparent=True, metadata={"Date": None, "Creator": None})
    return _inline(text.getvalue(), panel.title)


def _dress(axes: "Axes") -> None:
    axes.set_xlabel("training step", color=INK)
    axes.tick_params(colors=INK, length=3)
    axes.grid(color=FRAME, linewidth=0.6)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["bottom", "left"]].set_color(FRAME)
    if len(axes.lines) > 1:
        axes.legend(frameon=False, labelcolor=INK)


def _inline(svg: str, title: str) -> str:
    """The SVG element alone, without outside names, painted with the page's colours."""
    svg = svg[svg.index("<svg") :]
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg, flags=re.S)
    svg = re.sub(r' xmlns(:\w+)?="[^"]*"', "", svg).replace("xlink:href", "href")
    svg = re.sub(r'<svg width="[^"]*" height="[^"]*"|<svg height="[^"]*"', "<svg", svg)
    svg = re.sub(r' (width|height)="[\d.]+pt"', "", svg)
    for placeholder, paint in PAINT.items():
        svg = svg.replace(placeholder, paint)
    return svg.replace("<svg", f'<svg role="img" aria-label="{escape(title, quote=True)}"', 1)


def histogram(values: Sequence[int], bins: int = 24) -> str:
    """An SVG of how many values fall into each of `bins` equal parts of their range."""
    low, high = min(values), max(values)
    width = max(1, -(-(high - low + 1) // bins))
    counts = [0] * ((high - low) // width + 1)
    for value in values:
        counts[(value - low) // width] += 1
    said = [f"{low + i * width} to {low + (i + 1) * width - 1}: {count}" for i, count in enumerate(counts)]
    return bars(counts, said, str(low), str(high))


def bars(counts: Sequence[int], said: Sequence[str], low: str, high: str) -> str:
    """An SVG of upright bars side by side, what each says, and the ends of the scale below."""
    drawn = ""
    for i, (count, text) in enumerate(zip(counts, said, strict=True)):
        height = 100 * count / max(1, *counts)
        place = f'x="{i + 0.06:.2f}" y="{100 - height:.2f}" width="0.88" height="{height:.2f}"'
        drawn += f"<rect {place}><title>{escape(text)}</title></rect>"
    box = f'viewBox="0 0 {len(counts)} 100" preserveAspectRatio="none"'
    picture = f'<svg class="bars" role="img" {box}>{drawn}</svg>'
    return f'{picture}<div class="scale"><span>{escape(low)}</span><span>{escape(high)}</span></div>'


def from_above(points: Mapping[str, Sequence[Sequence[float]]]) -> str:
    """An SVG of places (x, y) [m] as the robot sees them, which stands below the picture: +x is up, +y is left."""
    xs = [p[0] for some in points.values() for p in some]
    ys = [p[1] for some in points.values() for p in some]
    size = max(max(xs) - min(xs), max(ys) - min(ys), 0.05) * 1.1
    left, top = -(max(ys) + min(ys)) / 2 - size / 2, -(max(xs) + min(xs)) / 2 - size / 2
    dots, legend = "", ""
    for i, (name, some) in enumerate(points.items()):
        paint = f"hsl({(210 + 137 * i) % 360} 60% 52%)"
        legend += f'<span><i style="background:{paint}"></i>{escape(name)}</span>'
        circles = (f'<circle cx="{-y:.4f}" cy="{-x:.4f}" r="{size / 110:.5f}"/>' for x, y in (p[:2] for p in some))
        dots += f'<g fill="{paint}" fill-opacity="0.75">{"".join(circles)}</g>'
    box = f'viewBox="{left:.4f} {top:.4f} {size:.4f} {size:.4f}"'
    return f'<svg class="places" role="img" {box}>{dots}</svg><div class="legend">{legend}</div>'


def rate_bar(label: str, successes: int, episodes: int, interval: Interval | None, kind: str) -> str:
    """A row: who, a bar of the success rate with its interval, and the count."""
    share = 100 * successes / max(episodes, 1)
    whisker = note = ""
    if interval is not None:
        low, high = (100 * end for end in interval)
        whisker = f'<i class="whisker" style="left:{low:.2f}%;width:{high - low:.2f}%"></i>'
        note = f"<small>{low:.0f} to {high:.0f} %</small>"
    return (
        f'<div class="rate {kind}"><span class="who">{escape(label)}</span>'
        f'<span class="track"><i class="fill" style="width:{share:.2f}%"></i>{whisker}</span>'
        f'<span class="count"><b>{successes}</b> of {episodes} {note}</span></div>'
    )
