"""`PolicyAgent`: a trained policy as an agent that answers one observation at a time."""

from __future__ import annotations

import copy
from collections import deque
from collections.abc import Callable
from pathlib import Path
from typing import get_args

import numpy as np
import torch
from numpy.typing import ArrayLike, NDArray
from torch import Tensor

from optimus.data.episode import BINARY, CONTINUOUS, DOOR_ANGLES, IMAGE_SUFFIX, OBJECT_POSITIONS, OBJECT_TURNS, Observation
from optimus.errors import CheckpointError, UnknownNameError
from optimus.learn import checkpoint
from optimus.learn.encoder.prepack import prepacked
from optimus.learn.heads import Component
from optimus.learn.onnx_runtime import by_onnx_runtime
from optimus.learn.policy import Policy
from optimus.learn.recording import Recording

OF_THINGS = (OBJECT_POSITIONS, OBJECT_TURNS, DOOR_ANGLES)
"""Observations of which there are as many as the scene has things or doors."""


class PolicyAgent:
    """Acts on the newest frames: each is encoded once, the trunk sees the tokens of the last few.

    `component` says which mean of the mixture is the answer: one `sampled` by a sharpened weight, or that of the `likeliest`, which
    may freeze where the demonstrations stood still. The gripper is a decision, and one wrong step of it drops what is held: it goes
    by the majority of the weight. `paper` samples by the plain weight, and the gripper with the rest. `continuous` samples like
    `sampled` and leaves the gripper as it comes, for policies that were taught where the fingers are to be.

    `compiled` has ONNX Runtime compute the network, which takes some seconds to prepare: the same answers but for rounding, in two
    thirds of the time of a large network, in less than half of that of a small one. `CheckpointError` without the packages of the
    extra `onnx`.
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
        if component not in (known := get_args(Component)):
            raise UnknownNameError("component", component, known)
        self._device = torch.device(device)
        self.policy = (policy if isinstance(policy, Policy) else checkpoint.load(policy, task)).to(self._device)
        self.policy.eval()
        self.component: Component = component
        self._several = len(checkpoint.tasks_of(self.policy.inputs.task)) > 1
        self._look, self._think = self.policy.token, self.policy.features
        if self._device.type == "cuda":
            self._look, self._think = _recorded(self.policy, self._device)
        elif compiled:
            self._look, self._think = by_onnx_runtime(self.policy, *_made_up(self.policy, self._device))
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
        self._noise.manual_seed(int(seed))

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
        if self._several:  # in a scene that has no doors they are shut, as in training
            observation = {DOOR_ANGLES: np.zeros(0, np.float32), **observation}
        needed = [camera + IMAGE_SUFFIX for camera in inputs.cameras] + list(inputs.proprioception)
        missing = [name for name in needed if name not in observation]
        if missing:
            raise CheckpointError(
                f"the policy needs {', '.join(missing)}, the observation has {', '.join(observation)}; "
                "use the environment it was trained in"
            )
        images = {c: _centre(np.asarray(observation[c + IMAGE_SUFFIX]), inputs.frame, crop) for c in inputs.cameras}
        low = {name: self._told(name, _numbers(name, observation[name])) for name in inputs.proprioception}
        return {c: x.to(self._device) for c, x in images.items()}, {name: x.to(self._device) for name, x in low.items()}

    def _told(self, name: str, value: NDArray[np.float32]) -> Tensor:
        """One low-dimensional observation `(1, n)`; to a policy of several tasks with zeros for things that a scene lacks."""
        size = self.policy.inputs.proprioception[name]
        if self._several and name in OF_THINGS and value.ndim == 1:
            value = np.pad(value, (0, max(0, size - len(value))))
        if value.shape != (size,):
            raise CheckpointError(
                f"the policy needs {name} of shape ({size},), the observation has {value.shape}; "
                "use the environment it was trained in"
            )
        if not np.isfinite(value).all():
            raise CheckpointError(f"the observation's {name} holds NaN or infinity")
        return torch.tensor(value)[None]


def _numbers(name: str, value: ArrayLike) -> NDArray[np.float32]:
    try:
        return np.asarray(value, np.float32)
    except (TypeError, ValueError) as error:
        raise CheckpointError(f"the observation's {name} is no array of numbers ({error})") from error


def trained_agent(run: Path, component: Component = "sampled", compiled: bool = False) -> PolicyAgent:
    """The policy of that run folder, ready to act; its gripper moves as in the demonstrations that it was trained on.
    `CheckpointError` for another component than a `sampled` one where that gripper was continuous."""
    if checkpoint.gripper_of(run) == BINARY:
        return PolicyAgent(run, component, compiled=compiled)
    if component != "sampled":
        raise CheckpointError(f"{run} was taught a continuous gripper, whose component is sampled: no {component!r}")
    return PolicyAgent(run, CONTINUOUS, compiled=compiled)


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


def _centre(image: NDArray[np.uint8], frame: tuple[int, int] | None, side: int) -> Tensor:
    """The middle of an image, `(1, side, side, 3)`; `CheckpointError` if it is none, or not of the size that the policy was trained
    on: of another size the middle shows something else."""
    fits = image.dtype == np.uint8 and image.ndim == 3 and image.shape[2] == 3 and min(image.shape[:2]) >= side
    if not fits or (frame is not None and image.shape[:2] != frame):
        height, width = frame or ("h", "w")
        raise CheckpointError(
            f"the policy needs images of type uint8 and shape ({height}, {width}, 3); "
            f"this one has type {image.dtype} and shape {image.shape}"
        )
    top, left = (image.shape[0] - side) // 2, (image.shape[1] - side) // 2
    return torch.from_numpy(np.ascontiguousarray(image[top : top + side, left : left + side]))[None]
