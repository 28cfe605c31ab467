"""`Task`: a family of problems, each drawn from one seed."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, partial

import numpy as np

from optimus.data.episode import TASKS_OWN
from optimus.errors import ModelError, require_at_least
from optimus.fingerprint import fingerprint
from optimus.goals import require_consistent
from optimus.logic import Atom, Facts
from optimus.objects.shapes import Shape
from optimus.predicates import PREDICATES, On, Released, achieved, kinds_of
from optimus.robots import Robot
from optimus.scene import Camera, Scene
from optimus.se3 import Pose
from optimus.state import State
from optimus.words import instruction, names_in

ROOM_TO_SPARE = 0.007
"""Between the open fingers, beyond the thing between them [m]: with 4 mm they get stuck on a cup, with 8 mm they do not."""


@dataclass(frozen=True, eq=False)
class Problem:
    """One instance: the scene, where its movables start, and the goal. `variant` names what else was drawn (an object, say)."""

    scene: Scene
    poses: dict[str, Pose]
    goal: Facts
    variant: str = ""
    receptacle: str = ""
    """Sizes of the furniture, where they are drawn; a size is held out for validation as a whole (`optimus.data.curate`)."""

    def __post_init__(self) -> None:
        movable = set(self.scene.movable_names)
        if set(self.poses) != movable:
            raise ModelError(f"a problem's poses are those of its movables: {sorted(movable)}, not {sorted(self.poses)}")
        for what, values, kind in (("poses", self.poses.values(), Pose), ("goal", self.goal, Atom)):
            for wrong in (v for v in values if not isinstance(v, kind)):
                raise ModelError(f"a problem's {what} hold {wrong!r}, a {type(wrong).__name__}, where {kind.__name__} is wanted")
        known = {*movable, *self.scene.fixture_poses, *(d.name for d in self.scene.doors)}
        unknown = sorted({name for atom in self.goal for name in atom.args} - known)
        if unknown:
            raise ModelError(f"the goal names {', '.join(unknown)}; the scene has {', '.join(sorted(known))}")
        kinds = kinds_of(self.scene)
        for atom in sorted(self.goal):
            if atom.predicate not in PREDICATES:
                raise ModelError(f"{atom} is asked for; what can be is {', '.join(sorted(PREDICATES))}")
            for name, kind in zip(atom.args, PREDICATES[atom.predicate].kinds, strict=True):
                if name not in kinds[kind]:
                    raise ModelError(f"{atom} is asked for, but {name} is no {kind}; those are {', '.join(kinds[kind]) or 'none'}")
        for name in sorted({atom.args[0] for atom in self.goal if atom.predicate == On.name}):
            _require_spanned(self.scene, name)
        require_consistent(self.goal, movable)

    @cached_property
    def instruction(self) -> str:
        """What is wanted, in plain English: "put the red block on the green block"."""
        return instruction(self.scene, self.poses, self.goal)

    @cached_property
    def words(self) -> dict[str, str]:
        """What each movable thing is called in plain English: "the red block"."""
        names = names_in(self.scene, self.poses)
        return {name: names[name] for name in self.scene.movable_names}

    def success(self, state: State) -> bool:
        """The strict rule: every atom of the goal holds, released, settled and the hand clear among them."""
        return all(achieved(self.scene, state, atom) for atom in self.goal)

    def paper_success(self, state: State) -> bool:
        """The paper's rule, which never asks for release."""
        return all(achieved(self.scene, state, atom) for atom in self.goal if atom.predicate != Released.name)


def _require_spanned(scene: Scene, name: str) -> None:
    """`ModelError` if the hand cannot open round a thing to be moved. Verified grasps were tried in physics, others hold across."""
    shape, opens = scene.shape_of(name), 2 * scene.robot.finger_travel
    if shape.verified:
        return
    if not shape.grasps:
        raise ModelError(f"{name} has no grasps: only what `Shape.grasps` says how to take can be moved")
    across = min(2 * np.abs(grasp.pose.matrix[:, 1]) @ np.array(shape.half_extents) for grasp in shape.grasps)
    if across > opens - ROOM_TO_SPARE:
        hand = f"the hand of {scene.robot.name} opens {1000 * opens:.0f} mm and needs {1000 * ROOM_TO_SPARE:.0f} mm to spare"
        raise ModelError(
            f"{name} is {1000 * across:.0f} mm across where it is to be taken; {hand}: make it smaller, or import it as an object "
            "(docs/add_an_object.md)"
        )


Objects = Mapping[str, Shape]
"""What a task may be done with: shapes by name."""


@dataclass(frozen=True)
class Task:
    """A task: its name, how a problem is drawn, and how many 20 Hz steps an agent has."""

    name: str
    summary: str
    draw: Callable[[np.random.Generator], Problem]
    horizon: int
    close_up: tuple[float, float, float] = field(default=(0.55, 0.0, 0.05))
    """What pictures for people are centred on [m]."""
    eye: tuple[float, float, float] = field(default=(0.66, -0.44, 0.46))
    """From where they are taken, against that centre [m]."""
    draw_with: Callable[[Objects, np.random.Generator], Problem] | None = None
    """Draws the problem with other objects; None where there are none to choose."""
    fingerprinted: int = 12
    """Problems that tell an edited task from what it was."""

    def __post_init__(self) -> None:
        if not isinstance(self.horizon, int):
            raise ModelError(f"{self.name}: the horizon is a number of steps, not {self.horizon!r}")
        require_at_least(1, horizon=self.horizon)

    @property
    def people_camera(self) -> Camera:
        """The camera of pictures for people."""
        x, y, z = (c + e for c, e in zip(self.close_up, self.eye, strict=True))
        return Camera("people", (x, y, z), self.close_up)

    def robot_record(self, robot: Robot | None) -> str:
        """What records say of the robot that takes the place of the task's own (None: nothing does): `TASKS_OWN`, or its name."""
        return TASKS_OWN if robot is None or robot == self.problem(0).scene.robot else robot.name

    def robot_text(self, record: str) -> str:
        """The same for people: the name in any case."""
        return f"{self.problem(0).scene.robot.name} ({TASKS_OWN})" if record == TASKS_OWN else record

    def over(self, name: str, objects: Objects) -> Task:
        """The same task, under another name, with those objects. `ModelError` if it has none to choose."""
        if self.draw_with is None:
            raise ModelError(f"{self.name} has objects of its own: others are chosen by `draw_with`, which it lacks")
        return replace(self, name=name, draw=partial(self.draw_with, objects), fingerprinted=1)  # each object may have to be made

    def problem(self, seed: int, robot: Robot | None = None) -> Problem:
        """The problem of that seed: the same one every time, on every machine. `robot` takes the place of the task's own."""
        problem = self.draw(np.random.default_rng([seed, 0x0971]))
        if not isinstance(problem, Problem):
            raise ModelError(f"{self.name}: `draw` gives a {type(problem).__name__}, where a Problem is wanted")
        return problem if robot is None else replace(problem, scene=replace(problem.scene, robot=robot))

    def fingerprint(self, seed: int, robot: Robot | None = None) -> str:
        """Sixteen hexadecimal digits that are others once what is drawn for the first few seeds from `seed` on has been edited: the
        task, the robot's file or an object."""
        problems = [self.problem(seed + i, robot) for i in range(self.fingerprinted)]
        if fingerprint(problems[0]) != fingerprint(self.problem(seed, robot)):
            raise ModelError(f"{self.name}: `draw` gives another problem each time for one seed; draw with its rng alone")
        return fingerprint(problems)


def pick_one(objects: Objects, rng: np.random.Generator) -> str:
    """The name of one of the objects, each as likely as the others."""
    names = list(objects)
    return names[int(rng.integers(len(names)))]


def footprint(shape: Shape) -> float:
    """The radius [m] of the disc that a standing thing covers, whatever its yaw."""
    return shape.reach(np.eye(3))


def sample_apart(
    rng: np.random.Generator, radii: list[float], low: tuple[float, float], high: tuple[float, float], gap: float = 0.01
) -> Iterator[tuple[float, float]]:
    """Positions [m], uniform in the box, of discs that do not overlap; `ModelError` if they do not fit."""
    for _ in range(1000):
        points = [rng.uniform(low, high) for _ in radii]
        pairs = [(i, j) for i in range(len(radii)) for j in range(i)]
        if all(np.linalg.norm(points[i] - points[j]) >= radii[i] + radii[j] + gap for i, j in pairs):
            return iter([(float(p[0]), float(p[1])) for p in points])
    raise ModelError(f"{len(radii)} things of radii {radii} m do not fit between {low} and {high}")
