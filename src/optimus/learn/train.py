"""Behaviour cloning: a curated dataset to a trained policy, within a number of steps or of minutes.

    RUN/config.json          what is trained, on what, how; versions; the runtime and steps that were settled
    RUN/model.safetensors    the policy: the running average of the weights, normalisation included
    RUN/train_state/         what training goes on from
    RUN/metrics.jsonl        one line a report: loss, rate, labels a second, held-out errors

A run that was killed goes on where its last checkpoint was; with a budget in steps it ends with the very same
weights.
"""

from __future__ import annotations

import json
import math
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import torch

from optimus.data.atomic import make_folder
from optimus.data.curate import load_curation
from optimus.data.episode_file import EpisodeHeader
from optimus.data.store import EpisodeStore, installed_versions
from optimus.data.windows import Windows
from optimus.errors import CheckpointError, DatasetError, OptimusError
from optimus.learn import checkpoint, metrics
from optimus.learn.gradient import GradientWorkers, LossConfig, Runtime, candidate_runtimes, fastest_runtime, usual_runtime
from optimus.learn.heldout import held_out
from optimus.learn.policy import Policy, PolicyConfig, PolicyInputs
from optimus.learn.schedule import RateConfig, StepPlan
from optimus.learn.state import OptimiserConfig, TrainState

STATE_FOLDER = "train_state"
POSITION_SCALE = "position_scale"
"""Key of a dataset's configuration: metres that a position action of 1 stands for."""
_REPORTS = 200  # lines of metrics over a run


class TrainingError(OptimusError):
    """A training run that cannot go on."""


@dataclass(frozen=True)
class TrainConfig:
    """How a policy is trained."""

    steps: int | None = None
    """Number of steps; if none, `minutes` decides."""
    minutes: float = 10.0
    """Time to train for, start-up included."""
    seed: int = 0
    windows: int = 1
    """Consecutive windows in a run."""
    change_weight: float = 1.0
    """Weight of labels near a change of the gripper."""
    change_reach: int = 2
    """Steps before and after such a change that count as near."""
    loss: LossConfig = field(default_factory=LossConfig)
    rate: RateConfig = field(default_factory=RateConfig)
    optimiser: OptimiserConfig = field(default_factory=OptimiserConfig)
    evaluations: int = 10
    """How often the held-out error is measured."""
    held_out_runs: int = 256
    """Windows that it is measured on."""
    checkpoint_seconds: float = 60.0
    """Time between checkpoints."""
    runtime: Runtime | None = None
    """Threads and precision; if none, the machine's usual ones, or with a budget of minutes the fastest, measured."""


@dataclass(frozen=True)
class Progress:
    """Where a run is."""

    step: int
    steps: int
    metrics: dict[str, float]
    """The newest report; empty before the first."""


def train(
    dataset: Path | str,
    run: Path | str,
    config: TrainConfig | None = None,
    policy: PolicyConfig | None = None,
    progress: Callable[[Progress], None] | None = None,
    corrections: Path | str | None = None,
    initial: Path | str | None = None,
) -> Policy:
    """Train a policy on the curated dataset `dataset` into the folder `run`, or go on with what is there.

    `corrections` is a second dataset, all of which is trained on; `initial` is a run folder whose weights to begin with, instead
    of random ones. The policy returned is the running average, as saved. `progress` is called after every step.
    """
    sources = Sources(Path(dataset), Path(corrections) if corrections else None, Path(initial) if initial else None)
    trainer = _Trainer(sources, Path(run), config or TrainConfig(), policy or PolicyConfig())
    try:
        trainer.run_to_end(progress or (lambda _: None))
    finally:
        trainer.workers.close()
    return trainer.state.average.eval()


@dataclass(frozen=True)
class Sources:
    """What a run learns from, and what it begins with."""

    dataset: Path
    corrections: Path | None = None
    initial: Path | None = None


class _Trainer:
    def __init__(self, sources: Sources, run: Path, config: TrainConfig, policy_config: PolicyConfig) -> None:
        self.run, self.config = run, config
        self.session_start = self.last_save = self.last_report = time.perf_counter()
        # Often enough that a short budget of minutes is still kept to: the plan is revised where it is saved.
        budget = math.inf if config.steps is not None else 60 * config.minutes
        self.save_interval = min(config.checkpoint_seconds, budget / 20)
        store, curation = EpisodeStore.open(sources.dataset), load_curation(sources.dataset)
        extra = _corrections(sources.corrections, store)
        cut = policy_config.cut(config.windows, config.change_weight, config.change_reach)
        self.windows = Windows(store, curation.train, cut, extra)
        self.validation = Windows(store, curation.validation, policy_config.cut())
        self.position_scale: float | None = store.config.get(POSITION_SCALE)
        if sources.initial:
            policy = checkpoint.load(sources.initial, store.task, store.control, store.robot).train()
        else:
            policy = fresh_policy(policy_config, PolicyInputs.of(store.task, self.windows), config.seed)
            policy.fit_normalisation(self.windows)
        make_folder(run)
        data = {"config": store.config, "versions": store.versions, "episodes": len(curation.train) + len(extra)}
        runtime, plan = self._settle(policy, {"dataset": data})
        self.workers = GradientWorkers(policy, self.windows, config.loss, runtime, config.seed)
        self.state = TrainState(policy, config.optimiser, plan)
        if self.state.restore(run / STATE_FOLDER):
            metrics.forget_after(run, self.state.step)
        self.seconds_before = self.state.seconds
        self.first_step = self.last_report_step = self.state.step
        self._save()

    def run_to_end(self, progress: Callable[[Progress], None]) -> None:
        """Take the steps that are left."""
        state = self.state
        report: dict[str, float] = {}
        losses: list[float] = []
        while state.step < state.plan.steps:
            loss, gradient = self.workers.gradient(state.step)
            before = state.plan.at(state.step)
            norm = state.update(gradient, self.config.rate.at(state.step, before))
            if not math.isfinite(loss.likelihood) or not math.isfinite(norm):
                raise TrainingError(
                    f"{self.run}: the loss is no longer finite at step {state.step}; "
                    "lower the learning rate, or check the dataset for extreme values"
                )
            losses.append(loss.likelihood)
            after = state.plan.at(state.step)
            if _passes(before, after, _REPORTS) or _passes(before, after, self.config.evaluations):
                report = self._report(sum(losses) / len(losses), loss.location, before, after)
                losses.clear()
            if time.perf_counter() - self.last_save > self.save_interval:
                self._replan()
                self._save()
            progress(Progress(state.step, state.plan.steps, report))
        self._save()

    def _report(self, loss: float, location: float, before: float, after: float) -> dict[str, float]:
        now, state = time.perf_counter(), self.state
        labels = (state.step - self.last_report_step) * self.config.loss.labels(self.windows.config)
        values = {
            "step": state.step,
            "steps": state.plan.steps,
            "seconds": self._consumed(),
            "loss": loss,
            "location_loss": location,
            "rate": self.config.rate.at(state.step, after),
            "labels_per_second": labels / (now - self.last_report),
        }
        if _passes(before, after, self.config.evaluations):
            errors = held_out(state.average, self.validation, self.config.held_out_runs, self.position_scale)
            values |= {f"held_out_{name}": value for name, value in errors.items()}
        metrics.append(self.run, values)
        self.last_report, self.last_report_step = time.perf_counter(), state.step
        return values

    def _save(self) -> None:
        self.state.seconds = self._consumed()
        self.state.save(self.run / STATE_FOLDER)
        checkpoint.save(self.run, self.state.average)
        self.last_save = time.perf_counter()

    def _consumed(self) -> float:
        """Training time so far [s], that of earlier sessions included."""
        return self.seconds_before + time.perf_counter() - self.session_start

    def _replan(self) -> None:
        """With a budget of minutes, end when they are over even on a machine that has changed its pace."""
        taken = self.state.step - self.first_step
        if self.config.steps is None and taken > 0:
            pace = (time.perf_counter() - self.session_start) / taken
            self.state.plan = self.state.plan.revised(self.state.step, 60 * self.config.minutes - self._consumed(), pace)

    def _settle(self, policy: Policy, about: dict[str, Any]) -> tuple[Runtime, StepPlan]:
        """Runtime and plan: those recorded in the run that is there, or measured now and recorded."""
        config = self.config
        what = json.loads(json.dumps({**policy.description(), "train": asdict(config), **about}))
        if (self.run / checkpoint.CONFIG_FILE).exists():
            there = checkpoint.read_config(self.run)
            there = {**there, **Policy.described(there)}
            _require_same(self.run, there, what)
            return Runtime(**there["runtime"]), StepPlan(**there["plan"])
        runtime, plan = config.runtime or usual_runtime(config.loss.runs), StepPlan(config.steps or 1)
        if config.steps is None:
            candidates = [runtime] if config.runtime else candidate_runtimes(config.loss.runs)
            runtime, seconds = fastest_runtime(policy, self.windows, config.loss, config.seed, candidates)
            left = 60 * config.minutes - (time.perf_counter() - self.session_start)
            plan = StepPlan(max(1, round(left / seconds)))
        versions = {**installed_versions(), "torch": torch.__version__}
        settled = {"runtime": asdict(runtime), "plan": asdict(plan), "versions": versions}
        checkpoint.write_config(self.run, {"task": policy.inputs.task, **what, **settled})
        return runtime, plan


def _corrections(path: Path | None, of: EpisodeStore) -> list[EpisodeHeader]:
    """All episodes of the dataset of corrections, if there is one; `DatasetError` if their actions mean something else."""
    if path is None:
        return []
    store = EpisodeStore.open(path)
    for what in ("control", "robot"):
        have, wanted = getattr(store, what), getattr(of, what)
        if have != wanted:
            raise DatasetError(f"{path} was collected with {what} = {have!r}, not {wanted!r}; collect it again")
    return store.headers()


def fresh_policy(config: PolicyConfig, inputs: PolicyInputs, seed: int) -> Policy:
    """A policy with random weights, a function of the seed; the global random state is left as it was."""
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        return Policy(config, inputs)


def _passes(before: float, after: float, parts: int) -> bool:
    """Whether progress has passed a multiple of `1 / parts`."""
    return math.floor(after * parts + 1e-9) > math.floor(before * parts + 1e-9)


def _require_same(run: Path, there: dict[str, Any], wanted: dict[str, Any]) -> None:
    """`CheckpointError` naming the first setting in which the run that is there differs."""
    have, want = _flat(there), _flat(wanted)
    for key in sorted(want):
        if have.get(key) != want[key]:
            raise CheckpointError(
                f"{run} was started with {key} = {have.get(key)!r}, not {want[key]!r}; "
                "use the same settings and data, or another folder"
            )


def _flat(value: Any, prefix: str = "") -> dict[str, Any]:
    if not isinstance(value, dict) or not value:
        return {prefix: value}
    return {k: v for name, part in value.items() for k, v in _flat(part, f"{prefix}.{name}" if prefix else name).items()}
