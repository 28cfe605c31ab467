"""The same policy computed plainly: what a first implementation of the paper's network does, to measure speed against.

Everything in float32, in PyTorch's own memory layout and with its own convolutions; every window's frames encoded, for
training and for every action.
"""

from __future__ import annotations

import copy

import torch
from torch import Tensor, nn

from optimus.data.windows import Batch
from optimus.learn.batches import on_device
from optimus.learn.encoder.small_maps import SmallMapConv2d
from optimus.learn.gradient import windows_of
from optimus.learn.policy import Policy


def plainly(policy: Policy, batch_norm: bool = False) -> Policy:
    """A copy of the policy that computes plainly; with `batch_norm`, as the published network normalises."""
    plain = copy.deepcopy(policy).to(memory_format=torch.contiguous_format)  # type: ignore[call-overload]
    for module in list(plain.modules()):
        if isinstance(module, SmallMapConv2d):
            module.as_products = False
        if batch_norm:
            for name, child in list(module.named_children()):
                if isinstance(child, nn.GroupNorm):
                    setattr(module, name, nn.BatchNorm2d(child.num_channels))
    return plain


def plain_loss(policy: Policy, batch: Batch, noise: torch.Generator | None) -> Tensor:
    """Mean loss of the labels at the windows' ends, each window's frames encoded by themselves."""
    seen, context = on_device(batch, torch.device("cpu")), policy.config.context
    of_windows = lambda x: windows_of(x, context).flatten(0, 1)  # noqa: E731
    count = seen.actions.shape[1]
    images = {name: of_windows(x) for name, x in seen.images.items()}
    low = {name: of_windows(x) for name, x in seen.proprioception.items()}
    shifts = {name: of_windows(x[:, None].expand(-1, count, -1)) for name, x in seen.shifts.items()}
    images = {name: x.permute(0, 1, 4, 2, 3).contiguous().permute(0, 1, 3, 4, 2) for name, x in images.items()}
    features = policy.features(policy.tokens(policy.frames(images, low, shifts)), noise)[:, -1]
    weight = of_windows(seen.weight)[:, -1]
    loss = policy.head.loss(features, policy.normalise(of_windows(seen.labels)[:, -1]), noise)
    return (loss * weight).sum() / weight.sum().clamp(min=1)


@torch.no_grad()
def plain_action(policy: Policy, images: dict[str, Tensor], low: dict[str, Tensor]) -> Tensor:
    """The action `(n,)` for a window, the likeliest; images `(1, context, crop, crop, 3)` and proprioception `(1, context, n)`."""
    images = {name: x.permute(0, 1, 4, 2, 3).contiguous().permute(0, 1, 3, 4, 2) for name, x in images.items()}
    features = policy.features(policy.tokens(policy.frames(images, low)))[:, -1]
    answer = policy.answers(features).answer("likeliest", torch.Generator())
    return policy.denormalise(answer).reshape(-1, answer.shape[-1])[0].clip(-1, 1)
