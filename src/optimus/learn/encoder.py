"""Images to features: one small convolutional network a camera, ending in the positions of keypoints."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import torch
import torch.nn.functional as F
from torch import Tensor, nn

_PART = 48
"""Images taken through the convolutions at once: what they make stays in a core's cache (a fifth faster)."""


@dataclass(frozen=True)
class EncoderConfig:
    """Convolutions, each followed by a ReLU; by default 76 pixels become a map of 19 x 19, then 10 x 10.

    The defaults are what a probe of localisation (a square among clutter, accurate to 0.3 pixels after 200
    steps) and a clock chose. A group norm after each convolution doubled the time of a step on a CPU and
    changed nothing in the probe; two layers of stride 2 in place of the first one took half as long again for
    the same accuracy.
    """

    channels: tuple[int, ...] = (32, 64, 64)
    kernels: tuple[int, ...] = (8, 3, 3)
    strides: tuple[int, ...] = (4, 2, 1)
    keypoints: int = 32
    sharpness: float = 3.0
    """Factor on the maps before their softmax: at 1 all keypoints start, and for long stay, near the centre."""
    features: int = 64
    """Size of the result for each camera."""

    @classmethod
    def from_json(cls, value: Mapping[str, Any]) -> EncoderConfig:
        """The inverse of `dataclasses.asdict`, from parsed JSON."""
        lists = {name: tuple(value[name]) for name in ("channels", "kernels", "strides")}
        return cls(**{**value, **lists})


class SpatialSoftmax(nn.Module):
    """Maps to the expected position of each of them, in [-1, 1] (Levine et al., 2016)."""

    def __init__(self, sharpness: float = 1.0) -> None:
        super().__init__()
        self.sharpness = sharpness

    def forward(self, maps: Tensor) -> Tensor:
        """`(N, k, h, w)` to `(N, 2 k)`: all x, then all y; always in float32."""
        n, k, h, w = maps.shape
        share = F.softmax(self.sharpness * maps.float().reshape(n, k, h * w), dim=-1)
        x = torch.linspace(-1, 1, w, device=maps.device).repeat(h)
        y = torch.linspace(-1, 1, h, device=maps.device).repeat_interleave(w)
        return (share @ torch.stack([x, y], 1)).transpose(1, 2).reshape(n, 2 * k)


class Encoder(nn.Module):
    """One camera's images to features."""

    def __init__(self, config: EncoderConfig) -> None:
        super().__init__()
        layers: list[nn.Module] = []
        channels = pairwise((3, *config.channels))
        for (c_in, c_out), kernel, stride in zip(channels, config.kernels, config.strides, strict=True):
            layers += [nn.Conv2d(c_in, c_out, kernel, stride, (kernel - 1) // 2), nn.ReLU(inplace=True)]
        self.trunk = nn.Sequential(*layers, nn.Conv2d(config.channels[-1], config.keypoints, 1))
        self.keypoints = SpatialSoftmax(config.sharpness)
        self.project = nn.Linear(2 * config.keypoints, config.features)
        for module in self.modules():
            if isinstance(module, nn.Conv2d):
                nn.init.kaiming_normal_(module.weight, nonlinearity="relu")
                assert module.bias is not None
                nn.init.zeros_(module.bias)

    def forward(self, images: Tensor, shifts: Tensor | None = None, half: bool = False) -> Tensor:
        """`(N, h, w, 3)` uint8 to `(N, features)` float32; `half` runs the convolutions in bfloat16.

        `shifts` `(N, 2)`: how far right and down of the centre each crop was taken [half sides]. The keypoints
        are moved by as much: a random crop varies what is seen but not where it is said to be.
        """
        places = torch.cat([self._located(part, half) for part in images.split(_PART)])
        if shifts is not None:
            places = places + shifts.repeat_interleave(places.shape[1] // 2, dim=1)
        return self.project(places)

    def _located(self, images: Tensor, half: bool) -> Tensor:
        # NHWC seen as NCHW is the memory layout (channels last) that the convolutions are fastest in.
        pixels = images.permute(0, 3, 1, 2).to(torch.bfloat16 if half else torch.float32)
        with torch.autocast(images.device.type, torch.bfloat16, enabled=half):
            maps = self.trunk(pixels.mul_(1 / 127.5).sub_(1))
        return self.keypoints(maps)
