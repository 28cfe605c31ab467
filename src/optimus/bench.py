"""Measurements anyone can repeat: CPU time, medians and percentiles."""

from __future__ import annotations

import shutil
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from optimus.collect import CollectConfig, collect
from optimus.control import require_control
from optimus.data.episode import IMAGE_SIZE, OSC
from optimus.demonstrate import INVALID, Attempt, ExpertConfig, demonstrate
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


@dataclass(frozen=True)
class BenchConfig:
    """What to measure with."""

    task: str
    episodes: int = 20
    seed: int = 0
    workers: int = 1
    control: str = OSC
    robot: Robot | None = None
    """Takes the place of the task's own."""
    check: bool = False
    """Validate every plan of the expert independently."""

    def __post_init__(self) -> None:
        task_named(self.task)
        require_control(self.control)

    def env(self, images: bool) -> ManipulationEnv:
        return ManipulationEnv(task_named(self.task), images=images, control=self.control, robot=self.robot)

    @property
    def about(self) -> dict[str, Any]:
        robot = self.robot or task_named(self.task).problem(self.seed).scene.robot
        return {"task": self.task, "control": self.control, "robot": robot.name}


def _expert_attempt(config: BenchConfig, seed: int) -> Attempt:
    return demonstrate(config.env(images=False), seed, ExpertConfig(check=config.check))


def bench_expert(config: BenchConfig, progress: Progress) -> dict[str, Any]:
    """The expert, unperturbed and without images, on `episodes` consecutive seeds; with `check`, invalid plans are counted."""
    attempts: list[Attempt] = []
    with executor(config.workers) as pool:
        for future in [pool.submit(_expert_attempt, config, config.seed + i) for i in range(config.episodes)]:
            attempts.append(future.result())
            progress(len(attempts), sum(a.success for a in attempts))
    played = [a.episode for a in attempts if a.episode is not None]
    steps, plan = spread([float(len(e)) for e in played]), spread([a.plan_seconds for a in attempts])
    errors = 1e3 * np.array([e for a in attempts for e in a.tracking] or [0.0])
    return {
        **config.about,
        "seed": config.seed,
        "episodes": config.episodes,
        "successes": sum(a.success for a in attempts),
        "paper_rule_successes": sum(bool(a.info.get("paper_success")) for a in attempts),
        "plan_seconds": plan,
        "episode_steps": {"median": steps["median"], "p95": steps["p95"]},
        "tracking_error_mm": {
            "median": float(np.median(errors)),
            "p99": float(np.percentile(errors, 99)),
            "max": float(errors.max()),
        },
        "failures": dict(Counter(a.failure for a in attempts if not a.success)),
        **({"invalid_plans": sum(a.failure.startswith(INVALID) for a in attempts)} if config.check else {}),
    }


def bench_collect(config: BenchConfig, progress: Progress) -> dict[str, Any]:
    """Collection as users run it: perturbed, rendered, written; process start-up included."""
    workers = config.workers or available_cores()
    folder = Path(tempfile.mkdtemp(prefix="optimus-bench-"))
    try:
        asked = CollectConfig(
            config.task, folder / "data", config.episodes, config.seed, workers, control=config.control, robot=config.robot
        )
        result = collect(asked, lambda done: progress(done, done))
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return {
        **config.about,
        "workers": workers,
        "demonstrations": result.demonstrations,
        "attempts": result.attempts,
        "seconds": result.seconds,
        "demonstrations_per_hour": 3600 * result.demonstrations / result.seconds,
        "cpu_seconds": result.cpu_seconds,
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
        result["step_ms" if images else "step_without_images_ms"] = spread(times, 1e3)
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
        result["frame_ms"][camera] = spread(times, 1e3)
    rig.close()
    return result


def bench_action(config: BenchConfig, progress: Progress) -> dict[str, Any]:
    """CPU milliseconds of one action of the `quick` policy on one core, images to action (weights do not matter: fresh ones)."""
    import torch

    from optimus.learn.agent import PolicyAgent
    from optimus.learn.policy import Policy, PolicyConfig, PolicyInputs

    torch.set_num_threads(1)
    env = config.env(images=True)
    observation, _ = env.reset(seed=config.seed)
    low = {k: v.shape[0] for k, v in observation.items() if v.ndim == 1}
    objects = len(env.world.scene.movable_names)
    inputs = PolicyInputs(config.task, env.world.image_cameras, low, objects, env.action_size, config.control)
    policy = Policy(PolicyConfig(), inputs)
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
    return {**config.about, "policy": "quick", "parameters": parameters, "threads": 1, "action_ms": spread(times, 1e3)}


BENCHES = {
    "expert": bench_expert,
    "collect": bench_collect,
    "step": bench_step,
    "action": bench_action,
    "render": bench_render,
}
