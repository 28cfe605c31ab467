"""Work on a GPU, recorded once as a CUDA graph and replayed: its hundreds of kernels are started by one call.

A small network's kernels take less time than starting them one by one from Python (docs/gpu.md has the figures).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Generic, TypeVar

import torch
from torch import Tensor

Out = TypeVar("Out")

_WARM_UPS = 3
"""Runs before the recording: libraries choose their kernels and take their memory in the first ones."""


class Recording(Generic[Out]):
    """A function of named tensors on one GPU, whose shapes never change and whose work is the same at every call.

    What a call returns are always the same tensors, which the next call overwrites.
    """

    def __init__(
        self, function: Callable[[Mapping[str, Tensor]], Out], example: Mapping[str, Tensor], noise: torch.Generator | None = None
    ) -> None:
        """`example` is on the GPU; `noise` is the generator that `function` draws from, if it does: seed it before a call."""
        self._inputs = {name: tensor.clone() for name, tensor in example.items()}
        with torch.cuda.device(next(iter(self._inputs.values())).device):
            self._record(function, noise)

    def _record(self, function: Callable[[Mapping[str, Tensor]], Out], noise: torch.Generator | None) -> None:
        self._graph = torch.cuda.CUDAGraph()
        if noise is not None:
            self._graph.register_generator_state(noise)
        beside = torch.cuda.Stream()
        beside.wait_stream(torch.cuda.current_stream())
        with torch.cuda.stream(beside):
            for _ in range(_WARM_UPS):
                function(self._inputs)
        torch.cuda.current_stream().wait_stream(beside)
        with torch.cuda.graph(self._graph):
            self._outputs = function(self._inputs)

    def __call__(self, inputs: Mapping[str, Tensor]) -> Out:
        """The function of `inputs`, of the example's shapes, wherever they are."""
        for name, held in self._inputs.items():
            held.copy_(inputs[name], non_blocking=True)
        self._graph.replay()
        return self._outputs
