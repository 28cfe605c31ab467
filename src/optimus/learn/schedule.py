"""How many steps there are and what the learning rate is at each: pure functions of a recorded plan."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class StepPlan:
    """Progress, 0 to 1, grows linearly from `progress` at step `start` to 1 at step `steps`."""

    steps: int
    start: int = 0
    progress: float = 0.0

    def at(self, step: int) -> float:
        """Progress when `step` steps have been taken."""
        if step >= self.steps:
            return 1.0
        return self.progress + (1 - self.progress) * (step - self.start) / (self.steps - self.start)

    def revised(self, step: int, seconds_left: float, seconds_a_step: float) -> StepPlan:
        """The plan that ends with the time, if this one misses it by over a twentieth; without a jump."""
        steps = step + max(1, round(seconds_left / seconds_a_step))
        if step >= self.steps or abs(steps - self.steps) <= 0.05 * (self.steps - step):
            return self
        return StepPlan(steps, step, self.at(step))


@dataclass(frozen=True)
class RateConfig:
    """From `first` to `last`, along a cosine or a line, after a linear rise."""

    first: float = 1.5e-3
    last: float = 1e-4
    warm_up: int = 50
    """Steps of the rise."""
    shape: Literal["cosine", "linear"] = "cosine"
    over: int | None = None
    """Steps from `first` to `last`, after which the rate stays; if none, all that there are."""

    def at(self, step: int, progress: float) -> float:
        """The learning rate of the step after `step` others, at that progress of the plan (0 to 1)."""
        way = progress if self.over is None else min(1.0, step / self.over)
        left = 1 - way if self.shape == "linear" else 0.5 * (1 + math.cos(math.pi * way))
        rise = min(1.0, (step + 1) / max(1, self.warm_up))
        return rise * (self.last + left * (self.first - self.last))
