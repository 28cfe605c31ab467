"""The evaluation protocol: a list of initial states, one episode each, k of n with an honest interval."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from functools import lru_cache, partial
from pathlib import Path
from typing import Any

import numpy as np
import torch

from optimus.conditions import USUAL, Conditions
from optimus.data.atomic import write_json, write_whole
from optimus.data.curate import load_curation
from optimus.data.episode import BINARY, CONTINUOUS, Episode
from optimus.data.store import EpisodeStore
from optimus.env import ManipulationEnv
from optimus.errors import CheckpointError, DatasetError
from optimus.learn import checkpoint
from optimus.learn.agent import Component, PolicyAgent
from optimus.learn.policy import PolicyInputs
from optimus.robots import Robot
from optimus.robots.catalogue import known_robots
from optimus.robots.catalogue import robot as robot_named
from optimus.rollout import rollout
from optimus.statistics import wilson
from optimus.tasks import task as task_named
from optimus.tasks import with_objects
from optimus.workers import finished

RANDOM_SEEDS_FROM = 10_000_000
"""Seeds of random initial states start here, far from those of any dataset."""


@dataclass(frozen=True)
class Outcome:
    """One evaluated episode."""

    seed: int
    success: bool
    paper_success: bool
    steps: int
    cause: str
    variant: str
    draws: int = 0
    """Seed of the policy's own draws."""
    mishap_at: int | None = None
    """Step at which what `Conditions.perturb` asks for happened; None if it did not."""


@dataclass(frozen=True)
class EvalReport:
    """What an evaluation found, in the order of its initial states."""

    task: str
    states: str
    outcomes: tuple[Outcome, ...]
    conditions: Conditions = USUAL

    @property
    def successes(self) -> int:
        return sum(o.success for o in self.outcomes)

    @property
    def episodes(self) -> int:
        return len(self.outcomes)

    def as_dict(self) -> dict[str, Any]:
        """JSON-able: counts, the Wilson 95 % interval, failures by cause, every outcome."""
        return {
            "task": self.task,
            "states": self.states,
            "conditions": asdict(self.conditions),
            "successes": self.successes,
            "episodes": self.episodes,
            "distinct_states": len({o.seed for o in self.outcomes}),
            "interval": list(wilson(self.successes, self.episodes)),
            "paper_rule_successes": sum(o.paper_success for o in self.outcomes),
            "failures": dict(Counter(o.cause for o in self.outcomes if not o.success)),
            "mishaps": sum(o.mishap_at is not None for o in self.outcomes),
            "outcomes": [asdict(o) for o in self.outcomes],
        }

    @property
    def lines(self) -> str:
        """The outcomes as JSON lines, one an episode, in the order of the initial states: the same text whoever played them."""
        return "".join(json.dumps(asdict(o)) + "\n" for o in self.outcomes)

    @property
    def file_name(self) -> str:
        """Of the report in a run's folder."""
        return "+".join(filter(None, [f"evaluation-{self.states}", self.conditions.said])) + ".json"

    def write(self, run: Path) -> None:
        """`RUN/evaluation-<states>[+<conditions>].json` with everything, and the outcomes beside it as `.jsonl`."""
        path = run / self.file_name
        write_whole(path.with_suffix(".jsonl"), self.lines.encode())
        write_json(path, self.as_dict())


@dataclass(frozen=True, eq=False)
class Start:
    """An initial state: a seed, and the physics state to start from where one was recorded."""

    seed: int
    state: np.ndarray | None = None
    objects: str | None = None
    """What to do the task with (see `optimus.tasks.task`); None: what the policy was trained with, empty: the task's own."""
    task: str | None = None
    """Of a policy of several tasks: which; None: its first."""


def validation_starts(dataset: Path, episodes: int) -> list[Start]:
    """The initial states of the validation demonstrations, then (if more are asked for) again from the first."""
    store, seeds = EpisodeStore.open(dataset), load_curation(dataset).validation
    if not seeds:
        raise DatasetError(f"{dataset} has no validation demonstrations; collect more, or evaluate with --states random")
    again = (seeds[i % len(seeds)] for i in range(episodes))
    return [Start(s, store.header(s).read("initial_state"), task=store.task) for s in again]


def random_starts(episodes: int, seed: int = 0, objects: str | None = None, task: str | None = None) -> list[Start]:
    """Fresh problems that no dataset holds, perhaps with other objects than the policy was trained with."""
    return [Start(RANDOM_SEEDS_FROM + seed * 100_000 + i, objects=objects, task=task) for i in range(episodes)]


def trained_robot(run: Path, asked: Robot | None = None) -> Robot | None:
    """The robot that the policy in `run` was trained with; None for the task's own. `CheckpointError` if another one is asked
    for, or none where only a robot file can tell."""
    inputs = checkpoint.load(run).inputs
    task = task_named(checkpoint.tasks_of(inputs.task)[0])
    if asked is None and inputs.robot in known_robots():
        asked = robot_named(inputs.robot)
    if task.robot_record(asked) != inputs.robot:
        have, wanted = task.robot_text(inputs.robot), task.robot_text(task.robot_record(asked))
        raise CheckpointError(f"{run} was trained with robot {have}, not {wanted}; name its own with --robot, or another run")
    return asked


def require_same_problems(run: Path, dataset: Path) -> None:
    """`DatasetError` if the states of `dataset` are those of another task or robot than the policy in `run` was trained with."""
    inputs, store = checkpoint.load(run).inputs, EpisodeStore.open(dataset)
    for what, have, fits in (
        ("task", store.task, checkpoint.tasks_of(inputs.task)),
        ("robot", store.robot, (inputs.robot,)),
    ):
        if have not in fits:
            wanted = " and ".join(map(repr, fits))
            raise DatasetError(f"{dataset} was collected with {what} = {have!r}, {run} trained with {wanted}; name another")


def policy_folder(run: Path, which: str) -> Path:
    """The run folder of the `last` or the `best` checkpoint of `run`; `CheckpointError` if that one has not been written."""
    folder = run / checkpoint.BEST_FOLDER if which == "best" else run
    checkpoint.read_config(folder)
    return folder


@lru_cache(maxsize=1)
def _agent(run: Path, component: Component, compiled: bool) -> PolicyAgent:
    torch.set_num_threads(1)
    return agent(run, component, compiled)


@lru_cache(maxsize=1)
def _actors(
    run: Path,
    component: Component,
    robot: Robot | None,
    task: str | None,
    objects: str | None,
    conditions: Conditions,
    compiled: bool,
) -> tuple[ManipulationEnv, PolicyAgent]:
    policy = _agent(run, component, compiled)
    return environment(run, policy.policy.inputs, robot, task, objects, conditions), policy


def agent(run: Path, component: Component = "sampled", compiled: bool = False) -> PolicyAgent:
    """The policy of that run folder, ready to act; its gripper moves as in the demonstrations that it was trained on."""
    return PolicyAgent(run, component if _gripper(run) == BINARY else CONTINUOUS, compiled=compiled)


def environment(
    run: Path,
    inputs: PolicyInputs,
    robot: Robot | None = None,
    task: str | None = None,
    objects: str | None = None,
    conditions: Conditions = USUAL,
) -> ManipulationEnv:
    """Where the policy of that run folder and of those inputs acts: its task, its control, its gripper, and the images or the
    positions that it was trained on. `task` and `objects` as `Start` takes them."""
    name = with_objects(_task_of(inputs.task, task, run), objects)
    return ManipulationEnv(
        conditions.of(task_named(name)),
        images=not inputs.told,
        control=inputs.control,
        robot=trained_robot(run, robot),
        positions=inputs.told,
        gripper=_gripper(run),
        worlds=conditions.world,
    )


def _gripper(run: Path) -> str:
    """How the gripper moved in the demonstrations that the policy of that run folder was trained on."""
    return checkpoint.read_config(run).get("dataset", {}).get("config", {}).get("gripper", BINARY)


def _task_of(trained: str, asked: str | None, run: Path) -> str:
    """Which task to do, the first where none is asked for; `CheckpointError` if the policy was not trained for it."""
    known = checkpoint.tasks_of(trained)
    if asked is not None and asked not in known:
        raise CheckpointError(f"{run} was trained for {', '.join(known)}, not for {asked!r}; name one of these")
    return asked or next(iter(known))


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
        else:
            what = "dropped or put down off the goal" if self.held else "never grasped"
        return what + (", standing still" if self.moved < 0.001 else "")


def _evaluate_one(
    run: Path, start: Start, seed: int, component: Component, robot: Robot | None, conditions: Conditions, compiled: bool
) -> Outcome:
    episode, cause = play(run, start, seed, component, robot=robot, conditions=conditions, compiled=compiled)
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
) -> tuple[Episode, str]:
    """One episode of the policy in `run`, and why it failed. A function of the arguments alone. `robot`: the one that it was
    trained with, needed only where that has no known name; `compiled`: as for `PolicyAgent`."""
    env, agent = _actors(run, component, robot, start.task, start.objects, conditions, compiled)
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
) -> EvalReport:
    """One episode from each start. The outcomes are the same for any number of workers. `robot`, `compiled`: as for `play`."""
    trained_robot(run, robot)
    if not starts:
        raise CheckpointError("nothing to evaluate: no initial states")
    task = _task_of(checkpoint.read_config(run)["task"], starts[0].task, run)
    outcomes: dict[int, Outcome] = {}
    how = (component, robot, conditions, compiled)
    jobs = [partial(_evaluate_one, run, start, seed + i, *how) for i, start in enumerate(starts)]
    for i, outcome in finished(jobs, workers):
        outcomes[i] = outcome
        progress(len(outcomes), sum(o.success for o in outcomes.values()))
    return EvalReport(task, states, tuple(outcomes[i] for i in range(len(starts))), conditions)
