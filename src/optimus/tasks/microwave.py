"""Microwave: open it and put an object in. MicrowaveReceptacle: another size every time. MicrowaveAdapt: in half of the starts
something stands before the door."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

from optimus.objects.furniture import WALL, box_open_in_front, panel
from optimus.objects.shapes import Shape, block, cup, cylinder, slab
from optimus.predicates import On, Released
from optimus.robots import PANDA
from optimus.scene import Bar, Camera, Door, Fixture, Movable, Scene
from optimus.se3 import Pose
from optimus.task import Objects, Problem, Task, footprint, pick_one


@dataclass(frozen=True)
class Size:
    """Outer sizes of the microwave [m]."""

    height: float = 0.30
    width: float = 0.50
    depth: float = 0.20


HEIGHTS, WIDTHS, DEPTHS = (0.30, 0.40), (0.50, 0.60), (0.20, 0.30)
"""Of those in MicrowaveReceptacle [m]."""
FRONT, HINGE_Y = 0.70, 0.28
"""Where the door is, and its hinge [m]: the microwave reaches from there to the right."""
BOTTOM = 0.002
BAR_OFF, BAR_INSET, BAR_RADIUS = 0.045, 0.05, 0.009
"""The bar stands this far off the panel's middle, this far from its free edge [m]."""
BAR_HEIGHT, BAR_LENGTH = 0.15, 0.15
"""Of its middle above the microwave's foot [m]."""
PLATFORM, PLATFORM_AT = 0.25, (0.42, -0.44)
HEIGHT = 0.02

OBJECTS: dict[str, Shape] = {
    "block": block(0.045, (0.85, 0.13, 0.13, 1.0)),
    "cylinder": cylinder(0.024, 0.08, (0.16, 0.35, 0.80, 1.0)),
    "cup": cup(0.030, 0.075, (0.95, 0.65, 0.10, 1.0)),
}
OBSTACLE = block(0.05, (0.30, 0.65, 0.35, 1.0), mass=0.08)
ASIDE = (0.80, -0.48)
"""Where the obstacle stands when it is in nobody's way [m]: scenes then differ in where things are, not in how many there are."""
OBSTACLE_AREA = ((0.36, -0.12), (0.56, 0.12))
"""Corners of where the obstacle's middle may start: within the door's swing, clear of the shut door and of the bar [m]."""

TABLE = Fixture("table", slab(0.5, 0.62, 0.05, (0.78, 0.72, 0.64, 1.0)), (0.62, 0.0, -0.025))
STAND = Fixture(
    "platform", slab(PLATFORM / 2, PLATFORM / 2, HEIGHT, (0.35, 0.38, 0.42, 1.0)), (*PLATFORM_AT, HEIGHT / 2)
)
BODY, FACE = (0.82, 0.83, 0.85, 1.0), (0.20, 0.22, 0.26, 1.0)
CAMERAS = (
    Camera("leftshoulder", (-0.15, 0.60, 0.80), (0.58, -0.05, 0.08), 58.0),
    Camera("rightshoulder", (-0.10, -0.70, 0.80), (0.58, -0.05, 0.08), 58.0),
)


def microwave(size: Size) -> tuple[Fixture, Door]:
    """A box, and the door before it, hinged on its left edge as the arm sees it."""
    middle = (FRONT + WALL / 2 + size.depth / 2, HINGE_Y - size.width / 2, BOTTOM + size.height / 2)
    box = Fixture("microwave", box_open_in_front(size.depth, size.width, size.height, BODY), middle, door="door")
    at = (-BAR_OFF, -(size.width - BAR_INSET), BAR_HEIGHT - size.height / 2)
    door = Door(
        name="door",
        shape=panel(size.width - 0.002, size.height - 0.004, FACE, -1.0, at, BAR_LENGTH),
        hinge=(FRONT, HINGE_Y, BOTTOM + size.height / 2),
        bar=Bar(at, BAR_RADIUS, BAR_LENGTH),
        turns=-1.0,
    )
    return box, door


def scene_of(shape: Shape, size: Size, obstacle: bool) -> Scene:
    """A microwave of that size, a platform with an object beside it, and perhaps something before the door."""
    box, door = microwave(size)
    movables = (Movable("object", shape), *([Movable("obstacle", OBSTACLE)] if obstacle else []))
    return Scene(
        robot=PANDA,
        fixtures=(TABLE, STAND, box),
        movables=movables,
        cameras=CAMERAS,
        doors=(door,),
        low=(0.05, -0.70, 0.005),
        high=(0.95, 0.70, 0.80),
    )


def _on_platform(shape: Shape, rng: np.random.Generator) -> Pose:
    reach = max(0.0, PLATFORM / 2 - footprint(shape))
    x, y = rng.uniform(-reach, reach, 2) + PLATFORM_AT
    return Pose.of((x, y, HEIGHT + shape.half_extents[2]), (0.0, 0.0, rng.uniform(-np.pi, np.pi)))


def draw(sizes: bool, adapt: bool, objects: Objects, rng: np.random.Generator) -> Problem:
    variant = pick_one(objects, rng)
    size = Size()
    if sizes:
        size = Size(*(round(float(rng.uniform(*r)), 2) for r in (HEIGHTS, WIDTHS, DEPTHS)))
    blocked = adapt and bool(rng.uniform() < 0.5)
    poses = {"object": _on_platform(objects[variant], rng)}
    if adapt:
        x, y = rng.uniform(*OBSTACLE_AREA) if blocked else ASIDE
        poses["obstacle"] = Pose.of((x, y, OBSTACLE.half_extents[2]), (0.0, 0.0, rng.uniform(-np.pi, np.pi)))
    goal = frozenset({On("object", "microwave"), Released("object")})
    name = variant if not adapt else "door blocked" if blocked else "door free"
    drawn = f"{size.width:.2f} x {size.depth:.2f} x {size.height:.2f} m" if sizes else ""
    return Problem(scene_of(objects[variant], size, adapt), poses, goal, name, drawn)


EYE = (-0.75, -1.0, 0.65)
CLOSE_UP = (0.55, 0.0, 0.12)


def _task(name: str, summary: str, horizon: int, sizes: bool = False, adapt: bool = False) -> Task:
    drawn = partial(draw, sizes, adapt)
    return Task(name, summary, partial(drawn, OBJECTS), horizon, CLOSE_UP, EYE, drawn)


MICROWAVE = _task("microwave", "open the microwave and put an object in", 1000)
MICROWAVE_RECEPTACLE = _task("microwave-receptacle", "the same, with a microwave of another size every time", 1000, sizes=True)
MICROWAVE_ADAPT = _task("microwave-adapt", "the same; in half of the starts, something before the door", 1300, adapt=True)
