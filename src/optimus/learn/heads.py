"""Features to a distribution over actions: a mixture of Gaussians."""

from __future__ import annotations

import math
from dataclasses import dataclass

import torch
import torch.nn.functional as F
from torch import Tensor, nn


@dataclass(frozen=True)
class MixtureConfig:
    """A mixture of Gaussians with diagonal covariance."""

    modes: int = 5
    min_deviation: float = 0.03
    """Smallest deviation, in normalised units: the likelihood of what hardly varies cannot explode."""
    gripper_weight: float = 1.0
    """Weight of the gripper's log-density beside that of each other dimension."""


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

    def _means_of(self, chosen: Tensor) -> Tensor:
        index = chosen[..., None, None].expand(*chosen.shape, 1, self.mean.shape[-1])
        return self.mean.gather(-2, index).squeeze(-2)


class MixtureHead(nn.Module):
    """One linear layer to the parameters of a mixture."""

    def __init__(self, config: MixtureConfig, width: int, actions: int) -> None:
        super().__init__()
        self.config, self.actions = config, actions
        self.parameters_of = nn.Linear(width, config.modes * (2 * actions + 1))
        self.weight = torch.ones(actions)
        self.weight[-1] = config.gripper_weight

    def forward(self, features: Tensor) -> Mixture:
        """`(..., width)` to a mixture, in float32."""
        k, n = self.config.modes, self.actions
        mean, spread, logits = self.parameters_of(features).float().split([k * n, k * n, k], dim=-1)
        deviation = F.softplus(spread) + self.config.min_deviation
        return Mixture(logits, torch.tanh(mean.unflatten(-1, (k, n))), deviation.unflatten(-1, (k, n)))

    def loss(self, features: Tensor, actions: Tensor) -> Tensor:
        """Negative log-likelihood of normalised `actions` `(..., n)`, shape `(...)`."""
        return -self(features).log_density(actions, self.weight.to(features.device))
