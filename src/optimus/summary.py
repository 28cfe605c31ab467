"""What a run folder holds, gathered for its report."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from optimus.data.curate import Curation
from optimus.data.episode import OSC, TASKS_OWN
from optimus.data.store import EpisodeStore
from optimus.evaluate import FilmedEpisode
from optimus.learn import checkpoint, metrics
from optimus.report import DatasetStats, EvaluationStats, ExpertStats, Film, ReportData
from optimus.statistics import quantiles, wilson
from optimus.tasks import task as task_named


@dataclass(frozen=True, eq=False)
class RunRecord:
    """Everything that a run left behind."""

    journal: dict[str, Any]
    store: EpisodeStore
    curation: Curation
    policy: Path
    evaluation: dict[str, Any]
    films: list[FilmedEpisode]


def summarise(record: RunRecord) -> ReportData:
    """The report of a run."""
    asked = record.journal["config"]
    task = task_named(asked["task"])
    trained = checkpoint.read_config(record.policy)
    return ReportData(
        title=f"{task.name}: from the task to a policy in {asked['minutes']:g} minutes",
        task=task.name,
        command=_command(asked),
        description=f"The task: {task.summary}. The policy sees {' and '.join(record.store.cameras)}, no object's position.",
        config={**asked, "collection": record.store.config, "policy": trained["policy"], "training": trained["train"]},
        versions=record.journal["versions"],
        expert=_expert(record.store, record.journal.get("plan_seconds", [])),
        dataset=_dataset(record.store, record.curation),
        metrics=metrics.read(record.policy),
        evaluations=[_evaluation(record.evaluation)],
        seconds=record.journal["seconds"],
        films=[Film(f.caption, f.strip, f.video, f.success) for f in record.films],
    )


def _command(asked: dict[str, Any]) -> str:
    """What to type for such a run; a robot that a file describes by its name alone."""
    words = f"optimus run {asked['task']} --minutes {asked['minutes']:g} --out {asked['out']} --seed {asked['seed']}"
    usual = {"control": OSC, "robot": TASKS_OWN}
    return words + "".join(f" --{key} {asked[key]}" for key, value in usual.items() if asked.get(key, value) != value)


def _expert(store: EpisodeStore, plan_seconds: list[float]) -> ExpertStats:
    """The expert as it was when it collected: pushed off its path, unless perturbation was off."""
    headers, failed = store.headers(), [store.read_failure(seed) for seed in store.failed_seeds]
    infos = [h.info for h in headers] + [f["info"] for f in failed]
    attempts = len(infos)
    return ExpertStats(
        episodes=attempts,
        successes=len(headers),
        paper_rule_successes=sum(bool(i.get("paper_success")) for i in infos),
        interval=wilson(len(headers), attempts),
        plan_seconds=quantiles(plan_seconds, 95),
        failures=dict(Counter(f["reason"] for f in failed)),
    )


def _dataset(store: EpisodeStore, curation: Curation) -> DatasetStats:
    headers = store.headers()
    lengths = [h.steps for h in headers]
    return DatasetStats(
        demonstrations=len(headers),
        steps=sum(lengths),
        lengths=lengths,
        per_skeleton=dict(Counter(" ".join(h.skeleton) for h in headers)),
        dropped=dict(Counter(reason.split(":")[0] for reason in curation.dropped.values())),
    )


def _evaluation(report: dict[str, Any]) -> EvaluationStats:
    low, high = report["interval"]
    rows = [{k: v for k, v in o.items() if v != ""} for o in report["outcomes"]]
    return EvaluationStats(
        successes=report["successes"],
        episodes=report["episodes"],
        interval=(low, high),
        states=report["states"],
        paper_rule_successes=report["paper_rule_successes"],
        failures=report["failures"],
        rows=rows,
    )
