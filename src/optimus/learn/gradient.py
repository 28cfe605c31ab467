"""The gradient of one training step: a pure function of the weights, the seed, the step and the runtime.

That is what makes resuming exact. Nothing random is carried from step to step: sampling, crops and dropout of
a step come from generators seeded with the seed, the step and the shard.
"""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Literal

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from optimus.data.windows import Batch, WindowConfig, Windows
from optimus.learn.policy import Policy
from optimus.workers import available_cores


@dataclass(frozen=True)
class Runtime:
    """How steps are computed. It decides their rounding, so it is settled once and recorded with the run."""

    shards: int
    """Parts that a batch is split into, each computed by one thread."""
    half: bool
    """Whether the convolutions run in bfloat16."""


@dataclass(frozen=True)
class LossConfig:
    """What a step minimises."""

    runs: int = 24
    """Runs of consecutive windows in a batch."""
    supervise: Literal["all", "last"] = "all"
    """Learn the actions at all frames of a window (contexts of 1 to 8 frames) or only that at its last."""
    location_weight: float = 30.0
    """Weight of the auxiliary error of the objects' positions, decoded from single frames.

    The gradient of the likelihood is some hundred times as long, and clipped: at a weight of 1 this one is lost.
    """

    def labels(self, cut: WindowConfig) -> int:
        """Labels in a batch, those near the start of an episode included that are left out."""
        return self.runs * cut.windows * (cut.context if self.supervise == "all" else 1)


@dataclass(frozen=True)
class StepLoss:
    """Parts of the loss of one step, means over its labels."""

    likelihood: float
    """Negative log-likelihood."""
    location: float


class GradientWorkers:
    """Computes gradients for one policy, its batch split over threads.

    Two threads with half a batch each are faster than one batch whose every operation is split in two: small
    operations do not scale, and the GIL is free while they run.
    """

    def __init__(self, policy: Policy, windows: Windows, config: LossConfig, runtime: Runtime, seed: int) -> None:
        self.policy, self.windows, self.config, self.runtime, self.seed = (
            policy,
            windows,
            config,
            runtime,
            seed,
        )
        self.parameters = [p for p in policy.parameters() if p.requires_grad]
        self._threads = ThreadPoolExecutor(runtime.shards, "gradient", initializer=_one_thread_each)

    def close(self) -> None:
        """End the threads."""
        self._threads.shutdown()

    def gradient(self, step: int) -> tuple[StepLoss, list[Tensor]]:
        """Loss and gradient at the current weights, on the batch of this step."""
        shards = self.runtime.shards
        parts = list(self._threads.map(lambda shard: self._shard(step, shard), range(shards)))
        total = [torch.stack(pieces).mean(0) if shards > 1 else pieces[0] for pieces in zip(*(g for _, g in parts), strict=True)]
        likelihood, location = (float(np.mean(v)) for v in zip(*(values for values, _ in parts), strict=True))
        return StepLoss(likelihood, location), total

    def _shard(self, step: int, shard: int) -> tuple[tuple[float, float], tuple[Tensor, ...]]:
        runs = len(range(shard, self.config.runs, self.runtime.shards))
        batch = self.windows.sample(np.random.default_rng([self.seed, step, shard]), runs)
        noise = torch.Generator().manual_seed(int(np.random.SeedSequence([self.seed, step, shard]).generate_state(1)[0]))
        likelihood, location = batch_loss(self.policy, batch, self.config, noise, self.runtime.half)
        loss = likelihood + self.config.location_weight * location
        gradient = torch.autograd.grad(loss, self.parameters, materialize_grads=True)
        return (float(likelihood.detach()), float(location.detach())), gradient


def batch_loss(
    policy: Policy, batch: Batch, config: LossConfig, noise: torch.Generator | None, half: bool
) -> tuple[Tensor, Tensor]:
    """Mean loss of the head over a batch's labels (of a mixture: negative log-likelihood), and mean error of its objects'
    positions."""
    images, proprioception = tensors(batch.images), tensors(batch.proprioception)
    # One crop for a run of frames.
    count = batch.actions.shape[1]
    shifts = {name: shift[:, None].expand(-1, count, -1) for name, shift in tensors(batch.shifts).items()}
    frames = policy.frames(images, proprioception, shifts, half)
    context = policy.config.context
    features = policy.features(windows_of(policy.tokens(frames), context).flatten(0, 1), noise)
    labels = torch.from_numpy(batch.actions)
    if batch.ahead.shape[2]:
        labels = torch.cat([labels[:, :, None], torch.from_numpy(batch.ahead)], 2)
    actions = windows_of(labels, context).flatten(0, 1)
    weight = windows_of(torch.from_numpy(batch.weight), context).flatten(0, 1)
    if config.supervise == "last":
        features, actions, weight = features[:, -1:], actions[:, -1:], weight[:, -1:]
    loss = policy.head.loss(features, policy.normalise(actions), noise)
    likelihood = (loss * weight).sum() / weight.sum().clamp(min=1)
    if config.location_weight == 0 or not policy.locates:
        return likelihood, torch.zeros(())
    return likelihood, policy.location_error(frames, torch.from_numpy(batch.objects)).mean()


def windows_of(frames: Tensor, context: int) -> Tensor:
    """Runs `(B, F, ...)` to their windows `(B, F - context + 1, context, ...)`."""
    windows = frames.unfold(1, context, 1)
    return windows.movedim(-1, 2)


def tensors(arrays: Mapping[str, NDArray[np.generic]]) -> dict[str, Tensor]:
    """The same arrays, as tensors."""
    return {name: torch.from_numpy(array) for name, array in arrays.items()}


def candidate_runtimes(runs: int) -> list[Runtime]:
    """One thread and all cores, in float32 and in bfloat16."""
    cores = min(available_cores(), runs)
    return [Runtime(shards, half) for shards in sorted({1, cores}) for half in (False, True)]


def usual_runtime(runs: int) -> Runtime:
    """What a budget in steps runs with unless told otherwise: a function of the machine, not of a clock, so that two runs
    of the same command end with the same weights."""
    cores = min(available_cores(), runs)
    able = torch.cpu.get_capabilities()
    return Runtime(cores, half=bool(able.get("avx512_bf16") or able.get("amx_bf16")))


def fastest_runtime(
    policy: Policy, windows: Windows, config: LossConfig, seed: int, candidates: Sequence[Runtime]
) -> tuple[Runtime, float]:
    """Time the candidates on real gradients, taking no step; the fastest, and its seconds a step."""
    seconds = {}
    for runtime in candidates:
        workers = GradientWorkers(policy, windows, config, runtime, seed)
        seconds[runtime] = min(_seconds(workers, step) for step in range(3))
        workers.close()
    best = min(seconds, key=lambda r: seconds[r])
    return best, seconds[best]


def _seconds(workers: GradientWorkers, step: int) -> float:
    start = time.perf_counter()
    workers.gradient(step)
    return time.perf_counter() - start


def _one_thread_each() -> None:
    torch.set_num_threads(1)  # of this thread only, in an OpenMP build
    torch.set_flush_denormal(True)
