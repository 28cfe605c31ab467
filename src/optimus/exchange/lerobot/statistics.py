"""The statistics of a LeRobotDataset: of every number of every feature, over all frames and exactly.

LeRobot itself samples images and estimates quantiles from histograms; these are the values that its estimates approach. Images
count in 0 to 1, by channel, with the shape `(3, 1, 1)`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

QUANTILES = {"q01": 0.01, "q10": 0.10, "q50": 0.50, "q90": 0.90, "q99": 0.99}
LEVELS = np.arange(256) / 255.0

Stats = dict[str, list]
"""`min`, `max`, `mean`, `std`, `count` and the quantiles of one feature, JSON-able."""


def of_numbers(values: NDArray) -> Stats:
    """Of an array `(T, n)` or `(T,)`."""
    table = values.reshape(len(values), -1).astype(np.float64)
    found = {"min": table.min(0), "max": table.max(0), "mean": table.mean(0), "std": table.std(0)}
    found |= {name: np.quantile(table, share, axis=0) for name, share in QUANTILES.items()}
    return {**{name: value.tolist() for name, value in found.items()}, "count": [len(table)]}


def histogram(images: NDArray[np.uint8]) -> NDArray[np.int64]:
    """How often each level occurs in each channel, `(3, 256)`; those of several arrays add up."""
    return np.stack([np.bincount(images[..., c].ravel(), minlength=256) for c in range(3)])


def of_images(counts: NDArray[np.int64], frames: int) -> Stats:
    """Of images with that histogram."""
    total = counts.sum(1)
    mean = counts @ LEVELS / total
    variance = counts @ LEVELS**2 / total - mean**2
    present = counts > 0
    found = {
        "min": LEVELS[present.argmax(1)],
        "max": LEVELS[255 - present[:, ::-1].argmax(1)],
        "mean": mean,
        "std": np.sqrt(np.maximum(variance, 0.0)),
    }
    reached = counts.cumsum(1)
    for name, share in QUANTILES.items():
        # numpy's linear rule: between the two values around position share * (n - 1)
        place = share * (total - 1)
        low, high = (_levels_at(reached, rounded(place)) for rounded in (np.floor, np.ceil))
        found[name] = low + (place - np.floor(place)) * (high - low)
    return {**{name: value.reshape(3, 1, 1).tolist() for name, value in found.items()}, "count": [frames]}


def _levels_at(reached: NDArray[np.int64], places: NDArray[np.float64]) -> NDArray[np.float64]:
    """The level of the pixel at that place of each channel's sorted pixels, `(3,)`; `reached` `(3, 256)` counts up."""
    return np.array([LEVELS[np.searchsorted(row, place, "right")] for row, place in zip(reached, places, strict=True)])
