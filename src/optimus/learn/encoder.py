"""Images to features: one small convolutional network a camera, ending in the positions of keypoints."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import torch
import torch.nn.functional as F
from torch import Tensor, nn

_PART = 48
"""Images taken through the convolutions at once: what they make then stays in a core's cache (a fifth faster than 192)."""


@dataclass(frozen=True)
class EncoderConfig:
    """Four convolutions, each followed by a ReLU; 76 pixels become a map of 10 x 10.

    There is no norm between them: on a CPU a group norm doubled the time of a step, and a probe of localisation was as
    accurate after as many steps without it.
    """

    channels: tuple[int, int, int, int] = (16, 32, 64, 64)
    keypoints: int = 32
    features: int = 64
    """Size of the result for each camera."""


class SpatialSoftmax(nn.Module):
    """Maps to the expected position of each of them, in [-1, 1] (Levine et al., 2016)."""

    def forward(self, maps: Tensor) -> Tensor:
        """`(N, k, h, w)` to `(N, 2 k)`: all x, then all y; always in float32."""
        n, k, h, w = maps.shape
        share = F.softmax(maps.float().reshape(n, k, h * w), dim=-1)
        x = torch.linspace(-1, 1, w, device=maps.device).repeat(h)
        y = torch.linspace(-1, 1, h, device=maps.device).repeat_interleave(w)
        return (share @ torch.stack([x, y], 1)).transpose(1, 2).reshape(n, 2 * k)


class Encoder(nn.Module):
    """One camera's images to features."""

    def __init__(self, config: EncoderConfig) -> None:
        super().__init__()
        kernels, strides = (5, 3, 3, 3), (2, 2, 2, 1)
        layers = []
        for (c_in, c_out), kernel, stride in zip(pairwise((3, *config.channels)), kernels, strides, strict=True):
            layers += [nn.Conv2d(c_in, c_out, kernel, stride, kernel // 2), nn.ReLU(inplace=True)]
        self.trunk = nn.Sequential(*layers, nn.Conv2d(config.channels[-1], config.keypoints, 1))
        self.keypoints = SpatialSoftmax()
        self.project = nn.Linear(2 * config.keypoints, config.features)
        for module in self.modules():
            if isinstance(module, nn.Conv2d):
                nn.init.kaiming_normal_(module.weight, nonlinearity="relu")
                nn.init.zeros_(module.bias)

    def forward(self, images: Tensor, half: bool = False) -> Tensor:
        """`(N, h, w, 3)` uint8 to `(N, features)` float32; `half` runs the convolutions in bfloat16."""
        return self.project(torch.cat([self._located(part, half) for part in images.split(_PART)]))

    def _located(self, images: Tensor, half: bool) -> Tensor:
        # NHWC seen as NCHW is the memory layout (channels last) that the convolutions are fastest in.
        pixels = images.permute(0, 3, 1, 2).to(torch.bfloat16 if half else torch.float32)
        with torch.autocast(images.device.type, torch.bfloat16, enabled=half):
            maps = self.trunk(pixels.mul_(1 / 127.5).sub_(1))
        return self.keypoints(maps)
