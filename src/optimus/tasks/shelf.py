"""Shelf: from the lowest rung to the middle one. ShelfReceptacle: the same, with another shelf every time."""

from __future__ import annotations

from functools import partial

import numpy as np

from optimus.objects.furniture import BOARD, board, uprights
from optimus.objects.shapes import Shape, block, cup, cylinder
from optimus.predicates import On, Released
from optimus.robots import PANDA
from optimus.scene import Camera, Fixture, Movable, Scene
from optimus.se3 import Pose
from optimus.task import Objects, Problem, Task, footprint, pick_one

WIDTH, DEPTH, HEIGHT = 0.50, 0.25, 1.00
"""Of the shelf in every Shelf problem [m]."""
WIDTHS, DEPTHS, HEIGHTS = (0.50, 0.75), (0.25, 0.40), (0.80, 1.00)
"""Of those in ShelfReceptacle [m]: the paper's intervals, the wider side across the arm's view, where it can be reached."""
FOOT = -0.10
"""The arm stands this much above the shelf's foot [m]."""
FRONT = 0.60
"""The shelf's front edge [m]."""
RUNGS = {"lower": 0.02, "middle": 0.35, "upper": 0.68}
"""Heights of the rungs' upper faces above the foot, as shares of the shelf's height."""
EDGE = 0.015
"""Things start this far inside a rung's edge [m]."""
REACH = 0.85
"""... and no further than this from the arm's axis [m]: beyond, no hand can be at the lowest rung, whatever way it is turned."""

WOOD, FRAME = (0.72, 0.60, 0.45, 1.0), (0.45, 0.38, 0.30, 1.0)
OBJECTS: dict[str, Shape] = {
    "block": block(0.045, (0.85, 0.13, 0.13, 1.0)),
    "cylinder": cylinder(0.024, 0.08, (0.16, 0.35, 0.80, 1.0)),
    "cup": cup(0.030, 0.075, (0.95, 0.65, 0.10, 1.0)),
}
CAMERAS = (
    Camera("leftshoulder", (-0.05, 0.62, 0.85), (0.60, 0.0, 0.10), 55.0),
    Camera("rightshoulder", (-0.05, -0.62, 0.85), (0.60, 0.0, 0.10), 55.0),
)
GROUND = Fixture("ground", board(1.6, 1.6, (0.80, 0.80, 0.78, 1.0)), (0.4, 0.0, FOOT - BOARD / 2 - 0.001))


def scene_of(shape: Shape, width: float, depth: float, height: float) -> Scene:
    """A shelf of that size [m] before the arm, and one object."""
    x = FRONT + depth / 2
    rungs = [
        Fixture(name, board(depth, width, WOOD), (x, 0.0, FOOT + share * height - BOARD / 2), words=f"{name} rung")
        for name, share in RUNGS.items()
    ]
    sides = Fixture("sides", uprights(depth, width, height, FRAME), (x, 0.0, FOOT + height / 2))
    return Scene(
        robot=PANDA,
        fixtures=(GROUND, *rungs, sides),
        movables=(Movable("object", shape),),
        cameras=CAMERAS,
        low=(0.15, -0.60, FOOT + 0.005),
        high=(1.00, 0.60, 0.85),
    )


def draw(sizes: bool, objects: Objects, rng: np.random.Generator) -> Problem:
    variant = pick_one(objects, rng)
    width, depth, height = (rng.uniform(*r) for r in (WIDTHS, DEPTHS, HEIGHTS)) if sizes else (WIDTH, DEPTH, HEIGHT)
    # whole centimetres: as many shelves as that still are, not one compiled model for every problem there is
    width, depth, height = (round(v, 2) for v in (width, depth, height))
    size = f"{width:.2f} x {depth:.2f} x {height:.2f} m" if sizes else ""
    shape = objects[variant]
    scene = scene_of(shape, width, depth, height)
    inset = footprint(shape) + EDGE
    x = y = REACH
    while np.hypot(x, y) > REACH:
        x = rng.uniform(-1, 1) * (depth / 2 - inset) + FRONT + depth / 2
        y = rng.uniform(-1, 1) * (width / 2 - inset)
    z = scene.fixture_poses["lower"].pos[2] + BOARD / 2 + shape.half_extents[2]
    pose = Pose.of((x, y, z), (0.0, 0.0, rng.uniform(-np.pi, np.pi)))
    return Problem(scene, {"object": pose}, frozenset({On("object", "middle"), Released("object")}), variant, size)


EYE = (-0.75, -1.0, 0.55)
CLOSE_UP = (0.55, 0.0, 0.2)


def _task(name: str, summary: str, sizes: bool) -> Task:
    drawn = partial(draw, sizes)
    return Task(name, summary, partial(drawn, OBJECTS), 400, CLOSE_UP, EYE, drawn)


SHELF = _task("shelf", "an object from the lowest rung of a shelf to the middle one", sizes=False)
SHELF_RECEPTACLE = _task("shelf-receptacle", "the same, each time on another shelf", sizes=True)
