"""A policy's network computed by ONNX Runtime, for long use on a CPU.

On one image at a time PyTorch spends most of its time between the operations, and on convolutions meant for many.
"""

from __future__ import annotations

import copy
import importlib.util
from collections.abc import Callable, Mapping

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn

from optimus.errors import CheckpointError
from optimus.learn.encoder.prepack import replace
from optimus.learn.encoder.small_maps import GatheredConv2d, SmallMapConv2d
from optimus.learn.onnx_file import onnx_model
from optimus.learn.policy import Policy

NEEDED = ("onnx", "onnxscript", "onnxruntime")


def is_installed() -> bool:
    """Whether the packages that this needs are there."""
    return all(importlib.util.find_spec(name) is not None for name in NEEDED)


class _Looking(nn.Module):
    """`Policy.token` of images and proprioception one after the other."""

    def __init__(self, policy: Policy) -> None:
        super().__init__()
        self.policy = copy.deepcopy(policy)
        replace(self.policy, SmallMapConv2d, GatheredConv2d)
        self.names = [*policy.inputs.cameras, *policy.inputs.proprioception]

    def forward(self, *inputs: Tensor) -> Tensor:
        values, cameras = dict(zip(self.names, inputs, strict=True)), self.policy.inputs.cameras
        return self.policy.token({c: values[c] for c in cameras}, {n: v for n, v in values.items() if n not in cameras})


class _Thinking(nn.Module):
    """`Policy.features` of a window."""

    def __init__(self, policy: Policy) -> None:
        super().__init__()
        self.policy = policy

    def forward(self, tokens: Tensor) -> Tensor:
        return self.policy.features(tokens)


@torch.no_grad()
def by_onnx_runtime(
    policy: Policy, images: Mapping[str, Tensor], low: Mapping[str, Tensor]
) -> tuple[Callable[..., Tensor], Callable[..., Tensor]]:
    """`policy.token` of one frame and `policy.features` of one window; `images` and `low` are a frame of the right shapes.

    It takes some seconds to prepare. `CheckpointError` without the packages of the extra `onnx`.
    """
    if not is_installed():
        raise CheckpointError(f"a compiled policy needs {', '.join(NEEDED)}; pip install 'optimus-tamp[onnx]', or do without")
    looking = _Looking(policy)
    window = policy.token(images, low)[:, None].repeat(1, policy.config.context, 1)
    look = _session(looking, (*images.values(), *low.values()), looking.names)
    think = _session(_Thinking(policy), (window,), ["tokens"])
    return lambda images, low: look({**images, **low}), lambda tokens: think({"tokens": tokens})


def _session(network: nn.Module, example: tuple[Tensor, ...], names: list[str]) -> Callable[[Mapping[str, Tensor]], Tensor]:
    """The network, from tensors by name to its one output."""
    import onnxruntime  # an extra

    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads, options.inter_op_num_threads = torch.get_num_threads(), 1
    model = onnx_model(network.eval(), example, names, ["result"]).SerializeToString()
    session = onnxruntime.InferenceSession(model, options, providers=["CPUExecutionProvider"])

    def run(values: Mapping[str, Tensor]) -> Tensor:
        arrays: dict[str, NDArray[np.generic]] = {name: value.numpy() for name, value in values.items()}
        return torch.from_numpy(session.run(["result"], arrays)[0])

    return run
