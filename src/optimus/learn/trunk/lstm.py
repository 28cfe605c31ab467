"""BC-RNN: an LSTM over the frames of a window (Mandlekar et al., 2021)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import torch
from torch import Tensor, nn


@dataclass(frozen=True)
class LSTMConfig:
    """A long short-term memory (Hochreiter and Schmidhuber, 1997)."""

    width: int = 1000
    layers: int = 2
    token: int = 256
    """Size of the tokens it reads."""
    kind: Literal["lstm"] = "lstm"

    def build(self, context: int) -> LSTM:
        """A trunk with random weights."""
        return LSTM(self)


class LSTM(nn.Module):
    """Reads a window from its first frame on with an empty memory, in use as in training: what lies before the window is
    forgotten, as with the transformer."""

    def __init__(self, config: LSTMConfig) -> None:
        super().__init__()
        self.layers = nn.LSTM(config.token, config.width, config.layers, batch_first=True)

    def forward(self, tokens: Tensor, noise: torch.Generator | None = None) -> Tensor:
        """`(B, C, token)` to `(B, C, width)`."""
        return self.layers(tokens)[0]
