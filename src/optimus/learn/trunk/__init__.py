"""What remembers: from the tokens of a window's frames to features that an action is drawn from. One file each."""

from collections.abc import Mapping
from typing import Any, Protocol

import torch
from torch import Tensor

from optimus.learn.trunk.dropout import dropout
from optimus.learn.trunk.lstm import LSTM, LSTMConfig
from optimus.learn.trunk.mlp import MLP, MLPConfig
from optimus.learn.trunk.transformer import Transformer, TransformerConfig


class Trunk(Protocol):
    """A module over the frames of a window."""

    def __call__(self, tokens: Tensor, noise: torch.Generator | None = None) -> Tensor:
        """Tokens `(B, C, token)` to features of each position `(B, C, width)`, each a function of the tokens up to its own;
        dropout only with `noise`."""
        ...


class TrunkConfig(Protocol):
    """What a trunk is made of."""

    @property
    def token(self) -> int:
        """Size of the tokens it reads."""
        ...

    @property
    def width(self) -> int:
        """Size of the features it gives."""
        ...

    def build(self, context: int) -> Trunk:
        """A trunk with random weights for windows of up to `context` frames."""
        ...


def trunk_config(value: Mapping[str, Any]) -> TransformerConfig | MLPConfig | LSTMConfig:
    """The inverse of `dataclasses.asdict`, from parsed JSON; an earlier version knew one kind only and did not name it."""
    kinds = {"transformer": TransformerConfig, "mlp": MLPConfig, "lstm": LSTMConfig}
    return kinds[value.get("kind", "transformer")](**value)


__all__ = [
    "LSTM",
    "MLP",
    "LSTMConfig",
    "MLPConfig",
    "Transformer",
    "TransformerConfig",
    "Trunk",
    "TrunkConfig",
    "dropout",
    "trunk_config",
]
