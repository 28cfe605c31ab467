"""Several runs on one page: success side by side, what was set differently, the training's curves over one another."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from pathlib import Path
from typing import Any

from optimus.data.atomic import write_whole
from optimus.report import charts, pieces
from optimus.report.data import ReportData
from optimus.report.page import duration


def write_comparison(runs: Mapping[str, ReportData], command: str, path: Path) -> None:
    """Write the page of `runs`, by the names they shall have, whole or not at all."""
    write_whole(path, render_comparison(runs, command).encode())


def render_comparison(runs: Mapping[str, ReportData], command: str) -> str:
    """The page as text."""
    title = f"{len(runs)} runs: {', '.join(sorted({data.task for data in runs.values()}))}"
    head = f"<header><h1>{escape(title)}</h1><pre><code>{escape(command)}</code></pre></header>"
    return pieces.document(title, [head, _results(runs), _failures(runs), _curves(runs), _differences(runs), _effort(runs)])


def _results(runs: Mapping[str, ReportData]) -> str:
    bars = ""
    for name, data in runs.items():
        for e in data.evaluations:
            label = f"{name}, {e.label}"
            bars += charts.rate_bar(label, e.successes, e.episodes, e.interval, "policy")
        if data.expert:
            x = data.expert
            bars += charts.rate_bar(f"{name}, expert", x.successes, x.episodes, x.interval, "expert")
    lead = "The thin mark on a bar is the 95 % interval; where two overlap widely, more episodes are needed to tell them apart."
    return pieces.section("result", "Result", f'<div class="card">{bars}</div>', lead) if bars else ""


def _failures(runs: Mapping[str, ReportData]) -> str:
    cards = ""
    for name, data in runs.items():
        for e in data.evaluations:
            if e.failures:
                failed = f"{e.episodes - e.successes} of {e.episodes} failed"
                cards += pieces.counts(f"{name}, {e.label}: {failed}", e.failures, "cause")
    return pieces.section("failures", "What went wrong", f'<div class="grid">{cards}</div>') if cards else ""


def _curves(runs: Mapping[str, ReportData]) -> str:
    cards = ""
    for panel in charts.PANELS:
        key = list(panel.curves.values())[-1]
        series = {name: [(line["step"], line[key]) for line in data.metrics if key in line] for name, data in runs.items()}
        if any(series.values()):
            cards += f'<div class="card"><h3>{escape(panel.title)}</h3>{charts.lines(panel, series)}</div>'
    return pieces.section("training", "Training", f'<div class="grid broad">{cards}</div>') if cards else ""


def _differences(runs: Mapping[str, ReportData]) -> str:
    """Settings and versions in which not all runs agree, a column a run."""
    settings: dict[str, dict[str, Any]] = {name: dict(pieces.flat({**data.config, **data.versions})) for name, data in runs.items()}
    keys = dict.fromkeys(key for values in settings.values() for key in values)
    rows = []
    for key in keys:
        values = [str(settings[name].get(key, "")) for name in runs]
        if len(set(values)) > 1:
            rows.append([key, *values])
    lead = "Settings and versions in which they do not all agree."
    return pieces.section("differences", "What was different", pieces.table(["setting", *runs], rows), lead) if rows else ""


def _effort(runs: Mapping[str, ReportData]) -> str:
    rows = []
    for name, data in runs.items():
        demonstrations = data.dataset.demonstrations if data.dataset else ""
        rows.append([name, demonstrations, duration(sum(data.seconds.values())) if data.seconds else "", data.command])
    return pieces.section("effort", "What it took", pieces.table(["run", "demonstrations", "time", "command"], rows))
