"""PickPlace: an object from the left platform to the right one (0.25 x 0.25 m each, centres 0.5 m apart)."""

from functools import partial

import numpy as np

from optimus.objects.shapes import Shape, block, cup, cylinder, slab
from optimus.predicates import On, Released
from optimus.robots import PANDA
from optimus.scene import Camera, Fixture, Movable, Scene
from optimus.se3 import Pose
from optimus.task import Objects, Problem, Task, footprint, pick_one

CENTRE_X = 0.50
APART = 0.50
HALF = 0.125
HEIGHT = 0.02

OBJECTS: dict[str, Shape] = {
    "block": block(0.045, (0.85, 0.13, 0.13, 1.0)),
    "cylinder": cylinder(0.024, 0.08, (0.16, 0.35, 0.80, 1.0)),
    "cup": cup(0.030, 0.075, (0.95, 0.65, 0.10, 1.0)),
}

TABLE = Fixture("table", slab(0.4, 0.5, 0.05, (0.78, 0.72, 0.64, 1.0)), (0.56, 0.0, -0.025))
LEFT = Fixture("left", slab(HALF, HALF, HEIGHT, (0.35, 0.38, 0.42, 1.0)), (CENTRE_X, APART / 2, HEIGHT / 2), words="platform")
RIGHT = Fixture("right", slab(HALF, HALF, HEIGHT, (0.25, 0.55, 0.45, 1.0)), (CENTRE_X, -APART / 2, HEIGHT / 2), words="platform")

CAMERA = Camera("agentview", (1.02, 0.0, 0.80), (0.50, 0.0, 0.04), 48.0)


def scene_of(shape: Shape) -> Scene:
    """Two platforms and the object."""
    return Scene(robot=PANDA, fixtures=(TABLE, LEFT, RIGHT), movables=(Movable("object", shape),), cameras=(CAMERA,))


def draw(objects: Objects, rng: np.random.Generator) -> Problem:
    variant = pick_one(objects, rng)
    shape = objects[variant]
    reach = HALF - footprint(shape)
    x, y = rng.uniform(-reach, reach, 2)
    pos = (CENTRE_X + x, APART / 2 + y, HEIGHT + shape.half_extents[2])
    pose = Pose.of(pos, (0.0, 0.0, rng.uniform(-np.pi, np.pi)))
    goal = frozenset({On("object", "right"), Released("object")})
    return Problem(scene_of(shape), {"object": pose}, goal, variant)


PICK_PLACE = Task(
    "pick-place", "carry an object from the left platform to the right one", partial(draw, OBJECTS), horizon=300, draw_with=draw
)
