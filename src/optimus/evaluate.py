"""The evaluation protocol: a list of initial states, one episode each, k of n with an honest interval."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from functools import lru_cache, partial
from pathlib import Path
from typing import Any

import numpy as np
import torch

from optimus.data.atomic import write_whole
from optimus.data.curate import load_curation
from optimus.data.episode import OBJECT_POSITIONS, Episode
from optimus.data.store import EpisodeStore
from optimus.env import ManipulationEnv
from optimus.errors import CheckpointError, DatasetError
from optimus.learn import checkpoint
from optimus.learn.agent import Component, PolicyAgent
from optimus.robots import Robot
from optimus.robots.catalogue import known_robots
from optimus.robots.catalogue import robot as robot_named
from optimus.rollout import rollout
from optimus.show import Film, png
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


@dataclass(frozen=True)
class EvalReport:
    """What an evaluation found, in the order of its initial states."""

    task: str
    states: str
    outcomes: tuple[Outcome, ...]

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
            "successes": self.successes,
            "episodes": self.episodes,
            "distinct_states": len({o.seed for o in self.outcomes}),
            "interval": list(wilson(self.successes, self.episodes)),
            "paper_rule_successes": sum(o.paper_success for o in self.outcomes),
            "failures": dict(Counter(o.cause for o in self.outcomes if not o.success)),
            "outcomes": [asdict(o) for o in self.outcomes],
        }


@dataclass(frozen=True, eq=False)
class Start:
    """An initial state: a seed, and the physics state to start from where one was recorded."""

    seed: int
    state: np.ndarray | None = None
    objects: str | None = None
    """What to do the task with (see `optimus.tasks.task`); None: what the policy was trained with."""
    task: str | None = None
    """Of a policy of several tasks: which; None: its first."""


def validation_starts(dataset: Path, episodes: int) -> list[Start]:
    """The initial states of the validation demonstrations, then (if more are asked for) again from the first."""
    store, seeds = EpisodeStore.open(dataset), load_curation(dataset).validation
    if not seeds:
        raise DatasetError(f"{dataset} has no validation demonstrations; collect more, or evaluate with --states random")
    state = lambda seed: store.header(seed).read("initial_state")  # noqa: E731
    return [Start(s, state(s), task=store.task) for s in (seeds[i % len(seeds)] for i in range(episodes))]


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
    for what in ("task", "robot"):
        have, wanted = getattr(store, what), getattr(inputs, what)
        if have != wanted and have not in checkpoint.tasks_of(wanted):
            raise DatasetError(f"{dataset} was collected with {what} = {have!r}, {run} trained with {wanted!r}; name another")


@lru_cache(maxsize=1)
def _actors(
    run: Path, component: Component, robot: Robot | None, objects: str | None, task: str | None
) -> tuple[ManipulationEnv, PolicyAgent]:
    torch.set_num_threads(1)
    agent = PolicyAgent(run, component)
    inputs = agent.policy.inputs
    name = with_objects(task or checkpoint.tasks_of(inputs.task)[0], objects)
    told = OBJECT_POSITIONS in inputs.proprioception
    arm = trained_robot(run, robot)
    return ManipulationEnv(task_named(name), images=not told, control=inputs.control, robot=arm, positions=told), agent


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


def _evaluate_one(run: Path, start: Start, seed: int, component: Component, robot: Robot | None) -> Outcome:
    episode, cause = play(run, start, seed, component, robot=robot)
    return Outcome(
        seed=start.seed,
        success=episode.success,
        paper_success=bool(episode.info["paper_success"]),
        steps=len(episode),
        cause=cause,
        variant=str(episode.info["variant"]),
    )


def play(
    run: Path,
    start: Start,
    seed: int,
    component: Component = "sampled",
    watch: Callable[[ManipulationEnv], None] = lambda env: None,
    robot: Robot | None = None,
) -> tuple[Episode, str]:
    """One episode of the policy in `run`, and why it failed. A function of the arguments alone. `robot`: the one that it was
    trained with, needed only where that has no known name."""
    env, agent = _actors(run, component, robot, start.objects, start.task)
    options = None if start.state is None else {"state": start.state}
    observation, _ = env.reset(seed=start.seed, options=options)
    # the same answers whichever process plays this episode, and whatever it played before
    agent.reset(seed * 1_000_003 + start.seed)
    witness = _Witness()

    def both(env: ManipulationEnv) -> None:
        witness(env)
        watch(env)

    episode = rollout(env, observation, agent, run.name, watch=both)
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
) -> EvalReport:
    """One episode from each start. The outcomes are the same for any number of workers. `robot`: as for `play`."""
    trained_robot(run, robot)
    if not starts:
        raise CheckpointError("nothing to evaluate: no initial states")
    task = starts[0].task or checkpoint.read_config(run)["task"]
    outcomes: dict[int, Outcome] = {}
    jobs = [partial(_evaluate_one, run, start, seed + i, component, robot) for i, start in enumerate(starts)]
    for i, outcome in finished(jobs, workers):
        outcomes[i] = outcome
        progress(len(outcomes), sum(o.success for o in outcomes.values()))
    return EvalReport(task, states, tuple(outcomes[i] for i in range(len(starts))))


@dataclass(frozen=True)
class FilmedEpisode:
    """An episode to look at."""

    caption: str
    video: Path
    strip: Path
    success: bool
    cause: str = ""


def film_outcomes(
    run: Path,
    starts: Sequence[Start],
    report: dict[str, Any],
    seed: int,
    component: Component,
    folder: Path,
    robot: Robot | None = None,
    each: int = 3,
) -> list[FilmedEpisode]:
    """Films (MP4, and a PNG strip) of the first few successes, and of failures of every cause. The episodes are played again: they
    are functions of their seeds."""
    films = []
    for success in (True, False):
        for i in worth_filming(report["outcomes"], success, each):
            outcome, film = report["outcomes"][i], Film()
            play(run, starts[i], seed + i, component, film, robot)
            path = folder / f"{'success' if success else 'failure'}-{i:03d}-{outcome['seed']}.mp4"
            film.write(path)
            write_whole(path.with_suffix(".png"), png(film.strip()))
            named = f"seed {outcome['seed']} {outcome['variant']}".strip()
            caption = f"{named}: {'success' if success else outcome['cause']}"
            films.append(FilmedEpisode(caption, path, path.with_suffix(".png"), success, outcome["cause"]))
    return films


def worth_filming(outcomes: Sequence[dict[str, Any]], success: bool, each: int) -> list[int]:
    """Indices of `each` outcomes; of failures one of every cause first, however many causes there are."""
    seen: Counter[str] = Counter()
    ranked = []
    for i, outcome in enumerate(outcomes):
        if outcome["success"] is success:
            ranked.append((seen[outcome["cause"]], i))
            seen[outcome["cause"]] += 1
    return [i for _, i in sorted(ranked)[: max(each, len(seen))]]
