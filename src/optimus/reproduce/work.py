"""What fills the cells of a table: a policy that is trained and tried, the expert that is tried, or somebody's time per action.

A piece of work gives its measurements by name; the one without a name is what the paper's figure stands beside.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

from optimus.bench import BenchConfig
from optimus.bench.expert import bench_expert
from optimus.bench.policy import bench_policy_action
from optimus.conditions import USUAL, Conditions
from optimus.data.atomic import make_folder, read_record, write_json
from optimus.data.episode import OSC
from optimus.reproduce.lesson import Data, Lesson, Trial, options
from optimus.reproduce.site import Site, commit, machine
from optimus.reproduce.timing import expert_time
from optimus.statistics import wilson
from optimus.words import slug

Measurement = dict[str, Any]
"""A rate (`successes`, `episodes`, `interval`, ...) or a time (`seconds`), JSON-able."""

USUAL_TRIALS = (Trial("", "validation"), Trial("best checkpoint", "validation", which="best"), Trial("random starts", "random"))
EXPERT_SEED = 7000
"""Of the expert's first trial: no dataset of a reproduction begins there, nor do random starts."""


class Work(Protocol):
    """Fills one cell."""

    def do(self, site: Site) -> dict[str, Measurement]:
        """The measurements by name, as far as they are not there yet."""
        ...

    def ahead(self, site: Site) -> tuple[Callable[[], object], Callable[[], object]]:
        """What may be done before: first what takes cores, then what takes a GPU. `do` does whatever of it is not done."""
        ...

    def commands(self, site: Site) -> list[str]:
        """The same by hand."""
        ...

    def machine(self, site: Site) -> dict[str, Any]:
        """What it was done on."""
        ...


class _NothingAhead:
    """Work that is done in one piece, here."""

    def machine(self, site: Site) -> dict[str, Any]:
        return machine()

    def ahead(self, site: Site) -> tuple[Callable[[], object], Callable[[], object]]:
        return lambda: None, lambda: None


@dataclass(frozen=True)
class PolicyWork:
    """A policy of each seed, tried in all the ways that are named."""

    lesson: Lesson
    trials: tuple[Trial, ...] = USUAL_TRIALS

    def do(self, site: Site) -> dict[str, Measurement]:
        seeds = range(site.seed, site.seed + site.budget.seeds)
        for seed in seeds:
            self.lesson.learn(site, seed)
        return {t.name: _pooled([self.lesson.tried(site, seed, t) for seed in seeds]) for t in self.trials}

    def machine(self, site: Site) -> dict[str, Any]:
        return self.lesson.machine(site, site.seed)

    def ahead(self, site: Site) -> tuple[Callable[[], object], Callable[[], object]]:
        seeds = range(site.seed, site.seed + site.budget.seeds)
        return lambda: self.lesson.collect(site), lambda: [self.lesson.learn(site, seed) for seed in seeds]

    def commands(self, site: Site) -> list[str]:
        found = [command for data in self.lesson.datasets for command in data.commands(site)]
        for seed in range(site.seed, site.seed + site.budget.seeds):
            found += [self.lesson.train_command(site, seed), *(t.command(site, self.lesson, seed) for t in self.trials)]
        return found


@dataclass(frozen=True)
class ExpertWork(_NothingAhead):
    """The planner and its controller, tried as policies are: without images, told the simulated state."""

    task: str
    control: str = OSC
    conditions: tuple[tuple[str, Conditions], ...] = (("", USUAL),)
    """Name -> what it is tried under."""

    def do(self, site: Site) -> dict[str, Measurement]:
        return {name: self._tried(site, conditions) for name, conditions in self.conditions}

    def _tried(self, site: Site, conditions: Conditions) -> Measurement:
        """Under these conditions; what an earlier call of the same commit measured is read."""
        stage = f"expert {self.task} {self.control} {conditions.said}".strip()
        file, of, n = site.out / "expert" / f"{slug(stage)}.json", commit(), site.budget.expert_episodes
        if file.exists() and (known := read_record(file))["commit"] == of:
            return known["measured"]
        config = BenchConfig(self.task, n, EXPERT_SEED, site.workers, self.control, conditions=conditions)
        with site.timed(stage):
            result = bench_expert(config, lambda done, k: site.progress(stage, done, n, {}))
        kept = ("successes", "episodes", "interval", "paper_rule_successes", "plan_seconds", "failures", "retries", "mishaps")
        measured = {**{key: result[key] for key in kept if key in result}, "distinct_states": n}
        make_folder(file.parent)
        write_json(file, {"commit": of, "measured": measured})
        return measured

    def commands(self, site: Site) -> list[str]:
        asked = f"--episodes {site.budget.expert_episodes} --seed {EXPERT_SEED} --control {self.control}"
        return [f"optimus bench expert {self.task} {asked}{options(c)} --json" for _, c in self.conditions]


@dataclass(frozen=True)
class ExpertTime(_NothingAhead):
    """The expert's time per action on a task: what it plans up front shared out over the actions, and its controller's."""

    task: str

    def do(self, site: Site) -> dict[str, Measurement]:
        with site.timed(f"time of the expert, {self.task}"):
            return expert_time(self.task, site.budget.timing_episodes, EXPERT_SEED)

    def commands(self, site: Site) -> list[str]:
        return []


@dataclass(frozen=True)
class PolicyTime(_NothingAhead):
    """A network's time per action on one thread, frames to action: encoding the newest frame, the whole window, and compiled."""

    preset: str

    def do(self, site: Site) -> dict[str, Measurement]:
        with site.timed(f"time of {self.preset}"):
            result = bench_policy_action(self.preset, 10 * site.budget.timing_rounds, site.seed, True, lambda done, k: None)
        shared = {"parameters": result["parameters"], "threads": 1}
        names = {"newest_frame": "", "plain": "whole window", "compiled": "compiled"}
        spent = {names[way]: q for way, q in result["action_ms"].items()}
        return {n: {"seconds": q["median"] / 1e3, "p95": q["p95"] / 1e3, **shared} for n, q in spent.items()}

    def commands(self, site: Site) -> list[str]:
        return [f"optimus bench action --preset {self.preset} --rounds {site.budget.timing_rounds} --json"]


def _pooled(reports: list[Measurement]) -> Measurement:
    """The trials of all seeds together."""
    k, n = (sum(r[key] for r in reports) for key in ("successes", "episodes"))
    causes: dict[str, int] = {}
    for cause, count in (item for r in reports for item in r["failures"].items()):
        causes[cause] = causes.get(cause, 0) + count
    return {
        "successes": k,
        "episodes": n,
        "interval": list(wilson(k, n)),
        "by_seed": [r["successes"] for r in reports],
        "states": reports[0]["states"],
        "distinct_states": len({outcome["seed"] for r in reports for outcome in r["outcomes"]}),
        "paper_rule_successes": sum(r["paper_rule_successes"] for r in reports),
        "mishaps": sum(r["mishaps"] for r in reports),
        "failures": causes,
    }


__all__ = ["Data", "ExpertTime", "ExpertWork", "Lesson", "PolicyTime", "PolicyWork", "Trial", "Work"]
