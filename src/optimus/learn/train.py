"""Behaviour cloning: curated datasets to a trained policy, within a number of steps, epochs or minutes.

    RUN/config.json          what is trained, on what, how; versions; the runtime and steps that were settled
    RUN/model.safetensors    the policy: the running average of the weights, normalisation included
    RUN/best/                the same of the step with the lowest held-out action error
    RUN/train_state/         what training goes on from
    RUN/metrics.jsonl        one line a report: loss, rate, labels a second, held-out errors
    RUN/tensorboard/         the same for TensorBoard

A run that was killed goes on where its last checkpoint was; unless it goes by the clock, it ends on a CPU with the very same
weights. Started by `torchrun`, several processes train one policy.
"""

from __future__ import annotations

import json
import math
import time
from collections.abc import Callable, Sequence
from contextlib import nullcontext
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

import torch

from optimus.data.atomic import make_folder
from optimus.data.lock import locked
from optimus.data.store import installed_versions, require_no_dataset
from optimus.errors import CheckpointError, OptimusError
from optimus.learn import checkpoint, metrics
from optimus.learn.batches import source_on
from optimus.learn.begun import require_same, require_same_inputs, train_described
from optimus.learn.board import Board, BoardName, board, require_board
from optimus.learn.card import write_card
from optimus.learn.gradient import GradientWorkers, Runtime, candidate_runtimes, fastest_runtime, usual_runtime
from optimus.learn.heldout import held_out
from optimus.learn.policy import Policy, PolicyConfig, PolicyInputs
from optimus.learn.ranks import Ranks, joined
from optimus.learn.recipe import TrainConfig
from optimus.learn.schedule import StepPlan
from optimus.learn.sources import SPLIT, STARTS, Lessons, Sources
from optimus.learn.state import TrainState

STATE_FOLDER = "train_state"
_REPORTS = 200  # lines of metrics over a run
_SAVING = 0.05  # share of the time, at most, that goes into checkpoints on the way
_ERROR = "held_out_action_error"  # decides which policy is the best


class TrainingError(OptimusError):
    """A training run that cannot go on."""


@dataclass(frozen=True)
class Progress:
    """Where a run is."""

    step: int
    steps: int
    metrics: dict[str, float]
    """The newest report; empty before the first."""


def train(
    dataset: Path | str | Sequence[Path],
    run: Path | str,
    config: TrainConfig | None = None,
    policy: PolicyConfig | None = None,
    progress: Callable[[Progress], None] | None = None,
    corrections: Path | str | Sequence[Path] = (),
    initial: Path | str | None = None,
    watch: BoardName = "tensorboard",
) -> Policy:
    """Train a policy on the curated dataset `dataset`, or on several, into the folder `run`, or go on with what is there.

    `corrections` are further datasets, all of which is trained on; `initial` is a run folder whose weights to begin with, instead
    of random ones. The policy returned is the running average, as saved. `progress` is called after every step, and what it raises
    ends the session, after a checkpoint; `watch` says where the figures go besides `metrics.jsonl`.
    """
    sources = Sources(_paths(dataset), _paths(corrections), Path(initial) if initial else None)
    config = config or TrainConfig()
    with joined(config.device) as ranks:
        if config.by_the_clock and ranks.count > 1:
            raise TrainingError(
                "several processes train for steps or epochs, not for minutes: their clocks differ; give --steps or --epochs"
            )
        require_board(watch)
        require_no_dataset(Path(run))
        with locked(Path(run)) if ranks.first else nullcontext():
            trainer = _Trainer(sources, Path(run), config, policy or PolicyConfig(), ranks)
            trainer.board = board(watch if ranks.first else "none", Path(run), trainer.state.step)
            try:
                trainer.run_to_end(progress or (lambda _: None))
            finally:
                trainer.close()
        return trainer.state.average.eval().cpu()


def _paths(given: Path | str | Sequence[Path]) -> tuple[Path, ...]:
    return (Path(given),) if isinstance(given, (str, Path)) else tuple(map(Path, given))


class _Trainer:
    def __init__(self, sources: Sources, run: Path, config: TrainConfig, policy_config: PolicyConfig, ranks: Ranks) -> None:
        self.run, self.config, self.ranks = run, config, ranks
        self.board: Board
        self.session_start = self.last_save = self.last_report = self.last_plan = time.perf_counter()
        self.first_taken = math.inf  # when the first step of the session had been: opening and compiling is not its pace
        # Often enough that a short budget of minutes is still kept to.
        self.plan_interval = 60 * config.minutes / 20 if config.by_the_clock else math.inf
        self.save_interval = self.least_save_interval = min(config.checkpoint_seconds, self.plan_interval)
        begun = checkpoint.load(sources.initial) if sources.initial else None
        policy_config = begun.config if begun else policy_config
        cut = policy_config.cut(config.windows, config.change_weight, config.change_reach)
        ranks.agree(None)  # only now may the others look: the first one curates before it comes here
        lessons = Lessons.of(sources, cut, config.demonstrations)
        if ranks.agree(split := lessons.about[SPLIT]) != split:
            raise TrainingError(f"process {ranks.rank} found other episodes than the first one; leave the data alone meanwhile")
        self.windows, self.validation, self.position_scale = lessons.train, lessons.validation, lessons.position_scale
        inputs = PolicyInputs.of(lessons.task, self.windows, policy_config.aims)
        policy = begun.train() if begun else fresh_policy(policy_config, inputs, config.seed)
        if begun and sources.initial:
            require_same_inputs(begun, inputs, sources.initial)
            lessons.require_new_to(sources.initial)
        else:
            policy.fit_normalisation(self.windows)
        policy.to(ranks.device)
        source = source_on(self.windows, ranks.device)
        measure = lambda among: fastest_runtime(policy, source, config.loss, config.seed, among)  # noqa: E731
        settled = self._settle(policy, {"dataset": lessons.about}, measure) if ranks.first else None
        settled = ranks.agree(settled)
        runtime, plan = Runtime(**settled["runtime"]), StepPlan(**settled["plan"])
        self.workers = GradientWorkers(policy, source, config.loss, runtime, config.seed, ranks)
        self.state = TrainState(policy, config.optimiser, plan)
        if ranks.first:
            if not self.state.restore(run / STATE_FOLDER):  # from the start, perhaps where another training's state was removed
                checkpoint.forget_best(run)
            metrics.forget_after(run, self.state.step)
        self.state.share(ranks)
        self.seconds_before = self.state.seconds
        self.first_step = self.last_report_step = self.state.step
        self.best = metrics.lowest(run, _ERROR)
        self._save()

    def close(self) -> None:
        """End the threads, and what the board still has to write."""
        self.workers.close()
        self.board.close()

    def run_to_end(self, progress: Callable[[Progress], None]) -> None:
        """Take the steps that are left."""
        state = self.state
        report: dict[str, float] = {}
        losses: list[tuple[float, float]] = []
        while state.step < state.plan.steps:
            found, gradient = self.workers.gradient(state.step)
            before = state.plan.at(state.step)
            norms = state.update(gradient, self.config.rate.at(state.step, before))
            likelihood, location, *lengths = torch.cat([found, norms]).tolist()  # the one time that a GPU is waited for
            if not all(map(math.isfinite, (likelihood, *lengths))):
                raise TrainingError(
                    f"{self.run}: the loss is no longer finite at step {state.step}; "
                    "lower the learning rate, or check the dataset for extreme values"
                )
            losses.append((likelihood, location))
            after = state.plan.at(state.step)
            if _passes(before, after, _REPORTS) or _passes(before, after, self.config.evaluations):
                loss, location = (sum(column) / len(losses) for column in zip(*losses, strict=True))
                report = self._report(loss, location, before, after)
                losses.clear()
            now = time.perf_counter()
            self.first_taken = min(self.first_taken, now)
            if now - self.last_plan > self.plan_interval:
                self._replan(now)
            if now - self.last_save > self.save_interval:
                self._save()
            try:
                progress(Progress(state.step, state.plan.steps, report))
            except BaseException:
                self._save()
                raise
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
        measure = self.ranks.first and _passes(before, after, self.config.evaluations)
        if measure:
            errors = held_out(state.average, self.validation, self.config.held_out_runs, self.position_scale)
            values |= {f"held_out_{name}": value for name, value in errors.items()}
        if self.ranks.first:
            metrics.append(self.run, values)
            self.board.add(values)
        if measure and (self.best is None or values[_ERROR] < self.best[_ERROR]):
            self.best = values
            self._save()
        self.last_report, self.last_report_step = time.perf_counter(), state.step
        return values

    def _save(self) -> None:
        """Write the state, then the policy, then the best one if it is this: killed in between, it is made good on the way in."""
        self.last_save, self.state.seconds = time.perf_counter(), self._consumed()
        if not self.ranks.first:
            return
        self._write()
        written = time.perf_counter()
        if self.least_save_interval > 0:
            # of a large policy a state is hundreds of megabytes: no more than a share of the time goes into writing them
            self.save_interval = max(self.least_save_interval, (written - self.last_save) / _SAVING)
        self.last_save = written

    def _write(self) -> None:
        self.state.save(self.run / STATE_FOLDER)
        checkpoint.save(self.run, self.state.average)
        best = self.best
        if best is not None and best["step"] == self.state.step != checkpoint.best_step(self.run):
            checkpoint.save_best(self.run, self.state.average, self.state.step, best[_ERROR])
        write_card(self.run)

    def _consumed(self) -> float:
        """Training time so far [s], that of earlier sessions included."""
        return self.seconds_before + time.perf_counter() - self.session_start

    def _replan(self, now: float) -> None:
        """With a budget of minutes, end when they are over even on a machine that has changed its pace."""
        self.last_plan = now
        taken = self.state.step - self.first_step - 1
        if taken > 0:
            pace = (now - self.first_taken) / taken
            self.state.plan = self.state.plan.revised(self.state.step, 60 * self.config.minutes - self._consumed(), pace)

    def _settle(
        self, policy: Policy, about: dict[str, Any], measure: Callable[[list[Runtime]], tuple[Runtime, float]]
    ) -> dict[str, Any]:
        """Runtime and plan, JSON-able: those recorded in the run that is there, or measured now and recorded."""
        config, ranks = self.config, self.ranks
        make_folder(self.run)
        what = json.loads(json.dumps({**policy.description(), "train": asdict(config), **about}))
        if (self.run / checkpoint.CONFIG_FILE).exists():
            there = checkpoint.read_config(self.run)
            there = {**there, **Policy.described(there), "train": train_described(there["train"])}
            kept = {key: about["dataset"][key] for key in (SPLIT, STARTS)}  # earlier versions did not
            there["dataset"] = {**kept, **there.get("dataset", {})}
            require_same(self.run, there, what)
            usual = asdict(Runtime(**there["runtime"]))
            for name, have in (("processes", ranks.count), ("device", ranks.device.type)):
                if usual[name] != have:
                    raise CheckpointError(f"{self.run} was started with {name} = {usual[name]!r}, not {have!r}; start it so again")
            return {"runtime": usual, "plan": there["plan"]}
        usual = config.runtime or usual_runtime(config.loss.runs, ranks.device.type, config.accumulate, ranks)
        runtime = usual if config.half is None else replace(usual, half=config.half)
        runtime = replace(runtime, compiled=runtime.compiled and policy.config.encoder.compiled)
        steps = config.steps_over(self.windows.labels, config.loss.labels(self.windows.config))
        if steps is None:
            measured = config.runtime is None and config.half is None and ranks.device.type == "cpu"
            runtime, seconds = measure(candidate_runtimes(runtime) if measured else [runtime])
            left = 60 * config.minutes - (time.perf_counter() - self.session_start)
            steps = max(1, round(left / seconds))
        plan = StepPlan(steps)
        settled = {"parameters": policy.parameter_count, "runtime": asdict(runtime), "plan": asdict(plan)}
        settled["versions"] = installed_versions()
        checkpoint.write_config(self.run, {"task": policy.inputs.task, **what, **settled})
        return settled


def fresh_policy(config: PolicyConfig, inputs: PolicyInputs, seed: int) -> Policy:
    """A policy with random weights, a function of the seed; the global random state is left as it was."""
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        return Policy(config, inputs)


def _passes(before: float, after: float, parts: int) -> bool:
    """Whether progress has passed a multiple of `1 / parts`."""
    return math.floor(after * parts + 1e-9) > math.floor(before * parts + 1e-9)
