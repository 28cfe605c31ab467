"""Dropout that is a function of a generator."""

from __future__ import annotations

import torch
from torch import Tensor


def dropout(x: Tensor, share: float, noise: torch.Generator | None) -> Tensor:
    """Drop this share of the entries; none without `noise`.

    The masks come from a generator of the caller's, so that a gradient is a function of its seed in whatever
    thread it is computed.
    """
    if noise is None or share == 0:
        return x
    return x * (torch.rand(x.shape, generator=noise, device=x.device) >= share) / (1 - share)
