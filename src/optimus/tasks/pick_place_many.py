"""Multi-step PickPlace: two to four objects, each from its platform on the left to its bin on the right."""

from __future__ import annotations

from functools import partial

import numpy as np

from optimus.objects.furniture import bin_of
from optimus.objects.household import basket, magnet, vase
from optimus.objects.shapes import Shape, cup, slab
from optimus.predicates import On, Released
from optimus.robots import PANDA
from optimus.scene import Camera, Fixture, Movable, Scene
from optimus.se3 import Pose
from optimus.task import Objects, Problem, Task, footprint
from optimus.words import colour_name

PLATFORM, BIN = 0.15, 0.20
"""Edges [m]."""
HEIGHT = 0.02
BIN_HEIGHT = 0.05
OBJECTS: dict[str, Shape] = {
    "basket": basket(0.080, 0.050, 0.075, (0.72, 0.50, 0.26, 1.0)),
    "vase": vase(0.030, 0.017, 0.100, (0.20, 0.36, 0.75, 1.0)),
    "magnet": magnet(0.060, 0.055, 0.030, (0.82, 0.14, 0.14, 1.0)),
    "cup": cup(0.030, 0.075, (0.95, 0.65, 0.10, 1.0)),
}
SPOTS = ((0.40, 0.15), (0.60, 0.15), (0.40, 0.34), (0.60, 0.34))
"""Centres of the platforms; each bin stands opposite, its centre 3 cm further from the middle [m]."""

TABLE = Fixture("table", slab(0.4, 0.55, 0.05, (0.78, 0.72, 0.64, 1.0)), (0.56, 0.0, -0.025))
CAMERA = Camera("agentview", (1.10, 0.0, 0.85), (0.47, 0.0, 0.0), 50.0)


def _bin_centre(spot: tuple[float, float]) -> tuple[float, float]:
    x, y = spot
    return (0.39 if x < 0.5 else 0.61, -0.15 if y < 0.2 else -0.37)


def scene_of(shapes: dict[str, Shape]) -> Scene:
    """Things by name, each with its platform and its bin."""
    fixtures = [TABLE]
    for (name, shape), spot in zip(shapes.items(), SPOTS, strict=False):
        tint = shape.rgba
        platform = slab(PLATFORM / 2, PLATFORM / 2, HEIGHT, (0.35, 0.38, 0.42, 1.0))
        fixtures.append(Fixture(f"{name}_platform", platform, (*spot, HEIGHT / 2), words="platform"))
        pale = (0.5 + tint[0] / 2, 0.5 + tint[1] / 2, 0.5 + tint[2] / 2, 1.0)
        where, called = (*_bin_centre(spot), BIN_HEIGHT / 2), f"{colour_name(pale)} bin"
        fixtures.append(Fixture(f"{name}_bin", bin_of(BIN, BIN_HEIGHT, pale), where, words=called))
    movables = tuple(Movable(name, shape) for name, shape in shapes.items())
    return Scene(robot=PANDA, fixtures=tuple(fixtures), movables=movables, cameras=(CAMERA,))


def problem_of(shapes: dict[str, Shape], variant: str, rng: np.random.Generator) -> Problem:
    """Each thing somewhere on its platform, at any yaw; the goal: each in its bin."""
    poses = {}
    for (name, shape), spot in zip(shapes.items(), SPOTS, strict=False):
        reach = max(0.0, PLATFORM / 2 - footprint(shape))
        x, y = rng.uniform(-reach, reach, 2) + spot
        poses[name] = Pose.of((x, y, HEIGHT + shape.half_extents[2]), (0.0, 0.0, rng.uniform(-np.pi, np.pi)))
    goal = frozenset(On(n, f"{n}_bin") for n in shapes) | {Released(n) for n in shapes}
    return Problem(scene_of(shapes), poses, goal, variant)


def draw(count: int, rng: np.random.Generator) -> Problem:
    """The paper's own objects, the first `count` of them."""
    return problem_of({name: OBJECTS[name] for name in list(OBJECTS)[:count]}, "", rng)


def draw_with(count: int, objects: Objects, rng: np.random.Generator) -> Problem:
    """`count` of the objects, all different if there are as many."""
    names = list(objects)
    chosen = [names[i] for i in rng.choice(len(names), count, replace=len(names) < count)]
    shapes = {f"object{k + 1}": objects[name] for k, name in enumerate(chosen)}
    return problem_of(shapes, "+".join(chosen), rng)


def _task(name: str, summary: str, count: int) -> Task:
    return Task(name, summary, partial(draw, count), horizon=300 * count, draw_with=partial(draw_with, count))


ONE = _task("pick-place-one", "basket into its bin", 1)  # a study's (docs/results/first-policies.md), not one of the paper's
PICK_PLACE_TWO = _task("pick-place-two", "basket and vase, each into its bin", 2)
PICK_PLACE_THREE = _task("pick-place-three", "basket, vase and magnet, each into its bin", 3)
PICK_PLACE_FOUR = _task("pick-place-four", "basket, vase, magnet and cup, each into its bin", 4)
