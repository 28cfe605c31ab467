"""Where the hand goes next: its pose at the next opening or closing of the gripper."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

KEYPOSE = 12
"""Numbers of a keypose: the hand's position [m] (3), the direction in which it approaches (3), and the line on which its fingers
close (6): the products of that line's direction with itself, which do not tell a hand from one turned by half a turn."""


def keyposes(gripper: NDArray[Any], position: NDArray[Any], quaternion: NDArray[Any]) -> NDArray[np.float32]:
    """`(T, 12)` of an episode's gripper labels `(T,)`, and the hand's positions `(T, 3)` [m] and xyzw quaternions `(T, 4)`.

    At every step that pose which the hand has when the label next changes; after the last change, its last pose.
    """
    stops = np.append(np.flatnonzero(np.diff(gripper)) + 1, len(gripper) - 1)
    at = stops[np.searchsorted(stops, np.arange(len(gripper)))]
    x, y, z, w = (quaternion[at] / np.linalg.norm(quaternion[at], axis=1, keepdims=True)).T
    closing = np.stack([2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)], 1)
    approach = np.stack([2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)], 1)
    line = closing[:, [0, 1, 2, 0, 0, 1]] * closing[:, [0, 1, 2, 1, 2, 2]]
    return np.concatenate([position[at], approach, line], 1).astype(np.float32)
