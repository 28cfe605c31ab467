"""Measurements: each branch by itself, every failure with its seed, and a profile that finds what was put there."""

import signal
import time
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from scipy.stats import binomtest

from optimus.bench import BENCHES, BenchConfig
from optimus.bench.expert import summary_of
from optimus.bench.where import looking, planning_shares
from optimus.cli.output import table
from optimus.demonstrate import Attempt, ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.errors import WorkerError
from optimus.tasks import task
from optimus.workers import finished


def attempt(seed: int, branch: str, success: bool, retries: tuple[str, ...] = ()) -> Attempt:
    """A made-up attempt: a real episode of stack under another name."""
    real = demonstrate(ManipulationEnv(task("stack"), images=False), 3, ExpertConfig())
    info = {**real.info, "variant": branch, "retried_because": list(retries)}
    if not success:
        return Attempt(seed, None, f"no plan: {branch} is shut", 0.5, {"variant": branch})
    return replace(real, seed=seed, info=info, plan_seconds=0.1)


def test_every_branch_is_counted_by_itself() -> None:
    names = {"base on target", "base elsewhere"}
    result = BENCHES["expert"](BenchConfig("stack-adapt", episodes=6, seed=7000), lambda done, successes: None)
    drawn = [task("stack-adapt").problem(7000 + i).variant for i in range(6)]
    assert set(result["branches"]) == set(drawn) <= names
    for name, branch in result["branches"].items():
        assert branch["episodes"] == branch["successes"] == drawn.count(name)
        expected = binomtest(branch["successes"], branch["episodes"]).proportion_ci(0.95, "wilson")
        np.testing.assert_allclose(branch["interval"], (expected.low, expected.high), atol=1e-4)


def test_failures_and_retries_are_named_with_their_seeds() -> None:
    attempts = [attempt(7, "open", True), attempt(8, "shut", False), attempt(9, "open", True, ("stuck", "empty hand"))]
    result = summary_of(attempts)
    assert result["successes"] == 2 and result["branches"]["shut"]["successes"] == 0
    assert result["branches"]["open"]["plan_seconds"]["median"] == 0.1
    assert result["failed_seeds"] == [{"seed": 8, "branch": "shut", "reason": "no plan: shut is shut"}]
    assert result["retries"] == {"stuck": 1, "empty hand": 1}
    assert [row["seed"] for row in result["retried_seeds"]] == [9]
    text = table(result)
    assert "2 of 3 (21 to 94 %)" in text and "seed 8" in text and "no plan: shut is shut" in text and "seed 9" in text
    assert "shut                   0 of 1 (0 to 79 %)" in text


def busy(module: str, seconds: float) -> None:
    """Spend CPU time in a function of a module of that name."""
    scope = {"__name__": module, "time": time}
    exec("def spin(end):\n    while time.process_time() < end:\n        pass\n", scope)
    scope["spin"](time.process_time() + seconds)  # pyright: ignore[reportCallIssue]


def test_the_profile_finds_who_was_busy() -> None:
    with looking() as looks:
        for _ in range(4):
            busy("optimus.motion.sampling", 0.3)
            busy("optimus.motion.lines", 0.1)
            busy("some.library", 0.1)
    assert looks.total() > 100
    for part, share in (("sampling", 0.6), ("motion", 0.2), ("other", 0.2)):
        assert looks[part] / looks.total() == pytest.approx(share, abs=0.1)


def test_shares_of_planning_time_add_up(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("optimus.bench.where.SECONDS", 0.5)
    found = planning_shares(BenchConfig("stack", episodes=2))
    assert sum(found["planning_shares"].values()) == pytest.approx(1.0)
    assert found["planning_shares"]["kinematics"] > 0.1 and found["looked_at"]["plans"] >= 2


def test_a_worker_that_is_killed_is_named() -> None:
    with pytest.raises(WorkerError, match="a worker process was killed"):
        list(finished([partial(signal.raise_signal, signal.SIGKILL)] * 2, 2))


@pytest.mark.parametrize("workers", [1, 2])
def test_jobs_end_with_their_numbers(workers: int) -> None:
    answers = dict(finished([partial(pow, n, 2) for n in range(5)], workers))
    assert answers == {0: 0, 1: 1, 2: 4, 3: 9, 4: 16}
