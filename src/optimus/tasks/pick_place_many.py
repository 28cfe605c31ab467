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
from optimus.task import Problem, Task, footprint

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
SPOTS = {"basket": (0.40, 0.15), "vase": (0.60, 0.15), "magnet": (0.40, 0.34), "cup": (0.60, 0.34)}
"""Centres of the platforms; each bin stands opposite, its centre 3 cm further from the middle [m]."""

TABLE = Fixture("table", slab(0.4, 0.55, 0.05, (0.78, 0.72, 0.64, 1.0)), (0.56, 0.0, -0.025))
CAMERA = Camera("agentview", (1.10, 0.0, 0.85), (0.47, 0.0, 0.0), 50.0)


def _bin_centre(name: str) -> tuple[float, float]:
    x, y = SPOTS[name]
    return (0.39 if x < 0.5 else 0.61, -0.15 if y < 0.2 else -0.37)


def scene_of(count: int) -> Scene:
    """The first `count` objects, each with its platform and its bin."""
    fixtures = [TABLE]
    for name in list(OBJECTS)[:count]:
        tint = OBJECTS[name].rgba
        platform = slab(PLATFORM / 2, PLATFORM / 2, HEIGHT, (0.35, 0.38, 0.42, 1.0))
        fixtures.append(Fixture(f"{name}_platform", platform, (*SPOTS[name], HEIGHT / 2)))
        pale = (0.5 + tint[0] / 2, 0.5 + tint[1] / 2, 0.5 + tint[2] / 2, 1.0)
        fixtures.append(Fixture(f"{name}_bin", bin_of(BIN, BIN_HEIGHT, pale), (*_bin_centre(name), BIN_HEIGHT / 2)))
    movables = tuple(Movable(name, OBJECTS[name]) for name in list(OBJECTS)[:count])
    return Scene(robot=PANDA, fixtures=tuple(fixtures), movables=movables, cameras=(CAMERA,))


SCENES = {count: scene_of(count) for count in (2, 3, 4)}


def draw(count: int, rng: np.random.Generator) -> Problem:
    scene = SCENES[count]
    poses = {}
    for movable in scene.movables:
        reach = PLATFORM / 2 - footprint(movable.shape)
        x, y = rng.uniform(-reach, reach, 2) + SPOTS[movable.name]
        poses[movable.name] = Pose.of((x, y, HEIGHT + movable.shape.half_extents[2]), (0.0, 0.0, rng.uniform(-np.pi, np.pi)))
    names = scene.movable_names
    goal = frozenset(On(n, f"{n}_bin") for n in names) | {Released(n) for n in names}
    return Problem(scene, poses, goal)


PICK_PLACE_TWO = Task("pick-place-two", "basket and vase, each into its bin", partial(draw, 2), horizon=600)
PICK_PLACE_THREE = Task("pick-place-three", "basket, vase and magnet, each into its bin", partial(draw, 3), horizon=900)
PICK_PLACE_FOUR = Task("pick-place-four", "basket, vase, magnet and cup, each into its bin", partial(draw, 4), horizon=1200)
