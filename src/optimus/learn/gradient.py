"""The gradient of one training step: a pure function of the weights, the seed, the step and the runtime.

That is what makes resuming exact on a CPU; on a GPU, whose libraries choose their algorithms by trying them, up to rounding.
Nothing random is carried from step to step: sampling, crops and dropout of a step come from generators seeded with the seed, the
step and the shard.
"""

from __future__ import annotations

import importlib.util
import os
import shutil
import time
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
import torch
from torch import Tensor

from optimus.data.windows import Batch, WindowConfig
from optimus.errors import OptimusError, require_at_least
from optimus.learn.batches import BatchSource, ResidentWindows, TensorBatch, on_device
from optimus.learn.policy import Policy
from optimus.learn.ranks import Ranks
from optimus.learn.recording import Recording
from optimus.workers import available_cores


class BatchError(OptimusError):
    """A batch that cannot be shared out as asked."""


@dataclass(frozen=True)
class Runtime:
    """How steps are computed. It decides their rounding, so it is settled once and recorded with the run."""

    shards: int
    """Threads of each process, each of which computes a part of its own."""
    half: bool
    """Whether the convolutions run in bfloat16."""
    accumulate: int = 1
    """Portions that each process computes one after the other."""
    processes: int = 1
    """Processes that a batch is split over."""
    device: str = "cpu"
    """What computes: `cpu` or `cuda`."""
    recorded: bool = False
    """On a GPU that holds the data set: whether a part is recorded once and replayed (`recording.py`)."""
    compiled: bool = False
    """Whether PyTorch compiles the convolutional networks: on a GPU, norms and what is around them in one pass over memory."""

    @property
    def parts(self) -> int:
        """Parts that a batch is made of; each is drawn by itself, whoever computes it."""
        return self.shards * self.accumulate * self.processes


@dataclass(frozen=True)
class LossConfig:
    """What a step minimises."""

    runs: int = 24
    """Runs of consecutive windows in a batch."""
    supervise: Literal["all", "last"] = "all"
    """Learn the actions at all frames of a window (contexts of 1 to 8 frames) or only that at its last."""
    location_weight: float = 30.0
    """Weight of the auxiliary errors: of the objects' positions, and of where the hand goes next, decoded from single frames.

    The gradient of the likelihood is some hundred times as long, and clipped: at a weight of 1 this one is lost.
    """

    def __post_init__(self) -> None:
        require_at_least(1, batch=self.runs)

    def labels(self, cut: WindowConfig) -> int:
        """Labels in a batch, those near the start of an episode included that are left out."""
        return self.runs * cut.windows * (cut.context if self.supervise == "all" else 1)


_PartGradient = tuple[Tensor, tuple[Tensor, ...]]
"""The losses of a part of a batch, and its gradient."""


class GradientWorkers:
    """Computes gradients for one policy, its batch split over threads, portions in turn, and processes.

    Two threads with half a batch each are faster than one batch whose every operation is split in two: small
    operations do not scale, and the GIL is free while they run.
    """

    def __init__(
        self, policy: Policy, windows: BatchSource, config: LossConfig, runtime: Runtime, seed: int, ranks: Ranks | None = None
    ) -> None:
        if runtime.parts > config.runs:
            raise BatchError(
                f"a batch of {config.runs} cannot be split into {runtime.parts} parts ({runtime.shards} threads x "
                f"{runtime.accumulate} portions x {runtime.processes} processes); use a larger batch or fewer portions"
            )
        if runtime.device == "cuda" and runtime.shards > 1:
            raise BatchError(f"a GPU computes a portion in one thread, not in {runtime.shards}; ask for portions instead")
        self.policy, self.windows, self.config, self.runtime, self.seed = (
            policy,
            windows,
            config,
            runtime,
            seed,
        )
        self.ranks = ranks or Ranks()
        self.parameters = [p for p in policy.parameters() if p.requires_grad]
        self._threads = ThreadPoolExecutor(runtime.shards, "gradient", initializer=_one_thread_each)
        self._recordings: dict[int, Recording[_PartGradient]] = {}
        self._device = self.parameters[0].device
        self._noise = torch.Generator(self._device)
        self._before = torch.get_float32_matmul_precision(), torch.backends.cudnn.benchmark
        if runtime.device == "cuda":
            torch.set_float32_matmul_precision("high")  # what is not in bfloat16 goes through the matrix units, too
            torch.backends.cudnn.benchmark = True  # shapes never change: try the algorithms once, keep the fastest
        if runtime.compiled:
            for trunk in (encoder.get_submodule("trunk") for encoder in policy.encoders.children()):
                if trunk._compiled_call_impl is None:  # else it has been, where the pace was measured
                    trunk.compile(dynamic=False)

    def close(self) -> None:
        """End the threads and give back the recordings' memory; what was set for all of the process is as it was."""
        self._threads.shutdown()
        self._recordings.clear()
        torch.set_float32_matmul_precision(self._before[0])
        torch.backends.cudnn.benchmark = self._before[1]

    def gradient(self, step: int) -> tuple[Tensor, list[Tensor]]:
        """Losses and gradient at the current weights, on the batch of this step: the same in every process.

        The losses are means over the labels, `(2,)`: the head's (of a mixture: negative log-likelihood), and the errors of what is
        said besides. All may be overwritten by the next call; on a GPU nothing has been waited for.
        """
        share = self.runtime.accumulate
        first = self.ranks.rank * share
        losses, total = self._portion(step, first)
        if share > 1 and self._recordings:
            total = [piece.clone() for piece in total]
        for portion in range(first + 1, first + share):
            more, pieces = self._portion(step, portion)
            losses = losses + more
            for mine, piece in zip(total, pieces, strict=True):
                mine.add_(piece)
        if share > 1:
            losses = losses / share
            for mine in total:
                mine.div_(share)
        self.ranks.average([losses, *total])
        return losses, total

    def _portion(self, step: int, portion: int) -> tuple[Tensor, list[Tensor]]:
        """Mean losses `(2,)` and gradient over the parts that the threads compute at once."""
        shards = self.runtime.shards
        work = lambda shard: self._part(step, portion * shards + shard)  # noqa: E731
        parts = [work(0)] if self.runtime.device == "cuda" else list(self._threads.map(work, range(shards)))
        total = [torch.stack(pieces).mean(0) if shards > 1 else pieces[0] for pieces in zip(*(g for _, g in parts), strict=True)]
        return torch.stack([losses for losses, _ in parts]).mean(0), total

    def _part(self, step: int, part: int) -> _PartGradient:
        runs = len(range(part, self.config.runs, self.runtime.parts))
        rng = np.random.default_rng([self.seed, step, part])
        seed = int(np.random.SeedSequence([self.seed, step, part]).generate_state(1)[0])
        if self.runtime.recorded and isinstance(self.windows, ResidentWindows):
            drawn = self.windows.drawn(rng, runs)
            recording = self._recording(self.windows, runs, drawn)
            self._noise.manual_seed(seed)
            return recording(drawn)
        noise = torch.Generator(self._device).manual_seed(seed)
        return self._gradient_on(self.windows.sample(rng, runs), noise)

    def _recording(self, source: ResidentWindows, runs: int, drawn: Mapping[str, Tensor]) -> Recording[_PartGradient]:
        """The gradient on so many runs, recorded at the first one."""
        if runs not in self._recordings:
            example = {name: tensor.to(self._device) for name, tensor in drawn.items()}
            work = lambda inputs: self._gradient_on(source.cut(inputs), self._noise)  # noqa: E731
            self._recordings[runs] = Recording(work, example, self._noise)
        return self._recordings[runs]

    def _gradient_on(self, batch: Batch | TensorBatch, noise: torch.Generator) -> _PartGradient:
        likelihood, location = batch_loss(self.policy, batch, self.config, noise, self.runtime.half)
        loss = likelihood + self.config.location_weight * location
        gradient = torch.autograd.grad(loss, self.parameters, materialize_grads=True)
        laid_out = tuple(_laid_out_like(g, p) for g, p in zip(gradient, self.parameters, strict=True))
        return torch.stack([likelihood.detach(), location.detach()]).double(), laid_out


def batch_loss(
    policy: Policy, batch: Batch | TensorBatch, config: LossConfig, noise: torch.Generator | None, half: bool
) -> tuple[Tensor, Tensor]:
    """Mean loss of the head over a batch's labels (of a mixture: negative log-likelihood), and mean error of the auxiliary ones."""
    seen = on_device(batch, policy.action_scale.device)
    # One crop for a run of frames.
    count = seen.actions.shape[1]
    shifts = {name: shift[:, None].expand(-1, count, -1) for name, shift in seen.shifts.items()}
    frames = policy.frames(seen.images, seen.proprioception, shifts, half)
    context = policy.config.context
    features = policy.features(windows_of(policy.tokens(frames), context).flatten(0, 1), noise)
    actions = windows_of(seen.labels, context).flatten(0, 1)
    weight = windows_of(seen.weight, context).flatten(0, 1)
    if config.supervise == "last":
        features, actions, weight = features[:, -1:], actions[:, -1:], weight[:, -1:]
    loss = policy.head.loss(features, policy.normalise(actions), noise)
    likelihood = (loss * weight).sum() / weight.sum().clamp(min=1)
    location = torch.zeros_like(likelihood)
    if config.location_weight and policy.locates:
        location = location + policy.location_error(frames, seen.objects).mean()
    if config.location_weight and policy.aims:
        location = location + policy.aim_error(frames, seen.keyposes).mean()
    return likelihood, location


def windows_of(frames: Tensor, context: int) -> Tensor:
    """Runs `(B, F, ...)` to their windows `(B, F - context + 1, context, ...)`."""
    windows = frames.unfold(1, context, 1)
    return windows.movedim(-1, 2)


def candidate_runtimes(usual: Runtime) -> list[Runtime]:
    """One thread and as many as `usual` has, in float32 and in bfloat16."""
    return [replace(usual, shards=n, half=half) for n in sorted({1, usual.shards}) for half in (False, True)]


def usual_runtime(runs: int, device: str = "cpu", accumulate: int = 1, ranks: Ranks | None = None) -> Runtime:
    """What a budget in steps runs with unless told otherwise: a function of the machine, not of a clock, so that two runs
    of the same command end with the same weights (on a GPU up to rounding)."""
    ranks = ranks or Ranks()
    if device == "cuda":
        half = torch.cuda.is_bf16_supported()
        return Runtime(1, half, accumulate, ranks.count, device, recorded=True, compiled=_can_compile())
    cores = available_cores() // ranks.on_this_machine
    able = torch.cpu.get_capabilities()
    half = bool(able.get("avx512_bf16") or able.get("amx_bf16"))
    return Runtime(max(1, min(cores, runs // (accumulate * ranks.count))), half, accumulate, ranks.count, device)


def _can_compile() -> bool:
    """Whether PyTorch can compile for the GPU: with Triton, which needs a C compiler, on one of compute capability 7 or more."""
    compilers = [os.environ.get("CC", "gcc"), "gcc", "cc", "clang"]
    there = importlib.util.find_spec("triton") is not None and any(map(shutil.which, compilers))
    return there and torch.cuda.get_device_capability() >= (7, 0)


def fastest_runtime(
    policy: Policy, windows: BatchSource, config: LossConfig, seed: int, candidates: Sequence[Runtime]
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
    workers.gradient(step)[0].tolist()  # which waits for a GPU
    return time.perf_counter() - start


def _laid_out_like(gradient: Tensor, weight: Tensor) -> Tensor:
    """The gradient in the memory layout of its weight: where the two differ, the optimiser goes tensor by tensor."""
    return gradient if gradient.stride() == weight.stride() else torch.empty_like(weight).copy_(gradient)


def _one_thread_each() -> None:
    torch.set_num_threads(1)  # of this thread only, in an OpenMP build
    torch.set_flush_denormal(True)
