"""Every fact that plans and goals are made of, each with its geometric test on a `State`."""

from __future__ import annotations

import numpy as np

from optimus.logic import Atom, Facts, Predicate, evaluate
from optimus.scene import Scene
from optimus.se3 import Pose
from optimus.state import State

REST_GAP = 0.006
"""A thing rests on a surface when its underside is within this of it [m]."""
REST_SPEED = 0.01
"""... and it is settled below this speed [m/s]."""
UPRIGHT = 0.97
"""The cosine of the largest tilt at which a thing still counts as standing (14 degrees)."""
OPEN_FROM = 1.3
"""A door counts as open from this angle on [rad], 74 degrees."""
SHUT_TO = 0.05
"""... and as shut up to this one [rad]."""
HAND_CLEAR = 0.05
"""The hand is clear of a thing when the tcp is this far above or beside it [m]."""


def pose_of(scene: Scene, state: State, name: str) -> Pose:
    """`base_from_thing` of a movable or a fixture."""
    return state.poses[name] if name in state.poses else scene.fixture_poses[name]


def _on(scene: Scene, state: State, thing: str, support: str) -> bool:
    return not _holding(scene, state, thing) and _stands_on(scene, state, thing, support)


def _stands_on(scene: Scene, state: State, thing: str, support: str) -> bool:
    """Whether it does, held or not."""
    surface = scene.shape_of(support).surface
    if surface is None:
        return False
    pose, under = state.poses[thing], pose_of(scene, state, support)
    shape = scene.shape_of(thing)
    if shape.level(pose.matrix) < UPRIGHT or under.matrix[2, 2] < UPRIGHT:
        return False
    height = shape.half_extents[2] if abs(pose.matrix[2, 2]) >= UPRIGHT else shape.above(pose.matrix)
    local = under.inverse.transform(pose.pos)
    inside = abs(local[0]) <= surface.half_x and abs(local[1]) <= surface.half_y
    return bool(inside and abs(local[2] - height - surface.z) < REST_GAP)


def _holding(scene: Scene, state: State, thing: str) -> bool:
    return state.held is not None and state.held.name == thing


def _hand_empty(scene: Scene, state: State) -> bool:
    return state.held is None


def _clear(scene: Scene, state: State, thing: str) -> bool:
    return not any(_on(scene, state, other, thing) for other in state.poses if other != thing)


def _released(scene: Scene, state: State, thing: str) -> bool:
    if _holding(scene, state, thing) or thing in state.touched:
        return False
    if state.speeds.get(thing, 0.0) > REST_SPEED:
        return False
    shape, at = scene.shape_of(thing), state.poses[thing].inverse.transform(state.tcp.pos)
    if shape.symmetric:  # however it is turned about its axis
        at = np.array([np.hypot(at[0], at[1]), 0.0, at[2]])
    local = np.abs(at) - np.array(shape.half_extents)
    return bool(np.linalg.norm(np.maximum(local, 0.0)) >= HAND_CLEAR)


def _open(scene: Scene, state: State, door: str) -> bool:
    return state.doors[door] >= OPEN_FROM


def _shut(scene: Scene, state: State, door: str) -> bool:
    return state.doors[door] <= SHUT_TO


On = Predicate("On", ("movable", "support"), _on)
Holding = Predicate("Holding", ("movable",), _holding)
HandEmpty = Predicate("HandEmpty", (), _hand_empty)
Clear = Predicate("Clear", ("movable",), _clear)
Released = Predicate("Released", ("movable",), _released)
Open = Predicate("Open", ("door",), _open)
Shut = Predicate("Shut", ("door",), _shut)

PREDICATES: dict[str, Predicate] = {p.name: p for p in (On, Holding, HandEmpty, Clear, Released, Open, Shut)}


def kinds_of(scene: Scene) -> dict[str, tuple[str, ...]]:
    """The names in a scene, by kind: movables, fixtures, all that can carry something, doors."""
    fixtures = tuple(f.name for f in scene.fixtures if f.shape.surface is not None)
    carriers = tuple(m.name for m in scene.movables if m.shape.surface is not None)
    return {
        "movable": scene.movable_names,
        "fixture": fixtures,
        "carrier": carriers,
        "support": (*carriers, *fixtures),
        "door": tuple(d.name for d in scene.doors),
    }


def way_open(scene: Scene, support: str) -> Facts:
    """What has to hold before a hand can get at what stands on `support`: that the door before it, if any, is open."""
    door = scene.door_before(support)
    return frozenset() if door is None else frozenset({Open(door)})


def achieved(scene: Scene, state: State, atom: Atom) -> bool:
    """Whether one atom of a goal is met. In the moment in which the fingers shut, a thing is held and nothing is on what it stands
    on, as far as plans go; a goal asks that it be lifted."""
    if not holds(scene, state, atom):
        return False
    if atom.predicate == Holding.name:
        return not any(_stands_on(scene, state, atom.args[0], s) for s in kinds_of(scene)["support"] if s != atom.args[0])
    if atom.predicate == Clear.name:
        return not any(_stands_on(scene, state, other, atom.args[0]) for other in state.poses if other != atom.args[0])
    return True


def holds(scene: Scene, state: State, atom: Atom) -> bool:
    """Whether one atom holds in `state`."""
    return PREDICATES[atom.predicate].holds(scene, state, *atom.args)


def facts_of(scene: Scene, state: State) -> Facts:
    """All that holds in `state`."""
    return evaluate(PREDICATES.values(), kinds_of(scene), scene, state)
