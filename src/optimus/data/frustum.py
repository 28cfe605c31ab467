"""What a camera sees: the pinhole projection, for cameras as episodes record them (`VIEWS`)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from optimus.se3 import Pose


def project(points: NDArray[np.floating[Any]], view: Mapping[str, Any]) -> NDArray[np.float64]:
    """Where `points` `(..., 3)` [m], base frame, are in the square picture of a camera: `(..., 3)`, right and up of the centre
    [half sides], and the distance along its axis [m], which is not positive behind it."""
    base_from_camera = Pose(np.asarray(view["pos"], float), np.asarray(view["quat"], float))
    local = (np.asarray(points, float) - base_from_camera.pos) @ base_from_camera.matrix
    depth = -local[..., 2]
    half = np.tan(np.radians(view["fovy"]) / 2) * np.where(depth == 0, np.nan, depth)
    return np.stack([local[..., 0] / half, local[..., 1] / half, depth], axis=-1)


def in_view(points: NDArray[np.floating[Any]], view: Mapping[str, Any]) -> NDArray[np.bool_]:
    """`(...)`: which of `points` `(..., 3)` [m] are in the picture, whatever may stand before them."""
    seen = project(points, view)
    return (seen[..., 2] > 0) & (np.abs(seen[..., 0]) <= 1) & (np.abs(seen[..., 1]) <= 1)
