"""How the things of an episode are turned, and how far its doors are open, as far as it is recorded."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from optimus.data.episode import STATE_COLUMNS
from optimus.data.episode_file import STATES, EpisodeHeader

Array = NDArray[np.float64]


def says_rotations(header: EpisodeHeader) -> bool:
    """Whether somebody recorded states, and where in them the things are."""
    columns = header.info.get(STATE_COLUMNS, {}).get("objects", {})
    return STATES in header.arrays and set(columns) >= set(header.object_names)


def rotations_of(header: EpisodeHeader) -> Array | None:
    """The things' rotations `(T, k, 3, 3)`, in the order of their names; None where that is not recorded."""
    if not says_rotations(header):
        return None
    from scipy.spatial.transform import Rotation  # it takes half a second to load, and few need it

    columns, states = header.info.get(STATE_COLUMNS, {}).get("objects", {}), header.read(STATES)
    quats = [states[:, columns[name] + 3 : columns[name] + 7] for name in header.object_names]
    turns = [Rotation.from_quat(quat, scalar_first=True).as_matrix() for quat in quats]
    return np.stack(turns, axis=1) if turns else np.empty((len(states), 0, 3, 3))


def door_columns(header: EpisodeHeader) -> list[int]:
    """Where in the recorded states the doors' angles are."""
    return sorted(header.info.get(STATE_COLUMNS, {}).get("doors", {}).values())


def doors_of(header: EpisodeHeader) -> Array:
    """How far the doors are open `(T, d)` [rad], in the order of the physics state, of an episode with recorded states."""
    return header.read(STATES)[:, door_columns(header)]


def as_columns(rotations: NDArray[Any]) -> NDArray[np.float32]:
    """Rotations `(..., 3, 3)` as their first two columns, one after the other `(..., 6)`: continuous, as neither angles nor
    quaternions are (Zhou et al., *On the Continuity of Rotation Representations in Neural Networks*, 2019)."""
    two = np.swapaxes(rotations[..., :2], -1, -2)
    return two.reshape(*two.shape[:-2], 6).astype(np.float32)
