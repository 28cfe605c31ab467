"""What the verbs say: the answer on standard output, progress on standard error."""

from __future__ import annotations

import json as jsonlib
import os
import sys
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from tqdm import tqdm

QUIET = "OPTIMUS_QUIET"
"""The environment variable that stands for `--quiet`: no progress bars."""


def say(result: dict[str, Any], json: bool, text: str) -> None:
    """The verb's answer, last on standard output: one JSON object, or a few words."""
    sys.stdout.write((jsonlib.dumps(result) if json else text) + "\n")
    sys.stdout.flush()


def rate(report: dict[str, Any]) -> str:
    """`45 of 50 (79 to 96 %)`, and over how few initial states where some came twice."""
    low, high = report["interval"]
    states = report.get("distinct_states", report["episodes"])
    repeated = f", from {states} distinct initial states" if states < report["episodes"] else ""
    return f"{report['successes']} of {report['episodes']} ({100 * low:.0f} to {100 * high:.0f} %{repeated})"


def counts(of: Mapping[str, int]) -> str:
    """`12 never grasped, 3 dropped`, the commonest first; `none`."""
    return ", ".join(f"{n} {what}" for what, n in sorted(of.items(), key=lambda item: -item[1])) or "none"


def table(result: dict[str, Any]) -> str:
    """A measurement for people: a line a quantity; parts, branches and single episodes indented below what they belong to."""
    if "interval" in result:
        result = {**result, "successes": rate(result)}
        del result["interval"], result["episodes"]
    lines = []
    for key, value in result.items():
        rows = _rows(value)
        lines.append(f"{key:<24} {'' if rows else _text(value)}".rstrip())
        lines += [f"  {name:<22} {_text(part)}" for name, part in rows.items()]
    return "\n".join(lines)


def _rows(value: Any) -> dict[str, Any]:
    """What stands below its own heading, line by line: parts that have parts, and lists of episodes."""
    if isinstance(value, list):
        if not all(isinstance(row, dict) for row in value):
            return {}
        return {f"seed {row['seed']}": {k: v for k, v in row.items() if k != "seed"} for row in value}
    nested = isinstance(value, dict) and any(isinstance(part, dict) for part in value.values())
    return dict(value) if nested else {}


def _text(value: Any) -> str:
    if isinstance(value, dict) and "interval" in value:
        rest = {k: v for k, v in value.items() if k not in ("successes", "episodes", "interval")}
        return ", ".join([rate(value), *(f"{k} {_text(v)}" for k, v in rest.items())])
    if isinstance(value, dict):
        return ", ".join(f"{k} {_text(v)}" for k, v in value.items() if v != "") or "none"
    if isinstance(value, list):
        return "; ".join(map(_text, value)) or "none"
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def _new_bar(total: int | None, what: str, unit: str, silent: bool = False) -> Any:
    quiet = silent or QUIET in os.environ
    return tqdm(total=total, desc=what, unit=unit, file=sys.stderr, dynamic_ncols=True, mininterval=0.5, disable=quiet)


@contextmanager
def bar(total: int | None, what: str, unit: str, silent: bool = False) -> Iterator[Any]:
    """A progress bar; none if it is to be silent."""
    with _new_bar(total, what, unit, silent) as made:
        yield made


def counter(bar: Any) -> Callable[[int, int], None]:
    """Shows `(done, successes)` on a bar."""

    def progress(done: int, successes: int) -> None:
        if done != successes:
            bar.set_postfix(refresh=False, successes=successes)
        bar.n = done
        bar.refresh()

    return progress


def counted(bar: Any) -> Callable[[int, int], None]:
    """Shows `(done, of how many)` on a bar."""

    def progress(done: int, of: int) -> None:
        bar.total, bar.n = of, done
        bar.update(0)

    return progress


class StageBars:
    """One bar a stage of the main job, the last one's left standing; with `several`, stages may go on at once, in threads."""

    def __init__(self, several: bool = False) -> None:
        self._several, self._lock = several, threading.Lock()
        self._bars: dict[str, Any] = {}

    def __call__(self, stage: str, done: int, total: int, note: dict[str, str]) -> None:
        """`note` stands behind the bar: what else there is to know of the stage."""
        with self._lock:
            if stage not in self._bars:
                if not self._several:
                    self._close()
                self._bars[stage] = _new_bar(total, stage, "it")
            bar = self._bars[stage]
            bar.total, bar.n = total, done
            if note:
                bar.set_postfix(note, refresh=False)
            bar.update(0)
            if done == total:
                bar.refresh()
                if self._several:
                    self._bars.pop(stage).close()

    def close(self) -> None:
        """Finish the bars that are open."""
        with self._lock:
            self._close()

    def _close(self) -> None:
        while self._bars:
            self._bars.popitem()[1].close()
