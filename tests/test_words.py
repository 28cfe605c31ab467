"""Instructions say what a goal asks for, so that a reader who has only the words finds the things again."""

import colorsys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from optimus.objects.library import LIBRARY
from optimus.objects.shapes import block, cup, slab
from optimus.predicates import On, Open, Released
from optimus.robots import PANDA
from optimus.scene import Camera, Fixture, Movable, Scene
from optimus.se3 import Pose
from optimus.tasks import TASKS
from optimus.tasks import task as task_named
from optimus.words import COLOURS, colour_name, instruction, names_in

RED, BLUE = (0.85, 0.13, 0.13, 1.0), (0.15, 0.33, 0.80, 1.0)
EYE = Camera("agentview", (1.0, 0.0, 0.8), (0.5, 0.0, 0.0))


def table_with(*movables: Movable) -> Scene:
    return Scene(PANDA, (Fixture("table", slab(0.4, 0.4, 0.05, RED), (0.5, 0.0, -0.025)),), movables, (EYE,))


@pytest.mark.parametrize("name", TASKS)
def test_every_task_says_what_it_wants_and_names_every_thing_of_its_goal(name: str) -> None:
    for seed in range(6):
        problem = task_named(name).problem(seed)
        names = names_in(problem.scene, problem.poses)
        assert len(set(names.values())) == len(names)
        for atom in problem.goal:
            assert all(names[a] in problem.instruction for a in atom.args)
        assert problem.instruction.startswith("put the ") and problem.words.keys() == problem.poses.keys()


def test_the_words_of_known_problems() -> None:
    assert task_named("stack").problem(0).instruction == "put the red block on the green block"
    three = "put the red block on the green block and then the blue block on the red block"
    assert task_named("stack-three").problem(0).instruction == three
    assert {task_named("pick-place").problem(s).instruction for s in range(12)} == {
        f"put the {thing} on the right platform" for thing in ("red block", "blue cylinder", "yellow cup")
    }
    assert task_named("microwave").problem(0).instruction.endswith(" in the microwave")
    assert task_named("shelf").problem(0).instruction.endswith(" on the middle rung")


def test_the_library_s_own_words_are_used() -> None:
    shape = block(0.05, RED)
    scene = table_with(Movable("object", type(shape)(**{**vars(shape), "kind": "mug-1"})))
    assert names_in(scene, {"object": Pose.of((0.5, 0.0, 0.02))})["object"] == f"the {LIBRARY['mug-1'].words}"


def test_what_has_to_be_there_first_is_said_first() -> None:
    scene = table_with(Movable("a", block(0.05, RED)), Movable("b", cup(0.03, 0.07, BLUE)), Movable("c", block(0.05, BLUE)))
    poses = {n: Pose.of((0.4 + 0.1 * i, 0.0, 0.02)) for i, n in enumerate("abc")}
    said = instruction(scene, poses, frozenset({On("a", "c"), On("b", "a"), Released("a"), Open("b")}))
    assert said == "put the red block on the blue block, the blue cup on the red block and then open the blue cup"


@given(st.lists(st.tuples(st.floats(0.3, 0.7), st.floats(-0.3, 0.3)), min_size=2, max_size=8, unique=True))
def test_things_that_look_alike_are_told_apart(places: list[tuple[float, float]]) -> None:
    scene = table_with(*(Movable(f"thing{i}", block(0.05, RED)) for i in range(len(places))))
    poses = {f"thing{i}": Pose.of((x, y, 0.02)) for i, (x, y) in enumerate(places)}
    names = names_in(scene, poses)
    assert len(set(names.values())) == len(names)
    for one in poses:  # left is +y
        for other in poses:
            if "left" in names[one] and "right" in names[other] and len(places) == 2:
                assert poses[one].pos[1] > poses[other].pos[1]


def test_two_alike_are_left_and_right_or_near_and_far() -> None:
    scene = table_with(Movable("a", block(0.05, RED)), Movable("b", block(0.05, RED)))
    aside = names_in(scene, {"a": Pose.of((0.5, -0.1, 0.02)), "b": Pose.of((0.5, 0.1, 0.02))})
    behind = names_in(scene, {"a": Pose.of((0.6, 0.0, 0.02)), "b": Pose.of((0.4, 0.0, 0.02))})
    assert (aside["a"], aside["b"]) == ("the right red block", "the left red block")
    assert (behind["a"], behind["b"]) == ("the far red block", "the near red block")


def test_colours_are_those_of_the_hue_circle() -> None:
    """Against the names of pure hues, which anyone would give."""
    for degrees, name in ((0, "red"), (30, "orange"), (52, "yellow"), (130, "green"), (222, "blue")):
        rgb = colorsys.hls_to_rgb(degrees / 360, 0.5, 0.85)
        assert colour_name((*rgb, 1.0)) == name
    for level, name in ((0.02, "black"), (0.55, "grey"), (0.98, "white")):
        assert colour_name((level, level, level, 1.0)) == name
    for name, rgb in COLOURS.items():
        r, g, b = np.array(rgb) / 255
        assert colour_name((float(r), float(g), float(b), 1.0)) == name
