"""Collection, one environment step, one frame, one action."""

from __future__ import annotations

import shutil
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

from optimus.bench.config import BenchConfig, Progress
from optimus.collect import CollectConfig, collect
from optimus.data.episode import IMAGE_SIZE
from optimus.data.keyposes import KEYPOSE
from optimus.render import Rig
from optimus.statistics import quantiles
from optimus.workers import available_cores


def bench_collect(config: BenchConfig, progress: Progress) -> dict[str, Any]:
    """Collection as users run it: perturbed, rendered, written; process start-up included. `busy` is the share of the workers' time
    that went into attempts: on idle cores, what is missing is start-up and waiting."""
    workers = config.workers or available_cores()
    folder = Path(tempfile.mkdtemp(prefix="optimus-bench-"))
    try:
        asked = CollectConfig(
            config.task, folder / "data", config.episodes, config.seed, workers, control=config.control, robot=config.robot
        )
        result = collect(asked, lambda tally: progress(tally.successes, tally.successes))
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return {
        **config.about,
        "workers": workers,
        "demonstrations": result.demonstrations,
        "attempts": result.attempts,
        "seconds": result.seconds,
        "demonstrations_per_hour": 3600 * result.demonstrations / result.seconds,
        "cpu_seconds_per_demonstration": {k: v / result.demonstrations for k, v in result.cpu_seconds.items()},
        "busy": sum(result.cpu_seconds.values()) / (workers * result.seconds),
        "failures": result.failures,
    }


def bench_step(config: BenchConfig, progress: Progress) -> dict[str, Any]:
    """CPU milliseconds of one 20 Hz step, with and without images, with random actions."""
    rng = np.random.default_rng(config.seed)
    result: dict[str, Any] = {**config.about}
    for images in (True, False):
        env = config.env(images)
        times = []
        for i in range(config.episodes):
            env.reset(seed=config.seed + i)
            for _ in range(20):
                action = rng.uniform(-0.3, 0.3, env.action_size).astype(np.float32)
                began = time.process_time()
                env.step(action)
                times.append(time.process_time() - began)
            progress(i + 1, i + 1)
        result["step_ms" if images else "step_without_images_ms"] = quantiles(times, 95, scale=1e3)
    return result


def bench_render(config: BenchConfig, progress: Progress) -> dict[str, Any]:
    """CPU milliseconds of one 84 x 84 frame, by camera."""
    env = config.env(images=False)
    env.reset(seed=config.seed)
    rig = Rig(env.world, IMAGE_SIZE)
    result: dict[str, Any] = {**config.about, "size": IMAGE_SIZE, "frame_ms": {}}
    for camera in env.world.image_cameras:
        rig.image(env.data, camera)
        times = []
        for i in range(config.episodes):
            began = time.process_time()
            rig.image(env.data, camera)
            times.append(time.process_time() - began)
            progress(i + 1, i + 1)
        result["frame_ms"][camera] = quantiles(times, 95, scale=1e3)
    rig.close()
    return result


def bench_action(config: BenchConfig, progress: Progress) -> dict[str, Any]:
    """CPU milliseconds of one action of the `quick` policy on one core, images to action (weights do not matter: fresh ones)."""
    import torch

    from optimus.learn.agent import PolicyAgent
    from optimus.learn.policy import Policy, PolicyInputs
    from optimus.learn.presets import preset

    torch.set_num_threads(1)
    env = config.env(images=True)
    observation, _ = env.reset(seed=config.seed)
    low = {k: v.shape[0] for k, v in observation.items() if v.ndim == 1}
    objects = len(env.world.scene.movable_names)
    inputs = PolicyInputs(config.task, env.world.image_cameras, low, objects, env.action_size, config.control, keypose=KEYPOSE)
    policy = Policy(preset("quick").policy, inputs)
    agent = PolicyAgent(policy)
    for _ in range(20):
        agent.act(observation)
    times = []
    for i in range(max(config.episodes, 20)):
        began = time.process_time()
        agent.act(observation)
        times.append(time.process_time() - began)
        progress(i + 1, i + 1)
    parameters = sum(p.numel() for p in policy.parameters())
    return {**config.about, "policy": "quick", "parameters": parameters, "threads": 1, "action_ms": quantiles(times, 95, scale=1e3)}
