"""One demonstration: plan, carry the plan out in physics, perhaps pushed off its path now and then."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal, get_args

import numpy as np

from optimus.closed_loop import ALONE, SHARED, ClosedLoop
from optimus.conditions import Conditions, Mishap
from optimus.data.episode import MISHAP, Episode, Observation
from optimus.env import ManipulationEnv
from optimus.errors import OptimusError
from optimus.expert import TimeLaw
from optimus.missed import MissedGrasp
from optimus.motion.plan import Infeasible, Plan
from optimus.planner import Budget, solve
from optimus.rollout import Meddler, Perturbation, Pushes, rollout
from optimus.skills import Style, Workspace
from optimus.validate import validate

MishapKind = Literal["push", "slip", "miss"]
MISHAPS: tuple[MishapKind, ...] = get_args(MishapKind)
"""`push` and `slip` happen to things (`optimus.conditions`), `miss` to the hand (`optimus.missed`)."""

INVALID = "invalid plan"
"""How the failure of an attempt begins whose plan did not stand up to the check."""


_BEFORE: dict[str, float] = {"hesitations": 0.0, "tremble_tilt": 0.0, "shove_tilt": 0.0, "overshoots": 0.0, "steady": 0.0}
"""What an earlier version's perturbation had none of."""


@dataclass(frozen=True)
class ExpertConfig:
    """Everything about how the expert plans and moves."""

    style: Style = field(default_factory=Style)
    law: TimeLaw = field(default_factory=TimeLaw)
    budget: Budget = field(default_factory=Budget)
    perturbation: Perturbation | None = None
    check: bool = False
    """Have every plan validated before it is carried out; an invalid one is a failure."""
    mishaps: float = 0.0
    """Share of the episodes in which a thing is pushed or slips, as `optimus.conditions` does it, or a grasp misses."""

    def __post_init__(self) -> None:
        if not 0.0 <= self.mishaps <= 1.0:
            raise OptimusError(f"mishaps happen in a share of 0 to 1 of the episodes, not in {self.mishaps}")

    @classmethod
    def from_json(cls, value: Mapping[str, Any]) -> ExpertConfig:
        """The inverse of `dataclasses.asdict`, from parsed JSON."""
        pushed = value["perturbation"]
        return cls(
            Style(**value["style"]),
            TimeLaw(**value["law"]),
            Budget(**value["budget"]),
            None if pushed is None else Perturbation(**{**_BEFORE, **pushed}),
            value.get("check", False),
            value.get("mishaps", 0.0),
        )

    def mishap(self, seed: int) -> MishapKind | None:
        """What is going to happen in the episode of that seed: perhaps nothing."""
        rng = np.random.default_rng([seed, 5])
        happens = rng.random() < self.mishaps
        return MISHAPS[int(rng.integers(len(MISHAPS)))] if happens else None


@dataclass(frozen=True, eq=False)
class Planned:
    """A plan or why there is none, and what planning again would go on with."""

    plan: Plan | Infeasible
    workspace: Workspace
    rng: np.random.Generator
    seconds: float
    """CPU time."""


@dataclass(frozen=True, eq=False)
class Attempt:
    """What came of one seed: an episode (also a failed one), or no plan and why."""

    seed: int
    episode: Episode | None
    failure: str
    plan_seconds: float
    """CPU time."""
    info: dict[str, Any]
    tracking: list[float] = field(default_factory=list)
    """Distance of the tcp from the planned path at each step of motion [m]."""

    @property
    def variant(self) -> str:
        """The branch of the task that the seed drew, or the kind of its object; empty where there is only one."""
        return str(self.info.get("variant", ""))

    @property
    def retries(self) -> list[str]:
        """Why it planned again, each time."""
        return self.info.get("retried_because", [])

    @property
    def success(self) -> bool:
        return self.episode is not None and self.episode.success


def plan_for(env: ManipulationEnv, seed: int, config: ExpertConfig) -> Planned:
    """The expert's plan for the problem of `seed`, to which `env` has been reset."""
    began, rng = time.process_time(), np.random.default_rng([seed, 1])
    workspace = Workspace(env.world, config.style)
    plan = solve(workspace, env.state(), env.problem.goal, rng, config.budget)
    return Planned(plan, workspace, rng, time.process_time() - began)


def demonstrate(
    env: ManipulationEnv,
    seed: int,
    config: ExpertConfig,
    meddler: Callable[[np.random.Generator], Meddler] | None = None,
    mishap: Mishap | None = None,
) -> Attempt:
    """Reset `env` to the problem of `seed`, plan, and carry the plan out. A function of the arguments alone.

    `meddler(rng)` makes what has a hand in the execution; by default the perturbation of `config`, if it has one.
    `mishap` changes the world; by default, that of `config` for this seed, which may be a grasp that misses. With any of them, the
    expert looks whether things still are where its plan supposes them.
    """
    kind: MishapKind | None = mishap.kind if mishap is not None else config.mishap(seed)
    mishap = mishap or Conditions(None if kind == "miss" else kind).mishap(seed)
    observation, info = env.reset(seed=seed)
    if env.problem.success(env.state()):
        return Attempt(seed, None, "nothing to do: the goal is met at the start", 0.0, {"variant": info["variant"]})
    planned, pushing = plan_for(env, seed, config), np.random.default_rng([seed, 2])
    plan, seconds = planned.plan, planned.seconds
    if isinstance(plan, Infeasible):
        return Attempt(seed, None, f"no plan: {plan}", seconds, {"variant": info["variant"]})
    wrong = validate(plan, env.world.scene, env.problem.goal, config.law) if config.check else []
    if wrong:
        failure = f"{INVALID}: {', '.join(sorted({v.what for v in wrong}))}"
        return Attempt(seed, None, failure, seconds, {"variant": info["variant"], "violations": [str(v) for v in wrong]})
    vigilance = ALONE if meddler is None and kind is None else SHARED
    expert = ClosedLoop(env, planned.workspace, plan, config.law, planned.rng, config.budget, vigilance)
    pushes: Meddler | None = None if config.perturbation is None else Pushes(config.perturbation, pushing, env)
    if meddler is not None:
        pushes = meddler(pushing)

    steady = 0.0 if config.perturbation is None else config.perturbation.steady
    missed = MissedGrasp(np.random.default_rng([seed, 6]), env, expert) if kind == "miss" else None

    def push(seen: Observation, label: np.ndarray) -> np.ndarray | None:
        astray = None if missed is None else missed.next(label)
        if pushes is None or (astray is not None and meddler is None):
            return astray
        answer = pushes.next(seen, label, expert.slack(steady))  # a policy is shown every frame, whoever acts
        return answer if astray is None else astray

    episode = rollout(env, observation, expert, "expert", push, mishap)
    info = {**episode.info, "perturbed": pushes is not None, **_facts(expert, plan)}
    at = mishap.at if missed is None else missed.at
    if at is not None:
        info[MISHAP] = {"kind": kind, "at": at}
    episode = replace(episode, skeleton=plan.skeleton, info=info)
    return Attempt(seed, episode, episode.failure, seconds, episode.info, expert.errors)


def _facts(expert: ClosedLoop, plan: Plan) -> dict[str, Any]:
    errors = np.array(expert.errors or [0.0])
    return {
        **({"no_plan": expert.infeasible} if expert.infeasible else {}),
        "retries": len(expert.retries),
        "retried_because": expert.retries,
        "stale_labels": expert.stale,
        "tracking_error": {"median": float(np.median(errors)), "max": float(errors.max())},
        "learned": plan.stats["learned"],
    }
