"""Where planning time goes, by a sampling profiler: now and then it looks which part of the program is at work.

Deterministic profilers make every call dearer, and so what consists of many small calls; this one only interrupts, some hundred
times a second of CPU time, and runs apart from everything that is timed.
"""

from __future__ import annotations

import signal
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import cycle
from types import FrameType
from typing import Any

from optimus.bench.config import BenchConfig
from optimus.demonstrate import ExpertConfig, plan_for

SECONDS = 3.0
"""CPU time that is looked at, at least."""
SECONDS_FOR_SLOW = 10.0
"""... after which it is enough even if not every one of the `SEEDS` has had its turn."""
SEEDS = 5
"""Problems that are planned for, again and again."""
INTERVAL = 0.001
"""Between two looks [s of CPU]; most kernels make it 4 ms."""

PARTS = {
    "optimus.logic": "search",
    "optimus.planner": "search",
    "optimus.predicates": "search",
    "optimus.skills": "skills",
    "optimus.motion": "motion",
    "optimus.motion.sampling": "sampling",
    "optimus.kinematics": "kinematics",
    "optimus.collision": "collision",
}
"""Module or package -> the part of planning that it is. Where one calls the other, the time is the called one's: a collision check
for the sampling planner is `collision`, its tree and its shortcuts are `sampling`; `motion` is what leads the tcp along lines."""
OTHER = "other"


def planning_shares(config: BenchConfig) -> dict[str, Any]:
    """The share of each part in the CPU time of planning, over the first few seeds."""
    env, planning, plans, spent = config.env(images=False), Counter[str](), 0, 0.0
    with looking() as looks:  # all the time: started anew with each plan, it would miss how plans begin
        for seed in cycle(range(config.seed, config.seed + min(SEEDS, config.episodes))):
            env.reset(seed=seed)
            before = looks.copy()
            spent += plan_for(env, seed, ExpertConfig()).seconds
            planning += looks.copy() - before  # in one piece: a look may come between
            plans += 1
            if spent >= (SECONDS if plans >= SEEDS else SECONDS_FOR_SLOW):
                break
    shares = {part: planning[part] / max(1, planning.total()) for part in dict.fromkeys([*PARTS.values(), OTHER])}
    return {"planning_shares": shares, "looked_at": {"plans": plans, "cpu_seconds": spent, "looks": planning.total()}}


@contextmanager
def looking() -> Iterator[Counter[str]]:
    """Count, while the block runs, how often each part was found at work."""
    looks: Counter[str] = Counter()

    def look(_: int, frame: FrameType | None) -> None:
        looks[part_of(frame)] += 1

    before = signal.signal(signal.SIGPROF, look)
    signal.setitimer(signal.ITIMER_PROF, INTERVAL, INTERVAL)
    try:
        yield looks
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)


def part_of(frame: FrameType | None) -> str:
    """The part that the innermost frame of any part belongs to: libraries and helpers count as their caller's."""
    while frame is not None:
        name = str(frame.f_globals.get("__name__", ""))
        while name:
            if name in PARTS:
                return PARTS[name]
            name = name.rpartition(".")[0]
        frame = frame.f_back
    return OTHER
