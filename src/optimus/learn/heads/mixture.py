"""A mixture of Gaussians over the next action; with one component, a Gaussian; with one of unit deviation, least squares."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
import torch
import torch.nn.functional as F
from numpy.typing import NDArray
from torch import Tensor, nn

from optimus.data.episode import GRIPPER

Component = Literal["sampled", "likeliest", "paper", "continuous"]
"""Which of its means a mixture answers with, see `PolicyAgent`."""

SHARPNESS = 4.0
"""Where two components mean two ways to the same end, drawing evenly between them at every step leads neither way; always taking
the likelier one may stand still for ever. Between the two: docs/results/first-policies.md."""


class NextAction:
    """What heads have in common that answer with the next action alone."""

    @property
    def chunk(self) -> int:
        """Actions in an answer."""
        return 1

    @property
    def executed(self) -> int:
        """How many of them are carried out before the next answer."""
        return 1


@dataclass(frozen=True)
class MixtureConfig(NextAction):
    """A mixture of Gaussians with diagonal covariance."""

    modes: int = 5
    min_deviation: float = 0.03
    """Smallest deviation, in normalised units: the likelihood of what hardly varies cannot explode."""
    max_deviation: float | None = None
    """If given, the largest deviation of the arm's part: a component that may be wide covers two ways at once, to the left and to
    the right, and means neither. The gripper's stays free, for nobody answers with the mean of that."""
    gripper_weight: float = 1.0
    """Weight of the gripper's log-density beside that of each other dimension."""
    fixed_deviation: float | None = None
    """If given, every deviation: with one mode, the loss is the squared error but for a factor and a constant."""
    kind: Literal["mixture"] = "mixture"

    def build(self, width: int, actions: int) -> MixtureHead:
        """A head with random weights."""
        return MixtureHead(self, width, actions)


@dataclass(frozen=True, eq=False)
class Mixture:
    """`logits` `(..., K)`; `mean`, `deviation` `(..., K, n)`; in normalised actions."""

    logits: Tensor
    mean: Tensor
    deviation: Tensor

    def log_density(self, actions: Tensor, weight: Tensor | None = None) -> Tensor:
        """Log-density of `actions` `(..., n)`, shape `(...)`; `weight` `(n,)` scales each dimension."""
        z = (actions.unsqueeze(-2) - self.mean) / self.deviation
        terms = -0.5 * z.square() - self.deviation.log() - 0.5 * math.log(2 * math.pi)
        of_mode = (terms if weight is None else terms * weight).sum(-1)
        return torch.logsumexp(F.log_softmax(self.logits, -1) + of_mode, -1)

    def likeliest(self) -> Tensor:
        """The mean of the component of highest weight, `(..., n)`."""
        return self._means_of(self.logits.argmax(-1))

    def sampled(self, noise: torch.Generator, sharpness: float = 1.0) -> Tensor:
        """The mean of a component drawn by its weight to the power of `sharpness`, `(..., n)`; nothing is added, as in the paper's
        code (whose sharpness is 1)."""
        weights = F.softmax(sharpness * self.logits, -1)
        chosen = torch.multinomial(weights.reshape(-1, weights.shape[-1]), 1, generator=noise)
        return self._means_of(chosen.reshape(weights.shape[:-1]))

    def answer(self, component: Component, noise: torch.Generator) -> Tensor:
        """The action `(..., n)` that is carried out, its gripper -1 or 1, or as it comes if `continuous`."""
        sharpness = 1.0 if component == "paper" else SHARPNESS
        mean = self.likeliest() if component == "likeliest" else self.sampled(noise, sharpness)
        if component == "continuous":
            return mean
        shut = mean[..., GRIPPER] > 0 if component == "paper" else self.shut()
        return torch.cat([mean[..., :GRIPPER], torch.where(shut, 1.0, -1.0)[..., None]], -1)

    def shut(self) -> Tensor:
        """Whether components of more than half of the weight have the gripper shut, `(...)`."""
        weight = torch.softmax(self.logits, -1)
        return (weight * (self.mean[..., GRIPPER] > 0)).sum(-1) > 0.5

    def _means_of(self, chosen: Tensor) -> Tensor:
        index = chosen[..., None, None].expand(*chosen.shape, 1, self.mean.shape[-1])
        return self.mean.gather(-2, index).squeeze(-2)


class MixtureHead(nn.Module):
    """One linear layer to the parameters of a mixture."""

    weight: Tensor

    def __init__(self, config: MixtureConfig, width: int, actions: int) -> None:
        super().__init__()
        self.config, self.actions = config, actions
        self.parameters_of = nn.Linear(width, config.modes * (2 * actions + 1))
        self.register_buffer("weight", torch.tensor([1.0] * (actions - 1) + [config.gripper_weight]), persistent=False)

    def forward(self, features: Tensor) -> Mixture:
        """`(..., width)` to a mixture, in float32."""
        k, n = self.config.modes, self.actions
        mean, spread, logits = self.parameters_of(features).float().split([k * n, k * n, k], dim=-1)
        return Mixture(logits, torch.tanh(mean.unflatten(-1, (k, n))), self._deviation(spread.unflatten(-1, (k, n))))

    def _deviation(self, spread: Tensor) -> Tensor:
        least, most = self.config.min_deviation, self.config.max_deviation
        if self.config.fixed_deviation is not None:
            return torch.full_like(spread, self.config.fixed_deviation)
        deviation = F.softplus(spread) + least
        if most is None:
            return deviation
        arm = least + (most - least) * torch.sigmoid(spread[..., :GRIPPER])
        return torch.cat([arm, deviation[..., GRIPPER:]], -1)

    def fit(self, actions: NDArray[np.float32]) -> None:
        """Nothing to be known beforehand."""

    def loss(self, features: Tensor, actions: Tensor, noise: torch.Generator | None = None) -> Tensor:
        """Negative log-likelihood of normalised `actions` `(..., n)`, shape `(...)`."""
        return -self(features).log_density(actions, self.weight)
