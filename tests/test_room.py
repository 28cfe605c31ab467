"""Room on a support: outlines cover what they stand for, and how far apart two of them are is never overstated."""

from dataclasses import replace

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from optimus.objects.shapes import Part, Shape, block, cylinder
from optimus.se3 import Pose, quat_from_rotvec, quat_mul
from optimus.skills.room import gap, outline

GREY = (0.5, 0.5, 0.5, 1.0)
HALVES = st.floats(0.01, 0.12)
ANGLES = st.floats(-3.2, 3.2)


def box(half: tuple[float, float, float]) -> Shape:
    return replace(block(0.04, GREY), parts=(Part("box", half),), half_extents=half)


def outside(corners: np.ndarray, points: np.ndarray) -> np.ndarray:
    """How far each of `points` `(n, 2)` is on the wrong side of the side of a convex outline that it is farthest out of [m]."""
    along = np.roll(corners, -1, axis=0) - corners
    turn = np.sign(along[0, 0] * along[1, 1] - along[0, 1] * along[1, 0])
    to = points[:, None] - corners
    cross = along[:, 0] * to[..., 1] - along[:, 1] * to[..., 0]
    return (-turn * cross / np.linalg.norm(along, axis=1)).max(1)


def border(corners: np.ndarray, count: int) -> np.ndarray:
    share = np.linspace(0.0, 1.0, count)[:, None, None]
    return (corners + share * (np.roll(corners, -1, axis=0) - corners)).reshape(-1, 2)


@given(st.tuples(HALVES, HALVES, HALVES), ANGLES, st.sampled_from([0.0, np.pi / 2, 0.6]), st.integers(0, 1000))
def test_the_outline_of_a_box_covers_it(half: tuple[float, float, float], yaw: float, tipped: float, seed: int) -> None:
    turn = quat_mul(quat_from_rotvec((0.0, 0.0, yaw)), quat_from_rotvec((tipped, 0.0, 0.0)))
    pose = Pose(np.array([0.3, -0.2, 0.1]), turn)
    inside = np.random.default_rng(seed).uniform(-1.0, 1.0, (300, 3)).round(1) * np.array(half)
    found = outline(box(half), pose)
    assert outside(found, (inside @ pose.matrix.T + pose.pos)[:, :2]).max() < 1e-9
    if tipped != 0.6:  # and no more than that
        corners = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * np.array(half)
        seen = (corners @ pose.matrix.T + pose.pos)[:, :2]
        assert len(found) == 4 and np.linalg.norm(found[:, None] - seen, axis=2).min(1).max() < 1e-9


@given(st.floats(0.01, 0.04), st.floats(0.02, 0.3), ANGLES, ANGLES, st.booleans())
def test_the_outline_of_a_cylinder_covers_it_whatever_its_roll(
    radius: float, height: float, yaw: float, roll: float, lies: bool
) -> None:
    shape = cylinder(radius, height, GREY)
    tipped = quat_from_rotvec((0.0, np.pi / 2 * lies, 0.0))
    turn = quat_mul(quat_mul(quat_from_rotvec((0.0, 0.0, yaw)), tipped), quat_from_rotvec((0.0, 0.0, roll)))
    pose = Pose(np.array([0.5, 0.1, radius]), turn)
    around = np.linspace(0.0, 2 * np.pi, 40)
    rims = [(radius * np.cos(a), radius * np.sin(a), z) for a in around for z in (-height / 2, height / 2)]
    seen = (np.array(rims) @ pose.matrix.T + pose.pos)[:, :2]
    found = outline(shape, pose)
    assert outside(found, seen).max() < 1e-9
    assert max(np.linalg.norm(found - pose.pos[:2], axis=1)) < 1.03 * np.linalg.norm(seen - pose.pos[:2], axis=1).max()


@given(st.tuples(HALVES, HALVES), ANGLES, st.tuples(HALVES, HALVES), ANGLES, st.tuples(st.floats(-0.3, 0.3), st.floats(-0.3, 0.3)))
def test_a_gap_is_no_wider_than_it_is_and_there_whenever_two_are_apart(
    first: tuple[float, float], turn: float, second: tuple[float, float], other_turn: float, at: tuple[float, float]
) -> None:
    a = outline(box((*first, 0.01)), Pose.of((0.0, 0.0, 0.01), (0.0, 0.0, turn)))
    b = outline(box((*second, 0.01)), Pose.of((*at, 0.01), (0.0, 0.0, other_turn)))
    here, there = border(a, 60), border(b, 60)
    nearest = float(np.linalg.norm(here[:, None] - there, axis=2).min())
    meet = min(outside(a, np.vstack([there, b.mean(0)])).min(), outside(b, np.vstack([here, a.mean(0)])).min()) < -1e-6
    found = gap(a, b)
    assert np.isclose(found, gap(b, a))
    if meet:
        assert found < 0.0
    else:
        assert found <= nearest + 1e-9
        assert found > -1e-6 or nearest < 0.01  # the borders are looked at every few millimetres
        assert found > 0.7 * nearest - 0.01  # corner to corner it says less
