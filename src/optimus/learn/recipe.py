"""How a policy is trained, as values: `TrainConfig`, and the recipes that go by a name."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Literal

from optimus.errors import UnknownNameError, require_at_least, require_finite
from optimus.learn.gradient import LossConfig, Runtime
from optimus.learn.schedule import RateConfig
from optimus.learn.state import OptimiserConfig

Device = Literal["auto", "cpu", "cuda"]
LEAST = 0.001
"""Of minutes and of epochs."""


@dataclass(frozen=True)
class TrainConfig:
    """How a policy is trained."""

    steps: int | None = None
    """Number of steps; if none, `epochs` decide."""
    epochs: float | None = None
    """Passes over the training episodes: as many labels as they have actions, times this; if none, `minutes` decide."""
    minutes: float = 10.0
    """Time to train for, start-up included."""
    seed: int = 0
    demonstrations: int | None = None
    """Learn from the first so many of each data set alone; the held-out ones stay the same. If none, from all."""
    windows: int = 1
    """Consecutive windows in a run."""
    change_weight: float = 1.0
    """Weight of labels near a change of the gripper."""
    change_reach: int = 2
    """Steps before and after such a change that count as near."""
    loss: LossConfig = field(default_factory=LossConfig)
    rate: RateConfig = field(default_factory=RateConfig)
    optimiser: OptimiserConfig = field(default_factory=OptimiserConfig)
    evaluations: int = 10
    """How often the held-out error is measured."""
    held_out_runs: int = 256
    """Windows that it is measured on."""
    checkpoint_seconds: float = 60.0
    """Time between checkpoints, longer where writing one takes long; 0: after every step."""
    accumulate: int = 1
    """Portions of a batch that each process computes one after the other: memory for one portion is enough."""
    device: Device = "auto"
    """`auto`: a GPU if there is one."""
    half: bool | None = None
    """Convolutions in bfloat16; if None, where the hardware has it."""
    runtime: Runtime | None = None
    """Threads and precision; if none, the machine's usual ones, or with a budget of minutes the fastest, measured."""

    def __post_init__(self) -> None:
        require_at_least(1, steps=self.steps, accumulate=self.accumulate, windows=self.windows)
        require_at_least(LEAST, epochs=self.epochs, minutes=self.minutes)
        require_finite(epochs=self.epochs, minutes=self.minutes)
        require_at_least(0, seed=self.seed)

    @property
    def by_the_clock(self) -> bool:
        """Whether `minutes` decide how long."""
        return self.steps is None and self.epochs is None

    def steps_over(self, actions: int, labels: int) -> int | None:
        """The number of steps on episodes of so many actions, so many labels a step; none by the clock."""
        if self.steps is None and self.epochs is not None:
            return max(1, math.ceil(self.epochs * actions / labels))
        return self.steps


RECIPES: dict[str, TrainConfig] = {
    "quick": TrainConfig(),
    # Table D.1 and Section D of the paper's appendix: one label a window, no running average, no auxiliary loss
    "paper": TrainConfig(
        steps=1_000_000,
        loss=LossConfig(runs=16, supervise="last", location_weight=0.0),
        rate=RateConfig(first=1e-4, last=1e-5, warm_up=0, shape="linear", over=100_000),
        optimiser=OptimiserConfig(weight_decay=0.01, decay_all=True, clip=1.0, clip_apart=False, average=0.0),
        evaluations=100,
    ),
    # All frames of a window are labels, as in `quick`: eight times the labels for the same encoding. The rate is that of small
    # residual networks under AdamW; the running average is long, for there are thousands of steps.
    "gpu": TrainConfig(
        epochs=20.0,
        loss=LossConfig(runs=64, location_weight=30.0),
        rate=RateConfig(first=5e-4, last=1e-5, warm_up=200),
        optimiser=OptimiserConfig(average=0.998),
        evaluations=5,
    ),
}
"""`quick`: minutes on a CPU; `paper`: a million steps of batches of 16 (512 and more for many tasks); `gpu`: the paper's networks
in minutes on a large GPU."""


def recipe(name: str) -> TrainConfig:
    """The recipe of that name; `UnknownNameError` lists the others."""
    if name not in RECIPES:
        raise UnknownNameError("recipe", name, RECIPES)
    return RECIPES[name]
