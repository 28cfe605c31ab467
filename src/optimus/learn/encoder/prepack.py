"""Convolutions of one image with weights that are laid out for it once, not at every call.

PyTorch takes its own slow convolution for a single small image, and oneDNN sorts the weights (45 MB in a ResNet-18) anew at every
call. Laid out beforehand an image takes half as long, to the same result.
"""

from __future__ import annotations

import copy
from collections.abc import Callable
from typing import TypeVar

import torch
from torch import Tensor, nn

Found = TypeVar("Found", bound=nn.Module)


class PrepackedConv2d(nn.Module):
    """A convolution's weights in oneDNN's own layout: for inference on a CPU alone."""

    def __init__(self, of: nn.Conv2d, shape: list[int]) -> None:
        super().__init__()
        self.stride, self.padding, self.bias = [*of.stride], [int(p) for p in of.padding], of.bias
        weight = of.weight.detach()
        self.weight = torch.ops.mkldnn._reorder_convolution_weight(weight, self.padding, self.stride, [1, 1], 1, shape)

    def forward(self, x: Tensor) -> Tensor:
        """As `nn.Conv2d`."""
        convolve = torch.ops.mkldnn._convolution_pointwise
        return convolve(x, self.weight, self.bias, self.padding, self.stride, [1, 1], 1, "none", [], "")


def replace(network: nn.Module, kind: type[Found], made: Callable[[Found], nn.Module]) -> None:
    """Put in the place of every module of `kind` in `network` what is `made` of it."""
    for parent in list(network.modules()):
        for name, child in list(parent.named_children()):
            if isinstance(child, kind):
                setattr(parent, name, made(child))


@torch.no_grad()
def prepacked(network: nn.Module, images: Tensor) -> nn.Module:
    """A copy of `network` for inference on inputs of the shape of `images` `(1, 3, h, w)`; the network itself where this build of
    PyTorch cannot."""
    if not (torch.backends.mkldnn.is_available() and hasattr(torch.ops.mkldnn, "_reorder_convolution_weight")):
        return network
    packed = copy.deepcopy(network)
    shapes: dict[nn.Module, list[int]] = {}
    hooks = [
        m.register_forward_hook(lambda m, inputs, _: shapes.__setitem__(m, [*inputs[0].shape]))
        for m in packed.modules()
        if isinstance(m, nn.Conv2d)
    ]
    packed(images)
    for hook in hooks:
        hook.remove()
    replace(packed, nn.Conv2d, lambda convolution: PrepackedConv2d(convolution, shapes[convolution]))
    return packed
