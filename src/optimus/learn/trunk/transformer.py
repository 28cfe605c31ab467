"""A causal transformer over the frames of a window (Radford et al., 2019), their places in the window learned."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import torch
import torch.nn.functional as F
from torch import Tensor, nn

from optimus.learn.trunk.dropout import dropout


@dataclass(frozen=True)
class TransformerConfig:
    """A pre-norm GPT."""

    width: int = 128
    layers: int = 3
    heads: int = 4
    dropout: float = 0.0
    """Share dropped after the input and each half block; 0.1 in the paper, which costs a small policy precision."""
    attention_dropout: float = 0.0
    """Share of the attention weights dropped; 0.1 in the paper."""
    kind: Literal["transformer"] = "transformer"

    @property
    def token(self) -> int:
        """Size of the tokens it reads."""
        return self.width

    def build(self, context: int) -> Transformer:
        """A trunk with random weights."""
        return Transformer(self, context)


class Block(nn.Module):
    """Attention, then a multilayer perceptron, each added to what it was given normalised."""

    def __init__(self, config: TransformerConfig) -> None:
        super().__init__()
        width = config.width
        self.heads, self.dropout, self.attention_dropout = config.heads, config.dropout, config.attention_dropout
        self.norm_attention, self.norm_mlp = nn.LayerNorm(width), nn.LayerNorm(width)
        self.qkv = nn.Linear(width, 3 * width, bias=False)
        self.merge = nn.Linear(width, width)
        self.expand, self.contract = nn.Linear(width, 4 * width), nn.Linear(4 * width, width)

    def forward(self, x: Tensor, noise: torch.Generator | None) -> Tensor:
        """`(B, C, width)` to the same."""
        b, c, d = x.shape
        q, k, v = self.qkv(self.norm_attention(x)).reshape(b, c, 3, self.heads, d // self.heads).permute(2, 0, 3, 1, 4)
        if noise is None or self.attention_dropout == 0:
            mixed = F.scaled_dot_product_attention(q, k, v, is_causal=True)
        else:
            mixed = _attention(q, k, v, self.attention_dropout, noise)
        x = x + dropout(self.merge(mixed.transpose(1, 2).reshape(b, c, d)), self.dropout, noise)
        return x + dropout(self.contract(F.gelu(self.expand(self.norm_mlp(x)))), self.dropout, noise)


def _attention(q: Tensor, k: Tensor, v: Tensor, share: float, noise: torch.Generator) -> Tensor:
    """Causal attention `(B, heads, C, d)` with a share of its weights dropped: PyTorch's own drops by a generator of its own."""
    scores = q @ k.transpose(-1, -2) / math.sqrt(q.shape[-1])
    later = torch.ones(scores.shape[-2:], dtype=torch.bool, device=q.device).triu(1)
    weights = F.softmax(scores.masked_fill(later, -math.inf), -1)
    return dropout(weights, share, noise) @ v


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
