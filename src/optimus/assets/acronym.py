"""Grasp files in the schema of ACRONYM (Eppner, Mousavian and Fox, 2021), read and written; nothing in them runs.

A transform is `object_from_gripper`: the gripper's z axis approaches, its fingers open along x, their tips 0.1122 m ahead.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import h5py
import numpy as np
from numpy.typing import NDArray

from optimus.errors import AssetError
from optimus.objects.shapes import Grasp
from optimus.se3 import Array, Pose

if TYPE_CHECKING:
    from optimus.assets.trial import Outcome

FINGERTIP, PAD = 0.1122, 0.0088
"""Of the schema's gripper: its fingertips ahead of its base, and the middle of the pads behind these [m]."""
GRIPPER_FROM_TCP = Pose.from_matrix((0.0, 0.0, FINGERTIP - PAD), np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]))
"""Its x, along which the fingers open, is the tcp's y."""
HELD = "grasps/qualities/flex/object_in_gripper"
MOTION = "grasps/qualities/flex/object_motion_during_{}_{}"
NEEDED = ("grasps/transforms", HELD, "object/file", "object/scale")


@dataclass(frozen=True, eq=False)
class GraspFile:
    """What is in a file: grasps `(n,)` as `object_from_tcp`, in metres of the scaled object, whether each held, and the object."""

    grasps: tuple[Pose, ...]
    held: NDArray[np.bool_]
    mesh: str
    """The object's mesh, as the file names it."""
    scale: float
    mass: float | None
    friction: float | None


def write_grasps(path: Path, grasps: Sequence[Grasp], outcomes: Sequence[Outcome], about: dict[str, Any]) -> None:
    """Write verified grasps; `about` becomes the `object` group (`file`, `scale`, `mass`, `friction`, `com`, `volume`)."""
    with h5py.File(path, "w") as file:
        to_gripper = GRIPPER_FROM_TCP.inverse
        file["grasps/transforms"] = np.array([_matrix(g.pose @ to_gripper) for g in grasps])
        file[HELD] = np.array([int(o.held) for o in outcomes])
        for phase in ("closing", "shaking"):
            moved = np.array([getattr(o, phase) for o in outcomes])
            file[MOTION.format(phase, "linear")], file[MOTION.format(phase, "angular")] = moved[:, 0], moved[:, 1]
        file["gripper/type"] = "panda"
        for key, value in about.items():
            file[f"object/{key}"] = value


def read_grasps(path: Path) -> GraspFile:
    """Read a file of that schema; `AssetError` says what is missing or damaged."""
    try:
        with h5py.File(path, "r") as file:
            missing = [key for key in NEEDED if key not in file]
            if missing:
                raise AssetError(f"{path} is no ACRONYM grasp file: it has no {', '.join(missing)} (it has {', '.join(file)})")
            transforms, held = np.asarray(file["grasps/transforms"], float), np.asarray(file[HELD], float) > 0.5
            return GraspFile(
                grasps=tuple(_tcp(t, path) for t in transforms),
                held=held,
                mesh=_text(file["object/file"][()]),  # pyright: ignore[reportIndexIssue]
                scale=float(np.asarray(file["object/scale"])),
                mass=_number(file, "object/mass"),
                friction=_number(file, "object/friction"),
            )
    except (OSError, ValueError, TypeError) as error:
        raise AssetError(f"{path} is not a readable HDF5 grasp file: {error}") from error


def _matrix(pose: Pose) -> Array:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = pose.matrix, pose.pos
    return matrix


def _tcp(transform: Array, path: Path) -> Pose:
    if transform.shape != (4, 4) or not np.allclose(transform[:3, :3] @ transform[:3, :3].T, np.eye(3), atol=1e-3):
        raise AssetError(f"{path}: grasps/transforms holds something that is not a rigid transform")
    return Pose.from_matrix(transform[:3, 3], transform[:3, :3]) @ GRIPPER_FROM_TCP


def _text(value: Any) -> str:
    return value.decode() if isinstance(value, bytes) else str(value)


def _number(file: h5py.File, key: str) -> float | None:
    return float(np.asarray(file[key])) if key in file else None
