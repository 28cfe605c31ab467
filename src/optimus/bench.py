"""Measurements anyone can repeat: CPU time, medians and percentiles."""

from __future__ import annotations

import shutil
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from optimus.collect import CollectConfig, collect
from optimus.data.episode import IMAGE_SIZE
from optimus.demonstrate import Attempt, ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.render import Rig
from optimus.robots import Robot
from optimus.tasks import task as task_named
from optimus.workers import available_cores, executor

Progress = Callable[[int, int], None]


def spread(values: list[float], scale: float = 1.0) -> dict[str, float]:
    """Median, 95th percentile and maximum."""
    v = np.array(values or [0.0]) * scale
    return {"median": float(np.median(v)), "p95": float(np.percentile(v, 95)), "max": float(v.max())}


def _expert_attempt(task: str, seed: int, robot: Robot | None) -> Attempt:
    return demonstrate(ManipulationEnv(task_named(task), images=False, robot=robot), seed, ExpertConfig())


def bench_expert(
    task: str, episodes: int, seed: int, workers: int, progress: Progress, robot: Robot | None = None
) -> dict[str, Any]:
    """The expert, unperturbed and without images, on `episodes` consecutive seeds."""
    task_named(task)
    attempts: list[Attempt] = []
    with executor(workers) as pool:
        for future in [pool.submit(_expert_attempt, task, seed + i, robot) for i in range(episodes)]:
            attempts.append(future.result())
            progress(len(attempts), sum(a.success for a in attempts))
    played = [a.episode for a in attempts if a.episode is not None]
    steps, plan = spread([float(len(e)) for e in played]), spread([a.plan_seconds for a in attempts])
    errors = [e.info["tracking_error"] for e in played]
    medians, worst = spread([e["median"] for e in errors], 1e3), spread([e["max"] for e in errors], 1e3)
    return {
        "task": task,
        "control": "osc",
        "robot": "panda" if robot is None else robot.name,
        "seed": seed,
        "episodes": episodes,
        "successes": sum(a.success for a in attempts),
        "paper_rule_successes": sum(bool(a.info.get("paper_success")) for a in attempts),
        "plan_seconds": plan,
        "episode_steps": {"median": steps["median"], "p95": steps["p95"]},
        "tracking_error_mm": {"median": medians["median"], "max": worst["max"]},
        "failures": dict(Counter(a.failure for a in attempts if not a.success)),
    }


def bench_collect(
    task: str, episodes: int, seed: int, workers: int, progress: Progress, robot: Robot | None = None
) -> dict[str, Any]:
    """Collection as users run it: perturbed, rendered, written; process start-up included."""
    workers = workers or available_cores()
    folder = Path(tempfile.mkdtemp(prefix="optimus-bench-"))
    try:
        config = CollectConfig(task, folder / "data", episodes, seed, workers, robot=robot)
        result = collect(config, lambda done: progress(done, done))
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return {
        "task": task,
        "workers": workers,
        "demonstrations": result.demonstrations,
        "attempts": result.attempts,
        "seconds": result.seconds,
        "demonstrations_per_hour": 3600 * result.demonstrations / result.seconds,
        "cpu_seconds": result.cpu_seconds,
        "failures": result.failures,
    }


def bench_step(
    task: str, episodes: int, seed: int, workers: int, progress: Progress, robot: Robot | None = None
) -> dict[str, Any]:
    """CPU milliseconds of one 20 Hz step, with and without images, with random actions."""
    rng = np.random.default_rng(seed)
    result: dict[str, Any] = {"task": task}
    for images in (True, False):
        env = ManipulationEnv(task_named(task), images=images, robot=robot)
        times = []
        for i in range(episodes):
            env.reset(seed=seed + i)
            for _ in range(20):
                action = rng.uniform(-0.3, 0.3, 7).astype(np.float32)
                began = time.process_time()
                env.step(action)
                times.append(time.process_time() - began)
            progress(i + 1, i + 1)
        result["step_ms" if images else "step_without_images_ms"] = spread(times, 1e3)
    return result


def bench_render(
    task: str, episodes: int, seed: int, workers: int, progress: Progress, robot: Robot | None = None
) -> dict[str, Any]:
    """CPU milliseconds of one 84 x 84 frame, by camera."""
    env = ManipulationEnv(task_named(task), images=False, robot=robot)
    env.reset(seed=seed)
    rig = Rig(env.world, IMAGE_SIZE)
    result: dict[str, Any] = {"task": task, "size": IMAGE_SIZE, "frame_ms": {}}
    for camera in env.world.image_cameras:
        rig.image(env.data, camera)
        times = []
        for i in range(episodes):
            began = time.process_time()
            rig.image(env.data, camera)
            times.append(time.process_time() - began)
            progress(i + 1, i + 1)
        result["frame_ms"][camera] = spread(times, 1e3)
    rig.close()
    return result


def bench_action(
    task: str, episodes: int, seed: int, workers: int, progress: Progress, robot: Robot | None = None
) -> dict[str, Any]:
    """CPU milliseconds of one action of the `quick` policy on one core, images to action (weights do not matter: fresh ones)."""
    import torch

    from optimus.learn.agent import PolicyAgent
    from optimus.learn.policy import Policy, PolicyConfig, PolicyInputs

    torch.set_num_threads(1)
    env = ManipulationEnv(task_named(task), robot=robot)
    observation, _ = env.reset(seed=seed)
    low = {k: v.shape[0] for k, v in observation.items() if v.ndim == 1}
    inputs = PolicyInputs(task, env.world.image_cameras, low, len(env.world.scene.movable_names))
    policy = Policy(PolicyConfig(), inputs)
    agent = PolicyAgent(policy)
    for _ in range(20):
        agent.act(observation)
    times = []
    for i in range(max(episodes, 20)):
        began = time.process_time()
        agent.act(observation)
        times.append(time.process_time() - began)
        progress(i + 1, i + 1)
    parameters = sum(p.numel() for p in policy.parameters())
    return {"task": task, "policy": "quick", "parameters": parameters, "threads": 1, "action_ms": spread(times, 1e3)}


BENCHES = {
    "expert": bench_expert,
    "collect": bench_collect,
    "step": bench_step,
    "action": bench_action,
    "render": bench_render,
}
