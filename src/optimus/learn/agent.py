"""`PolicyAgent`: a trained policy as an agent that answers one observation at a time."""

from __future__ import annotations

from collections import deque
from pathlib import Path
from typing import Literal

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from optimus.data.episode import GRIPPER, IMAGE_SUFFIX, Observation
from optimus.errors import CheckpointError
from optimus.learn import checkpoint
from optimus.learn.heads import Mixture
from optimus.learn.policy import Policy

Component = Literal["sampled", "likeliest", "paper"]

SHARPNESS = 4.0
"""Where two components mean two ways to the same end, drawing evenly between them at every step leads neither way; always taking
the likelier one may stand still for ever. Between the two: docs/results/first-policies.md."""


class PolicyAgent:
    """Acts on the newest frames: each is encoded once, the transformer sees the tokens of the last few.

    `component` says which mean of the mixture is the answer: one `sampled` by a sharpened weight, or that of the `likeliest`, which
    may freeze where the demonstrations stood still. The gripper is a decision, and one wrong step of it drops what is held: it goes
    by the majority of the weight. `paper` samples by the plain weight, and the gripper with the rest.
    """

    def __init__(
        self,
        policy: Policy | Path | str,
        component: Component = "sampled",
        task: str | None = None,
    ) -> None:
        self.policy = policy if isinstance(policy, Policy) else checkpoint.load(policy, task)
        self.policy.eval()
        self.component: Component = component
        self._tokens: deque[Tensor] = deque(maxlen=self.policy.config.context)
        self._noise = torch.Generator()
        self.reset(0)

    def reset(self, seed: int) -> None:
        """Forget the frames; the answers that follow are a function of the seed and the observations."""
        self._tokens.clear()
        self._noise.manual_seed(seed)

    @torch.inference_mode()
    def act(self, observation: Observation) -> NDArray[np.float32]:
        """The action `(n,)` for the newest observation; the gripper is -1 or 1."""
        token = self._encode(observation)
        # Before the first frame there is the first frame, as in training.
        self._tokens.extend([token] * (1 if self._tokens else self.policy.config.context))
        features = self.policy.features(torch.stack(list(self._tokens), 1))[:, -1]
        mixture = self.policy.mixture(features)
        sharpness = 1.0 if self.component == "paper" else SHARPNESS
        answer = mixture.likeliest() if self.component == "likeliest" else mixture.sampled(self._noise, sharpness)
        action = self.policy.denormalise(answer)[0].numpy().astype(np.float32)
        shut = bool(action[GRIPPER] > 0) if self.component == "paper" else _majority(mixture)
        action[GRIPPER] = 1.0 if shut else -1.0
        return action.clip(-1, 1)

    def _encode(self, observation: Observation) -> Tensor:
        """The token `(1, width)` of one frame."""
        inputs = self.policy.inputs
        needed = [camera + IMAGE_SUFFIX for camera in inputs.cameras] + list(inputs.proprioception)
        missing = [name for name in needed if name not in observation]
        if missing:
            raise CheckpointError(
                f"the policy needs {', '.join(missing)}, the observation has {', '.join(observation)}; "
                "use the environment it was trained in"
            )
        images = {camera: _centre(observation[camera + IMAGE_SUFFIX], self.policy.config.crop) for camera in inputs.cameras}
        low = {name: torch.as_tensor(observation[name], dtype=torch.float32)[None] for name in inputs.proprioception}
        return self.policy.tokens(self.policy.frames(images, low))


def _centre(image: NDArray[np.uint8], side: int) -> Tensor:
    """The middle of an image, `(1, side, side, 3)`."""
    top, left = (image.shape[0] - side) // 2, (image.shape[1] - side) // 2
    return torch.from_numpy(np.ascontiguousarray(image[top : top + side, left : left + side]))[None]


def _majority(mixture: Mixture) -> bool:
    """Whether components of more than half of the weight have the gripper shut."""
    weight = torch.softmax(mixture.logits[0], -1)
    return bool(weight[mixture.mean[0, :, GRIPPER] > 0].sum() > 0.5)
