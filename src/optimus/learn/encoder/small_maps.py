"""Convolutions onto maps of a few pixels as products of matrices: what convolution kernels are slow at, worst in their gradients.

On a map of 3 x 3 most of a 3 x 3 kernel's taps lie outside: of 9 x 9 pairs of pixel and tap only 49 meet. Each tap is one product
over the pixels that it meets, so the padding is never computed with.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import torch
import torch.nn.functional as F
from torch import Tensor, nn

_LARGEST = 3
"""Side of the largest map [pixels] that is faster this way: at 5 the time is equal (docs/performance.md)."""
_WORTH_IT = 16
"""Images from which on it is faster."""

_Span = tuple[slice, slice]


class SmallMapConv2d(nn.Conv2d):
    """A convolution 3 x 3 with a padding of 1 that takes the faster way, on a CPU, in training."""

    as_products = True
    """Off: always the library's convolution."""

    def forward(self, input: Tensor) -> Tensor:
        """As `nn.Conv2d`."""
        usual = not self.as_products or not self.is_small(input) or len(input) < _WORTH_IT or input.device.type != "cpu"
        if usual or not torch.is_grad_enabled():
            return super().forward(input)
        half = torch.is_autocast_enabled("cpu")
        kind = torch.bfloat16 if half else input.dtype
        with torch.autocast("cpu", enabled=False):
            return TapProducts.apply(input.to(kind), self.weight.to(kind), self.stride[0])

    def is_small(self, input: Tensor) -> bool:
        """Whether what it makes of `input` is a small map."""
        return (max(input.shape[-2:]) - 1) // self.stride[0] + 1 <= _LARGEST


class GatheredConv2d(nn.Module):
    """The same convolution of one image, for ONNX Runtime: what each pixel's taps see is gathered, and then it is one product.

    The library's own reads all weights once for every row of the map, and they do not stay in the cache: 10 MB for 3 x 3 pixels of
    512 channels. A product reads them once.
    """

    def __init__(self, of: SmallMapConv2d) -> None:
        super().__init__()
        self.of, self.stride = of, of.stride[0]

    def forward(self, input: Tensor) -> Tensor:
        """As `nn.Conv2d`, of one image `(1, c, h, w)`."""
        if not self.of.is_small(input):
            return self.of(input)
        channels, high, wide = input.shape[1:]
        made = [(side - 1) // self.stride + 1 for side in (high, wide)]
        pixels = torch.cat([input.reshape(channels, -1).T, input.new_zeros(1, channels)])  # the last one is the padding
        seen = pixels[self._seen(high, wide)].reshape(-1, 9 * channels)
        taps = self.of.weight.permute(0, 2, 3, 1).reshape(-1, 9 * channels, 1, 1)  # ONNX Runtime sorts them once
        return F.conv2d(seen.T.reshape(1, -1, *made), taps)

    def _seen(self, high: int, wide: int) -> Tensor:
        """The pixel that each tap of each pixel made sees, tap after tap, pixel after pixel."""
        padded = F.pad(torch.arange(high * wide).view(high, wide), (1, 1, 1, 1), value=high * wide)
        return padded.unfold(0, 3, self.stride).unfold(1, 3, self.stride).flatten()


class TapProducts(torch.autograd.Function):
    """`conv2d(x, weight, stride=stride, padding=1)` for kernels of 3 x 3, tap by tap; sums of taps are kept in float32."""

    @staticmethod
    def forward(ctx: Any, x: Tensor, weight: Tensor, stride: int) -> Tensor:
        n, c, h, w = x.shape
        wider, high, wide = len(weight), (h - 1) // stride + 1, (w - 1) // stride + 1
        pixels = x.permute(2, 3, 0, 1).contiguous()
        out = x.new_zeros((high, wide, n, wider), dtype=torch.float32)
        for tap, seen, made in _taps((h, w), (high, wide), stride):
            rows = pixels[seen].reshape(-1, c) @ weight[(..., *tap)].T
            out[made] += rows.view(out[made].shape)
        ctx.save_for_backward(pixels, weight)
        ctx.stride = stride
        return out.to(x.dtype).permute(2, 3, 0, 1)

    @staticmethod
    def backward(ctx: Any, *gradients: Tensor) -> tuple[Tensor, Tensor, None]:
        pixels, weight = ctx.saved_tensors
        above = gradients[0].permute(2, 3, 0, 1).contiguous()
        h, w, _, c = pixels.shape
        high, wide, _, wider = above.shape
        below = torch.zeros_like(pixels, dtype=torch.float32)
        of_weight = torch.empty_like(weight)  # in the weight's own layout: the optimiser is slow where the two differ
        for tap, seen, made in _taps((h, w), (high, wide), ctx.stride):
            rows = above[made].reshape(-1, wider)
            below[seen] += (rows @ weight[(..., *tap)]).view(below[seen].shape)
            of_weight[(..., *tap)] = rows.T @ pixels[seen].reshape(-1, c)
        return below.to(pixels.dtype).permute(2, 3, 0, 1), of_weight, None


def _taps(seen: tuple[int, int], made: tuple[int, int], stride: int) -> Iterator[tuple[tuple[int, int], _Span, _Span]]:
    """Each tap of a kernel 3 x 3: the pixels of the map below that it sees, and those of the map above that it makes."""
    rows, columns = (_spans(n, m, stride) for n, m in zip(seen, made, strict=True))
    for i, (row_seen, row_made) in enumerate(rows):
        for j, (column_seen, column_made) in enumerate(columns):
            yield (i, j), (row_seen, column_seen), (row_made, column_made)


def _spans(seen: int, made: int, stride: int) -> list[tuple[slice, slice]]:
    """The same along one axis."""
    spans = []
    for tap in range(3):
        inside = [k for k in range(made) if 0 <= k * stride + tap - 1 < seen]
        first, last = (inside[k] * stride + tap - 1 for k in (0, -1)) if inside else (0, -1)
        spans.append((slice(first, last + 1, stride), slice(inside[0], inside[-1] + 1) if inside else slice(0, 0)))
    return spans
