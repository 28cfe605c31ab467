"""Small made-up episodes: a coloured square on noise, whose place decides the action."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from optimus.data.curate import CurationConfig, curate
from optimus.data.episode import IMAGE_SIZE, Episode
from optimus.data.store import EpisodeStore

CAMERAS = ("front", "wrist")
REACH = 0.2  # [m] half the side of the area that the square moves in


def square_image(place: NDArray[np.floating[Any]], rng: np.random.Generator, size: int = 10) -> NDArray[np.uint8]:
    """A red square at `place` `(2,)` [m] in the area, on grey noise."""
    image = rng.integers(90, 120, size=(IMAGE_SIZE, IMAGE_SIZE, 3), dtype=np.uint8)
    row, column = np.round((place / REACH + 1) / 2 * (IMAGE_SIZE - 12 - size) + 6).astype(int)
    image[row : row + size, column : column + size] = (200, 30, 30)
    return image


def make_episode(seed: int, steps: int = 20, task: str = "square", cameras: tuple[str, ...] = CAMERAS, **changes: Any) -> Episode:
    """The hand goes to the square: the action is the way that is left, and only the image shows where to."""
    rng = np.random.default_rng(seed)
    target = rng.uniform(-REACH, REACH, size=2)
    hand = np.zeros((steps, 3), np.float32)
    actions = np.zeros((steps, 7), np.float32)
    for t in range(steps):
        actions[t, :2] = target - hand[t, :2]
        actions[t, 6] = 1 if t > steps // 2 else -1
        if t + 1 < steps:
            hand[t + 1, :2] = hand[t, :2] + 0.2 * actions[t, :2] + rng.normal(0, 0.005, 2)
    observations: dict[str, NDArray[Any]] = {
        "robot0_eef_pos": hand,
        "robot0_eef_quat": np.tile(np.array([1, 0, 0, 0], np.float32), (steps, 1)),
        "robot0_gripper_qpos": np.tile(np.array([0.04, -0.04], np.float32), (steps, 1)),
        "robot0_target_error": np.zeros((steps, 6), np.float32),
    }
    for camera in cameras:
        observations[f"{camera}_image"] = np.stack([square_image(target, rng) for _ in range(steps)])
    objects = np.zeros((steps, 1, 3), np.float32)
    objects[:, 0, :2] = target
    values: dict[str, Any] = {
        "task": task,
        "seed": seed,
        "agent": "formula",
        "observations": observations,
        "actions": actions,
        "executed": actions.copy(),
        "initial_state": rng.normal(size=12),
        "objects": objects,
        "object_names": ("square",),
        "success": True,
        "skeleton": ("pick", "place"),
    }
    return Episode(**{**values, **changes})


def make_dataset(
    path: Path, episodes: int = 8, steps: int = 20, config: dict[str, Any] | None = None, cameras: tuple[str, ...] = CAMERAS
) -> EpisodeStore:
    """A curated dataset of such episodes."""
    store = EpisodeStore.create(path, "square", cameras, config or {"position_scale": 1.0})
    for seed in range(episodes):
        store.write(make_episode(seed, steps, cameras=cameras))
    curate(path, CurationConfig())
    return store
