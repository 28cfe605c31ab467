"""What a report is made of. Plain data: a part that was not measured is left out, and so is its section."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

Interval = tuple[float, float]
"""Lower and upper end of a 95 % interval of a proportion, in 0 to 1."""


@dataclass(frozen=True)
class ExpertStats:
    """How the planner did on the episodes it was given."""

    episodes: int
    successes: int
    paper_rule_successes: int | None = None
    interval: Interval | None = None
    plan_seconds: Mapping[str, float] = field(default_factory=dict)  # median, p95, max: CPU time [s]
    failures: Mapping[str, int] = field(default_factory=dict)  # by reason


@dataclass(frozen=True)
class DatasetStats:
    """The demonstrations that the policy learned from."""

    demonstrations: int
    steps: int
    lengths: Sequence[int] = ()  # steps of each demonstration
    per_skeleton: Mapping[str, int] = field(default_factory=dict)
    dropped: Mapping[str, int] = field(default_factory=dict)  # by reason
    training: int | None = None  # demonstrations learned from
    held_out: int | None = None  # for validation


@dataclass(frozen=True)
class EvaluationStats:
    """How the policy did, from one list of initial states and under the same conditions."""

    successes: int
    episodes: int
    interval: Interval
    states: str = "validation"
    conditions: str = ""  # as in the file's name; empty for the usual ones
    paper_rule_successes: int | None = None
    failures: Mapping[str, int] = field(default_factory=dict)  # by cause
    rows: Sequence[Mapping[str, Any]] = ()  # one an episode; its keys are the table's columns
    distinct: int | None = None  # initial states, where some were played more than once: the interval counts every episode

    @property
    def label(self) -> str:
        again = f" ({self.distinct} different)" if self.distinct not in (None, self.episodes) else ""
        return ", ".join([f"{self.states} states{again}", *filter(None, self.conditions.split("+"))])


@dataclass(frozen=True)
class Film:
    """One episode to look at: pictures side by side, a video, or both."""

    caption: str
    strip: Path | bytes | None = None  # PNG
    video: Path | None = None  # MP4
    success: bool | None = None
    cause: str = ""  # of a failure, as `EvaluationStats.failures` counts them
    evaluation: str = ""  # label of that which it is from; empty if there is one only


@dataclass(frozen=True)
class Starts:
    """Where an object stood at first, seen from above: `(x, y)` [m], x away from the arm's base, y to its left."""

    thing: str
    learned: Sequence[tuple[float, float]]
    held_out: Sequence[tuple[float, float]] = ()
    failed: Sequence[tuple[float, float]] = ()
    """From where the policy failed."""


@dataclass(frozen=True)
class ReportData:
    """A whole run. `metrics` are the lines of the training log; `charts.PANELS` says which keys are drawn."""

    title: str
    task: str
    command: str
    description: str = ""
    config: Mapping[str, Any] = field(default_factory=dict)
    versions: Mapping[str, Any] = field(default_factory=dict)
    expert: ExpertStats | None = None
    dataset: DatasetStats | None = None
    metrics: Sequence[Mapping[str, float]] = ()
    evaluations: Sequence[EvaluationStats] = ()
    seconds: Mapping[str, float] = field(default_factory=dict)  # by stage, in order
    films: Sequence[Film] = ()
    starts: Sequence[Starts] = ()
    commands: Sequence[str] = ()
    """What to type for each stage, and for looking into what came of it."""
