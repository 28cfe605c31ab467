"""Stack: the red cube onto the green one (robosuite's two-block start: 16 x 16 cm, any yaw, no overlap)."""

import numpy as np

from optimus.objects.shapes import block, slab
from optimus.predicates import On, Released
from optimus.robots import PANDA
from optimus.scene import Camera, Fixture, Movable, Scene
from optimus.se3 import Pose
from optimus.task import Problem, Task, sample_apart

CENTRE = (0.50, 0.0)
RANGE = 0.08

TABLE = Fixture("table", slab(0.4, 0.4, 0.05, (0.78, 0.72, 0.64, 1.0)), (0.56, 0.0, -0.025))
SCENE = Scene(
    robot=PANDA,
    fixtures=(TABLE,),
    movables=(
        Movable("cubeA", block(0.04, (0.85, 0.13, 0.13, 1.0))),
        Movable("cubeB", block(0.05, (0.13, 0.62, 0.22, 1.0))),
    ),
    cameras=(Camera("agentview", (0.98, 0.0, 0.42), (0.49, 0.0, 0.06), 36.0),),
)


def draw(rng: np.random.Generator) -> Problem:
    low = (CENTRE[0] - RANGE, CENTRE[1] - RANGE)
    high = (CENTRE[0] + RANGE, CENTRE[1] + RANGE)
    halves = [m.shape.half_extents[2] for m in SCENE.movables]
    places = sample_apart(rng, [h * np.sqrt(2) for h in halves], low, high)
    poses = {
        movable.name: Pose.of((x, y, half), (0.0, 0.0, rng.uniform(-np.pi, np.pi)))
        for movable, half, (x, y) in zip(SCENE.movables, halves, places, strict=True)
    }
    return Problem(SCENE, poses, frozenset({On("cubeA", "cubeB"), Released("cubeA")}))


STACK = Task("stack", "put the red cube on the green one", draw, horizon=300)
