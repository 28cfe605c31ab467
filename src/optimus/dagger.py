"""DAgger with the planner as teacher (Ross et al. 2011): round by round the newest policy acts, the expert plans on from wherever
that led and answers, and training goes on with those answers too. Nobody has to be asked: the expert is a program.

    RUN/                      a policy, trained on the demonstrations alone
    RUN/dagger/1/data/        episodes in which it acted and the expert answered
    RUN/dagger/1/policy/      trained on from its weights, on demonstrations and answers
    RUN/dagger/2/data/ ...    the same of that policy
    RUN/dagger.json           success before and after each round

With `plain`, the expert acts alone instead (`RUN/plain/...`, `RUN/plain.json`): what as many more demonstrations are worth.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from optimus.collect import CollectConfig, collect
from optimus.correct import Turns
from optimus.data.atomic import read_record, write_json
from optimus.data.curate import load_curation
from optimus.data.episode import IMAGE_SIZE, IMAGE_SUFFIX, IMPORTED, TASKS_OWN
from optimus.data.episode_file import OBSERVATION_PREFIX
from optimus.data.store import EpisodeStore
from optimus.demonstrate import ExpertConfig
from optimus.errors import DatasetError, require_at_least
from optimus.evaluate import evaluate, trained_robot, validation_starts
from optimus.learn.begun import train_described
from optimus.learn.board import BoardName
from optimus.learn.policy import PolicyConfig
from optimus.learn.train import Progress, TrainConfig, train
from optimus.robots.catalogue import known_robots
from optimus.robots.catalogue import robot as robot_named
from optimus.tasks import task as task_named
from optimus.world import compile_scene

SEEDS_FROM = 100_000_000
"""Seeds of the episodes added start here, far from those of demonstrations, corrections and evaluations."""
SEEDS_A_RUN, SEEDS_A_ROUND = 10_000_000, 100_000
ROUND_SHARE = 0.5
"""Of the first policy's training, for each round's."""
RATE_SHARE = 2 / 3
"""Of the first policy's first learning rate, likewise: the weights are not random any more."""
ALONE_FROM = 1.5
"""The expert acts alone from a step drawn up to this many times a demonstration's mean length: so episodes come to their end."""

StageProgress = Callable[[str, int, int, dict[str, str]], None]
"""`(stage, done, total, notes)`"""


@dataclass(frozen=True)
class DaggerConfig:
    """How often, and with how many episodes."""

    rounds: int
    episodes: int = 50
    """Successful episodes added in each round."""
    plain: bool = False
    """Add demonstrations by the expert alone."""
    evaluations: int = 50
    """Episodes, from validation states, in which success is measured before and after each round."""
    workers: int = 0

    def __post_init__(self) -> None:
        require_at_least(1, dagger=self.rounds, dagger_episodes=self.episodes, dagger_evaluations=self.evaluations)
        require_at_least(0, workers=self.workers)

    @property
    def name(self) -> str:
        """Of the folder and of the report."""
        return "plain" if self.plain else "dagger"


def dagger(
    dataset: Path,
    run: Path,
    lesson: TrainConfig,
    config: DaggerConfig,
    progress: StageProgress = lambda *_: None,
    policy: PolicyConfig | None = None,
    watch: BoardName = "tensorboard",
) -> dict[str, Any]:
    """Train `run` on `dataset`, then the rounds; goes on where it was stopped. Returns the report, JSON-able.
    `policy` is the network; `watch` says where the figures go, as for `train`.

    A function of `dataset`, `lesson` and `config` where `lesson` is a number of steps, for any number of workers.
    """
    rounds = _Rounds(dataset, run, lesson, config, policy or PolicyConfig(), progress, watch)
    for number in range(config.rounds + 1):
        rounds.do(number)
    return rounds.report


class _Rounds:
    def __init__(
        self,
        dataset: Path,
        run: Path,
        lesson: TrainConfig,
        config: DaggerConfig,
        network: PolicyConfig,
        progress: StageProgress,
        watch: BoardName,
    ) -> None:
        self.dataset, self.run, self.lesson, self.config = dataset, run, lesson, config
        self.network, self.progress = network, progress
        self.watch: BoardName = watch
        self.store = EpisodeStore.open(dataset)
        lessons = {"policy": asdict(network), "train": asdict(lesson)}
        asked = {"dataset": dataset.name, "task": self.store.task, **lessons, **asdict(config)}
        del asked["rounds"], asked["workers"]  # more rounds may be asked for later, and the outcome depends on no workers
        self._require_usual()
        self.file = run / f"{config.name}.json"
        self.report: dict[str, Any] = {"config": json.loads(json.dumps(asked)), "rounds": []}
        if self.file.exists():
            self._go_on()

    def _require_usual(self) -> None:
        """`DatasetError` where what rounds add would differ: before the first training, not after it."""
        if IMPORTED in self.store.config:
            raise DatasetError(f"{self.dataset} was imported: rounds are of a task known here; train without --dagger")
        if self.store.robot not in (TASKS_OWN, *known_robots()):
            raise DatasetError(
                f"{self.dataset} was collected with robot {self.store.robot!r}, of whom rounds know the name alone; "
                "train without --dagger, and add what `optimus collect --policy RUN --robot FILE` gathers by --corrections"
            )
        if self.store.views:
            names = ", ".join(view["name"] for view in self.store.views)
            raise DatasetError(f"{self.dataset} is seen by {names}, as what rounds add is not; train without --dagger")
        for header in map(self.store.header, self.store.seeds[:1]):
            for camera in self.store.cameras:
                size = header.arrays[f"{OBSERVATION_PREFIX}{camera}{IMAGE_SUFFIX}"].shape[1:3]
                if size != (IMAGE_SIZE, IMAGE_SIZE):
                    usual = (IMAGE_SIZE, IMAGE_SIZE)
                    raise DatasetError(f"{self.dataset}: rounds add images of {usual}, those of {camera} are {size}")
        arm = None if self.store.robot == TASKS_OWN else robot_named(self.store.robot)
        usual_cameras = compile_scene(task_named(self.store.task).problem(0, arm).scene).image_cameras
        if self.store.cameras not in ((), usual_cameras):
            have, wanted = ", ".join(self.store.cameras), ", ".join(usual_cameras)
            raise DatasetError(f"{self.dataset} is seen by {have}, what rounds add by {wanted}; train without --dagger")

    def _go_on(self) -> None:
        there = read_record(self.file, ("config", "rounds"))
        begun = {**there["config"], "train": train_described(there["config"]["train"])}
        for key, wanted in self.report["config"].items():
            if begun.get(key) != wanted:
                raise DatasetError(
                    f"{self.file} was begun with {key} = {begun.get(key)!r}, not {wanted!r}; "
                    "use the same settings or another folder"
                )
        self.report = there

    def data(self, number: int) -> Path:
        """The episodes added in a round."""
        return self.run / self.config.name / str(number) / "data"

    def policy(self, number: int) -> Path:
        """What came of a round; of round 0 the first policy."""
        return self.run / self.config.name / str(number) / "policy" if number else self.run

    def do(self, number: int) -> None:
        """One round, unless it has been done; each of its stages goes on where it was stopped."""
        if number < len(self.report["rounds"]):
            return
        added = self._collect(number) if number else {}
        self._train(number)
        curation = load_curation(self.dataset)
        row = {
            "round": number,
            "policy": str(self.policy(number).relative_to(self.run)),
            "demonstrations": (self.lesson.demonstrations or len(curation.train)) + number * self.config.episodes,
            **added,
            "success": self._evaluate(number),
        }
        self.report["rounds"].append(row)
        write_json(self.file, self.report)

    def _collect(self, number: int) -> dict[str, Any]:
        before, wanted = self.policy(number - 1), self.config.episodes
        length = np.mean([header.steps for header in self.store.headers()])
        turns = None if self.config.plain else Turns(before, policy_until=round(ALONE_FROM * length))
        asked = CollectConfig(
            self.store.task,
            self.data(number),
            wanted,
            SEEDS_FROM + SEEDS_A_RUN * self.lesson.seed + SEEDS_A_ROUND * number,
            self.config.workers,
            ExpertConfig.from_json(self.store.config["expert"]),
            turns,
            control=self.store.control,
            robot=trained_robot(before),
            images=bool(self.store.cameras),
        )
        stage = f"round {number}: {'demonstrate' if self.config.plain else 'correct'}"
        result = collect(asked, lambda tally: self.progress(stage, tally.successes, wanted, {}))
        added = EpisodeStore.open(self.data(number))
        acted = [np.any(e.actions != e.executed, axis=1).mean() for e in map(added.read, added.seeds)]
        replanned = [added.header(seed).info["retries"] for seed in added.seeds]
        return {
            "attempts": result.attempts,
            "failures": result.failures,
            "share_not_by_expert": float(np.mean(acted)),
            "planned_again": int(np.sum(replanned)),
        }

    def _train(self, number: int) -> None:
        lesson, first = self.lesson, self.lesson.rate.first
        if number:
            rate = replace(lesson.rate, first=RATE_SHARE * first)
            steps = None if lesson.steps is None else max(1, round(ROUND_SHARE * lesson.steps))
            epochs = None if lesson.epochs is None else ROUND_SHARE * lesson.epochs
            lesson = replace(lesson, steps=steps, epochs=epochs, minutes=ROUND_SHARE * lesson.minutes, rate=rate)

        def report(p: Progress) -> None:
            shown = ("loss", "held_out_action_error_mm")
            notes = {k: f"{p.metrics[k]:.3g}" for k in shown if k in p.metrics}
            self.progress(f"round {number}: train" if number else "train", p.step, p.steps, notes)

        more = [self.data(k) for k in range(1, number + 1)]
        begun = self.policy(number - 1) if number else None
        train(self.dataset, self.policy(number), lesson, self.network, report, more, begun, self.watch)

    def _evaluate(self, number: int) -> dict[str, Any]:
        starts = validation_starts(self.dataset, self.config.evaluations)

        def note(done: int, successes: int) -> None:
            self.progress(f"round {number}: evaluate", done, len(starts), {"successes": str(successes)})

        found = evaluate(self.policy(number), starts, "validation", self.lesson.seed, self.config.workers, progress=note)
        return {k: v for k, v in found.as_dict().items() if k not in ("task", "states", "outcomes")}
