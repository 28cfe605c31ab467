"""The trials: one episode from each initial state, in as many processes as there are."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import lru_cache, partial
from pathlib import Path

import numpy as np
import torch

from optimus.conditions import USUAL, Conditions
from optimus.data.episode import Episode
from optimus.data.episode_file import start_digest
from optimus.env import ManipulationEnv
from optimus.errors import CheckpointError, require_at_least
from optimus.evaluate.actors import environment, task_of, trained_robot
from optimus.evaluate.outcome import EvalReport, Outcome
from optimus.evaluate.start import Start, require_unseen
from optimus.evaluate.unfinished import Unfinished
from optimus.learn import checkpoint
from optimus.learn.agent import Component, PolicyAgent, trained_agent
from optimus.learn.sources import learned_starts
from optimus.robots import Robot
from optimus.rollout import rollout
from optimus.workers import finished


@lru_cache(maxsize=1)
def _agent(run: Path, weights: str, component: Component, compiled: bool) -> PolicyAgent:
    torch.set_num_threads(1)
    if checkpoint.weights_of(run) != weights:
        raise CheckpointError(f"{run} has been trained on meanwhile; evaluate it again when that is done")
    return trained_agent(run, component, compiled)


@lru_cache(maxsize=1)
def _learned(run: Path, weights: str) -> set[str]:
    return learned_starts(run)


@lru_cache(maxsize=1)
def _actors(
    run: Path,
    weights: str,
    component: Component,
    robot: Robot | None,
    task: str | None,
    objects: str | None,
    conditions: Conditions,
    compiled: bool,
) -> tuple[ManipulationEnv, PolicyAgent]:
    policy = _agent(run, weights, component, compiled)
    return environment(run, policy.policy.inputs, robot, task, objects, conditions), policy


class _Witness:
    """Remembers what the final state alone does not tell."""

    def __init__(self) -> None:
        self.held = False
        self.moved = 0.0
        self._last: np.ndarray | None = None

    def __call__(self, env: ManipulationEnv) -> None:
        state = env.state()
        self.held = self.held or state.held is not None
        recent = 0.0 if self._last is None else float(np.linalg.norm(state.tcp.pos - self._last))
        self.moved = 0.9 * self.moved + 0.1 * recent
        self._last = state.tcp.pos

    def cause(self, env: ManipulationEnv, episode: Episode) -> str:
        """Why the episode failed, in a few words; empty for a success."""
        if episode.success:
            return ""
        state = env.state()
        if state.held is not None:
            what = "still holding at the end"
        elif self.held and env.problem.paper_success(state):
            what = "put down on the goal, the hand still there"
        else:
            what = "dropped or put down off the goal" if self.held else "never grasped"
        return what + (", standing still" if self.moved < 0.001 else "")


def _evaluate_one(run: Path, start: Start, seed: int, asked: EvalReport, robot: Robot | None) -> Outcome:
    how = (asked.conditions, asked.compiled, asked.weights)
    episode, cause = play(run, start, seed, asked.component, lambda env: None, robot, *how)
    if start.state is None and start_digest(episode.initial_state) in _learned(run, asked.weights):
        raise CheckpointError(f"{run} has learned from the initial state of seed {start.seed}; evaluate with another --seed")
    return Outcome(
        seed=start.seed,
        success=episode.success,
        paper_success=bool(episode.info["paper_success"]),
        steps=len(episode),
        cause=cause,
        variant=str(episode.info["variant"]),
        draws=seed,
        mishap_at=episode.info["mishap_at"],
    )


def play(
    run: Path,
    start: Start,
    seed: int,
    component: Component = "sampled",
    watch: Callable[[ManipulationEnv], None] = lambda env: None,
    robot: Robot | None = None,
    conditions: Conditions = USUAL,
    compiled: bool = False,
    weights: str | None = None,
) -> tuple[Episode, str]:
    """One episode of the policy in `run`, and why it failed. A function of the arguments alone. `robot`: the one that it was
    trained with, needed only where that has no known name; `compiled`: as for `PolicyAgent`; `weights`: those that it is to have
    (`checkpoint.weights_of`), `CheckpointError` if it has others by now."""
    weights = weights or checkpoint.weights_of(run)
    env, agent = _actors(run, weights, component, robot, start.task, start.objects, conditions, compiled)
    options = None if start.state is None else {"state": start.state}
    observation, _ = env.reset(seed=start.seed, options=options)
    # the same answers whichever process plays this episode, and whatever it played before
    agent.reset(seed * 1_000_003 + start.seed)
    witness, mishap = _Witness(), conditions.mishap(start.seed)

    def all_of_them(env: ManipulationEnv) -> None:
        mishap(env)
        witness(env)
        watch(env)

    episode = rollout(env, observation, agent, run.name, watch=all_of_them)
    episode = replace(episode, info={**episode.info, "mishap_at": mishap.at})
    return episode, witness.cause(env, episode)


def evaluate(
    run: Path,
    starts: Sequence[Start],
    states: str,
    seed: int = 0,
    workers: int = 0,
    component: Component = "sampled",
    progress: Callable[[int, int], None] = lambda done, successes: None,
    robot: Robot | None = None,
    conditions: Conditions = USUAL,
    compiled: bool = False,
    keep: bool = False,
) -> EvalReport:
    """One episode from each start. The outcomes are the same for any number of workers. `robot`, `compiled`: as for `play`.

    With `keep`, what was found stays in the run's folder should this be interrupted, and the same evaluation goes on from it, until
    `EvalReport.write` has put the report there. `CheckpointError` if the policy has learned from one of the initial states.
    """
    require_at_least(0, seed=seed, workers=workers)
    trained_robot(run, robot)
    if not starts:
        raise CheckpointError("nothing to evaluate: no initial states")
    require_unseen(run, starts)
    task = task_of(checkpoint.read_config(run)["task"], starts[0].task, run)
    asked = EvalReport(task, states, (), conditions, component, seed, checkpoint.weights_of(run), compiled)
    unfinished = Unfinished(run, asked, starts) if keep else None
    outcomes = dict(unfinished.outcomes) if unfinished else {}
    left = [i for i in range(len(starts)) if i not in outcomes]
    jobs = [partial(_evaluate_one, run, starts[i], seed + i, asked, robot) for i in left]
    for job, outcome in finished(jobs, workers):
        outcomes[left[job]] = outcome
        if unfinished:
            unfinished.add(left[job], outcome)
        progress(len(outcomes), sum(o.success for o in outcomes.values()))
    return replace(asked, outcomes=tuple(outcomes[i] for i in range(len(starts))))
