"""A policy's training step and its action, beside the same policy computed plainly, in the same run."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any, TypeVar

import numpy as np
import torch
from torch import Tensor

from optimus.bench.config import Progress
from optimus.bench.yardstick import plain_action, plain_loss, plainly
from optimus.data.episode import IMAGE_SIZE, IMAGE_SUFFIX, PROPRIOCEPTION, Observation
from optimus.data.keyposes import KEYPOSE
from optimus.data.windows import Batch
from optimus.learn.agent import PolicyAgent
from optimus.learn.gradient import LossConfig, batch_loss, usual_runtime
from optimus.learn.onnx_runtime import is_installed
from optimus.learn.policy import Policy, PolicyConfig, PolicyInputs
from optimus.learn.presets import preset
from optimus.learn.recipe import recipe
from optimus.learn.schedule import StepPlan
from optimus.learn.state import TrainState
from optimus.learn.train import fresh_policy
from optimus.statistics import quantiles

_Result = TypeVar("_Result")

LABELS = 16
"""Labels in a step: the paper's batch."""
CHUNK = 8
"""Consecutive windows in a run, where frames are shared."""
CAMERAS = ("agentview", "robot0_eye_in_hand")


def bench_gradient_step(name: str, rounds: int, seed: int, progress: Progress) -> dict[str, Any]:
    """CPU seconds of the gradient of 16 labels on one thread: plainly, with independent windows, and with runs of windows that
    share frames. Images are noise: the time does not depend on them.

    The optimiser's update is the same for all and given by itself.
    """
    torch.set_num_threads(1)
    config = preset(name).policy
    rng = np.random.default_rng(seed)
    policy = fresh_policy(config, made_up_inputs(), seed)
    half = usual_runtime(LABELS).half
    apart, runs = _batch(rng, config, LABELS, 1), _batch(rng, config, LABELS // CHUNK, CHUNK)
    ways: dict[str, Callable[[], list[Tensor]]] = {
        "plain": _plain_gradient(plainly(policy), apart),
        "plain_batch_norm": _plain_gradient(plainly(policy, batch_norm=True), apart),
        "independent": _fast_gradient(policy, apart, half),
        "chunked": _fast_gradient(policy, runs, half),
    }
    spent: dict[str, list[float]] = {way: [] for way in (*ways, "update")}
    newest: dict[str, list[Tensor]] = {}
    off = 0.0
    state = TrainState(policy, replace(recipe("paper").optimiser, weight_decay=0.0), StepPlan(1))
    for k in range(rounds + 1):  # the first one warms up
        for way, gradient in ways.items():
            newest[way] = _timed(spent[way], gradient)
        off = _difference(newest["plain"], newest["independent"])
        _timed(spent["update"], lambda: state.update(newest["independent"], 0.0))  # at a rate of zero the weights stay
        progress(k, k)
    seconds = {way: float(np.median(times[1:])) for way, times in spent.items()}
    return {
        "preset": name,
        "parameters": policy.parameter_count,
        "labels": LABELS,
        "threads": 1,
        "half": half,
        "gradient_seconds": {way: seconds[way] for way in ways},
        "update_seconds": seconds["update"],
        **{f"speedup_{way}": seconds["plain"] / seconds[way] for way in ("independent", "chunked")},
        **{f"speedup_{way}_over_batch_norm": seconds["plain_batch_norm"] / seconds[way] for way in ("independent", "chunked")},
        "gradient_difference": off,
    }


def bench_policy_action(name: str, rounds: int, seed: int, compiled: bool, progress: Progress) -> dict[str, Any]:
    """CPU milliseconds of an action, frames to action, on one thread: by encoding the whole window, by encoding the newest frame,
    and the same by ONNX Runtime where that is installed; and by how much the answers differ."""
    torch.set_num_threads(1)
    config = preset(name).policy
    policy = fresh_policy(config, made_up_inputs(), seed).eval()
    rng = np.random.default_rng(seed)
    frames = [made_up_frame(rng) for _ in range(config.context + rounds)]
    agents = {"newest_frame": PolicyAgent(policy, "likeliest")}
    if compiled and is_installed():
        agents["compiled"] = PolicyAgent(policy, "likeliest", compiled=True)
    plain = plainly(policy)
    spent: dict[str, list[float]] = {way: [] for way in ("plain", *agents)}
    off = 0.0
    for k, frame in enumerate(frames):
        answers = {way: _timed(spent[way], partial(agent.act, frame)) for way, agent in agents.items()}
        if k < config.context:  # until the window is full of different frames; and the first calls warm up
            continue
        window = _window(frames[k + 1 - config.context : k + 1], config)
        expected = _timed(spent["plain"], partial(plain_action, plain, *window)).numpy()
        off = max([off, *(float(np.abs(answer - expected).max()) for answer in answers.values())])
        done = k + 1 - config.context
        progress(done, done)
    times = {way: quantiles(values[-rounds:], 95, scale=1e3) for way, values in spent.items()}
    result = {"preset": name, "parameters": policy.parameter_count, "threads": 1, "action_ms": times, "difference": off}
    for key, way in (("speedup", "newest_frame"), ("speedup_compiled", "compiled")):
        if way in times:
            result[key] = times["plain"]["median"] / times[way]["median"]
    return result


def made_up_inputs() -> PolicyInputs:
    """Two cameras and the usual proprioception."""
    return PolicyInputs("stack", CAMERAS, dict(PROPRIOCEPTION), objects=2, keypose=KEYPOSE)


def _batch(rng: np.random.Generator, config: PolicyConfig, runs: int, windows: int) -> Batch:
    """A batch of the right shapes."""
    shape, side = (runs, windows + config.context - 1), config.crop
    normal = lambda *size: rng.normal(size=(*shape, *size)).astype(np.float32)  # noqa: E731
    return Batch(
        images={c: rng.integers(0, 256, (*shape, side, side, 3), np.uint8) for c in CAMERAS},
        shifts={c: rng.uniform(-0.1, 0.1, (runs, 2)).astype(np.float32) for c in CAMERAS},
        proprioception={name: normal(size) for name, size in PROPRIOCEPTION.items()},
        actions=normal(7).clip(-0.9, 0.9),
        weight=np.ones(shape, np.float32),
        objects=normal(2, 3),
        keyposes=normal(KEYPOSE),
        ahead=normal(config.head.chunk - 1, 7).clip(-0.9, 0.9),
    )


def made_up_frame(rng: np.random.Generator) -> Observation:
    """An observation of noise."""
    images = {c + IMAGE_SUFFIX: rng.integers(0, 256, (IMAGE_SIZE, IMAGE_SIZE, 3), np.uint8) for c in CAMERAS}
    return {**images, **{name: rng.normal(size=size).astype(np.float32) for name, size in PROPRIOCEPTION.items()}}


def _window(frames: list[Observation], config: PolicyConfig) -> tuple[dict[str, Tensor], dict[str, Tensor]]:
    edge = (IMAGE_SIZE - config.crop) // 2
    inside = slice(edge, edge + config.crop)
    images = {c: torch.from_numpy(np.stack([f[c + IMAGE_SUFFIX][inside, inside] for f in frames]))[None] for c in CAMERAS}
    return images, {name: torch.from_numpy(np.stack([f[name] for f in frames]))[None] for name in PROPRIOCEPTION}


def _plain_gradient(policy: Policy, batch: Batch) -> Callable[[], list[Tensor]]:
    return lambda: _gradient(plain_loss(policy, batch, torch.Generator().manual_seed(0)), policy)


def _fast_gradient(policy: Policy, batch: Batch, half: bool) -> Callable[[], list[Tensor]]:
    loss = LossConfig(runs=len(batch.actions), supervise="last", location_weight=0.0)
    return lambda: _gradient(batch_loss(policy, batch, loss, torch.Generator().manual_seed(0), half)[0], policy)


def _gradient(loss: Tensor, policy: Policy) -> list[Tensor]:
    return list(torch.autograd.grad(loss, list(policy.parameters()), materialize_grads=True))


def _difference(first: list[Tensor], second: list[Tensor]) -> float:
    """Length of the difference over the length of the first."""
    a, b = (torch.cat([g.flatten() for g in gradient]) for gradient in (first, second))
    return float((a - b).norm() / a.norm())


def _timed(spent: list[float], work: Callable[[], _Result]) -> _Result:
    began = time.process_time()
    result = work()
    spent.append(time.process_time() - began)
    return result
