"""How well a policy answers on held-out episodes: this, unlike the likelihood, goes with success."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import torch
from torch import Tensor

from optimus.data.episode import GRIPPER
from optimus.data.windows import Windows
from optimus.learn.gradient import tensors
from optimus.learn.policy import Policy

_RUNS_AT_ONCE = 32


@torch.inference_mode()
def held_out(policy: Policy, windows: Windows, runs: int, position_scale: float | None = None) -> dict[str, float]:
    """Errors of the likeliest component's mean at the last frame of evenly spread windows, centre crop.

    `action_error`: mean distance in position (under joint control: of the joints), in units of the action;
    `action_error_mm`: the same [mm] if the action's scale [m] is known; `gripper_right`: share of gripper answers
    with the label's sign; `likelihood`: mean negative log-likelihood; `location_error_mm`: mean distance of the auxiliary answer,
    if the policy was taught it.
    """
    indices = np.unique(np.linspace(0, len(windows) - 1, min(runs, len(windows))).astype(int))
    rows = [_errors(policy, windows, part) for part in np.array_split(indices, -(-len(indices) // _RUNS_AT_ONCE))]
    mean = {name: float(torch.cat([row[name] for row in rows]).mean()) for name in rows[0]}
    if position_scale is not None:
        mean["action_error_mm"] = 1000 * position_scale * mean["action_error"]
    return mean


def _errors(policy: Policy, windows: Windows, indices: np.ndarray) -> dict[str, Tensor]:
    batch = windows.batch(indices)
    frames = policy.frames(tensors(batch.images), tensors(batch.proprioception))
    context = policy.config.context
    features = policy.features(policy.tokens(frames[:, -context:]))[:, -1]
    label = torch.from_numpy(batch.actions[:, -1])
    mixture = policy.mixture(features)
    answer = policy.denormalise(mixture.likeliest())
    distance: Callable[[Tensor], Tensor] = lambda x: torch.linalg.vector_norm(x, dim=-1)  # noqa: E731
    seen = frames[:, -1]
    place = policy.located(seen) * policy.objects_deviation + policy.objects_mean
    objects = torch.from_numpy(batch.objects[:, -1])
    located = {}
    if objects.shape[1]:
        located["location_error_mm"] = 1000 * distance(place.unflatten(-1, (-1, 3)) - objects).mean(-1)
    arm = zip(("action_error", "rotation_error"), policy.inputs.arm_parts, strict=False)
    return {
        **{name: distance(answer[:, part] - label[:, part]) for name, part in arm},
        "gripper_right": (answer[:, GRIPPER].sign() == label[:, GRIPPER].sign()).float(),
        "likelihood": -mixture.log_density(policy.normalise(label)),
        **located,
    }
