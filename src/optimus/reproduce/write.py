"""A table's results as Markdown, CSV and a plot, the paper's figures beside ours."""

from __future__ import annotations

import csv
import io
import shlex
import textwrap
from pathlib import Path
from typing import Any

from optimus.data.atomic import write_whole
from optimus.reproduce.budget import Budget

OURS, PAPERS = "#2f6fb0", "#c2453a"


def write_table(out: Path, found: dict[str, Any]) -> None:
    """`table.md`, `table.csv`, `plot.png` in `out`, of what `results.json` says."""
    write_whole(out / "table.md", markdown(found).encode())
    write_whole(out / "table.csv", as_csv(found).encode())
    write_whole(out / "plot.png", plot(found))


def said(measured: dict[str, Any] | None) -> str:
    """`45 of 50 (79 to 96 %)`, or `12.3 ms`; a dash where nothing was measured."""
    if measured is None:
        return "-"
    if "seconds" in measured:
        return f"{1e3 * measured['seconds']:.3g} ms"
    low, high = (100 * end for end in measured["interval"])
    return f"{measured['successes']} of {measured['episodes']} ({low:.0f} to {high:.0f} %)"


def of_paper(value: float | None, timed: bool) -> str:
    """The paper's figure."""
    if value is None:
        return ""
    return f"{1e3 * value:.3g} ms" if timed else f"{value:g} %"


def lines(found: dict[str, Any]) -> list[tuple[dict[str, Any], str, dict[str, Any]]]:
    """Every measurement: its cell, its name, itself."""
    return [(cell, name, m) for cell in found["cells"] for name, m in cell["measured"].items()]


def markdown(found: dict[str, Any]) -> str:
    """The table, then every measurement by itself, then how it was made."""
    columns = list(dict.fromkeys(c["column"] for c in found["cells"]))
    rows = list(dict.fromkeys(c["row"] for c in found["cells"]))
    cells = {(c["row"], c["column"]): c for c in found["cells"]}
    text = [f"# {found['title']}", "", _about(found), "", "| | " + " | ".join(f"{c} | paper" for c in columns) + " |"]
    text.append("|---" * (2 * len(columns) + 1) + "|")
    for row in rows:
        parts = []
        for column in columns:
            cell = cells.get((row, column), {"measured": {}, "paper": None})
            main = cell["measured"].get("")
            parts += [said(main), of_paper(cell["paper"], main is not None and "seconds" in main)]
        text.append(f"| {row} | " + " | ".join(parts) + " |")
    text += ["", f"![{found['title']}](plot.png)"]
    shown = ("row", "column", "tried on", "ours", "by the paper's rule", "distinct states", "hours", "commit", "processor")
    text += ["", "## Every measurement", "", f"| {' | '.join(shown)} |", "|---" * len(shown) + "|"]
    for cell, name, m in lines(found):
        usual = "seeds from 7000 on" if "episodes" in m and "successes" in m else ""
        usual = f"{m.get('states', 'validation')} states" if "by_seed" in m else usual
        counted = [str(m.get(k, "")) for k in ("paper_rule_successes", "distinct_states")]
        machine = cell["machine"]
        spent = [f"{cell['hours']:.2f}", cell["commit"] or "", ", ".join(filter(None, (machine["processor"], machine["gpu"])))]
        spent = spent if name == next(iter(cell["measured"])) else [""] * len(spent)
        shown = [cell["row"], cell["column"], name or usual, said(m), *counted, *spent]
        text.append(f"| {' | '.join(shown)} |")
    steps = dict.fromkeys(command for cell, _, _ in lines(found) for command in cell["commands"])
    text += ["", "## Commands", "", "```text", *commands_of(found), "```", "", "By itself, in that folder:", ""]
    return "\n".join([*text, "```text", *steps, "```", ""])


def commands_of(found: dict[str, Any], column: str | None = None) -> list[str]:
    """What filled the cells that are filled, or those of one column; of a page that was put together from a campaign, as it says
    itself."""
    if "filled_by" in found:
        return [found["filled_by"]]
    if found["complete"] and column is None:
        return [found["command"]]
    filled: dict[str, tuple[str, ...]] = {}
    for cell in found["cells"]:
        if column in (None, cell["column"]):
            filled[cell["row"]] = (*filled.get(cell["row"], ()), cell["column"])
    names = [f"{c['row']} {c['column']}" for c in found["cells"]] + found["missing"]
    alike: dict[str, list[str]] = {}
    for row, columns in filled.items():
        # columns are named only where others of the row were left out
        whole = all(n.endswith(tuple(f" {c}" for c in columns)) for n in names if n.startswith(f"{row} "))
        alike.setdefault("" if whole else f" --columns {shlex.join(columns)}", []).append(row)
    return [f"{found['command']} --rows {shlex.join(rows)}{columns}" for columns, rows in alike.items()]


def _about(found: dict[str, Any]) -> str:
    """With how much of what it was made, as far as it matters to what was measured."""
    versions = ", ".join(f"{k} {v}" for k, v in found["versions"].items())
    timed = any("seconds" in m for _, _, m in lines(found))
    budget = Budget(**found["asked"]["budget"])
    parts = [
        *(_of_times(budget) if timed else _of_trials(budget, found["asked"]["seed"])),
        f"{'; '.join(dict.fromkeys(_said_of(cell['machine']) for cell in found['cells']))}. {versions}.",
        f"{found['hours']:.2f} hours, that of other work on the machine included.",
    ]
    return " ".join(parts) + ("" if found["complete"] else f" **Not finished; missing: {'; '.join(found['missing'])}.**")


def _said_of(machine: dict[str, Any]) -> str:
    return f"{machine['processor']}, {machine['cores']} cores, GPU: {machine['gpu'] or 'none'}"


def _of_times(budget: Budget) -> list[str]:
    return [
        f"Budget `{budget.name}`: CPU time on one core, {budget.timing_episodes} problems a task, "
        f"{10 * budget.timing_rounds} actions a network (median).",
        "TAMP plans once and follows its plan, told the state; a network has two 84 x 84 images, whose rendering is not counted.",
    ]


def _of_trials(budget: Budget, seed: int) -> list[str]:
    unit, long = budget.how_long
    parts = [
        f"Budget `{budget.name}`: {budget.demonstrations} demonstrations a dataset, {long:.9g} {unit} of training, "
        f"{budget.episodes} trials a policy and condition, {budget.seeds} training seed(s) from {seed} on.",
        "Strict success; k of n with the Wilson 95 % interval.",
    ]
    if budget.seeds > 1:
        parts.append("Intervals are those of these policies: another training seed's may lie outside.")
    if budget.horizon is not None:
        parts.append(f"Policies' trials end after {budget.horizon} steps: this proves the path and says nothing of success.")
    return parts


def as_csv(found: dict[str, Any]) -> str:
    """A line a measurement."""
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    names = ("successes", "episodes", "paper_rule_successes", "distinct_states", "seconds")
    rows.writerow(["row", "column", "tried_on", *names[:2], "low", "high", *names[2:], "paper", "hours"])
    for cell, name, m in lines(found):
        low, high = m.get("interval", ("", ""))
        numbers = [m.get(k, "") for k in names]
        paper = cell["paper"] if name == "" and cell["paper"] is not None else ""
        rows.writerow([cell["row"], cell["column"], name, *numbers[:2], low, high, *numbers[2:], paper, f"{cell['hours']:.4f}"])
    return text.getvalue()


def plot(found: dict[str, Any]) -> bytes:
    """A PNG: a bar a cell with its interval, and a mark where the paper's figure is."""
    from matplotlib.figure import Figure  # heavy, and needed here alone

    bars = [(c, c["measured"][""]) for c in found["cells"] if "" in c["measured"]]
    timed = bool(bars) and "seconds" in bars[0][1]
    scale = 1e3 if timed else 100.0
    figure = Figure(figsize=(9.0, 1.2 + 0.3 * max(1, len(bars))), layout="constrained")
    axes = figure.add_subplot()
    labels = []
    for i, (cell, m) in enumerate(bars):
        value = m["seconds"] if timed else m["successes"] / max(1, m["episodes"])
        axes.barh(i, scale * value, color=OURS, height=0.7)
        if not timed:
            low, high = m["interval"]
            axes.plot((scale * low, scale * high), (i, i), color="black", linewidth=1.2)
        if cell["paper"] is not None:
            axes.plot(cell["paper"] * (scale if timed else 1.0), i, marker="D", color=PAPERS, markersize=5)
        labels.append(textwrap.fill(f"{cell['row']}: {cell['column']}", 45))
    axes.set_yticks(range(len(labels)), labels, fontsize=8)
    axes.invert_yaxis()
    axes.set_xlabel("CPU time per action [ms]" if timed else "strict success [%], Wilson 95 % interval")
    axes.set_title(f"{found['title']} (diamonds: the paper)", fontsize=10)
    if timed:
        axes.set_xscale("log")
    else:
        axes.set_xlim(0, 100)
    image = io.BytesIO()
    figure.savefig(image, format="png", dpi=110, metadata={"Software": None})
    return image.getvalue()
