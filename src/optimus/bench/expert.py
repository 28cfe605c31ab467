"""The expert's success, branch by branch, its planning time, and how well it keeps to its plans."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from functools import partial
from typing import Any

from optimus.bench.config import BenchConfig, Progress
from optimus.bench.where import planning_shares
from optimus.demonstrate import INVALID, Attempt, ExpertConfig, demonstrate
from optimus.statistics import quantiles, wilson
from optimus.workers import finished


def bench_expert(config: BenchConfig, progress: Progress) -> dict[str, Any]:
    """The expert, unperturbed and without images, on `episodes` consecutive seeds; with `check`, invalid plans are counted."""
    done: dict[int, Attempt] = {}
    jobs = [partial(_attempt, config, config.seed + i) for i in range(config.episodes)]
    for i, attempt in finished(jobs, config.workers):
        done[i] = attempt
        progress(len(done), sum(a.success for a in done.values()))
    attempts = [done[i] for i in sorted(done)]
    return {
        **config.about,
        "seed": config.seed,
        **summary_of(attempts),
        **({"mishaps": sum(a.info["mishap_at"] is not None for a in attempts)} if config.conditions.perturb else {}),
        **({"invalid_plans": sum(a.failure.startswith(INVALID) for a in attempts)} if config.check else {}),
        **(planning_shares(config) if config.where else {}),
    }


def summary_of(attempts: list[Attempt]) -> dict[str, Any]:
    """What came of all of them, JSON-able."""
    return {
        **_counts(attempts),
        "paper_rule_successes": sum(bool(a.info.get("paper_success")) for a in attempts),
        **_numbers(attempts),
        "branches": _branches(attempts),
        **_retries(attempts),
        **_failures(attempts),
    }


def _attempt(config: BenchConfig, seed: int) -> Attempt:
    mishap = config.conditions.mishap(seed)
    attempt = demonstrate(config.env(images=False), seed, ExpertConfig(budget=config.budget, check=config.check), mishap=mishap)
    return replace(attempt, info={**attempt.info, "mishap_at": mishap.at})


def _counts(attempts: list[Attempt]) -> dict[str, Any]:
    successes = sum(a.success for a in attempts)
    return {"episodes": len(attempts), "successes": successes, "interval": list(wilson(successes, len(attempts)))}


def _numbers(attempts: list[Attempt]) -> dict[str, Any]:
    steps = [float(len(a.episode)) for a in attempts if a.episode is not None]
    return {
        "plan_seconds": quantiles([a.plan_seconds for a in attempts], 95),
        "episode_steps": quantiles(steps, 95),
        "tracking_error_mm": quantiles([e for a in attempts for e in a.tracking], 99, scale=1e3),
    }


def _branches(attempts: list[Attempt]) -> dict[str, Any]:
    """Each branch of the task (or each kind of object) by itself; empty where there is only one."""
    by_name: dict[str, list[Attempt]] = {}
    for attempt in attempts:
        by_name.setdefault(attempt.variant, []).append(attempt)
    if set(by_name) <= {""}:
        return {}
    return {
        name: {**_counts(some), "plan_seconds": quantiles([a.plan_seconds for a in some], 95)}
        for name, some in sorted(by_name.items())
    }


def _retries(attempts: list[Attempt]) -> dict[str, Any]:
    """Episodes in which the expert planned again, and why."""
    retried = [a for a in attempts if a.retries]
    return {
        "retries": dict(Counter(reason for a in retried for reason in a.retries)),
        "retried_seeds": [{"seed": a.seed, "branch": a.variant, "success": a.success, "because": a.retries} for a in retried],
    }


def _failures(attempts: list[Attempt]) -> dict[str, Any]:
    failed = [a for a in attempts if not a.success]
    return {
        "failures": dict(Counter(a.failure for a in failed)),
        "failed_seeds": [{"seed": a.seed, "branch": a.variant, "reason": a.failure} for a in failed],
    }
