"""What the verbs say: the answer on standard output, progress on standard error."""

from __future__ import annotations

import json as jsonlib
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from tqdm import tqdm


def say(result: dict[str, Any], json: bool, text: str) -> None:
    """The verb's answer, last on standard output: one JSON object, or a few words."""
    sys.stdout.write((jsonlib.dumps(result) if json else text) + "\n")


def rate(report: dict[str, Any]) -> str:
    """`45 of 50 (79 to 96 %)`, and over how few initial states where some came twice."""
    low, high = report["interval"]
    few = report["distinct_states"] < report["episodes"]
    repeated = f", from {report['distinct_states']} distinct initial states" if few else ""
    return f"{report['successes']} of {report['episodes']} ({100 * low:.0f} to {100 * high:.0f} %{repeated})"


def _new_bar(total: int | None, what: str, unit: str) -> Any:
    return tqdm(total=total, desc=what, unit=unit, file=sys.stderr, dynamic_ncols=True, mininterval=0.5)


@contextmanager
def bar(total: int | None, what: str, unit: str) -> Iterator[Any]:
    """A progress bar."""
    with _new_bar(total, what, unit) as made:
        yield made


def counter(bar: Any) -> Callable[[int, int], None]:
    """Shows `(done, successes)` on a bar."""

    def progress(done: int, successes: int) -> None:
        if done != successes:
            bar.set_postfix(successes=successes)
        bar.n = done
        bar.refresh()

    return progress


class StageBars:
    """One bar a stage of the main job, the last one's left standing."""

    def __init__(self) -> None:
        self._stage, self._bar = "", None

    def __call__(self, stage: str, done: int, total: int, note: dict[str, str]) -> None:
        """`note` stands behind the bar: what else there is to know of the stage."""
        if stage != self._stage or self._bar is None:
            self.close()
            self._stage, self._bar = stage, _new_bar(total, stage, "it")
        self._bar.total, self._bar.n = total, done
        if note:
            self._bar.set_postfix(note, refresh=False)
        self._bar.update(0)
        if done == total:
            self._bar.refresh()

    def close(self) -> None:
        """Finish the bar that is open."""
        if self._bar is not None:
            self._bar.close()
