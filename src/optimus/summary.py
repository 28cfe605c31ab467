"""What a run folder holds, gathered for its report."""

from __future__ import annotations

import shlex
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from optimus.data.atomic import read_record
from optimus.data.curate import Curation, load_curation
from optimus.data.episode import OSC, TASKS_OWN
from optimus.data.store import EpisodeStore
from optimus.errors import DatasetError
from optimus.evaluate import EvalReport
from optimus.filming import FilmedEpisode, caption_of
from optimus.learn import checkpoint, metrics
from optimus.report import DatasetStats, EvaluationStats, ExpertStats, Film, ReportData, Starts
from optimus.statistics import quantiles, wilson
from optimus.tasks import task as task_named

EPISODES = 50
"""Of an evaluation, where nothing else is asked for."""
EVALUATED = ("interval", "outcomes", "successes", "episodes", "states", "paper_rule_successes", "failures")
"""What the file of an evaluation says at least."""
Point = tuple[float, float]


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
        films=[_film(f) for f in record.films],
        starts=_starts(record.store, record.curation, record.evaluation),
        commands=_commands(asked),
    )


def summary_of(folder: Path) -> ReportData:
    """The report of a folder that `run` or `train` made, from what lies in it. `CheckpointError` if neither did."""
    if (folder / "run.json").exists():
        return summarise(_record(folder))
    trained = checkpoint.read_config(folder)
    found = [(read_record(path, EVALUATED), _how(path)) for path in sorted(folder.glob("evaluation-*.json"))]
    evaluations = [_evaluation(e, how) for e, how in found]
    films = [
        _film(film, stats.label)
        for (e, how), stats in zip(found, evaluations, strict=True)
        for film in films_in(folder / "films", e, how)
    ]
    return ReportData(
        title=f"{folder.resolve().name}: a policy for {trained['task']}",
        task=trained["task"],
        command=f"optimus train DATASET --out {folder}",
        config={"policy": trained["policy"], "training": trained["train"]},
        versions=trained.get("versions", {}),
        metrics=metrics.read(folder),
        evaluations=evaluations,
        films=films,
    )


def _how(file: Path) -> str:
    """What was unusual about an evaluation, from its report's name."""
    return file.stem.partition("+")[2]


def _record(folder: Path) -> RunRecord:
    journal = read_record(folder / "run.json", ("config", "seconds"))
    asked = journal["config"]
    file = folder / "policy" / EvalReport(asked["task"], "validation", (), seed=asked["seed"]).file_name
    if not file.exists():
        raise DatasetError(f"{folder} has not been evaluated yet; call optimus run again to let it go on")
    evaluation, data = read_record(file, EVALUATED), folder / "data"
    films = films_in(folder / "films", evaluation, _how(file))
    return RunRecord(journal, EpisodeStore.open(data), load_curation(data), folder / "policy", evaluation, films)


def films_in(folder: Path, evaluation: dict[str, Any], how: str = "") -> list[FilmedEpisode]:
    """The films of an evaluation (`how_said`) that lie in `folder`, as `film_outcomes` named them."""
    films, outcomes = [], dict(enumerate(evaluation["outcomes"]))
    for video in sorted(folder.glob("[sf]*-*-*.mp4"), key=lambda path: (path.name.startswith("failure"), path.name)):
        name, _, said = video.stem.partition("+")
        kind, index, seed = name.rsplit("-", 2)
        outcome = outcomes.get(int(index)) if index.isdecimal() else None
        if outcome is None or said != how or str(outcome["seed"]) != seed or outcome["success"] != (kind == "success"):
            continue  # of another evaluation
        films.append(FilmedEpisode(caption_of(outcome), video, video.with_suffix(".png"), kind == "success", outcome["cause"]))
    return films


def _film(filmed: FilmedEpisode, evaluation: str = "") -> Film:
    caption = f"{filmed.caption} ({evaluation})" if evaluation else filmed.caption
    return Film(caption, filmed.strip, filmed.video, filmed.success, filmed.cause, evaluation)


def _command(asked: dict[str, Any]) -> str:
    """What to type for such a run; a robot that a file describes by its name alone."""
    task, out = shlex.quote(asked["task"]), shlex.quote(asked["out"])
    words = f"optimus run {task} --minutes {asked['minutes']:g} --out {out} --seed {asked['seed']}"
    usual = {"demonstrations": None, "episodes": EPISODES, "mishaps": 0.0, "control": OSC, "robot": TASKS_OWN}
    words += "".join(f" --{key} {asked[key]}" for key, value in usual.items() if asked.get(key, value) != value)
    return words + (" --corrections" if asked.get("corrections", True) else "")


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
        training=len(curation.train),
        held_out=len(curation.validation),
    )


def _starts(store: EpisodeStore, curation: Curation, evaluation: dict[str, Any]) -> list[Starts]:
    """Where each object stood when an episode began; only states of the dataset are known where a policy failed."""
    known = evaluation["states"] == "validation"
    failed = {o["seed"] for o in evaluation["outcomes"] if not o["success"]} if known else set[int]()
    train, held_out = set(curation.train), set(curation.validation)
    learned: dict[str, list[Point]] = {}
    others: dict[str, list[Point]] = {}
    missed: dict[str, list[Point]] = {}
    for header in store.headers():
        first = header.read("objects")[0]
        for name, (x, y, _) in zip(header.object_names, first, strict=True):
            groups = ((header.seed in train, learned), (header.seed in held_out, others), (header.seed in failed, missed))
            for belongs, where in groups:
                where.setdefault(name, [])
                if belongs:
                    where[name].append((float(x), float(y)))
    return [Starts(name, learned[name], others[name], missed[name]) for name in learned]


def _commands(asked: dict[str, Any]) -> list[str]:
    """The run's stages one by one, and how to look into it."""
    out = shlex.quote(asked["out"])
    return [
        _command(asked),
        f"optimus evaluate {out}/policy --dataset {out}/data --episodes {asked['episodes']} --seed {asked['seed']}",
        f"optimus view {out}",
        f"optimus report {out} --out {out}.html",
    ]


def _evaluation(report: dict[str, Any], how: str = "") -> EvaluationStats:
    low, high = report["interval"]
    rows = [{k: v for k, v in o.items() if v != ""} for o in report["outcomes"]]
    return EvaluationStats(
        successes=report["successes"],
        episodes=report["episodes"],
        interval=(low, high),
        states=report["states"],
        conditions=how,
        paper_rule_successes=report["paper_rule_successes"],
        failures=report["failures"],
        rows=rows,
        distinct=report.get("distinct_states"),
    )
