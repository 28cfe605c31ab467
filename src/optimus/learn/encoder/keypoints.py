"""Images to features: a convolutional network a camera, ending in the positions of keypoints."""

from __future__ import annotations

from typing import Protocol

import torch
import torch.nn.functional as F
from torch import Tensor, nn


class AnyEncoderConfig(Protocol):
    """What an encoder is made of."""

    @property
    def keypoints(self) -> int: ...
    @property
    def sharpness(self) -> float: ...
    @property
    def features(self) -> int:
        """Size of the result for each camera."""
        ...

    @property
    def at_once(self) -> int:
        """Images taken through the convolutions at once."""
        ...

    @property
    def prepacked(self) -> bool:
        """Whether an agent had better keep the weights in the convolutions' own layout (see `encoder.prepack`)."""
        ...

    @property
    def compiled(self) -> bool:
        """Whether compiling it for a GPU is worth the minute that this takes."""
        ...

    def maps(self) -> nn.Module:
        """A new network from images `(N, 3, h, w)` to maps `(N, keypoints, h', w')`."""
        ...


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

    def __init__(self, config: AnyEncoderConfig) -> None:
        super().__init__()
        self.at_once = config.at_once
        self.trunk = config.maps()
        self.keypoints = SpatialSoftmax(config.sharpness)
        self.project = nn.Linear(2 * config.keypoints, config.features)
        for module in self.modules():
            if isinstance(module, nn.Conv2d):
                nn.init.kaiming_normal_(module.weight, nonlinearity="relu")
                if module.bias is not None:
                    nn.init.zeros_(module.bias)

    def forward(self, images: Tensor, shifts: Tensor | None = None, half: bool = False) -> Tensor:
        """`(N, h, w, 3)` uint8 to `(N, features)` float32; `half` runs the convolutions in bfloat16.

        `shifts` `(N, 2)`: how far right and down of the centre each crop was taken [half sides]. The keypoints
        are moved by as much: a random crop varies what is seen but not where it is said to be.
        """
        at_once = self.at_once if images.device.type == "cpu" else len(images)
        places = torch.cat([self._located(part, half) for part in images.split(at_once)])
        if shifts is not None:
            places = places + shifts.repeat_interleave(places.shape[1] // 2, dim=1)
        return self.project(places)

    def _located(self, images: Tensor, half: bool) -> Tensor:
        # NHWC seen as NCHW is the memory layout (channels last) that the convolutions are fastest in.
        pixels = images.permute(0, 3, 1, 2).to(torch.bfloat16 if half else torch.float32)
        with torch.autocast(images.device.type, torch.bfloat16, enabled=half):
            maps = self.trunk(pixels.mul_(1 / 127.5).sub_(1))
        return self.keypoints(maps)
