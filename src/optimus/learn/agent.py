"""`PolicyAgent`: a trained policy as an agent that answers one observation at a time."""

from __future__ import annotations

import copy
import os
import shutil
from collections import deque
from collections.abc import Callable
from pathlib import Path

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from optimus.data.episode import BINARY, CONTINUOUS, IMAGE_SUFFIX, Observation
from optimus.errors import CheckpointError
from optimus.learn import checkpoint
from optimus.learn.encoder.prepack import prepacked
from optimus.learn.heads import Component
from optimus.learn.policy import Policy
from optimus.learn.recording import Recording


class PolicyAgent:
    """Acts on the newest frames: each is encoded once, the trunk sees the tokens of the last few.

    `component` says which mean of the mixture is the answer: one `sampled` by a sharpened weight, or that of the `likeliest`, which
    may freeze where the demonstrations stood still. The gripper is a decision, and one wrong step of it drops what is held: it goes
    by the majority of the weight. `paper` samples by the plain weight, and the gripper with the rest. `continuous` samples like
    `sampled` and leaves the gripper as it comes, for policies that were taught where the fingers are to be.

    `compiled` has PyTorch compile the network first, which takes a minute: for long use. `CheckpointError` if there is no compiler.
    On a `device` of type `cuda` the network is recorded instead (`recording.py`), and the policy is moved there.
    """

    def __init__(
        self,
        policy: Policy | Path | str,
        component: Component = "sampled",
        task: str | None = None,
        compiled: bool = False,
        device: str = "cpu",
    ) -> None:
        self._device = torch.device(device)
        self.policy = (policy if isinstance(policy, Policy) else checkpoint.load(policy, task)).to(self._device)
        self.policy.eval()
        self.component: Component = component
        self._look, self._think = self.policy.token, self.policy.features
        if self._device.type == "cuda":
            self._look, self._think = _recorded(self.policy, self._device)
        elif compiled:
            self._look, self._think = _compiled(self.policy)
        elif self.policy.config.encoder.prepacked:
            self._look = _with_prepacked_encoders(self.policy).token
        self._tokens: deque[Tensor] = deque(maxlen=self.policy.config.context)
        self._planned: deque[NDArray[np.float32]] = deque()
        self._noise = torch.Generator(self._device)
        self.reset()

    def reset(self, seed: int = 0) -> None:
        """Forget the frames; the answers that follow are a function of the seed and the observations."""
        self._tokens.clear()
        self._planned.clear()
        self._noise.manual_seed(seed)

    @torch.no_grad()
    def act(self, observation: Observation) -> NDArray[np.float32]:
        """The action `(n,)` for the newest observation; the gripper is -1 or 1."""
        token = self._look(*self._tensors(observation))
        # Before the first frame there is the first frame, as in training.
        self._tokens.extend([token] * (1 if self._tokens else self.policy.config.context))
        if not self._planned:
            self._plan()
        return self._planned.popleft()

    def _plan(self) -> None:
        """Answer: with the next action, or the next few where the head answers in chunks."""
        features = self._think(torch.stack(list(self._tokens), 1))[:, -1]
        answer = self.policy.answers(features).answer(self.component, self._noise)
        actions = self.policy.denormalise(answer).cpu().numpy().astype(np.float32).clip(-1, 1)
        self._planned.extend(actions.reshape(-1, actions.shape[-1])[: self.policy.config.head.executed])

    def _tensors(self, observation: Observation) -> tuple[dict[str, Tensor], dict[str, Tensor]]:
        """Images and proprioception of one frame, as the policy takes them."""
        inputs, crop = self.policy.inputs, self.policy.config.crop
        needed = [camera + IMAGE_SUFFIX for camera in inputs.cameras] + list(inputs.proprioception)
        missing = [name for name in needed if name not in observation]
        if missing:
            raise CheckpointError(
                f"the policy needs {', '.join(missing)}, the observation has {', '.join(observation)}; "
                "use the environment it was trained in"
            )
        for name, size in inputs.proprioception.items():
            if observation[name].shape != (size,):
                raise CheckpointError(
                    f"the policy needs {name} of shape ({size},), the observation has {observation[name].shape}; "
                    "use the environment it was trained in"
                )
        images = {camera: _centre(observation[camera + IMAGE_SUFFIX], crop).to(self._device) for camera in inputs.cameras}
        low = {name: torch.as_tensor(observation[name], dtype=torch.float32)[None] for name in inputs.proprioception}
        return images, {name: value.to(self._device) for name, value in low.items()}


def trained_agent(run: Path, component: Component = "sampled", compiled: bool = False) -> PolicyAgent:
    """The policy of that run folder, ready to act; its gripper moves as in the demonstrations that it was trained on.
    `CheckpointError` for another component than a `sampled` one where that gripper was continuous."""
    if checkpoint.gripper_of(run) == BINARY:
        return PolicyAgent(run, component, compiled=compiled)
    if component != "sampled":
        raise CheckpointError(f"{run} was taught a continuous gripper, whose component is sampled: no {component!r}")
    return PolicyAgent(run, CONTINUOUS, compiled=compiled)


def compiler() -> str | None:
    """The C++ compiler that PyTorch would compile a network with, if it is there."""
    return shutil.which(os.environ.get("CXX", "c++"))


@torch.no_grad()
def _compiled(policy: Policy) -> tuple[Callable[..., Tensor], Callable[..., Tensor]]:
    """`policy.token` of one frame and `policy.features` of one window, compiled: the weights become constants that are laid out for
    the machine, which PyTorch does only where this is set while it compiles."""
    if compiler() is None:
        raise CheckpointError("to compile a policy needs a C++ compiler: c++ on the path, or the one that CXX names; do without")
    from torch._inductor import config as inductor  # seconds to import, and only this needs it

    look, think = torch.compile(policy.token, dynamic=False), torch.compile(policy.features, dynamic=False)
    with inductor.patch(freezing=True):
        think(look(*_made_up(policy, torch.device("cpu")))[:, None].repeat(1, policy.config.context, 1))
    return look, think


def _made_up(policy: Policy, device: torch.device) -> tuple[dict[str, Tensor], dict[str, Tensor]]:
    """Images and proprioception of one frame, of the right shapes."""
    side, seen = policy.config.crop, policy.inputs
    images = {camera: torch.zeros(1, side, side, 3, dtype=torch.uint8, device=device) for camera in seen.cameras}
    return images, {name: torch.ones(1, size, device=device) for name, size in seen.proprioception.items()}


@torch.no_grad()
def _recorded(policy: Policy, device: torch.device) -> tuple[Callable[..., Tensor], Callable[..., Tensor]]:
    """`policy.token` of one frame and `policy.features` of one window, recorded on a GPU."""
    images, low = _made_up(policy, device)
    frame = {**images, **low}  # cameras and proprioception have different names
    look = Recording(lambda x: policy.token({c: x[c] for c in images}, {n: x[n] for n in low}), frame)
    window = look(frame)[:, None].repeat(1, policy.config.context, 1)
    think = Recording(lambda x: policy.features(x["window"]), {"window": window})
    # copies: the next call overwrites what a recording returned
    return lambda images, low: look({**images, **low}).clone(), lambda window: think({"window": window}).clone()


def _with_prepacked_encoders(policy: Policy) -> Policy:
    """A copy of the policy to encode one frame at a time with."""
    acting = copy.deepcopy(policy)
    side = policy.config.crop
    for encoder in acting.encoders.values():
        image = torch.zeros(1, 3, side, side).to(memory_format=torch.channels_last)
        encoder.trunk = prepacked(encoder.get_submodule("trunk"), image)
    return acting


def _centre(image: NDArray[np.uint8], side: int) -> Tensor:
    """The middle of an image, `(1, side, side, 3)`; `CheckpointError` if it is none, or too small."""
    if image.dtype != np.uint8 or image.ndim != 3 or image.shape[2] != 3 or min(image.shape[:2]) < side:
        raise CheckpointError(
            f"the policy needs images of type uint8 and shape (h, w, 3), h and w at least {side}; "
            f"this one has type {image.dtype} and shape {image.shape}"
        )
    top, left = (image.shape[0] - side) // 2, (image.shape[1] - side) // 2
    return torch.from_numpy(np.ascontiguousarray(image[top : top + side, left : left + side]))[None]
