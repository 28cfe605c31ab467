"""Each predicate on states made by hand, where anyone can say what holds."""

from typing import Any

import numpy as np

from optimus.predicates import Clear, HandEmpty, Holding, On, Released, facts_of
from optimus.se3 import Pose
from optimus.state import Held, State
from optimus.tasks import task

SCENE = task("stack").problem(0).scene
FAR = Pose.of((0.5, 0.0, 0.4), (np.pi, 0.0, 0.0))


def state(a: tuple[float, float, float], turn: tuple[float, float, float] = (0, 0, 0), **rest: Any) -> State:
    poses = {"cubeA": Pose.of(a, turn), "cubeB": Pose.of((0.5, 0.0, 0.025))}
    return State(np.zeros(7), 0.08, poses, **{"tcp": FAR, **rest})


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
