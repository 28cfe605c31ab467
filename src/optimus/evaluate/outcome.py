"""What an episode came to, and what all of them together."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from optimus.conditions import USUAL, Conditions
from optimus.data.atomic import write_json, write_whole
from optimus.statistics import wilson
from optimus.words import slug

if TYPE_CHECKING:
    from optimus.learn.heads import Component

UNFINISHED = ".unfinished"
"""Ending of the file that an evaluation keeps beside its report to be, see `evaluate.unfinished`."""


@dataclass(frozen=True)
class Outcome:
    """One evaluated episode."""

    seed: int
    success: bool
    paper_success: bool
    steps: int
    cause: str
    variant: str
    draws: int = 0
    """Seed of the policy's own draws."""
    mishap_at: int | None = None
    """Step at which what `Conditions.perturb` asks for happened; None if it did not."""


def states_label(states: str, task: str | None = None, objects: str | None = None) -> str:
    """What initial states were played: `states`, and of which task and with which objects where that was asked for."""
    return "-".join(filter(None, [states, slug(task or ""), "" if objects is None else slug(objects) or "own"]))


def how_said(conditions: Conditions, component: str, seed: int) -> str:
    """Under what conditions and with which draws episodes were played; empty for the usual ones."""
    return "+".join(filter(None, [conditions.said, component if component != "sampled" else "", f"seed-{seed}" if seed else ""]))


@dataclass(frozen=True)
class EvalReport:
    """What an evaluation found, in the order of its initial states."""

    task: str
    states: str
    outcomes: tuple[Outcome, ...]
    conditions: Conditions = USUAL
    component: Component = "sampled"
    seed: int = 0
    """Of the policy's draws, and of random states."""
    weights: str = ""
    """Of the policy (`checkpoint.weights_of`)."""
    compiled: bool = False

    @property
    def question(self) -> dict[str, Any]:
        """What was asked, of which weights, JSON-able."""
        return {
            "task": self.task,
            "states": self.states,
            "conditions": asdict(self.conditions),
            "component": self.component,
            "seed": self.seed,
            "weights": self.weights,
            "compiled": self.compiled,
        }

    def answered(self, run: Path, seeds: Sequence[int]) -> dict[str, Any] | None:
        """The report in that run's folder that answers the same question with episodes from these seeds, if there is one."""
        there = self._known(run)
        return there if there and [o["seed"] for o in there["outcomes"]] == list(seeds) else None

    def _known(self, run: Path) -> dict[str, Any] | None:
        """The report in that run's folder that answers the same question, with episodes from whatever seeds."""
        try:
            there = json.loads((run / self.file_name).read_text())
            same = {key: there.get(key) for key in self.question} == self.question
            return there if same and all("seed" in o for o in there["outcomes"]) else None
        except (OSError, ValueError, KeyError, AttributeError, TypeError):  # none, or a damaged one
            return None

    @property
    def successes(self) -> int:
        return sum(o.success for o in self.outcomes)

    @property
    def episodes(self) -> int:
        return len(self.outcomes)

    def as_dict(self) -> dict[str, Any]:
        """JSON-able: counts, the Wilson 95 % interval, failures by cause, every outcome."""
        return {
            **self.question,
            "successes": self.successes,
            "episodes": self.episodes,
            "distinct_states": len({o.seed for o in self.outcomes}),
            "interval": list(wilson(self.successes, self.episodes)),
            "paper_rule_successes": sum(o.paper_success for o in self.outcomes),
            "failures": dict(Counter(o.cause for o in self.outcomes if not o.success)),
            "mishaps": sum(o.mishap_at is not None for o in self.outcomes),
            "outcomes": [asdict(o) for o in self.outcomes],
        }

    @property
    def lines(self) -> str:
        """The outcomes as JSON lines, one an episode, in the order of the initial states: the same text whoever played them."""
        return _lines([asdict(o) for o in self.outcomes])

    @property
    def file_name(self) -> str:
        """Of the report in a run's folder."""
        said = how_said(self.conditions, self.component, self.seed)
        return "+".join(filter(None, [f"evaluation-{self.states}", said])) + ".json"

    def write(self, run: Path) -> None:
        """`RUN/evaluation-<states>[+<conditions>][+<component>][+seed-<n>].json` with everything, the outcomes beside it as
        `.jsonl`. One of the same question that has these outcomes and more stays as it is."""
        path, known = run / self.file_name, self._known(run)
        mine = self.as_dict()["outcomes"]
        if known is None or known["outcomes"][: len(mine)] != mine:
            known = self.as_dict()
            write_json(path, known)
        write_whole(path.with_suffix(".jsonl"), _lines(known["outcomes"]).encode())
        path.with_suffix(UNFINISHED).unlink(missing_ok=True)


def _lines(outcomes: list[dict[str, Any]]) -> str:
    return "".join(json.dumps(outcome) + "\n" for outcome in outcomes)
