"""The page itself: each section from its own part of the data."""

from collections.abc import Mapping, Sequence
from html import escape
from pathlib import Path

from optimus.data.atomic import write_whole
from optimus.report import charts, pieces
from optimus.report.coverage import coverage
from optimus.report.data import DatasetStats, EvaluationStats, ExpertStats, Film, ReportData, Starts

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
        _failures(data.films, data.evaluations),
        _training(data.metrics),
        _dataset(data.dataset),
        _starts(data.starts),
        _expert(data.expert),
        _time(data.seconds),
        _episodes(data.evaluations),
        _settings(data),
    ]
    return pieces.document(data.title, parts)


def _header(data: ReportData) -> str:
    description = f"<p>{escape(data.description)}</p>" if data.description else ""
    return f"<header><h1>{escape(data.title)}</h1>{description}<p>{WHAT}</p><pre><code>{escape(data.command)}</code></pre></header>"


def _result(expert: ExpertStats | None, evaluations: Sequence[EvaluationStats]) -> str:
    bars = []
    if expert:
        bars.append(charts.rate_bar("Expert (planner)", expert.successes, expert.episodes, expert.interval, "expert"))
    for e in evaluations:
        label = f"Policy, {e.label}"
        bars.append(charts.rate_bar(label, e.successes, e.episodes, e.interval, "policy"))
    if not bars:
        return ""
    tables = []
    if expert and expert.failures:
        tables.append(pieces.counts("Failures of the expert", expert.failures, "reason"))
    grid = f'<div class="grid" style="margin-top:1rem">{"".join(tables)}</div>' if tables else ""
    return pieces.section("result", "Result", f'<div class="card">{"".join(bars)}</div>{grid}')


def _films(films: Sequence[Film]) -> str:
    lead = "Episodes of the evaluation. Time runs from left to right in the strips."
    shown = [film for film in films if film.success is not False]
    return pieces.section("films", "What it looks like", _moving(shown), lead) if shown else ""


def _moving(films: Sequence[Film], strips_at_most: int = 3) -> str:
    """Videos beside one another, strips below one another."""
    with_strip = [(film, film.strip) for film in films if film.strip][:strips_at_most]
    videos = "".join(pieces.figure(film, pieces.video(film.video)) for film in films if film.video)
    strips = "".join(pieces.figure(film, pieces.picture(strip, film.caption)) for film, strip in with_strip)
    return (f'<div class="grid films">{videos}</div>' if videos else "") + (
        f'<div class="card strips">{strips}</div>' if strips else ""
    )


def _failures(films: Sequence[Film], evaluations: Sequence[EvaluationStats]) -> str:
    """What went wrong, each evaluation by itself, the most frequent first, each with films of it where there are some."""
    body, rest = "", [film for film in films if film.success is False]
    for e in evaluations:
        where = f"; {e.label}" if len(evaluations) > 1 else ""
        for cause, count in sorted(e.failures.items(), key=lambda item: -item[1]):
            of_it = [film for film in rest if film.cause == cause and film.evaluation in ("", e.label)]
            rest = [film for film in rest if film not in of_it]
            title = f"{escape(cause)}: {count} of {e.episodes} episodes{escape(where)}"
            body += f'<h3 class="cause failure">{title}</h3>{_moving(of_it, strips_at_most=1)}'
    if not body and not rest:
        return ""
    return pieces.section("failures", "What went wrong", body + _moving(rest), "Failures of the policy by their cause.")


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
    cards.append(_curation(stats))
    body = pieces.numbers(numbers) + f'<div class="grid">{"".join(cards)}</div>'
    return pieces.section("dataset", "Demonstrations", body, "What the policy learned from: episodes of the expert.")


def _curation(stats: DatasetStats) -> str:
    """What became of each demonstration: learned from, held out, or left out and why."""
    kept = {"learned from": stats.training, "held out for validation": stats.held_out}
    rows = [[what, count] for what, count in kept.items() if count is not None]
    rows += [[f"left out: {why}", count] for why, count in sorted(stats.dropped.items(), key=lambda item: -item[1])]
    if not rows:
        return ""
    return f'<div class="card"><h3>Curation</h3>{pieces.table(["demonstrations", "number"], rows, number=1)}</div>'


def _starts(starts: Sequence[Starts]) -> str:
    cards = "".join(f'<div class="card"><h3>{escape(s.thing)}</h3>{picture}</div>' for s in starts if (picture := coverage(s)))
    lead = "Where things stood at first, from above. Dots: learned from; rings: held out; crosses: where the policy failed."
    return pieces.section("starts", "Coverage of starts", f'<div class="grid">{cards}</div>', lead) if cards else ""


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
    rows_shown = pieces.table(["stage", "time"], [[name, value] for name, value in rows.items()], number=1)
    return pieces.section("time", "Time", f'<div class="card"><div class="stack">{parts}</div>{rows_shown}</div>')


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
            rows_shown = pieces.table(columns, [[row.get(column, "") for column in columns] for row in e.rows])
            summary = f"<summary>{e.episodes} episodes, {escape(e.label)}</summary>"
            body += f"<details>{summary}{rows_shown}</details>"
    return pieces.section("episodes", "Every episode", body) if body else ""


def _settings(data: ReportData) -> str:
    cards = ""
    for title, values in (("Configuration", data.config), ("Versions", data.versions)):
        if values:
            cards += f'<div class="card"><h3>{title}</h3>{pieces.table([], list(pieces.flat(values)))}</div>'
    lines = "".join(f"<pre><code>{escape(line)}</code></pre>" for line in data.commands)
    grid = f'{lines}<div class="grid">{cards}</div>'
    return pieces.section("settings", "To repeat it", grid, f"Task: {data.task}") if cards or lines else ""
