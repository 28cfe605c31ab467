"""`Thing`: an object that was prepared for handling, and how it is made from a mesh."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import trimesh

from optimus.assets.antipodal import Candidate, candidates, diverse, lean_of
from optimus.assets.convex import convex_pieces
from optimus.assets.trial import REST_LEAN, REST_SPEED, GraspTrial, Outcome, dropped
from optimus.errors import AssetError
from optimus.objects.shapes import Grasp, Inertia, Mesh, Part, Rgba, Shape, Vec3
from optimus.robots import PANDA, Robot
from optimus.se3 import quat_from_matrix

POINTS, PAIRS = 4000, 600
"""Of the surface, from which grasps are sampled, and of opposite faces among them."""
TRIED = 150
"""Candidates that are tried in physics at most, of each share."""
LEANS = (np.radians(20.0), np.radians(65.0))
"""Grasps from above lean less than the first, grasps from the side more than the second [rad]."""
WANTED, LEAST = 48, 20
"""Grasps that are kept, and without which a thing is refused."""
LARGEST, SMALLEST, TALLEST = 0.16, 0.015, 0.20
"""Across (of the circle about it), along its longest side, and in height [m]: what fits the tasks and the hand."""
HEAVIEST = 0.5
"""[kg]; the gripper's own mass in the other hand of the scales."""


@dataclass(frozen=True)
class Facts:
    """What is known of an object besides its geometry."""

    name: str
    category: str
    words: str
    """An English noun phrase without an article."""
    mass: float
    """[kg]"""
    friction: float
    rgba: Rgba
    symmetric: bool = False
    source: str = "library"


@dataclass(frozen=True, eq=False)
class Thing:
    """An object ready for tasks: its shape, whose grasps were all tried, and what came of each trial."""

    facts: Facts
    shape: Shape
    outcomes: tuple[Outcome, ...]
    watertight: bool
    com: Vec3
    volume: float
    """[m^3]"""
    rest: tuple[float, float]
    """How fast it still moves [m/s] and how far it leans [rad], 2 s after it was let fall from 5 cm."""

    @property
    def from_above(self) -> int:
        """How many grasps come from above."""
        return sum(bool(lean_of(g) < LEANS[0]) for g in self.shape.grasps)

    @property
    def from_the_side(self) -> int:
        """How many come from the side."""
        return sum(bool(lean_of(g) >= LEANS[1]) for g in self.shape.grasps)


def shape_of(mesh: trimesh.Trimesh, facts: Facts) -> Shape:
    """The shape of `mesh` (watertight [m], z up as it stands), without grasps; its frame is that of its bounding box's middle."""
    mesh = mesh.copy()
    mesh.apply_translation(-mesh.bounds.mean(axis=0))
    half = tuple(float(v) for v in mesh.extents / 2)
    half = (half[0], half[1], half[2])
    _require_size(half)
    pieces = [Part("mesh", mesh=_mesh(piece)) for piece in convex_pieces(mesh, facts.symmetric)]
    return Shape(
        kind=facts.name,
        parts=tuple(pieces),
        half_extents=half,
        mass=facts.mass,
        rgba=facts.rgba,
        symmetric=facts.symmetric,
        friction=facts.friction,
        look=_mesh(mesh),
        inertia=_inertia(mesh, facts.mass),
        verified=True,
    )


def prepare(
    mesh: trimesh.Trimesh, facts: Facts, given: Sequence[Candidate] | None = None, robot: Robot = PANDA, seed: int = 0
) -> Thing:
    """A thing from its mesh, with verified grasps, sampled here or from among those `given` (in the frame of the bounding box's
    middle). `AssetError` says why it cannot be used."""
    shape = shape_of(mesh, facts)
    speed, lean = rest = dropped(shape)
    if speed > REST_SPEED or lean > REST_LEAN:
        state = f"{1000 * speed:.0f} mm/s and {np.degrees(lean):.0f} degrees from upright"
        raise AssetError(f"does not stand still when it is let fall from 5 cm: {state} after 2 s")
    assert shape.look is not None and shape.inertia is not None
    com = shape.inertia.com
    centred = trimesh.Trimesh(shape.look.vertices, shape.look.faces, process=False)
    if given is None:
        rng = np.random.default_rng(seed)
        given = candidates(centred, np.array(com), 2 * robot.finger_travel, (POINTS, PAIRS), rng)
    found = verified(shape, given, robot)
    if len(found) < LEAST:
        raise AssetError(f"has {len(found)} grasps that hold, of {len(given)} that geometry allows; {LEAST} are wanted")
    grasps, outcomes = zip(*found, strict=True)
    shape = replace(shape, grasps=grasps)
    return Thing(facts, shape, outcomes, bool(mesh.is_watertight), com, float(centred.volume), rest)


def verified(shape: Shape, given: Sequence[Candidate], robot: Robot) -> list[tuple[Grasp, Outcome]]:
    """Those of the candidates that hold in physics, up to `WANTED`, with what came of them: from above, leaning and from the
    side in equal shares as far as there are such, far apart, the best first."""
    trial = GraspTrial(shape, robot)
    clear = [c for c in given if trial.is_clear(c.grasp)]
    shares = [[c for c in clear if low <= c.lean < high] for low, high in pairwise((0.0, *LEANS, np.inf))]
    queues = [deque(diverse(share, TRIED)) for share in shares]
    found: list[tuple[Grasp, Outcome]] = []
    for _ in range(TRIED):
        for queue in queues:
            if queue and len(found) < WANTED:
                candidate = queue.popleft()
                outcome = trial.run(candidate.grasp)
                if outcome.held:
                    found.append((candidate.grasp, outcome))
    return found


def _require_size(half: Sequence[float]) -> None:
    across, height, longest = 2 * float(np.hypot(half[0], half[1])), 2 * half[2], 2 * max(half)
    if across > LARGEST or height > TALLEST:
        size = f"{100 * across:.1f} cm across and {100 * height:.1f} cm high"
        raise AssetError(f"is {size}; up to {100 * LARGEST:.0f} and {100 * TALLEST:.0f} cm fit (--scale makes it smaller)")
    if longest < SMALLEST:
        raise AssetError(f"is {1000 * longest:.1f} mm long; from {1000 * SMALLEST:.0f} mm on it can be handled (--scale)")


def _mesh(mesh: trimesh.Trimesh) -> Mesh:
    return Mesh(np.asarray(mesh.vertices, float), np.asarray(mesh.faces, np.int32))


def _inertia(mesh: trimesh.Trimesh, mass: float) -> Inertia:
    """As of a body of even density."""
    solid = mesh.copy()
    solid.density = mass / float(mesh.volume)
    moments, axes = np.linalg.eigh(solid.moment_inertia)
    if np.linalg.det(axes) < 0:
        axes[:, 2] *= -1
    com, quat = mesh.center_mass.tolist(), quat_from_matrix(axes).tolist()
    principal = (float(moments[0]), float(moments[1]), float(moments[2]))
    return Inertia((com[0], com[1], com[2]), principal, (quat[0], quat[1], quat[2], quat[3]))
