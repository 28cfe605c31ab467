"""Each predicate on states made by hand, where anyone can say what holds."""

from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from optimus.objects.shapes import block, cylinder, unrolled
from optimus.predicates import Clear, HandEmpty, Holding, On, Released, facts_of
from optimus.scene import Scene
from optimus.se3 import Pose
from optimus.state import Held, State
from optimus.tasks import task

SCENE = task("stack").problem(0).scene
GREY = (0.5, 0.5, 0.5, 1.0)
ANGLES = st.floats(-np.pi, np.pi)
FAR = Pose.of((0.5, 0.0, 0.4), (np.pi, 0.0, 0.0))


def state(a: tuple[float, float, float], turn: tuple[float, float, float] = (0, 0, 0), **rest: Any) -> State:
    poses = {"cubeA": Pose.of(a, turn), "cubeB": Pose.of((0.5, 0.0, 0.025))}
    return State(np.zeros(7), 0.08, poses, **{"tcp": FAR, **rest})


def surface_height(scene: Scene, support: str) -> float:
    surface = scene.shape_of(support).surface
    assert surface is not None
    return surface.z


def test_stacked() -> None:
    facts = facts_of(SCENE, state((0.505, 0.01, 0.07)))
    assert {On("cubeA", "cubeB"), On("cubeB", "table"), Released("cubeA"), HandEmpty(), Clear("cubeA")} <= facts
    assert Clear("cubeB") not in facts and On("cubeA", "table") not in facts


def test_floating_beside_or_tilted_is_not_on() -> None:
    for s in (state((0.5, 0.0, 0.08)), state((0.53, 0.0, 0.07)), state((0.5, 0.0, 0.07), (0.6, 0.0, 0.0))):
        assert On("cubeA", "cubeB") not in facts_of(SCENE, s)


def test_a_cube_on_its_side_is_still_on() -> None:
    assert On("cubeA", "cubeB") in facts_of(SCENE, state((0.5, 0.0, 0.07), (np.pi / 2, 0.0, 0.0)))


def test_held_moving_touched_or_near_is_not_released() -> None:
    near = Pose.of((0.5, 0.0, 0.09), (np.pi, 0.0, 0.0))
    held = Held("cubeA", FAR.inverse @ Pose.of((0.5, 0.0, 0.07)))
    assert Holding("cubeA") in facts_of(SCENE, state((0.5, 0.0, 0.07), held=held))
    cases: list[dict[str, Any]] = [{"held": held}, {"speeds": {"cubeA": 0.05}}, {"touched": frozenset({"cubeA"})}, {"tcp": near}]
    for rest in cases:
        facts = facts_of(SCENE, state((0.5, 0.0, 0.07), **rest))
        assert Released("cubeA") not in facts
    assert On("cubeA", "cubeB") not in facts_of(SCENE, state((0.5, 0.0, 0.07), held=held))


@given(heading=ANGLES, lean=st.floats(0.0, np.pi), roll=ANGLES)
def test_a_body_of_revolution_is_as_high_however_it_is_rolled(heading: float, lean: float, roll: float) -> None:
    shape = cylinder(0.03, 0.1, (1.0, 1.0, 1.0, 1.0))
    turns = ((0.0, 0.0, heading), (lean, 0.0, 0.0), (0.0, 0.0, roll))
    rotation = np.linalg.multi_dot([Pose.of(rotvec=turn).matrix for turn in turns])
    around = np.linspace(0.0, 2 * np.pi, 400)
    rims = np.array([[0.03 * np.cos(a), 0.03 * np.sin(a), z] for a in around for z in (-0.05, 0.05)])
    lowest = float((rims @ rotation.T)[:, 2].min())
    assert shape.above(rotation) == pytest.approx(-lowest, abs=1e-5)


@given(heading=ANGLES, lean=st.floats(0.0, np.pi), roll=ANGLES)
def test_how_far_a_turned_thing_reaches_is_what_its_points_say(heading: float, lean: float, roll: float) -> None:
    rotation = Rotation.from_euler("zxz", (heading, lean, roll)).as_matrix()
    around = np.linspace(0.0, 2 * np.pi, 2000)
    rims = [0.02 * np.cos(around), 0.02 * np.sin(around), np.full(2000, 0.06)]
    assert abs(cylinder(0.02, 0.12, GREY).reach(rotation) - np.hypot(*(rotation @ rims)[:2]).max()) < 1e-6
    corners = np.array(list(product((-0.02, 0.02), (-0.02, 0.02), (-0.02, 0.02)))).T
    assert np.isclose(block(0.04, GREY).reach(rotation), np.hypot(*(rotation @ corners)[:2]).max())


@given(heading=ANGLES, lean=st.floats(1.0, 2.1), roll=ANGLES)
def test_the_turn_of_what_lies_about_its_axis_is_forgotten(heading: float, lean: float, roll: float) -> None:
    lying = Pose.of(rotvec=(0.0, 0.0, heading)) @ Pose.of(rotvec=(lean, 0.0, 0.0))
    plain, rolled = (unrolled(lying @ Pose.of(rotvec=(0.0, 0.0, turn))).matrix for turn in (0.0, roll))
    np.testing.assert_allclose(plain, rolled, atol=1e-9)
    np.testing.assert_allclose(plain[:, 2], lying.matrix[:, 2], atol=1e-9)
    assert abs(plain[2, 1]) < 1e-9 and np.linalg.det(plain) == pytest.approx(1.0)


def test_a_cylinder_on_its_side_is_on_however_it_is_rolled() -> None:
    problem = next(p for p in map(task("pick-place").problem, range(20)) if p.variant == "cylinder")
    scene = problem.scene
    at = scene.fixture_poses["right"].transform((0.0, 0.0, surface_height(scene, "right") + 0.024))
    for roll in (0.0, 0.4, 0.8):
        lying = Pose(at, (Pose.of(rotvec=(np.pi / 2, 0.0, 0.0)) @ Pose.of(rotvec=(0.0, 0.0, roll))).quat)
        assert On("object", "right") in facts_of(scene, State(np.zeros(7), 0.08, {"object": lying}, FAR))
        leaning = Pose(at, (Pose.of(rotvec=(1.2, 0.0, 0.0)) @ Pose.of(rotvec=(0.0, 0.0, roll))).quat)
        assert On("object", "right") not in facts_of(scene, State(np.zeros(7), 0.08, {"object": leaning}, FAR))
