"""The sequence model between features and actions: a causal transformer over the frames of a window."""

from __future__ import annotations

from dataclasses import dataclass

import torch
import torch.nn.functional as F
from torch import Tensor, nn


@dataclass(frozen=True)
class TransformerConfig:
    """A pre-norm GPT."""

    width: int = 128
    layers: int = 3
    heads: int = 4
    dropout: float = 0.0
    """Share dropped after the input and each half block; 0.1 in the paper, which costs a small policy precision."""


def dropout(x: Tensor, share: float, noise: torch.Generator | None) -> Tensor:
    """Drop this share of the entries; none without `noise`.

    The masks come from a generator of the caller's, so that a gradient is a function of its seed in whatever
    thread it is computed.
    """
    if noise is None or share == 0:
        return x
    return x * (torch.rand(x.shape, generator=noise, device=x.device) >= share) / (1 - share)


class Block(nn.Module):
    """Attention, then a multilayer perceptron, each added to what it was given normalised."""

    def __init__(self, config: TransformerConfig) -> None:
        super().__init__()
        width = config.width
        self.heads, self.dropout = config.heads, config.dropout
        self.norm_attention, self.norm_mlp = nn.LayerNorm(width), nn.LayerNorm(width)
        self.qkv = nn.Linear(width, 3 * width, bias=False)
        self.merge = nn.Linear(width, width)
        self.expand, self.contract = nn.Linear(width, 4 * width), nn.Linear(4 * width, width)

    def forward(self, x: Tensor, noise: torch.Generator | None) -> Tensor:
        """`(B, C, width)` to the same."""
        b, c, d = x.shape
        q, k, v = self.qkv(self.norm_attention(x)).reshape(b, c, 3, self.heads, d // self.heads).permute(2, 0, 3, 1, 4)
        mixed = F.scaled_dot_product_attention(q, k, v, is_causal=True)
        x = x + dropout(self.merge(mixed.transpose(1, 2).reshape(b, c, d)), self.dropout, noise)
        return x + dropout(self.contract(F.gelu(self.expand(self.norm_mlp(x)))), self.dropout, noise)


class Transformer(nn.Module):
    """Tokens of a window to features, each position seeing itself and those before it."""

    def __init__(self, config: TransformerConfig, context: int) -> None:
        super().__init__()
        self.position = nn.Parameter(torch.zeros(context, config.width))
        self.norm_in, self.norm_out = nn.LayerNorm(config.width), nn.LayerNorm(config.width)
        self.blocks = nn.ModuleList(Block(config) for _ in range(config.layers))
        self.dropout = config.dropout
        for module in self.modules():
            if isinstance(module, nn.Linear):
                nn.init.normal_(module.weight, std=0.02)
                if module.bias is not None:
                    nn.init.zeros_(module.bias)

    def forward(self, tokens: Tensor, noise: torch.Generator | None = None) -> Tensor:
        """`(B, C, width)` to the same, C at most the context; dropout only with `noise`."""
        x = dropout(self.norm_in(tokens + self.position[: tokens.shape[1]]), self.dropout, noise)
        for block in self.blocks:
            x = block(x, noise)
        return self.norm_out(x)
