"""The page itself: each section from its own part of the data."""

from collections.abc import Mapping, Sequence
from html import escape
from pathlib import Path

from optimus.data.atomic import write_whole
from optimus.report import charts, pieces
from optimus.report.data import DatasetStats, EvaluationStats, ExpertStats, Film, ReportData

WHAT = (
    "A planner that knows the task solved it again and again in simulation; a neural network then learned to"
    " do the same from camera images alone. No person demonstrated anything. The bars show how often each of"
    " them succeeds; the thin mark on a bar is the 95 % interval that the number of episodes allows."
)


def write_report(data: ReportData, path: Path) -> None:
    """Write the page, whole or not at all. `StorageError` when a file cannot be read or written."""
    write_whole(path, render(data).encode())


def render(data: ReportData) -> str:
    """The page as text."""
    parts = [
        _header(data),
        _result(data.expert, data.evaluations),
        _films(data.films),
        _training(data.metrics),
        _dataset(data.dataset),
        _expert(data.expert),
        _time(data.seconds),
        _episodes(data.evaluations),
        _settings(data),
    ]
    return pieces.document(data.title, parts)


def _header(data: ReportData) -> str:
    description = f"<p>{escape(data.description)}</p>" if data.description else ""
    return (
        f"<header><h1>{escape(data.title)}</h1>{description}<p>{WHAT}</p>"
        f"<pre><code>{escape(data.command)}</code></pre></header>"
    )


def _result(expert: ExpertStats | None, evaluations: Sequence[EvaluationStats]) -> str:
    bars = []
    if expert:
        bars.append(charts.rate_bar("Expert (planner)", expert.successes, expert.episodes, expert.interval, "expert"))
    for e in evaluations:
        label = f"Policy, {e.states} states"
        bars.append(charts.rate_bar(label, e.successes, e.episodes, e.interval, "policy"))
    if not bars:
        return ""
    tables = [
        pieces.counts(f"Failures of the policy, {e.states} states", e.failures, "cause") for e in evaluations if e.failures
    ]
    if expert and expert.failures:
        tables.append(pieces.counts("Failures of the expert", expert.failures, "reason"))
    grid = f'<div class="grid" style="margin-top:1rem">{"".join(tables)}</div>' if tables else ""
    return pieces.section("result", "Result", f'<div class="card">{"".join(bars)}</div>{grid}')


def _films(films: Sequence[Film]) -> str:
    videos = "".join(pieces.figure(film, pieces.video(film.video)) for film in films if film.video)
    strips = "".join(pieces.figure(film, pieces.picture(film.strip, film.caption)) for film in films if film.strip)
    body = (f'<div class="grid">{videos}</div>' if videos else "") + (
        f'<div class="card" style="margin-top:1rem">{strips}</div>' if strips else ""
    )
    lead = "Episodes of the evaluation. Time runs from left to right in the strips."
    return pieces.section("films", "What it looks like", body, lead) if body else ""


def _training(metrics: Sequence[Mapping[str, float]]) -> str:
    cards = ""
    for panel in charts.PANELS:
        if picture := charts.curves(panel, metrics):
            cards += f'<div class="card"><h3>{escape(panel.title)}</h3>{picture}</div>'
    lead = "Held-out demonstrations took no part in training."
    return pieces.section("training", "Training", f'<div class="grid broad">{cards}</div>', lead) if cards else ""


def _dataset(stats: DatasetStats | None) -> str:
    if stats is None:
        return ""
    numbers = {"Demonstrations": f"{stats.demonstrations:,}", "Steps": f"{stats.steps:,}"}
    if stats.lengths:
        numbers["Median length"] = f"{sorted(stats.lengths)[len(stats.lengths) // 2]} steps"
    numbers["Dropped"] = f"{sum(stats.dropped.values()):,}"
    cards = []
    if stats.lengths:
        cards.append(f'<div class="card"><h3>Lengths [steps]</h3>{charts.histogram(stats.lengths)}</div>')
    if stats.per_skeleton:
        cards.append(pieces.counts("Plans", stats.per_skeleton, "sequence of skills"))
    if stats.dropped:
        cards.append(pieces.counts("Dropped", stats.dropped, "reason"))
    body = pieces.numbers(numbers) + f'<div class="grid">{"".join(cards)}</div>'
    return pieces.section("dataset", "Demonstrations", body, "What the policy learned from: episodes of the expert.")


def _expert(stats: ExpertStats | None) -> str:
    if stats is None:
        return ""
    numbers = {"Episodes": f"{stats.episodes:,}", "Solved": f"{stats.successes:,}"}
    if stats.paper_rule_successes is not None:
        numbers["By the paper's rule"] = f"{stats.paper_rule_successes:,}"
    for key, value in stats.plan_seconds.items():
        numbers[f"Planning, {key}"] = f"{1000 * value:.0f} ms" if value < 1 else f"{value:.2f} s"
    return pieces.section("expert", "Expert", pieces.numbers(numbers), "Planning is CPU time an episode.")


def _time(seconds: Mapping[str, float]) -> str:
    total = sum(seconds.values())
    if total <= 0:
        return ""
    parts = "".join(f'<i style="flex:{s / total:.4f}" title="{escape(n, quote=True)}"></i>' for n, s in seconds.items())
    rows = {**{name: duration(s) for name, s in seconds.items()}, "together": duration(total)}
    table = pieces.table(["stage", "time"], [[name, value] for name, value in rows.items()], number=1)
    return pieces.section("time", "Time", f'<div class="card"><div class="stack">{parts}</div>{table}</div>')


def duration(seconds: float) -> str:
    """Seconds as people say them."""
    if seconds < 60:
        return f"{seconds:.1f} s"
    minutes, rest = divmod(round(seconds), 60)
    return f"{minutes} min {rest:02d} s" if minutes < 60 else f"{minutes // 60} h {minutes % 60:02d} min"


def _episodes(evaluations: Sequence[EvaluationStats]) -> str:
    body = ""
    for e in evaluations:
        if e.rows:
            columns = list(e.rows[0])
            table = pieces.table(columns, [[row.get(column, "") for column in columns] for row in e.rows])
            summary = f"<summary>{e.episodes} episodes, {escape(e.states)} states</summary>"
            body += f"<details>{summary}{table}</details>"
    return pieces.section("episodes", "Every episode", body) if body else ""


def _settings(data: ReportData) -> str:
    cards = ""
    for title, values in (("Configuration", data.config), ("Versions", data.versions)):
        if values:
            cards += f'<div class="card"><h3>{title}</h3>{pieces.table([], list(pieces.flat(values)))}</div>'
    grid = f'<div class="grid">{cards}</div>'
    return pieces.section("settings", "To repeat it", grid, f"Task: {data.task}") if cards else ""
