"""StackAdapt: stack on the target platform only, where in half of the starts the base block stands already."""

import numpy as np

from optimus.objects.shapes import block, slab
from optimus.predicates import On, Released
from optimus.robots import PANDA
from optimus.scene import Camera, Fixture, Movable, Scene
from optimus.se3 import Pose
from optimus.task import Problem, Task, sample_apart
from optimus.tasks.stack import BASE_EDGE, EDGE, GREEN, RED

HALF = 0.125
"""Of a platform's edge [m]."""
HEIGHT = 0.02
CENTRE_X, ASIDE = 0.50, 0.18

TABLE = Fixture("table", slab(0.4, 0.45, 0.05, (0.78, 0.72, 0.64, 1.0)), (0.56, 0.0, -0.025))
OTHER = Fixture("other", slab(HALF, HALF, HEIGHT, (0.35, 0.38, 0.42, 1.0)), (CENTRE_X, ASIDE, HEIGHT / 2), words="platform")
TARGET = Fixture("target", slab(HALF, HALF, HEIGHT, (0.25, 0.55, 0.70, 1.0)), (CENTRE_X, -ASIDE, HEIGHT / 2), words="platform")
SCENE = Scene(
    robot=PANDA,
    fixtures=(TABLE, OTHER, TARGET),
    movables=(Movable("cubeA", block(EDGE, RED)), Movable("cubeB", block(BASE_EDGE, GREEN))),
    cameras=(Camera("agentview", (1.05, 0.0, 0.60), (0.48, 0.0, 0.05), 44.0),),
)


def draw(rng: np.random.Generator) -> Problem:
    on_target = bool(rng.uniform() < 0.5)
    reach = HALF - BASE_EDGE / np.sqrt(2)
    low, high = (-reach, -reach), (reach, reach)
    first, second = sample_apart(rng, [EDGE / np.sqrt(2), BASE_EDGE / np.sqrt(2)], low, high)
    yaws = rng.uniform(-np.pi, np.pi, 2)
    side = -ASIDE if on_target else ASIDE
    poses = {
        "cubeA": Pose.of((CENTRE_X + first[0], ASIDE + first[1], HEIGHT + EDGE / 2), (0.0, 0.0, yaws[0])),
        "cubeB": Pose.of((CENTRE_X + second[0], side + second[1], HEIGHT + BASE_EDGE / 2), (0.0, 0.0, yaws[1])),
    }
    goal = frozenset({On("cubeB", "target"), On("cubeA", "cubeB"), Released("cubeA"), Released("cubeB")})
    return Problem(SCENE, poses, goal, "base on target" if on_target else "base elsewhere")


STACK_ADAPT = Task("stack-adapt", "the red cube on the green one, both on the target platform", draw, horizon=600)
