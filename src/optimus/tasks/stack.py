"""Stack, two to five blocks: one on the other, in a fixed order (robosuite's sizes and starts: any yaw, no overlap)."""

from __future__ import annotations

from functools import partial

import numpy as np

from optimus.logic import Facts
from optimus.objects.shapes import Rgba, block, slab
from optimus.predicates import On, Released
from optimus.robots import PANDA
from optimus.scene import Camera, Fixture, Movable, Scene
from optimus.se3 import Pose
from optimus.task import Problem, Task, sample_apart

CENTRE = (0.50, 0.0)
BASE_EDGE, EDGE = 0.05, 0.04
RED, GREEN = (0.85, 0.13, 0.13, 1.0), (0.13, 0.62, 0.22, 1.0)
BLUE, YELLOW, PURPLE = (0.15, 0.33, 0.80, 1.0), (0.93, 0.72, 0.10, 1.0), (0.55, 0.22, 0.62, 1.0)
BLOCKS: tuple[tuple[str, float, Rgba], ...] = (
    ("cubeA", EDGE, RED),
    ("cubeB", BASE_EDGE, GREEN),
    ("cubeC", EDGE, BLUE),
    ("cubeD", EDGE, YELLOW),
    ("cubeE", EDGE, PURPLE),
)
TOWER = ("cubeB", "cubeA", "cubeC", "cubeD", "cubeE")
"""From the base upwards."""
RANGE = {2: 0.08, 3: 0.10, 4: 0.12, 5: 0.14}
"""Blocks start within this of the middle, either way [m]."""

TABLE = Fixture("table", slab(0.4, 0.4, 0.05, (0.78, 0.72, 0.64, 1.0)), (0.56, 0.0, -0.025))
NEAR = Camera("agentview", (0.98, 0.0, 0.42), (0.49, 0.0, 0.06), 36.0)
FAR = Camera("agentview", (1.05, 0.0, 0.50), (0.48, 0.0, 0.08), 42.0)


def scene_of(count: int) -> Scene:
    """A table with `count` blocks."""
    movables = tuple(Movable(name, block(edge, rgba)) for name, edge, rgba in BLOCKS[:count])
    return Scene(robot=PANDA, fixtures=(TABLE,), movables=movables, cameras=(NEAR if count == 2 else FAR,))


SCENES = {count: scene_of(count) for count in RANGE}


def tower(count: int) -> Facts:
    """The goal: each block on the one before it, and let go of."""
    names = TOWER[:count]
    pairs = list(zip(names[1:], names[:-1], strict=True))
    return frozenset(On(upper, lower) for upper, lower in pairs) | {Released(upper) for upper, _ in pairs}


def draw(count: int, rng: np.random.Generator) -> Problem:
    scene, reach = SCENES[count], RANGE[count]
    low, high = (CENTRE[0] - reach, CENTRE[1] - reach), (CENTRE[0] + reach, CENTRE[1] + reach)
    halves = [m.shape.half_extents[2] for m in scene.movables]
    places = sample_apart(rng, [h * np.sqrt(2) for h in halves], low, high)
    poses = {
        movable.name: Pose.of((x, y, half), (0.0, 0.0, rng.uniform(-np.pi, np.pi)))
        for movable, half, (x, y) in zip(scene.movables, halves, places, strict=True)
    }
    return Problem(scene, poses, tower(count))


STACK = Task("stack", "put the red cube on the green one", partial(draw, 2), horizon=300)
STACK_THREE = Task("stack-three", "a tower of three: green, red, blue", partial(draw, 3), horizon=900)
STACK_FOUR = Task("stack-four", "a tower of four: green, red, blue, yellow", partial(draw, 4), horizon=1350)
STACK_FIVE = Task("stack-five", "a tower of five: green, red, blue, yellow, purple", partial(draw, 5), horizon=1800)
