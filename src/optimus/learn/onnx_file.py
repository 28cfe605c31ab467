"""A policy as an ONNX file: one step from an observation to an action, with its crops and normalisation inside.

Inputs: `<camera>_image` `(84, 84, 3)` uint8; each low-dimensional observation `(n,)` float32; `tokens` `(context, width)` float32,
what the step before gave (anything at the first step); `first` (bool): forget what was before.

Outputs: `action` `(chunk, n)` float32, the likeliest, gripper -1 or 1; `next_tokens`, for the next step; and of a mixture
`weights` `(K,)` and `means` `(K, n)`, to draw from instead.
"""

from __future__ import annotations

import copy
import json
import tempfile
from dataclasses import asdict
from pathlib import Path
from typing import Any

import torch
from torch import Tensor, nn

from optimus.data.atomic import write_whole
from optimus.data.episode import IMAGE_SIZE, IMAGE_SUFFIX
from optimus.errors import OptimusError
from optimus.learn.heads import Mixture
from optimus.learn.policy import Policy

OPSET = 18


class ExportError(OptimusError):
    """A policy that cannot be written in another format."""


def export_onnx(policy: Policy, file: Path) -> None:
    """Write `policy` to `file`; `ExportError` without the packages of the extra `onnx`."""
    try:
        import onnx  # heavy, and few need it: the extra `onnx`
        import onnxscript  # noqa: F401
    except ImportError as error:
        raise ExportError(f"ONNX files need {error.name}, which is not installed; pip install 'optimus-tamp[onnx]'") from error
    step = OneStep(policy).eval()
    with tempfile.TemporaryDirectory() as folder, torch.no_grad():
        program = torch.onnx.export(
            step,
            step.example(),
            input_names=step.inputs,
            output_names=step.outputs,
            opset_version=OPSET,
            dynamo=True,
            verbose=False,
        )
        assert program is not None
        made = Path(folder) / "policy.onnx"
        program.save(str(made))
        model = onnx.load(str(made))
    about = {"inputs": asdict(policy.inputs), "context": policy.config.context, "parameters": policy.parameter_count}
    for key, value in about.items():
        model.metadata_props.add(key=f"optimus.{key}", value=json.dumps(value))
    write_whole(file, model.SerializeToString())


class OneStep(nn.Module):
    """One step of a policy, of tensors alone."""

    def __init__(self, policy: Policy) -> None:
        super().__init__()
        self.policy = copy.deepcopy(policy).eval().requires_grad_(False)
        seen = policy.inputs
        self.inputs = [*(camera + IMAGE_SUFFIX for camera in seen.cameras), *seen.proprioception, "tokens", "first"]
        answers = self._answers(torch.zeros(1, policy.config.trunk.width))
        self.outputs = ["action", "next_tokens", *(("weights", "means") if isinstance(answers, Mixture) else ())]

    def example(self) -> tuple[Tensor, ...]:
        """Inputs of the right shapes."""
        config, seen = self.policy.config, self.policy.inputs
        return (
            *(torch.zeros(IMAGE_SIZE, IMAGE_SIZE, 3, dtype=torch.uint8) for _ in seen.cameras),
            *(torch.ones(size) for size in seen.proprioception.values()),
            torch.zeros(config.context, config.trunk.token),
            torch.tensor(True),
        )

    def forward(self, *inputs: Tensor) -> tuple[Tensor, ...]:
        """See the module."""
        policy, values = self.policy, dict(zip(self.inputs, inputs, strict=True))
        edge = (IMAGE_SIZE - policy.config.crop) // 2
        inside = slice(edge, edge + policy.config.crop)
        images = {c: values[c + IMAGE_SUFFIX][inside, inside][None] for c in policy.inputs.cameras}
        token = policy.token(images, {name: values[name][None] for name in policy.inputs.proprioception})
        moved = torch.cat([values["tokens"][1:], token])
        tokens = torch.where(values["first"], token.expand_as(moved), moved)
        answers = self._answers(policy.features(tokens[None])[:, -1])
        action = policy.denormalise(answers.answer("likeliest", torch.Generator())).clip(-1, 1)
        rest: tuple[Tensor, ...] = ()
        if isinstance(answers, Mixture):
            rest = (torch.softmax(answers.logits[0], -1), policy.denormalise(answers.mean[0]))
        return action.reshape(-1, action.shape[-1]), tokens, *rest

    def _answers(self, features: Tensor) -> Any:
        return self.policy.answers(features)
