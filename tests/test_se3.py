"""Poses against scipy's rotations."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from optimus.se3 import Pose, error_between, interpolate, quat_from_matrix, quat_mul, rotvec_from_quat

vectors = st.lists(st.floats(-3.0, 3.0), min_size=3, max_size=3).map(np.array)


def rotation(pose: Pose) -> Rotation:
    return Rotation.from_quat(np.roll(pose.quat, -1))


@given(vectors, vectors)
def test_composition_agrees_with_scipy(a: np.ndarray, b: np.ndarray) -> None:
    product = Pose.of(rotvec=a) @ Pose.of(rotvec=b)
    expected = Rotation.from_rotvec(a) * Rotation.from_rotvec(b)
    np.testing.assert_allclose(product.matrix, expected.as_matrix(), atol=1e-12)
    np.testing.assert_allclose(quat_mul(Pose.of(rotvec=a).quat, Pose.of(rotvec=b).quat), product.quat)


@given(vectors, vectors, vectors)
def test_inverse_undoes(pos: np.ndarray, turn: np.ndarray, point: np.ndarray) -> None:
    pose = Pose.of(pos, turn)
    np.testing.assert_allclose(pose.inverse.transform(pose.transform(point)), point, atol=1e-9)
    np.testing.assert_allclose((pose @ pose.inverse).matrix, np.eye(3), atol=1e-12)


@given(vectors)
def test_matrix_round_trip(turn: np.ndarray) -> None:
    matrix = Rotation.from_rotvec(turn).as_matrix()
    np.testing.assert_allclose(Pose(np.zeros(3), quat_from_matrix(matrix)).matrix, matrix, atol=1e-9)


@given(vectors)
def test_rotvec_is_the_shorter_rotation(turn: np.ndarray) -> None:
    found = rotvec_from_quat(Pose.of(rotvec=turn).quat)
    assert np.linalg.norm(found) <= np.pi + 1e-9
    np.testing.assert_allclose(Rotation.from_rotvec(found).as_matrix(), Rotation.from_rotvec(turn).as_matrix(), atol=1e-9)


@given(vectors, vectors, vectors, vectors, st.floats(0.0, 1.0))
def test_interpolation_turns_at_a_constant_rate(
    p: np.ndarray, u: np.ndarray, q: np.ndarray, v: np.ndarray, f: float
) -> None:
    a, b = Pose.of(p, u), Pose.of(q, v)
    whole, part = error_between(b, a), error_between(interpolate(a, b, f), a)
    np.testing.assert_allclose(part[:3], f * whole[:3], atol=1e-9)
    angle = (rotation(interpolate(a, b, f)) * rotation(a).inv()).magnitude()
    np.testing.assert_allclose(angle, f * np.linalg.norm(whole[3:]), atol=1e-6)
