"""How much a reproduction may cost: the same rows, with fewer demonstrations, smaller networks and fewer trials."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Literal

from optimus.errors import UnknownNameError, require_at_least
from optimus.learn.presets import preset
from optimus.learn.recipe import Device, TrainConfig, recipe

METHODS: tuple[str, ...] = ("OPTIMUS", "BC-MLP", "BC-RNN", "BeT")
"""As the paper names them."""
LOCATING = "OPTIMUS locating"
"""The same, also taught where the objects are. The small network always is."""
PAPERS: dict[str, str] = {
    "OPTIMUS": "optimus-30m",
    "BC-MLP": "bc-mlp",
    "BC-RNN": "bc-rnn",
    "BeT": "bet",
    LOCATING: "optimus-30m-locating",
}
SMALL: dict[str, str] = {"OPTIMUS": "quick", "BC-MLP": "quick-mlp", "BC-RNN": "quick-rnn", "BeT": "quick-bet", LOCATING: "quick"}


@dataclass(frozen=True)
class Budget:
    """What each row may use."""

    name: str
    demonstrations: int
    """In a dataset."""
    presets: Mapping[str, str] = field(default_factory=lambda: SMALL)
    """Method -> the network that stands for it."""
    steps: int | None = None
    """Gradient steps of a policy; if none, `epochs` decide."""
    epochs: float | None = None
    """Passes over its demonstrations: long tasks are trained for longer, and no figure depends on the processor's pace; if none,
    `minutes` decide."""
    minutes: float = 10.0
    recipe: str | None = None
    """What all are trained by; each by its own recipe if none."""
    batch: int | None = None
    """Runs of windows in a step; the recipe's own if none."""
    held_out_runs: int = 256
    episodes: int = 50
    """Trials of a policy under each condition, for every seed that it was trained with."""
    seeds: int = 1
    """Policies trained, each from another seed."""
    expert_episodes: int = 150
    """50 trials, three times."""
    timing_episodes: int = 20
    """Of the expert, on each task."""
    timing_rounds: int = 5
    """Ten times as many actions of each network are timed."""
    horizon: int | None = None
    """Most steps of a policy's trial, where that is fewer than the task's own."""
    device: Device = "auto"

    def __post_init__(self) -> None:
        require_at_least(1, seeds=self.seeds)

    @property
    def options(self) -> str:
        """Of the command line, where they are not those of the budget of this name."""
        usual = BUDGETS.get(self.name, self)
        seeds = f" --seeds {self.seeds}" if self.seeds != usual.seeds else ""
        return seeds + (f" --device {self.device}" if self.device != usual.device else "")

    @property
    def how_long(self) -> tuple[Literal["steps", "epochs", "minutes"], float]:
        """A policy is trained: in what unit that is counted, and how many."""
        if self.steps is not None:
            return "steps", self.steps
        return ("minutes", self.minutes) if self.epochs is None else ("epochs", self.epochs)

    def training(self, network: str, seed: int) -> TrainConfig:
        """How the preset `network` is trained: by the budget's recipe or its own; the rate anneals over the steps there are."""
        base = recipe(self.recipe or preset(network).recipe)
        return replace(
            base,
            steps=self.steps,
            epochs=self.epochs,
            minutes=self.minutes,
            seed=seed,
            rate=replace(base.rate, over=None),
            loss=base.loss if self.batch is None else replace(base.loss, runs=self.batch),
            evaluations=min(base.evaluations, self.steps or 10),
            held_out_runs=self.held_out_runs,
            device=self.device,
        )


_SMOKE = Budget(
    "smoke",
    demonstrations=4,
    steps=2,
    batch=2,
    held_out_runs=4,
    episodes=2,
    expert_episodes=2,
    timing_episodes=1,
    timing_rounds=1,
    horizon=12,
    device="cpu",
)
BUDGETS: dict[str, Budget] = {
    "smoke": _SMOKE,
    "cpu": Budget("cpu", demonstrations=300, epochs=20.0, device="cpu"),
    "gpu": Budget("gpu", demonstrations=1000, presets=PAPERS, epochs=20.0, recipe="gpu", device="cuda"),
}
"""`smoke`: minutes, to prove the path; `cpu`: two cores overnight; `gpu`: one large GPU within half an hour a row."""


def budget(name: str) -> Budget:
    """The budget of that name; `UnknownNameError` lists the others."""
    if name not in BUDGETS:
        raise UnknownNameError("budget", name, BUDGETS)
    return BUDGETS[name]
