"""Rigid transforms: `Pose`, with frames spelled `a_from_b` and quaternions `wxyz`."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


def quat_mul(a: Array, b: Array) -> Array:
    """The Hamilton product of two quaternions `(4,) wxyz`."""
    aw, ax, ay, az = a.tolist()  # Python's own floats: several times faster than arrays of four
    bw, bx, by, bz = b.tolist()
    return np.array(
        [
            aw * bw - ax * bx - ay * by - az * bz,
            aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
        ]
    )


def quat_from_rotvec(rotvec: ArrayLike) -> Array:
    """The unit quaternion `(4,) wxyz` of a rotation vector `(3,)` [rad]."""
    x, y, z = np.asarray(rotvec, dtype=np.float64).tolist()
    half = 0.5 * math.sqrt(x * x + y * y + z * z)
    # sin(h)/h by its series near zero, where the quotient is 0/0
    scale = 0.5 * (math.sin(half) / half if half > 1e-9 else 1.0 - half * half / 6.0)
    return np.array([math.cos(half), scale * x, scale * y, scale * z])


def rotvec_from_quat(quat: Array) -> Array:
    """The rotation vector `(3,)` [rad] of the shorter rotation that `quat` `(4,) wxyz` stands for."""
    return np.array(_rotvec(*quat.tolist()))


def _rotvec(w: float, x: float, y: float, z: float) -> tuple[float, float, float]:
    if not w >= 0.0:
        w, x, y, z = -w, -x, -y, -z
    norm = math.sqrt(x * x + y * y + z * z)
    scale = 2.0 * math.atan2(norm, w) / norm if norm > 1e-12 else 2.0
    return scale * x, scale * y, scale * z


def matrix_from_quat(quat: Array) -> Array:
    """The rotation matrix `(3, 3)` of a unit quaternion `(4,) wxyz`."""
    w, x, y, z = quat.tolist()
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def quat_from_matrix(matrix: Array) -> Array:
    """The unit quaternion `(4,) wxyz`, w >= 0, of a rotation matrix `(3, 3)` (Shepperd's method)."""
    m = matrix.tolist()
    diagonal = [m[0][0] + m[1][1] + m[2][2], m[0][0], m[1][1], m[2][2]]
    largest = diagonal.index(max(diagonal))
    if largest == 0:
        quat = [1 + diagonal[0], m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]]
    else:
        i = largest - 1
        j, k = (i + 1) % 3, (i + 2) % 3
        quat = [m[k][j] - m[j][k], 0.0, 0.0, 0.0]
        quat[1 + i] = 1 + m[i][i] - m[j][j] - m[k][k]
        quat[1 + j] = m[j][i] + m[i][j]
        quat[1 + k] = m[k][i] + m[i][k]
    unit = np.array(quat) / math.sqrt(sum(x * x for x in quat))
    return unit if quat[0] >= 0 else -unit


@dataclass(frozen=True, eq=False)
class Pose:
    """A rigid transform: position `pos` `(3,)` [m] and unit quaternion `quat` `(4,) wxyz`."""

    pos: Array
    quat: Array

    @staticmethod
    def of(pos: ArrayLike = (0.0, 0.0, 0.0), rotvec: ArrayLike = (0.0, 0.0, 0.0)) -> Pose:
        """A pose from a position [m] and a rotation vector [rad]."""
        return Pose(np.asarray(pos, dtype=np.float64), quat_from_rotvec(rotvec))

    @staticmethod
    def from_matrix(pos: ArrayLike, matrix: Array) -> Pose:
        """A pose from a position [m] and a rotation matrix `(3, 3)`."""
        return Pose(np.asarray(pos, dtype=np.float64), quat_from_matrix(matrix))

    def __matmul__(self, other: Pose) -> Pose:
        """`a_from_c = a_from_b @ b_from_c`."""
        return Pose(self.pos + self.matrix @ other.pos, quat_mul(self.quat, other.quat))

    @property
    def inverse(self) -> Pose:
        conjugate = self.quat * np.array([1.0, -1.0, -1.0, -1.0])
        return Pose(-(matrix_from_quat(conjugate) @ self.pos), conjugate)

    @property
    def matrix(self) -> Array:
        """The rotation `(3, 3)`."""
        return matrix_from_quat(self.quat)

    def transform(self, points: ArrayLike) -> Array:
        """Points `(..., 3)` of frame b, in frame a."""
        return np.asarray(points) @ self.matrix.T + self.pos

    def shifted(self, offset: ArrayLike) -> Pose:
        """The same orientation, moved by `offset` `(3,)` [m] of the outer frame."""
        return Pose(self.pos + np.asarray(offset, dtype=np.float64), self.quat)


def error_between(target: Pose, actual: Pose) -> Array:
    """What is missing from `actual` to `target`: `(6,)`, position [m] and rotation vector [rad], outer frame."""
    tw, tx, ty, tz = target.quat.tolist()
    aw, ax, ay, az = actual.quat.tolist()
    turn = _rotvec(  # of the target's quaternion times the other's conjugate
        tw * aw + tx * ax + ty * ay + tz * az,
        tx * aw - tw * ax - ty * az + tz * ay,
        ty * aw - tw * ay + tx * az - tz * ax,
        tz * aw - tw * az - tx * ay + ty * ax,
    )
    return np.array([*(target.pos - actual.pos).tolist(), *turn])


def interpolate(start: Pose, end: Pose, fraction: float) -> Pose:
    """The pose at `fraction` (0 to 1) of the straight line, turning at a constant rate."""
    error = error_between(end, start)
    turn = quat_from_rotvec(fraction * error[3:])
    return Pose(start.pos + fraction * error[:3], quat_mul(turn, start.quat))


def turn_towards(a: Array, b: Array, at_most: float = np.pi) -> Array:
    """The quaternion `(4,) wxyz` of the shortest rotation from direction `a` `(3,)` towards `b`, of `at_most` [rad]."""
    axis = np.cross(a, b)
    sine = float(np.linalg.norm(axis))
    if sine < 1e-9:  # no way is the shortest
        return np.array([1.0, 0.0, 0.0, 0.0])
    return quat_from_rotvec(axis / sine * min(float(np.arctan2(sine, a @ b)), at_most))


def look_at(pos: ArrayLike, target: ArrayLike, up: ArrayLike = (0.0, 0.0, 1.0)) -> Array:
    """The quaternion `(4,) wxyz` of a MuJoCo camera (it looks along -z) at `pos` that sees `target` in its centre; seen straight
    along `up`, the image's top is towards +x, or +z where that is `up`."""
    z = np.asarray(pos, float) - np.asarray(target, float)
    z /= np.linalg.norm(z)
    x = np.cross(np.asarray(up, float), z)
    if np.linalg.norm(x) < 1e-6:
        x = np.cross((1.0, 0.0, 0.0) if abs(z[0]) < 0.9 else (0.0, 0.0, 1.0), z)
    x /= np.linalg.norm(x)
    return quat_from_matrix(np.column_stack([x, np.cross(z, x), z]))
