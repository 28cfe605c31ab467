"""Many seeds, many processes -> a dataset of successful demonstrations."""

from __future__ import annotations

import math
import os
import time
from collections import Counter
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import asdict, dataclass, field
from functools import lru_cache, partial
from itertools import count
from pathlib import Path
from typing import Any

from optimus.control import CONTROLS, require_control
from optimus.correct import Corrections, Turns, require_same_arm
from optimus.data.episode import OSC, TASKS_OWN
from optimus.data.store import EpisodeStore
from optimus.demonstrate import ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.errors import DatasetError, StorageError
from optimus.robots import Robot
from optimus.rollout import Perturbation
from optimus.tasks import task as task_named
from optimus.workers import available_cores, executor
from optimus.world import compile_scene

GIVE_UP_AFTER = 30
"""Attempts without a single success."""


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


@dataclass(frozen=True)
class Collected:
    """What a collection came to; the CPU seconds are those of this run alone."""

    demonstrations: int
    attempts: int
    failures: dict[str, int]
    seconds: float
    cpu_seconds: dict[str, float]
    new: int
    """Demonstrations added by this run."""
    plan_seconds: list[float]
    """CPU time of each attempt's planning, in the order of their ends."""


@dataclass(frozen=True)
class _Outcome:
    success: bool
    cpu: dict[str, float]


@lru_cache(maxsize=2)
def _env(task: str, control: str, robot: Robot | None) -> ManipulationEnv:
    return ManipulationEnv(task_named(task), control=control, robot=robot)


def _attempt(config: CollectConfig, seed: int) -> _Outcome:
    """One seed, in a worker: its episode or the reason of its failure is written before this returns."""
    env, turns = _env(config.task, config.control, config.robot), config.turns
    env.cpu.clear()
    attempt = demonstrate(env, seed, config.expert, None if turns is None else partial(Corrections, turns))
    began = time.process_time()
    store = _store(config.out)
    if attempt.success and attempt.episode is not None:
        store.write(attempt.episode)
    else:
        store.write_failure(seed, attempt.failure, attempt.episode.skeleton if attempt.episode else (), attempt.info)
    cpu = {"planning": attempt.plan_seconds, **env.cpu, "writing": time.process_time() - began}
    return _Outcome(attempt.success, cpu)


@lru_cache(maxsize=2)
def _store(out: Path) -> EpisodeStore:
    return EpisodeStore.open(out)


def open_dataset(config: CollectConfig) -> EpisodeStore:
    """The dataset folder of a collection, made or opened; errors if it belongs to another one."""
    task, control = task_named(config.task), require_control(config.control)
    robot = task.robot_record(config.robot)
    if config.turns is not None:
        require_same_arm(config.turns, task, control, robot)
    cameras = compile_scene(task.problem(config.seed, config.robot).scene).image_cameras
    _require_writable(config.out)
    expert = asdict(config.expert)
    about: dict[str, Any] = {"seed": config.seed, "control": control, **CONTROLS[control].scales, "expert": expert}
    if robot != TASKS_OWN:
        about["robot"] = robot
    if config.turns is not None:
        about["turns"] = config.turns.record
    return EpisodeStore.create(config.out, task.name, cameras, about)


def collect(config: CollectConfig, progress: Callable[[int], None] = lambda done: None) -> Collected:
    """Attempt one seed after another until `config.episodes` have succeeded; goes on where an earlier run was stopped.

    The episodes kept are the first successes in the order of the seeds, whatever the number of workers: never are more attempts
    under way than successes are missing, so none can come to be surplus.
    """
    began, store = time.perf_counter(), open_dataset(config)
    had = set(store.seeds)
    if len(had) > config.episodes:
        raise DatasetError(f"{config.out} already holds {len(had)} episodes, more than the {config.episodes} asked for")
    successes, failures = len(had), len(store.failed_seeds)
    pending: set[Future[_Outcome]] = set()
    seeds = _unattempted(store, config.seed)
    cpu: Counter[str] = Counter()
    plan_seconds: list[float] = []
    progress(successes)
    with executor(config.workers or available_cores()) as pool:
        try:
            while successes < config.episodes:
                if config.max_seconds == math.inf:
                    _require_hope(store, successes, failures)
                late = time.perf_counter() - began > config.max_seconds
                if late and not pending:
                    break
                while not late and len(pending) < min(config.episodes - successes, 2 * (config.workers or available_cores())):
                    pending.add(pool.submit(_attempt, config, next(seeds)))
                done, pending = wait(pending, return_when=FIRST_COMPLETED)
                for outcome in (future.result() for future in done):
                    successes += outcome.success
                    failures += not outcome.success
                    cpu.update(outcome.cpu)
                    plan_seconds.append(outcome.cpu["planning"])
                progress(successes)
        finally:
            pool.shutdown(wait=True, cancel_futures=True)
    reasons = Counter(store.read_failure(seed)["reason"] for seed in store.failed_seeds)
    seconds, new = time.perf_counter() - began, successes - len(had)
    return Collected(successes, successes + failures, dict(reasons), seconds, dict(cpu), new, plan_seconds)


def _unattempted(store: EpisodeStore, first: int) -> Iterator[int]:
    known = {*store.seeds, *store.failed_seeds}
    return (seed for seed in count(first) if seed not in known)


def _require_hope(store: EpisodeStore, successes: int, failures: int) -> None:
    if successes == 0 and failures >= GIVE_UP_AFTER:
        reasons = Counter(store.read_failure(seed)["reason"] for seed in store.failed_seeds)
        raise DatasetError(f"no success in {failures} attempts; most often: {reasons.most_common(1)[0][0]}")


def _require_writable(out: Path) -> None:
    """`StorageError` before any work is done if nothing could be written there."""
    folder = next(p for p in (out, *out.absolute().parents) if p.exists())
    if not folder.is_dir() or not os.access(folder, os.W_OK | os.X_OK):
        raise StorageError(f"cannot write to {out}: {folder} is not a writable folder; name another with --out")
