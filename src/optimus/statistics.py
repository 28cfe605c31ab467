"""Numbers that stand for many: an interval for a proportion, a few quantiles for a spread."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np


def wilson(successes: int, episodes: int, z: float = 1.96) -> tuple[float, float]:
    """The Wilson score interval of a proportion, 95 % for the default `z` (Wilson 1927)."""
    if episodes == 0:
        return (0.0, 1.0)
    p, n = successes / episodes, episodes
    centre = (p + z * z / (2 * n)) / (1 + z * z / n)
    half = z / (1 + z * z / n) * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
    return (max(0.0, centre - half), min(1.0, centre + half))


def quantiles(values: Sequence[float], *percents: int, scale: float = 1.0) -> dict[str, float]:
    """Median, the percentiles asked for (`p95`) and maximum, times `scale`; zeros if there are no values."""
    v = np.array(values if len(values) else [0.0]) * scale
    rest = {f"p{p}": float(np.percentile(v, p)) for p in percents}
    return {"median": float(np.median(v)), **rest, "max": float(v.max())}
