"""What the policy's cameras see, side by side and large enough to look at."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from optimus.data.episode import IMAGE_SIZE, IMAGE_SUFFIX, Observation

HEIGHT = 3 * IMAGE_SIZE
"""Of the pictures, about [pixels]."""


def blank(cameras: Sequence[str]) -> NDArray[np.uint8]:
    """A picture of that size, before there is one."""
    return np.zeros((HEIGHT, HEIGHT * len(cameras), 3), np.uint8)


def side_by_side(observation: Observation, cameras: Sequence[str]) -> NDArray[np.uint8]:
    """The cameras' images `(h, w, 3)` beside one another, enlarged by a whole number: the policy sees no more."""
    row = np.concatenate([observation[camera + IMAGE_SUFFIX] for camera in cameras], axis=1)
    times = max(1, HEIGHT // row.shape[0])
    return row.repeat(times, axis=0).repeat(times, axis=1)
