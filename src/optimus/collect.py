"""Many seeds, many processes -> a dataset of successful demonstrations."""

from __future__ import annotations

import math
import os
import time
from collections import Counter
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Future, wait
from dataclasses import asdict, dataclass, field, replace
from functools import lru_cache, partial
from itertools import count
from pathlib import Path
from typing import Any

from optimus.control import CONTROLS, require_control
from optimus.correct import Corrections, Turns, is_told, require_same_work, require_usual_eyes
from optimus.data.episode import BINARY, OSC, TASKS_OWN
from optimus.data.store import EpisodeStore
from optimus.demonstrate import ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.errors import DatasetError, StorageError, WorkerError, require_at_least
from optimus.robots import Robot
from optimus.rollout import Perturbation
from optimus.tasks import task as task_named
from optimus.workers import available_cores, executor, require_backend
from optimus.world import compile_scene

GIVE_UP_AFTER = 30
"""Attempts without a single success."""
MOST_BROKEN = 5
"""Times in a row that all workers are replaced without an attempt having come to its end."""


LENIENCE = 1.5
"""Of a task's horizon, what an episode may take in which somebody meddles: it is meant for those who are left alone, and pauses and
ways back would make the longer half of `microwave`'s demonstrations fail by it."""


@dataclass(frozen=True)
class CollectConfig:
    """What to collect, and where to."""

    task: str
    out: Path
    episodes: int = 200
    """Successful demonstrations wanted."""
    seed: int = 0
    """Of the first attempt; the next ones follow."""
    workers: int = 0
    """Processes; 0 takes every core. The dataset does not depend on it."""
    expert: ExpertConfig = field(default_factory=lambda: ExpertConfig(perturbation=Perturbation()))
    turns: Turns | None = None
    """Collect corrections: a policy and the expert take turns to act, in place of the perturbation."""
    max_seconds: float = math.inf
    """Begin no further attempt after this time, even if that leaves fewer episodes than wanted."""
    control: str = OSC
    """How actions move the arm; a name of `optimus.control`."""
    robot: Robot | None = None
    """Takes the place of the task's own."""
    images: bool = True
    """Render what the cameras see; without, `optimus.rerender` can do so later from the states."""
    backend: str = "local"
    """Where the workers are; a name of `optimus.workers.BACKENDS`. The dataset does not depend on it."""

    def __post_init__(self) -> None:
        require_at_least(1, episodes=self.episodes)
        require_at_least(0, seed=self.seed, workers=self.workers, max_seconds=self.max_seconds)


@dataclass(frozen=True)
class Collected:
    """What a collection came to; the CPU seconds are those of this run alone."""

    demonstrations: int
    attempts: int
    failures: dict[str, int]
    seconds: float
    cpu_seconds: dict[str, float]
    """By part: planning, physics, rendering, writing, and other."""
    new: int
    """Demonstrations added by this run."""
    plan_seconds: list[float]
    """CPU time of each attempt's planning, in the order of their ends."""


@dataclass(eq=False)
class Tally:
    """How a collection stands."""

    wanted: int
    had: int = 0
    """Demonstrations that were there when it began."""
    successes: int = 0
    """... and that are there now."""
    failures: Counter[str] = field(default_factory=Counter)
    """Of all attempts that the folder knows of, by reason."""
    cpu: Counter[str] = field(default_factory=Counter)
    plan_seconds: list[float] = field(default_factory=list)

    @property
    def attempts(self) -> int:
        return self.successes + self.failures.total()

    def count(self, store: EpisodeStore) -> None:
        """Take from the folder what there is."""
        self.successes = len(store.seeds)
        self.failures = Counter(str(store.read_failure(seed)["reason"]) for seed in store.failed_seeds)

    def add(self, outcome: _Outcome) -> None:
        self.successes += not outcome.failure
        self.failures.update([outcome.failure] if outcome.failure else [])
        self.cpu.update(outcome.cpu)
        self.plan_seconds.append(outcome.cpu["planning"])


@dataclass(frozen=True)
class _Outcome:
    failure: str
    """Empty for a success."""
    cpu: dict[str, float]


@lru_cache(maxsize=2)
def _env(
    task: str, control: str, robot: Robot | None, images: bool, gripper: str, told: bool, lenience: float
) -> ManipulationEnv:
    asked = task_named(task)
    asked = replace(asked, horizon=round(lenience * asked.horizon))
    return ManipulationEnv(asked, images, control=control, robot=robot, positions=told, gripper=gripper)


def _attempt(config: CollectConfig, seed: int) -> _Outcome:
    """One seed, in a worker: its episode or the reason of its failure is written before this returns."""
    began = time.process_time()
    turns = config.turns
    told = turns is not None and is_told(turns.policy)
    alone = config.expert.perturbation is None and turns is None and config.expert.mishaps == 0.0
    lenience = 1.0 if alone else LENIENCE
    env = _env(config.task, config.control, config.robot, config.images, config.expert.law.gripper, told, lenience)
    env.cpu.clear()
    attempt = demonstrate(env, seed, config.expert, None if turns is None else partial(Corrections, turns))
    cpu = {"planning": attempt.plan_seconds, **env.cpu}
    written, store = time.process_time(), _store(config.out)
    if attempt.success and attempt.episode is not None:
        store.write(attempt.episode)
    else:
        store.write_failure(seed, attempt.failure, attempt.episode.skeleton if attempt.episode else (), attempt.info)
    ended = time.process_time()
    cpu["writing"] = ended - written
    cpu["other"] = max(0.0, ended - began - sum(cpu.values()))
    return _Outcome("" if attempt.success else attempt.failure, cpu)


@lru_cache(maxsize=2)
def _store(out: Path) -> EpisodeStore:
    return EpisodeStore.open(out)


def open_dataset(config: CollectConfig) -> EpisodeStore:
    """The dataset folder of a collection, made or opened; errors if it belongs to another one."""
    task, control = task_named(config.task), require_control(config.control)
    robot = task.robot_record(config.robot)
    require_backend(config.backend)
    if config.turns is not None:
        require_same_work(config.turns, task, control, robot, config.expert.law.gripper)
    cameras = compile_scene(task.problem(config.seed, config.robot).scene).image_cameras if config.images else ()
    if config.turns is not None:
        require_usual_eyes(config.turns, cameras)
    _require_writable(config.out)
    expert = asdict(config.expert)
    about: dict[str, Any] = {"seed": config.seed, "control": control, **CONTROLS[control].scales, "expert": expert}
    if robot != TASKS_OWN:
        about["robot"] = robot
    if config.expert.law.gripper != BINARY:
        about["gripper"] = config.expert.law.gripper
    if config.turns is not None:
        about["turns"] = config.turns.record
    return EpisodeStore.create(config.out, task.name, cameras, about, task.fingerprint(config.seed, config.robot))


def collect(config: CollectConfig, progress: Callable[[Tally], None] = lambda tally: None) -> Collected:
    """Attempt one seed after another until `config.episodes` have succeeded; goes on where an earlier run was stopped.

    The episodes kept are the first successes in the order of the seeds, whatever the number of workers: never are more attempts
    under way than successes are missing, so none can come to be surplus. Workers that are killed are replaced, and what they were
    at is done again; when the disk is full, `StorageError` says so, and what has been written stays.
    """
    began, store = time.perf_counter(), open_dataset(config)
    tally = Tally(config.episodes, had=len(store.headers()))  # a damaged one is named before it counts
    if tally.had > config.episodes:
        raise DatasetError(f"{config.out} already holds {tally.had} episodes, more than the {config.episodes} asked for")
    broken, over = 0, False
    while not over:
        tally.count(store)
        progress(tally)
        before = tally.attempts
        try:
            _work(config, store, tally, began + config.max_seconds, progress)
            over = True
        except BrokenExecutor as error:
            broken = broken + 1 if tally.attempts == before else 0
            if broken == MOST_BROKEN:
                told = "the workers were killed, perhaps for want of memory: give fewer --workers"
                raise WorkerError(f"{broken} times in a row no attempt came to its end: {told}") from error
            store = EpisodeStore.open(config.out)
        except StorageError as error:
            raise StorageError(f"{error}; what is there is whole: make room, and the same command goes on") from error
    seconds, new = time.perf_counter() - began, tally.successes - tally.had
    return Collected(
        tally.successes, tally.attempts, dict(tally.failures), seconds, dict(tally.cpu), new, tally.plan_seconds
    )


def _work(
    config: CollectConfig, store: EpisodeStore, tally: Tally, until: float, progress: Callable[[Tally], None]
) -> None:
    """Share attempts out to workers and count what comes back, until it is enough or the time is over."""
    workers = config.workers or available_cores()
    # one in reserve for every worker, but none that would have to be waited for once the time is over
    under_way = 2 * workers if config.max_seconds == math.inf else workers
    seeds, pending = _unattempted(store, config.seed), set[Future[_Outcome]]()
    with executor(workers, config.backend) as pool:
        try:
            while tally.successes < config.episodes:
                if config.max_seconds == math.inf:
                    _require_hope(tally)
                late = time.perf_counter() > until
                if late and not pending:
                    break
                while not late and len(pending) < min(config.episodes - tally.successes, under_way):
                    pending.add(pool.submit(_attempt, config, next(seeds)))
                done, pending = wait(pending, return_when=FIRST_COMPLETED)
                for future in done:
                    tally.add(future.result())
                progress(tally)
        finally:
            pool.shutdown(wait=True, cancel_futures=True)


def _unattempted(store: EpisodeStore, first: int) -> Iterator[int]:
    known = {*store.seeds, *store.failed_seeds}
    return (seed for seed in count(first) if seed not in known)


def _require_hope(tally: Tally) -> None:
    if tally.successes == 0 and tally.attempts >= GIVE_UP_AFTER:
        raise DatasetError(f"no success in {tally.attempts} attempts; most often: {tally.failures.most_common(1)[0][0]}")


def _require_writable(out: Path) -> None:
    """`StorageError` before any work is done if nothing could be written there."""
    folder = next(p for p in (out, *out.absolute().parents) if p.exists())
    if not folder.is_dir() or not os.access(folder, os.W_OK | os.X_OK):
        raise StorageError(f"cannot write to {out}: {folder} is not a writable folder; name another with --out")
