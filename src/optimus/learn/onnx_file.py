"""A policy as an ONNX file: one step from an observation to an action, with its crops and normalisation inside.

Inputs: `<camera>_image` `(84, 84, 3)` uint8 (or of the size that the policy was trained on); each low-dimensional observation
`(n,)` float32; `tokens` `(context, width)` float32, what the step before gave (anything at the first step); `first` (bool): forget
what was before.

Outputs: `action` `(chunk, n)` float32, the likeliest, of which the first `optimus.executed` (in the metadata) are for this step and
those that follow, its gripper -1 or 1, or as it comes where `optimus.gripper` is continuous; `next_tokens`, for the next step; and
of a mixture `weights` `(K,)` and `means` `(K, n)`, to draw from instead.
"""

from __future__ import annotations

import copy
import json
import logging
import tempfile
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import Any

import torch
from torch import Tensor, nn

from optimus.data.atomic import write_whole
from optimus.data.episode import BINARY, CONTINUOUS, IMAGE_SIZE, IMAGE_SUFFIX
from optimus.errors import OptimusError
from optimus.learn.heads import Mixture
from optimus.learn.policy import Policy

OPSET = 18


class ExportError(OptimusError):
    """A policy that cannot be written in another format."""


def export_onnx(policy: Policy, file: Path, gripper: str = BINARY) -> None:
    """Write `policy`, which was taught with that kind of `gripper`, to `file`; `ExportError` without the packages of the extra
    `onnx`, or if its cameras have pictures of different sizes."""
    step = OneStep(policy, gripper).eval()
    model = onnx_model(step, step.example(), step.inputs, step.outputs)
    config = policy.config
    about = {"inputs": asdict(policy.inputs), "context": config.context, "executed": config.head.executed, "gripper": gripper}
    about["parameters"] = policy.parameter_count
    for key, value in about.items():
        model.metadata_props.add(key=f"optimus.{key}", value=json.dumps(value))
    write_whole(file, model.SerializeToString())


def onnx_model(network: nn.Module, example: tuple[Tensor, ...], inputs: list[str], outputs: list[str]) -> Any:
    """The network as an `onnx.ModelProto`, for inputs of the shapes of `example`; `ExportError` without the packages of the extra
    `onnx`."""
    try:
        import onnx  # heavy, and few need it: the extra `onnx`
        import onnxscript  # noqa: F401
    except ImportError as error:
        raise ExportError(f"ONNX files need {error.name}, which is not installed; pip install 'optimus-tamp[onnx]'") from error
    with tempfile.TemporaryDirectory() as folder, torch.no_grad(), _without_chatter():
        program = torch.onnx.export(
            network, example, input_names=inputs, output_names=outputs, opset_version=OPSET, dynamo=True, verbose=False
        )
        assert program is not None
        made = Path(folder) / "policy.onnx"
        program.save(str(made))
        return onnx.load(str(made))


@contextmanager
def _without_chatter() -> Iterator[None]:
    """What PyTorch says as it exports is about packages that are not needed, and about its own future."""
    logger = logging.getLogger("torch.onnx")
    level = logger.level
    logger.setLevel(logging.ERROR)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    finally:
        logger.setLevel(level)


class OneStep(nn.Module):
    """One step of a policy, of tensors alone."""

    def __init__(self, policy: Policy, gripper: str = BINARY) -> None:
        super().__init__()
        self.policy, self.gripper = copy.deepcopy(policy).eval().requires_grad_(False), gripper
        seen = policy.inputs
        if seen.cameras and seen.frame is None:
            raise ExportError("the cameras of this policy have pictures of different sizes; an ONNX file has one for all")
        self.frame = seen.frame or (IMAGE_SIZE, IMAGE_SIZE)
        self.inputs = [*(camera + IMAGE_SUFFIX for camera in seen.cameras), *seen.proprioception, "tokens", "first"]
        answers = self._answers(torch.zeros(1, policy.config.trunk.width))
        self.outputs = ["action", "next_tokens", *(("weights", "means") if isinstance(answers, Mixture) else ())]

    def example(self) -> tuple[Tensor, ...]:
        """Inputs of the right shapes."""
        config, seen = self.policy.config, self.policy.inputs
        return (
            *(torch.zeros(*self.frame, 3, dtype=torch.uint8) for _ in seen.cameras),
            *(torch.ones(size) for size in seen.proprioception.values()),
            torch.zeros(config.context, config.trunk.token),
            torch.tensor(True),
        )

    def forward(self, *inputs: Tensor) -> tuple[Tensor, ...]:
        """See the module."""
        policy, values = self.policy, dict(zip(self.inputs, inputs, strict=True))
        side = policy.config.crop
        rows, columns = (slice((length - side) // 2, (length - side) // 2 + side) for length in self.frame)
        images = {c: values[c + IMAGE_SUFFIX][rows, columns][None] for c in policy.inputs.cameras}
        token = policy.token(images, {name: values[name][None] for name in policy.inputs.proprioception})
        moved = torch.cat([values["tokens"][1:], token])
        tokens = torch.where(values["first"], token.expand_as(moved), moved)
        answers = self._answers(policy.features(tokens[None])[:, -1])
        chosen = answers.likeliest() if self.gripper == CONTINUOUS else answers.answer("likeliest", torch.Generator())
        action = policy.denormalise(chosen).clip(-1, 1)
        rest: tuple[Tensor, ...] = ()
        if isinstance(answers, Mixture):
            rest = (torch.softmax(answers.logits[0], -1), policy.denormalise(answers.mean[0]))
        return action.reshape(-1, action.shape[-1]), tokens, *rest

    def _answers(self, features: Tensor) -> Any:
        return self.policy.answers(features)
