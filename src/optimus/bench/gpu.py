"""A policy's training step and its action on a GPU: elapsed time, with the data set resident there."""

from __future__ import annotations

import shutil
import tempfile
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import torch

from optimus.bench.config import Progress
from optimus.bench.policy import CAMERAS, made_up_frame, made_up_inputs
from optimus.data.episode import IMAGE_SIZE, IMAGE_SUFFIX, PROPRIOCEPTION, Episode
from optimus.data.store import EpisodeStore
from optimus.data.windows import Windows
from optimus.learn.agent import PolicyAgent
from optimus.learn.batches import ResidentWindows
from optimus.learn.gradient import GradientWorkers, LossConfig, Runtime, usual_runtime
from optimus.learn.presets import preset
from optimus.learn.ranks import device_kind
from optimus.learn.recipe import recipe
from optimus.learn.schedule import StepPlan
from optimus.learn.state import TrainState
from optimus.learn.train import fresh_policy
from optimus.statistics import quantiles

_EPISODES, _LENGTH = 20, 100
_SECONDS = 1.5
"""Each way is timed for at least so long, after its first steps."""
_WAYS = (("last", "one by one"), ("last", "recorded"), ("last", "as trained"), ("all", "as trained"))
"""Frames of a window whose labels are learned, and how a step is computed."""
GPU_WAYS = len(_WAYS)
"""In which a step is timed."""
_WARM_UP, _GROUP = 3, 5
"""Steps that are not counted, and steps timed as one."""


def bench_gpu_step(name: str, batch: int, seed: int, progress: Progress) -> dict[str, Any]:
    """Training steps a second, the optimiser's included, with `batch` windows in a step: one kernel after the other, and as
    `train` does it (recorded, its encoders compiled); labels at the windows' last frames, and at all. The pictures are noise.

    `DeviceError` if there is no GPU.
    """
    device = torch.device(device_kind("cuda"))
    folder = Path(tempfile.mkdtemp(prefix="optimus-bench-"))
    try:
        config = preset(name).policy
        windows = Windows(_noise(folder / "data", seed), range(_EPISODES), config.cut())
        source = ResidentWindows(windows, device)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    usual = usual_runtime(batch, "cuda")
    usual = replace(usual, compiled=usual.compiled and config.encoder.compiled)
    recorded = replace(usual, compiled=False)
    runtimes = {"one by one": replace(recorded, recorded=False), "recorded": recorded, "as trained": usual}
    steps: dict[str, float] = {}
    memory: dict[str, float] = {}
    for labels, way in _WAYS:
        torch.cuda.reset_peak_memory_stats()
        loss = LossConfig(runs=batch, supervise="all" if labels == "all" else "last", location_weight=0.0)
        steps[f"{labels}, {way}"] = 1 / _seconds_a_step(name, source, loss, runtimes[way], seed)
        memory[f"{labels}, {way}"] = torch.cuda.max_memory_allocated() / 1e9
        progress(len(steps), len(steps))
    return {
        "preset": name,
        "parameters": fresh_policy(config, made_up_inputs(), seed).parameter_count,
        "gpu": torch.cuda.get_device_name(),
        "torch": torch.__version__,
        "windows": batch,
        "half": usual.half,
        "compiled": usual.compiled,
        "steps_per_second": steps,
        "labels_per_second": {way: rate * batch * (config.context if way.startswith("all") else 1) for way, rate in steps.items()},
        "gigabytes": memory,
    }


def bench_gpu_action(name: str, rounds: int, seed: int, progress: Progress) -> dict[str, Any]:
    """Milliseconds of an action, frames in the main memory to action there, elapsed: only the newest frame is encoded, on a GPU.

    `DeviceError` if there is no GPU.
    """
    policy = fresh_policy(preset(name).policy, made_up_inputs(), seed)
    agent = PolicyAgent(policy, "likeliest", device=device_kind("cuda"))
    rng = np.random.default_rng(seed)
    frames = [made_up_frame(rng) for _ in range(20)]
    spent = []
    for k in range(rounds + len(frames)):
        began = time.perf_counter()
        agent.act(frames[k % len(frames)])
        spent.append(time.perf_counter() - began)
        progress(k, k)
    times = quantiles(spent[len(frames) :], 95, scale=1e3)
    about = {"preset": name, "parameters": policy.parameter_count, "gpu": torch.cuda.get_device_name()}
    return {**about, "action_ms": times, "actions_per_second": 1e3 / times["median"]}


def _seconds_a_step(name: str, source: ResidentWindows, loss: LossConfig, runtime: Runtime, seed: int) -> float:
    policy = fresh_policy(preset(name).policy, made_up_inputs(), seed).to(runtime.device)
    workers = GradientWorkers(policy, source, loss, runtime, seed)
    state = TrainState(policy, recipe("paper").optimiser, StepPlan(1_000_000))

    def step() -> None:
        losses, gradient = workers.gradient(state.step)
        torch.cat([losses, state.update(gradient, 1e-4)]).tolist()

    try:
        return _median_seconds(step)
    finally:
        workers.close()


def _median_seconds(step: Callable[[], None]) -> float:
    for _ in range(_WARM_UP):
        step()
    until, groups = time.perf_counter() + _SECONDS, []
    while not groups or time.perf_counter() < until:
        began = time.perf_counter()
        for _ in range(_GROUP):
            step()
        groups.append((time.perf_counter() - began) / _GROUP)
    return float(np.median(groups))


def _noise(folder: Path, seed: int) -> EpisodeStore:
    """A data set of noise, of the right shapes."""
    rng = np.random.default_rng(seed)
    store = EpisodeStore.create(folder, "stack", CAMERAS, {})
    for number in range(_EPISODES):
        low = {name: rng.normal(size=(_LENGTH, size)).astype(np.float32) for name, size in PROPRIOCEPTION.items()}
        shape = (_LENGTH, IMAGE_SIZE, IMAGE_SIZE, 3)
        images = {camera + IMAGE_SUFFIX: rng.integers(256, size=shape, dtype=np.uint8) for camera in CAMERAS}
        actions = rng.uniform(-0.9, 0.9, (_LENGTH, 7)).astype(np.float32)
        objects = rng.normal(size=(_LENGTH, 2, 3)).astype(np.float32)
        state = np.zeros(1)
        store.write(Episode("stack", number, "noise", {**low, **images}, actions, actions, state, objects, ("a", "b"), True))
    return store
