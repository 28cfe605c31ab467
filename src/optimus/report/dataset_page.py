"""A data set as one self-contained page: its figures, and contact sheets of how episodes begin and end."""

import io
from collections.abc import Mapping, Sequence
from html import escape

import numpy as np
from PIL import Image

from optimus.data.describe import BINS, CELLS, Description, starting_places
from optimus.data.episode import IMAGE_SUFFIX, INSTRUCTION
from optimus.data.episode_file import OBSERVATION_PREFIX, EpisodeHeader
from optimus.data.store import EpisodeStore
from optimus.report import charts, pieces
from optimus.report.data import Film

SHEET_EPISODES = 12
"""On a contact sheet: as many columns, evenly spread over the data set."""
MOMENTS = 5
"""... and as many rows, evenly spread over each episode."""
TILE = 84
"""Side of a tile [pixels]."""


def render_dataset(store: EpisodeStore, about: Description) -> str:
    """The page as text."""
    return pieces.document(
        f"{about.task}: {about.episodes} demonstrations",
        [_header(about), _sheets(store), _lengths(about), _starts(store, about), _actions(about), _settings(store, about)],
    )


def _header(about: Description) -> str:
    numbers = {
        "Demonstrations": f"{about.episodes:,}",
        "Steps": f"{about.steps:,}",
        "Median length": f"{int(np.median(about.lengths))} steps",
        "Failed attempts": f"{sum(about.failures.values()):,}",
        "Pushed on purpose": f"{about.perturbed:,}",
        "Planned again": f"{about.retried:,}",
        "Mishaps": f"{about.mishaps:,}",
    }
    if about.imitability is not None:
        numbers["Left to chance, an episode"] = f"{1000 * about.imitability.drift:.0f} mm"
    names = " and ".join(f"{c} ({h} x {w})" for c, (h, w, *_) in about.cameras.items()) or "no camera"
    lead = f"<p>Task {escape(about.task)}, seen by {escape(names)}.</p>"
    return f"<header><h1>{escape(about.task)}</h1>{lead}</header>{pieces.numbers(numbers)}"


def _sheets(store: EpisodeStore) -> str:
    headers = store.headers()
    chosen = [headers[i] for i in np.unique(np.linspace(0, len(headers) - 1, SHEET_EPISODES).round().astype(int))]
    seeds = ", ".join(str(h.seed) for h in chosen)
    sheets = ""
    for camera in store.cameras:
        caption = f"{camera}: episodes {seeds} from left to right, each from its start (top) to its end"
        sheets += pieces.figure(Film(caption), pieces.picture(contact_sheet(chosen, camera), caption))
    lead = f"One column an episode, named by its seed; `optimus dataset {store.path} --play {chosen[0].seed}` writes one as a film."
    return pieces.section("sheets", "What it looks like", f'<div class="card">{sheets}</div>', lead) if sheets else ""


def contact_sheet(headers: Sequence[EpisodeHeader], camera: str) -> bytes:
    """A PNG: a column an episode, `MOMENTS` of its images of that camera from top to bottom."""
    sheet = Image.new("RGB", (len(headers) * (TILE + 2) - 2, MOMENTS * (TILE + 2) - 2), "grey")
    for column, header in enumerate(headers):
        slot = header.arrays[f"{OBSERVATION_PREFIX}{camera}{IMAGE_SUFFIX}"]
        images = np.memmap(header.path, np.uint8, "r", slot.offset, slot.shape)
        for row, moment in enumerate(np.linspace(0, header.steps - 1, MOMENTS).round().astype(int)):
            tile = Image.fromarray(np.asarray(images[moment])).resize((TILE, TILE), Image.Resampling.LANCZOS)
            sheet.paste(tile, (column * (TILE + 2), row * (TILE + 2)))
    buffer = io.BytesIO()
    sheet.save(buffer, "PNG", optimize=True)
    return buffer.getvalue()


def _lengths(about: Description) -> str:
    cards = f'<div class="card"><h3>Lengths [steps]</h3>{charts.histogram(about.lengths)}</div>'
    counted: tuple[tuple[str, Mapping[str, int], str], ...] = (
        ("Plans", about.skeletons, "sequence of skills"),
        ("Split", about.split, "part"),
        ("Instructions", about.instructions, INSTRUCTION),
        ("Objects", about.objects, "thing"),
        ("Variants", about.variants, "variant"),
        ("Failed attempts", about.failures, "reason"),
    )
    cards += "".join(pieces.counts(title, found, what) for title, found, what in counted if found)
    return pieces.section("counts", "How many of what", f'<div class="grid">{cards}</div>')


def _starts(store: EpisodeStore, about: Description) -> str:
    if not about.starts:
        return ""
    rows = [
        [name, f"{s.low[0]:.3f} to {s.high[0]:.3f}", f"{s.low[1]:.3f} to {s.high[1]:.3f}", f"{s.cells} ({s.expected_cells:.0f})"]
        for name, s in about.starts.items()
    ]
    columns = ["thing", "x [m]", "y [m]", f"of {CELLS * CELLS} cells"]
    picture = charts.from_above(starting_places(store.headers()))
    cards = f'<div class="card">{picture}</div><div class="card">{pieces.table(columns, rows)}</div>'
    lead = "From above, the robot at the lower edge. In brackets: the cells that as many starts would reach if drawn evenly."
    return pieces.section("starts", "Where things start", f'<div class="grid">{cards}</div>', lead)


def _actions(about: Description) -> str:
    edges = np.linspace(-1, 1, BINS + 1)
    cards = ""
    for number, spread in enumerate(about.actions):
        said = [f"{a:.1f} to {b:.1f}: {n}" for a, b, n in zip(edges, edges[1:], spread.histogram, strict=False)]
        note = f"mean {spread.mean:.2f}, sd {spread.sd:.2f}, at the limit {100 * spread.saturated:.1f} %"
        drawn = charts.bars(spread.histogram, said, "-1", "1")
        cards += f'<div class="card"><h3>action {number}</h3>{drawn}<small>{note}</small></div>'
    lead = "Every number of the actions over all steps; the last is the gripper's, which 1 shuts."
    return pieces.section("actions", "How it moves", f'<div class="grid">{cards}</div>', lead)


def _settings(store: EpisodeStore, about: Description) -> str:
    tables = (("Collected with", store.config), ("Versions", about.versions))
    cards = "".join(f'<div class="card"><h3>{t}</h3>{pieces.table([], list(pieces.flat(v)))}</div>' for t, v in tables if v)
    return pieces.section("settings", "To repeat it", f'<div class="grid">{cards}</div>') if cards else ""
