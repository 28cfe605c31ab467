"""A flow from noise to chunks of actions, taken in a few steps (Lipman et al., 2023; chunks: Zhao et al., 2023)."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn

from optimus.data.episode import GRIPPER
from optimus.learn.heads.mixture import Component

_FREQUENCIES = 8
"""Sines and cosines of the time that the velocity is told."""


@dataclass(frozen=True)
class FlowConfig:
    """Straight paths from noise to data. What is learned is where such a path leads to on the average, not the velocity along it:
    the two say the same, but near the end this one does not err by much."""

    chunk: int = 8
    """Actions in an answer: the next one and those to follow."""
    executed: int = 4
    """How many of them are carried out before the next answer."""
    steps: int = 4
    """Of the integration by Euler's method."""
    width: int = 512
    layers: int = 3
    kind: Literal["flow"] = "flow"

    def build(self, width: int, actions: int) -> FlowHead:
        """A head with random weights."""
        return FlowHead(self, width, actions)


@dataclass(frozen=True, eq=False)
class Flow:
    """Where noise is carried to, given the features that an answer is for."""

    carried: Callable[[Tensor], Tensor]
    """Noise `(..., chunk, n)` to normalised actions of the same shape."""
    shape: torch.Size
    device: torch.device

    def likeliest(self) -> Tensor:
        """What the middle of the noise is carried to, `(..., chunk, n)`."""
        return self.carried(torch.zeros(self.shape, device=self.device))

    def sampled(self, noise: torch.Generator) -> Tensor:
        """What noise is carried to, `(..., chunk, n)`."""
        return self.carried(torch.randn(self.shape, generator=noise, device=self.device))

    def answer(self, component: Component, noise: torch.Generator) -> Tensor:
        """The actions `(..., chunk, n)`, their gripper -1 or 1, or as it comes if `continuous`. They are drawn by the flow itself
        unless the `likeliest` is asked for."""
        actions = self.likeliest() if component == "likeliest" else self.sampled(noise)
        if component == "continuous":
            return actions
        shut = torch.where(actions[..., GRIPPER:] > 0, 1.0, -1.0)
        return torch.cat([actions[..., :GRIPPER], shut], -1)


class FlowHead(nn.Module):
    """A multilayer perceptron: features, time and where the chunk is now, to where it will be at the end."""

    def __init__(self, config: FlowConfig, width: int, actions: int) -> None:
        super().__init__()
        self.config, self.actions = config, actions
        size = config.chunk * actions
        layers: list[nn.Module] = [nn.Linear(width + size + 2 * _FREQUENCIES, config.width), nn.SiLU()]
        for _ in range(config.layers - 1):
            layers += [nn.Linear(config.width, config.width), nn.SiLU()]
        self.layers = nn.Sequential(*layers, nn.Linear(config.width, size))

    def fit(self, actions: NDArray[np.float32]) -> None:
        """Nothing to be known beforehand."""

    def forward(self, features: Tensor) -> Flow:
        """Features `(..., width)` to a flow over chunks `(..., chunk, n)`."""
        features = features.float()
        shape = torch.Size((*features.shape[:-1], self.config.chunk, self.actions))

        def carried(x: Tensor) -> Tensor:
            for k in range(self.config.steps):
                time = features.new_full(shape[:-2], k / self.config.steps)
                # the velocity is the way that is left over the time that is left
                x = x + (self.end(features, x, time) - x) / (self.config.steps - k)
            return x

        return Flow(carried, shape, features.device)

    def end(self, features: Tensor, x: Tensor, time: Tensor) -> Tensor:
        """The mean end of paths through `x` `(..., chunk, n)` at `time` `(...)` in [0, 1), of the same shape as `x`."""
        angles = time[..., None] * math.pi * torch.arange(1, _FREQUENCIES + 1, device=time.device)
        seen = torch.cat([features, x.flatten(-2), angles.sin(), angles.cos()], -1)
        return self.layers(seen).view(x.shape)

    def loss(self, features: Tensor, actions: Tensor, noise: torch.Generator | None = None) -> Tensor:
        """Mean squared error `(...)` of the end, seen from a random time of the straight path from noise to normalised `actions`
        `(..., chunk, n)`; always the same noise without a generator."""
        device = actions.device
        drawn = torch.Generator(device).manual_seed(0) if noise is None else noise
        start = torch.randn(actions.shape, generator=drawn, device=device)
        time = torch.rand(actions.shape[:-2], generator=drawn, device=device)
        part = time[..., None, None]
        end = self.end(features.float(), (1 - part) * start + part * actions, time)
        return (end - actions).square().mean((-1, -2))
