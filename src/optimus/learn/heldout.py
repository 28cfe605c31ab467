"""How well a policy answers on held-out episodes: this, unlike the likelihood, goes with success."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import torch
from torch import Tensor

from optimus.data.episode import GRIPPER
from optimus.data.windows import Windows
from optimus.learn.batches import on_device
from optimus.learn.policy import Policy

_RUNS_AT_ONCE = 32


@torch.inference_mode()
def held_out(policy: Policy, windows: Windows, runs: int, position_scale: float | None = None) -> dict[str, float]:
    """Errors of the likeliest answer at the last frame of evenly spread windows, centre crop.

    `action_error`: mean distance in position (under joint control: of the joints), in units of the action;
    `action_error_mm`: the same [mm] if the action's scale [m] is known; `gripper_right`: share of gripper answers
    with the label's sign; `likelihood`: mean loss of the head (of a mixture: negative log-likelihood); `location_error_mm` and
    `aim_error_mm`: mean distance of the objects' places, and of where the hand goes next, if the policy says so.
    """
    indices = np.unique(np.linspace(0, len(windows) - 1, min(runs, len(windows))).astype(int))
    rows = [_errors(policy, windows, part) for part in np.array_split(indices, -(-len(indices) // _RUNS_AT_ONCE))]
    mean = {name: float(torch.cat([row[name] for row in rows]).mean()) for name in rows[0]}
    if position_scale is not None:
        mean["action_error_mm"] = 1000 * position_scale * mean["action_error"]
    return mean


def _errors(policy: Policy, windows: Windows, indices: np.ndarray) -> dict[str, Tensor]:
    batch = on_device(windows.batch(indices), policy.action_scale.device)
    frames = policy.frames(batch.images, batch.proprioception)
    context = policy.config.context
    features = policy.features(policy.tokens(frames[:, -context:]))[:, -1]
    label = batch.actions[:, -1]
    answer = policy.denormalise(policy.answers(features).likeliest())
    answer = answer if answer.ndim == 2 else answer[:, 0]
    distance: Callable[[Tensor], Tensor] = lambda x: torch.linalg.vector_norm(x, dim=-1)  # noqa: E731
    parts = policy.inputs.arm_parts or (slice(None),)  # imported actions may be nothing but a gripper's
    arm = zip(("action_error", "rotation_error"), parts, strict=False)
    errors = {
        **{name: distance(answer[:, part] - label[:, part]) for name, part in arm},
        "gripper_right": (answer[:, GRIPPER].sign() == label[:, GRIPPER].sign()).float(),
        "likelihood": policy.head.loss(features, policy.normalise(batch.labels[:, -1])),
    }
    if policy.locates:
        place = policy.located(frames[:, -1]) * policy.objects_deviation + policy.objects_mean
        off = place.unflatten(-1, (-1, 3)) - batch.objects[:, -1]
        errors["location_error_mm"] = 1000 * distance(off).nanmean(-1)
    if policy.aims:
        aim = policy.aimed(frames[:, -1]) * policy.keypose_deviation + policy.keypose_mean
        errors["aim_error_mm"] = 1000 * distance((aim - batch.keyposes[:, -1])[:, :3])
    return errors
