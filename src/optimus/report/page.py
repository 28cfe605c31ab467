"""The page itself: each section from its own part of the data."""

import base64
from collections.abc import Iterator, Mapping, Sequence
from html import escape
from importlib import resources
from pathlib import Path
from typing import Any

from optimus.data.atomic import write_whole
from optimus.errors import StorageError
from optimus.report import charts
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
    return page(data.title, parts)


def page(title: str, parts: Sequence[str]) -> str:
    """A page that needs nothing beside itself, of those parts; empty ones are left out."""
    style = (resources.files("optimus.report") / "style.css").read_text(encoding="utf-8")
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(title)}</title>\n<style>\n{style}</style>\n</head>\n<body>\n<main>\n"
        + "\n".join(part for part in parts if part)
        + "\n</main>\n</body>\n</html>\n"
    )


def _header(data: ReportData) -> str:
    description = f"<p>{escape(data.description)}</p>" if data.description else ""
    return (
        f"<header><h1>{escape(data.title)}</h1>{description}<p>{WHAT}</p>"
        f"<pre><code>{escape(data.command)}</code></pre></header>"
    )


def section(name: str, title: str, body: str, lead: str = "") -> str:
    """A part of the page under a heading, with a line of text before it."""
    lead = f"<p>{escape(lead)}</p>" if lead else ""
    return f'<section id="{name}"><h2>{escape(title)}</h2>{lead}{body}</section>'


def _result(expert: ExpertStats | None, evaluations: Sequence[EvaluationStats]) -> str:
    bars = []
    if expert:
        bars.append(charts.rate_bar("Expert (planner)", expert.successes, expert.episodes, expert.interval, "expert"))
    for e in evaluations:
        label = f"Policy, {e.states} states"
        bars.append(charts.rate_bar(label, e.successes, e.episodes, e.interval, "policy"))
    if not bars:
        return ""
    tables = []
    if expert and expert.failures:
        tables.append(counts_table("Failures of the expert", expert.failures, "reason"))
    grid = f'<div class="grid" style="margin-top:1rem">{"".join(tables)}</div>' if tables else ""
    return section("result", "Result", f'<div class="card">{"".join(bars)}</div>{grid}')


def _films(films: Sequence[Film]) -> str:
    lead = "Episodes of the evaluation. Time runs from left to right in the strips."
    shown = [film for film in films if film.success is not False]
    return section("films", "What it looks like", _moving(shown), lead) if shown else ""


def _moving(films: Sequence[Film], strips_at_most: int = 3) -> str:
    """Videos beside one another, strips below one another."""
    with_strip = [film for film in films if film.strip][:strips_at_most]
    videos = "".join(_figure(film, _video(film.video)) for film in films if film.video)
    strips = "".join(_figure(film, _picture(film.strip, film.caption)) for film in with_strip)
    return (f'<div class="grid films">{videos}</div>' if videos else "") + (
        f'<div class="card strips">{strips}</div>' if strips else ""
    )


def _failures(films: Sequence[Film], evaluations: Sequence[EvaluationStats]) -> str:
    """What went wrong, the most frequent first, each with films of it where there are some."""
    counts: dict[str, int] = {}
    for e in evaluations:
        for cause, count in e.failures.items():
            counts[cause] = counts.get(cause, 0) + count
    episodes = sum(e.episodes for e in evaluations)
    body = ""
    for cause, count in sorted(counts.items(), key=lambda item: -item[1]):
        of_it = [film for film in films if film.success is False and film.cause == cause]
        body += f'<h3 class="cause failure">{escape(cause)}: {count} of {episodes} episodes</h3>{_moving(of_it, strips_at_most=1)}'
    rest = [film for film in films if film.success is False and film.cause not in counts]
    if not body and not rest:
        return ""
    return section("failures", "What went wrong", body + _moving(rest), "Failures of the policy by their cause.")


def _figure(film: Film, inside: str) -> str:
    kind = "" if film.success is None else ' class="success"' if film.success else ' class="failure"'
    return f"<figure>{inside}<figcaption{kind}>{escape(film.caption)}</figcaption></figure>"


def _video(path: Path) -> str:
    source = _uri(path, "video/mp4")
    return f'<video controls muted loop playsinline preload="metadata" src="{source}"></video>'


def _picture(source: Path | bytes, caption: str) -> str:
    return f'<img alt="{escape(caption, quote=True)}" src="{_uri(source, "image/png")}">'


def _uri(source: Path | bytes, kind: str) -> str:
    try:
        content = source if isinstance(source, bytes) else source.read_bytes()
    except OSError as error:
        raise StorageError(f"cannot read {source}: {error.strerror or error}") from error
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"


def _training(metrics: Sequence[Mapping[str, float]]) -> str:
    cards = ""
    for panel in charts.PANELS:
        if picture := charts.curves(panel, metrics):
            cards += f'<div class="card"><h3>{escape(panel.title)}</h3>{picture}</div>'
    lead = "Held-out demonstrations took no part in training."
    return section("training", "Training", f'<div class="grid broad">{cards}</div>', lead) if cards else ""


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
        cards.append(counts_table("Plans", stats.per_skeleton, "sequence of skills"))
    cards.append(_curation(stats))
    body = _numbers(numbers) + f'<div class="grid">{"".join(cards)}</div>'
    return section("dataset", "Demonstrations", body, "What the policy learned from: episodes of the expert.")


def _curation(stats: DatasetStats) -> str:
    """What became of each demonstration: learned from, held out, or left out and why."""
    kept = {"learned from": stats.training, "held out for validation": stats.held_out}
    rows = [[what, count] for what, count in kept.items() if count is not None]
    rows += [[f"left out: {why}", count] for why, count in sorted(stats.dropped.items(), key=lambda item: -item[1])]
    if not rows:
        return ""
    return f'<div class="card"><h3>Curation</h3>{table(["demonstrations", "number"], rows, number=1)}</div>'


def _starts(starts: Sequence[Starts]) -> str:
    cards = "".join(f'<div class="card"><h3>{escape(s.thing)}</h3>{picture}</div>' for s in starts if (picture := coverage(s)))
    lead = "Where things stood at first, from above. Dots: learned from; rings: held out; crosses: where the policy failed."
    return section("starts", "Coverage of starts", f'<div class="grid">{cards}</div>', lead) if cards else ""


def _expert(stats: ExpertStats | None) -> str:
    if stats is None:
        return ""
    numbers = {"Episodes": f"{stats.episodes:,}", "Solved": f"{stats.successes:,}"}
    if stats.paper_rule_successes is not None:
        numbers["By the paper's rule"] = f"{stats.paper_rule_successes:,}"
    for key, value in stats.plan_seconds.items():
        numbers[f"Planning, {key}"] = f"{1000 * value:.0f} ms" if value < 1 else f"{value:.2f} s"
    return section("expert", "Expert", _numbers(numbers), "Planning is CPU time an episode.")


def _time(seconds: Mapping[str, float]) -> str:
    total = sum(seconds.values())
    if total <= 0:
        return ""
    parts = "".join(f'<i style="flex:{s / total:.4f}" title="{escape(n, quote=True)}"></i>' for n, s in seconds.items())
    rows = {**{name: duration(s) for name, s in seconds.items()}, "together": duration(total)}
    rows_shown = table(["stage", "time"], [[name, value] for name, value in rows.items()], number=1)
    return section("time", "Time", f'<div class="card"><div class="stack">{parts}</div>{rows_shown}</div>')


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
            rows_shown = table(columns, [[row.get(column, "") for column in columns] for row in e.rows])
            summary = f"<summary>{e.episodes} episodes, {escape(e.states)} states</summary>"
            body += f"<details>{summary}{rows_shown}</details>"
    return section("episodes", "Every episode", body) if body else ""


def _settings(data: ReportData) -> str:
    cards = ""
    for title, values in (("Configuration", data.config), ("Versions", data.versions)):
        if values:
            cards += f'<div class="card"><h3>{title}</h3>{table([], list(flat(values)))}</div>'
    lines = "".join(f"<pre><code>{escape(line)}</code></pre>" for line in data.commands)
    grid = f'{lines}<div class="grid">{cards}</div>'
    return section("settings", "To repeat it", grid, f"Task: {data.task}") if cards or lines else ""


def flat(values: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Nested settings one a line, with dotted names."""
    for key, value in values.items():
        if isinstance(value, Mapping) and value:
            yield from flat(value, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key}", value


def _numbers(values: Mapping[str, str]) -> str:
    cells = "".join(f"<div><dt>{escape(k)}</dt><dd>{escape(v)}</dd></div>" for k, v in values.items())
    return f'<dl class="numbers">{cells}</dl>'


def counts_table(title: str, counts: Mapping[str, int], what: str) -> str:
    """A table of counts, the greatest first."""
    ordered = sorted(counts.items(), key=lambda item: -item[1])
    rows_shown = table([what, "episodes"], [[name, count] for name, count in ordered], number=1)
    return f'<div class="card"><h3>{escape(title)}</h3>{rows_shown}</div>'


def table(columns: Sequence[str], rows: Sequence[Sequence[Any]], number: int | None = None) -> str:
    """A table; the column of that index holds numbers."""

    def line(cells: Sequence[Any], tag: str) -> str:
        kinds = [' class="number"' if i == number else "" for i in range(len(cells))]
        pairs = zip(kinds, cells, strict=True)
        return f"<tr>{''.join(f'<{tag}{kind}>{escape(str(cell))}</{tag}>' for kind, cell in pairs)}</tr>"

    head = f"<thead>{line(columns, 'th')}</thead>" if columns else ""
    body = "".join(line(row, "td") for row in rows)
    return f'<div class="wide"><table>{head}<tbody>{body}</tbody></table></div>'
