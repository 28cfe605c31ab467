"""What answers: from features to the next action, or the next few. One file each."""

from collections.abc import Mapping
from typing import Any, Protocol

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from optimus.learn.heads.bet import BeTConfig, BeTHead
from optimus.learn.heads.flow import FlowConfig, FlowHead
from optimus.learn.heads.mixture import SHARPNESS, Component, Mixture, MixtureConfig, MixtureHead


class Answers(Protocol):
    """A distribution over normalised actions `(..., n)`, or over chunks of them `(..., chunk, n)`."""

    def likeliest(self) -> Tensor:
        """The one best answer."""
        ...

    def answer(self, component: Component, noise: torch.Generator) -> Tensor:
        """What is carried out, the gripper -1 or 1, or as it comes if `continuous`."""
        ...


class Head(Protocol):
    """A module that says what to do."""

    def __call__(self, features: Tensor) -> Answers:
        """Features `(..., width)` to a distribution over actions."""
        ...

    def loss(self, features: Tensor, actions: Tensor, noise: torch.Generator | None = None) -> Tensor:
        """What training minimises, `(...)`, given normalised actions `(..., n)`, or `(..., chunk, n)` where chunks have more than
        one; whatever is drawn comes from `noise`."""
        ...

    def fit(self, actions: NDArray[np.float32]) -> None:
        """Learn beforehand what normalised actions `(N, n)` there are."""
        ...


class HeadConfig(Protocol):
    """What a head is made of."""

    @property
    def chunk(self) -> int:
        """Actions in an answer."""
        ...

    @property
    def executed(self) -> int:
        """How many of them are carried out before the next answer."""
        ...

    def build(self, width: int, actions: int) -> Head:
        """A head with random weights, from features of size `width` to actions of size `actions`."""
        ...


def head_config(value: Mapping[str, Any]) -> MixtureConfig | BeTConfig | FlowConfig:
    """The inverse of `dataclasses.asdict`, from parsed JSON; an earlier version knew one kind only and did not name it."""
    kinds = {"mixture": MixtureConfig, "bet": BeTConfig, "flow": FlowConfig}
    return kinds[value.get("kind", "mixture")](**value)


__all__ = [
    "SHARPNESS",
    "Answers",
    "BeTConfig",
    "BeTHead",
    "Component",
    "FlowConfig",
    "FlowHead",
    "Head",
    "HeadConfig",
    "Mixture",
    "MixtureConfig",
    "MixtureHead",
    "head_config",
]
