"""Room on a support: discs cover what they stand for, and little else."""

from dataclasses import replace

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from optimus.objects.shapes import Part, Shape, block, cylinder
from optimus.se3 import Pose, quat_from_rotvec, quat_mul
from optimus.skills.room import discs, sides

GREY = (0.5, 0.5, 0.5, 1.0)
HALVES = st.floats(0.01, 0.12)
ANGLES = st.floats(-3.2, 3.2)


def box(half: tuple[float, float, float]) -> Shape:
    return replace(block(0.04, GREY), parts=(Part("box", half),), half_extents=half)


def covers(found: np.ndarray, points: np.ndarray) -> np.ndarray:
    """How far points `(n, 2)` are outside of the nearest disc [m]."""
    return (np.linalg.norm(points[:, None] - found[None, :, :2], axis=2) - found[None, :, 2]).min(1)


@given(st.tuples(HALVES, HALVES, HALVES), ANGLES, st.sampled_from([0.0, np.pi / 2, np.pi]), st.integers(0, 1000))
def test_discs_cover_a_box_and_are_no_wider_than_it_is(
    half: tuple[float, float, float], yaw: float, tipped: float, seed: int
) -> None:
    quat = quat_mul(quat_from_rotvec((0.0, 0.0, yaw)), quat_from_rotvec((tipped, 0.0, 0.0)))
    pose = Pose(np.array([0.3, -0.2, 0.1]), quat)
    inside = np.random.default_rng(seed).uniform(-1.0, 1.0, (300, 3)).round(1) * np.array(half)
    seen = (inside @ pose.matrix.T + pose.pos)[:, :2]
    found = discs(box(half), pose)
    assert covers(found, seen).max() < 1e-9
    long = sides(box(half), pose)
    if long is None:
        assert len(found) == 1
        return
    assert np.isclose(found[:, :2].mean(0), pose.pos[:2]).all()
    if len(found) < 8:  # of more than that each is as long as it has to be
        assert found[:, 2].max() <= np.sqrt(2.0) * np.hypot(*long[1]) + 1e-9


@given(st.floats(0.01, 0.04), st.floats(0.02, 0.3), ANGLES, ANGLES)
def test_discs_cover_a_cylinder_that_lies_whatever_its_roll(radius: float, height: float, yaw: float, roll: float) -> None:
    shape = cylinder(radius, height, GREY)
    lying = quat_mul(quat_from_rotvec((0.0, 0.0, yaw)), quat_from_rotvec((0.0, np.pi / 2, 0.0)))
    pose = Pose(np.array([0.5, 0.1, radius]), quat_mul(lying, quat_from_rotvec((0.0, 0.0, roll))))
    around = np.linspace(0.0, 2 * np.pi, 40)
    rims = [(radius * np.cos(a), radius * np.sin(a), z) for a in around for z in np.linspace(-height / 2, height / 2, 9)]
    seen = (np.array(rims) @ pose.matrix.T + pose.pos)[:, :2]
    assert covers(discs(shape, pose), seen).max() < 1e-9


def test_what_leans_is_one_disc() -> None:
    pose = Pose.of((0.5, 0.0, 0.1), (0.5, 0.0, 0.0))
    assert sides(box((0.02, 0.1, 0.02)), pose) is None and len(discs(box((0.02, 0.1, 0.02)), pose)) == 1
