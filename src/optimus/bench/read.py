"""Reading for training: batches of windows at random from a large dataset."""

from __future__ import annotations

import shutil
import tempfile
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from optimus.bench.config import BenchConfig, Progress
from optimus.data.episode import Episode
from optimus.data.store import EpisodeStore
from optimus.data.windows import WindowConfig, Windows
from optimus.errors import StorageError
from optimus.statistics import quantiles

FRAMES, LENGTH = 100_000, 100
"""In the whole dataset, and in an episode."""
WINDOWS, CONTEXT = 16, 8
"""In a batch, and frames in a window."""
LEAST = 200
"""Batches measured, at least."""


def bench_read(config: BenchConfig, progress: Progress) -> dict[str, Any]:
    """CPU and elapsed milliseconds of a batch of `WINDOWS` windows of `CONTEXT` frames, all of the task's cameras, drawn at random
    from `FRAMES` frames that have just been written (where memory allows, they come from the system's cache). The pictures are
    noise: nothing is decoded, so what they show does not matter."""
    folder = Path(tempfile.mkdtemp(prefix="optimus-bench-"))
    try:
        store, size = _made(config, folder)
        windows = Windows(store, store.seeds, WindowConfig(context=CONTEXT))
        rng, batches = np.random.default_rng(config.seed), max(config.episodes, LEAST)
        cpu, elapsed = [], []
        for i in range(batches):
            began, cpu_began = time.perf_counter(), time.process_time()
            windows.sample(rng, WINDOWS)
            cpu.append(time.process_time() - cpu_began)
            elapsed.append(time.perf_counter() - began)
            progress(i + 1, i + 1)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    about = {"cameras": len(store.cameras), "frames": FRAMES, "gigabytes": size / 1e9, "windows": WINDOWS, "context": CONTEXT}
    return {**config.about, **about, "batch_ms": quantiles(elapsed, 95, scale=1e3), "batch_cpu_ms": quantiles(cpu, 95, scale=1e3)}


def _made(config: BenchConfig, folder: Path) -> tuple[EpisodeStore, int]:
    """The dataset, and its size [bytes]."""
    env = config.env(images=True)
    seen, _ = env.reset(seed=config.seed)
    rng = np.random.default_rng(config.seed)
    observations = {
        name: rng.integers(256, size=(LENGTH, *value.shape), dtype=np.uint8)
        if value.dtype == np.uint8
        else np.repeat(value[None], LENGTH, axis=0)
        for name, value in seen.items()
    }
    actions = rng.uniform(-1, 1, (LENGTH, env.action_size)).astype(np.float32)
    objects = np.repeat(env.object_positions()[None].astype(np.float32), LENGTH, axis=0)
    names = env.world.scene.movable_names
    episode = Episode(config.task, 0, "noise", observations, actions, actions, env.snapshot(), objects, names, True)
    size = FRAMES // LENGTH * sum(array.nbytes for array in observations.values())
    if shutil.disk_usage(folder).free < 1.2 * size:
        raise StorageError(f"{size / 1e9:.1f} GB are to be written to {folder}, where there is less room; set TMPDIR to another")
    store = EpisodeStore.create(folder / "data", config.task, env.world.image_cameras, {})
    for seed in range(FRAMES // LENGTH):
        store.write(replace(episode, seed=seed))
    return store, size
