"""The main job: collect, curate, train, evaluate and report, within one budget of minutes. Each stage goes on where it was stopped.

    OUT/run.json      the resolved configuration, versions, what each stage took
    OUT/data/         the dataset
    OUT/first/        with corrections: a first policy, trained on the demonstrations alone
    OUT/corrections/  with corrections: episodes in which it acted and the expert answered
    OUT/policy/       the policy and its metrics
    OUT/films/        short films of successes and failures
    OUT/report.html   what to look at
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from optimus.collect import CollectConfig, Collected, collect
from optimus.conditions import USUAL
from optimus.control import require_control
from optimus.correct import Turns
from optimus.data.atomic import make_folder, read_record, write_json
from optimus.data.curate import CurationConfig, curate
from optimus.data.episode import OSC, TASKS_OWN
from optimus.data.store import EpisodeStore, installed_versions, require_no_dataset
from optimus.demonstrate import ExpertConfig
from optimus.errors import DatasetError, require_at_least, require_finite
from optimus.evaluate import EvalReport, evaluate, how_said, validation_starts
from optimus.filming import film_outcomes
from optimus.learn.card import write_card
from optimus.learn.checkpoint import weights_of
from optimus.learn.recipe import LEAST
from optimus.learn.schedule import RateConfig
from optimus.learn.train import Progress, TrainConfig, train
from optimus.report import write_report
from optimus.robots import Robot
from optimus.rollout import Perturbation
from optimus.summary import EPISODES, RunRecord, films_in, summarise
from optimus.tasks import task as task_named

DEMONSTRATIONS_PER_MINUTE = 18
"""Of the whole budget: about a sixth of it goes into collecting."""
CORRECTIONS_PER_MINUTE = 7
CORRECTION_SHARE = 0.13
"""Of the whole budget, at most, for collecting corrections."""
FIRST_SHARE = 0.55
"""Of the time that is left for training: the first policy's."""
EVALUATION_MINUTES = 2.0
"""Kept back for evaluation, films and report."""

LEAST_TRAINING = 0.5
"""Minutes of training, however few are left."""

CORRECTION_SEEDS_FROM = 5_000_000
"""Seeds of corrections start here, far from those of demonstrations and of evaluations."""

StageProgress = Callable[[str, int, int, dict[str, str]], None]
"""`(stage, done, total, notes)`"""


@dataclass(frozen=True)
class RunConfig:
    """What to run, where to, within which budget."""

    task: str
    out: Path
    minutes: float = 20.0
    demonstrations: int | None = None
    episodes: int = EPISODES
    seed: int = 0
    workers: int = 0
    corrections: bool = False
    """Train a first policy, let it act and the expert answer, and train on those answers too. The same time spent on training
    with demonstrations alone is worth as much or more (docs/results/first-policies.md)."""
    control: str = OSC
    """How actions move the arm; a name of `optimus.control`."""
    robot: Robot | None = None
    """Takes the place of the task's own."""
    mishaps: float = 0.0
    """Share of the demonstrations in which something happens that the expert makes good; see `ExpertConfig`."""

    def __post_init__(self) -> None:
        require_at_least(LEAST, minutes=self.minutes)
        require_finite(minutes=self.minutes)
        require_at_least(1, episodes=self.episodes, demonstrations=self.demonstrations)
        require_at_least(0, seed=self.seed, workers=self.workers)

    @property
    def about(self) -> dict[str, Any]:
        """What decides about the outcome, JSON-able: a folder is for one of these."""
        asked = {k: v for k, v in vars(self).items() if k != "workers"}
        return {**asked, "out": self.out.name, "robot": task_named(self.task).robot_record(self.robot)}

    @property
    def wanted(self) -> int:
        """Demonstrations to collect."""
        return self.demonstrations if self.demonstrations is not None else max(40, round(DEMONSTRATIONS_PER_MINUTE * self.minutes))


class Journal:
    """`run.json`: what was asked for, and what each stage took, over all the sessions that it needed."""

    def __init__(self, config: RunConfig) -> None:
        self.path = config.out / "run.json"
        asked = config.about
        self.value: dict[str, Any] = {"config": asked, "versions": installed_versions(), "seconds": {}}
        if self.path.exists():
            there = read_record(self.path, ("config", "seconds"))
            there["config"] = {"control": OSC, "robot": TASKS_OWN, "mishaps": 0.0, **there["config"]}
            for key, wanted in asked.items():
                if key == "out":  # a folder may be renamed
                    there["config"][key] = wanted
                if there["config"].get(key) != wanted:
                    raise DatasetError(
                        f"{config.out} was begun with {key} = {there['config'].get(key)!r}, not {wanted!r}; "
                        "use the same settings or another folder"
                    )
            self.value = there
        else:
            make_folder(config.out)
        self.write()

    def write(self) -> None:
        write_json(self.path, self.value)

    def add(self, stage: str, seconds: float) -> None:
        self.value["seconds"][stage] = self.value["seconds"].get(stage, 0.0) + seconds
        self.write()

    @property
    def spent(self) -> float:
        """Seconds, all sessions together."""
        return sum(self.value["seconds"].values())

    def settled(self, key: str, decide: Callable[[], Any]) -> Any:
        """A value decided once and kept for later sessions."""
        if key not in self.value:
            self.value[key] = decide()
            self.write()
        return self.value[key]


def run(config: RunConfig, progress: StageProgress = lambda *_: None) -> dict[str, Any]:
    """Everything, from the task's name to the report. Returns `{evaluation, report, ...}`, JSON-able."""
    task_named(config.task)
    require_control(config.control)
    require_no_dataset(config.out)
    wanted = _collection(config, config.out / "data")  # refuses what makes no sense before anything is written
    journal = Journal(config)
    data, policy = config.out / "data", config.out / "policy"
    collected = _timed(journal, "collect", lambda: _collect(wanted, progress))
    journal.value.setdefault("plan_seconds", []).extend(collected.plan_seconds)
    curation = _timed(journal, "curate", lambda: curate(data, CurationConfig(validation_episodes=config.episodes)))
    first, corrections = config.out / "first", config.out / "corrections"
    if config.corrections:
        minutes = journal.settled("first_minutes", lambda: FIRST_SHARE * _minutes_left(config, journal))
        _timed(journal, "first policy", lambda: _train("first policy", Lesson(config, data, first, minutes), progress))
        if "corrections" not in journal.value:  # what the policy has learned from is not added to
            found = _timed(journal, "correct", lambda: _correct(config, corrections, first, progress))
            journal.settled("corrections", lambda: found.demonstrations)
    lesson = Lesson(config, data, policy, journal.settled("train_minutes", lambda: _minutes_left(config, journal)))
    if config.corrections:
        lesson = replace(lesson, corrections=corrections, initial=first)
    _timed(journal, "train", lambda: _train("train", lesson, progress))
    report = _timed(journal, "evaluate", lambda: _evaluate(config, data, policy, progress))
    page = config.out / "report.html"
    if not journal.value.get("filmed"):
        _timed(journal, "films", lambda: _films(config, data, policy, report))
        journal.settled("filmed", lambda: True)
    films = films_in(config.out / "films", report, how_said(USUAL, "sampled", config.seed))
    write_report(summarise(RunRecord(journal.value, EpisodeStore.open(data), curation, policy, report, films)), page)
    return {
        "task": config.task,
        "demonstrations": len(curation.kept) + len(curation.dropped),
        "evaluation": {k: v for k, v in report.items() if k != "outcomes"},
        "seconds": journal.value["seconds"],
        "report": str(page),
    }


def _timed(journal: Journal, stage: str, work: Callable[[], Any]) -> Any:
    began = time.perf_counter()
    try:
        return work()
    finally:
        journal.add(stage, time.perf_counter() - began)


def _minutes_left(config: RunConfig, journal: Journal) -> float:
    return max(LEAST_TRAINING, config.minutes - journal.spent / 60 - min(EVALUATION_MINUTES, config.minutes / 4))


def _collection(config: RunConfig, data: Path) -> CollectConfig:
    expert = ExpertConfig(perturbation=Perturbation(), mishaps=config.mishaps)
    how = (config.wanted, config.seed, config.workers)
    return CollectConfig(config.task, data, *how, expert, control=config.control, robot=config.robot)


def _collect(wanted: CollectConfig, progress: StageProgress) -> Collected:
    return collect(wanted, lambda tally: progress("collect", tally.successes, wanted.episodes, {}))


def _correct(config: RunConfig, corrections: Path, first: Path, progress: StageProgress) -> Collected:
    wanted = max(4, round(CORRECTIONS_PER_MINUTE * config.minutes))
    seed = config.seed + CORRECTION_SEEDS_FROM
    asked = CollectConfig(
        config.task,
        corrections,
        wanted,
        seed,
        config.workers,
        ExpertConfig(),
        Turns(first),
        max_seconds=CORRECTION_SHARE * 60 * config.minutes,  # a poor first policy spoils most of what it touches
        control=config.control,
        robot=config.robot,
    )
    return collect(asked, lambda tally: progress("correct", tally.successes, wanted, {}))


@dataclass(frozen=True)
class Lesson:
    """What is trained on, into which folder, for how long, from which weights."""

    config: RunConfig
    data: Path
    policy: Path
    minutes: float
    corrections: Path | None = None
    initial: Path | None = None


def _train(stage: str, lesson: Lesson, progress: StageProgress) -> None:
    def report(p: Progress) -> None:
        notes = {k: f"{p.metrics[k]:.3g}" for k in ("loss", "held_out_action_error_mm", "labels_per_second") if k in p.metrics}
        progress(stage, p.step, p.steps, notes)

    rate = RateConfig() if lesson.initial is None else RateConfig(first=1e-3)
    config = TrainConfig(minutes=lesson.minutes, seed=lesson.config.seed, rate=rate)
    train(lesson.data, lesson.policy, config, None, report, lesson.corrections or (), lesson.initial)


def _evaluate(config: RunConfig, data: Path, policy: Path, progress: StageProgress) -> dict[str, Any]:
    starts = validation_starts(data, config.episodes)
    asked = EvalReport(str(starts[0].task), "validation", (), seed=config.seed, weights=weights_of(policy))
    if known := asked.answered(policy, [s.seed for s in starts]):
        return known

    def note(done: int, successes: int) -> None:
        progress("evaluate", done, config.episodes, {"successes": str(successes)})

    report = evaluate(policy, starts, "validation", config.seed, config.workers, progress=note, robot=config.robot, keep=True)
    report.write(policy)
    write_card(policy)
    return report.as_dict()


def _films(config: RunConfig, data: Path, policy: Path, report: dict[str, Any]) -> None:
    starts = validation_starts(data, config.episodes)
    film_outcomes(policy, starts, report, config.seed, "sampled", config.out / "films", config.robot)


