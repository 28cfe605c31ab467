"""ResNet-18 (He et al., 2016) as a policy looks with it: up to its last maps, without pooling and classes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

import torch.nn.functional as F
from torch import Tensor, nn

from optimus.learn.encoder.small_maps import SmallMapConv2d

_GROUP = 16
"""Channels normalised together. Group norms, not batch norms: each image is encoded by itself, the same in training and in
use, which is what caching the features of earlier frames and averaging the weights need."""


@dataclass(frozen=True)
class ResNetConfig:
    """The network of the paper (Section 4.2, Appendix D): 11.2 million weights a camera; 76 pixels become maps of 3 x 3."""

    keypoints: int = 32
    sharpness: float = 1.0
    """Factor on the maps before their softmax."""
    features: int = 64
    """Size of the result for each camera."""
    kind: Literal["resnet18"] = "resnet18"

    @property
    def at_once(self) -> int:
        """Images taken through the convolutions at once: with fewer, reading the weights begins to show."""
        return 128

    @property
    def prepacked(self) -> bool:
        """Whether an agent lays out the weights beforehand."""
        return True

    @property
    def compiled(self) -> bool:
        """Whether it is compiled for a GPU: its norms are as slow as its convolutions there."""
        return True

    @classmethod
    def from_json(cls, value: Mapping[str, Any]) -> ResNetConfig:
        """The inverse of `dataclasses.asdict`, from parsed JSON."""
        return cls(**value)

    def maps(self) -> nn.Module:
        """Images `(N, 3, h, w)` to maps `(N, keypoints, h / 32, w / 32)`."""
        layers = [nn.Conv2d(3, 64, 7, 2, 3, bias=False), norm(64), nn.ReLU(inplace=True), nn.MaxPool2d(3, 2, 1)]
        channels = 64
        for wider, stride in ((64, 1), (128, 2), (256, 2), (512, 2)):
            layers += [ResidualBlock(channels, wider, stride), ResidualBlock(wider, wider, 1)]
            channels = wider
        return Whole(*layers, nn.Conv2d(channels, self.keypoints, 1))


class Whole(nn.Sequential):
    """Its layers in turn. PyTorch compiles its own class block by block; this one becomes a single graph."""

    def forward(self, input: Tensor) -> Tensor:
        """As `nn.Sequential`."""
        for layer in self:
            input = layer(input)
        return input


class ResidualBlock(nn.Module):
    """Two convolutions, added to what came in."""

    def __init__(self, channels: int, wider: int, stride: int) -> None:
        super().__init__()
        self.first = SmallMapConv2d(channels, wider, 3, stride, 1, bias=False)
        self.second = SmallMapConv2d(wider, wider, 3, 1, 1, bias=False)
        self.norm_first, self.norm_second = norm(wider), norm(wider)
        shrinks = stride != 1 or channels != wider
        self.pass_on = nn.Sequential(nn.Conv2d(channels, wider, 1, stride, bias=False), norm(wider)) if shrinks else nn.Identity()

    def forward(self, x: Tensor) -> Tensor:
        """`(N, c, h, w)` to `(N, wider, h / stride, w / stride)`."""
        y = F.relu_(self.norm_first(self.first(x)))
        return F.relu_(self.norm_second(self.second(y)) + self.pass_on(x))


class Norm(nn.GroupNorm):
    """Computed in float32, given on as it came: in bfloat16 half as much memory is moved until the next convolution."""

    def forward(self, input: Tensor) -> Tensor:
        """As `nn.GroupNorm`."""
        return super().forward(input).to(input.dtype)


def norm(channels: int) -> nn.Module:
    """The normalisation after a convolution."""
    return Norm(channels // _GROUP, channels)
