"""BC-MLP: layers over the newest frame alone (Mandlekar et al., 2021)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import torch
from torch import Tensor, nn


@dataclass(frozen=True)
class MLPConfig:
    """A multilayer perceptron."""

    width: int = 1024
    layers: int = 2
    """Hidden layers; the policy's embedding of a frame is the first one's matrix."""
    kind: Literal["mlp"] = "mlp"

    @property
    def token(self) -> int:
        """Size of the tokens it reads."""
        return self.width

    def build(self, context: int) -> MLP:
        """A trunk with random weights."""
        return MLP(self)


class MLP(nn.Module):
    """Each position by itself: with any context, an action is a function of one frame."""

    def __init__(self, config: MLPConfig) -> None:
        super().__init__()
        layers: list[nn.Module] = [nn.ReLU()]
        for _ in range(config.layers - 1):
            layers += [nn.Linear(config.width, config.width), nn.ReLU()]
        self.layers = nn.Sequential(*layers)

    def forward(self, tokens: Tensor, noise: torch.Generator | None = None) -> Tensor:
        """`(B, C, width)` to the same."""
        return self.layers(tokens)
