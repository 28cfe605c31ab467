"""Place: put what is held down on a fixture. Stack: put it down on another movable. They differ in where, not in how."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import islice
from typing import ClassVar

import numpy as np

from optimus.logic import Facts, Operator, ground
from optimus.motion.plan import Segment
from optimus.objects.shapes import Surface
from optimus.predicates import Clear, HandEmpty, Holding, On, Released, kinds_of, pose_of, way_open
from optimus.scene import Scene
from optimus.se3 import Array, Pose, error_between, quat_from_rotvec, quat_mul, rotvec_from_quat, turn_towards
from optimus.skills.skill import Refinement, Way, Workspace, gripper_action
from optimus.state import State

RELEASE_GAP = 0.001
"""Things are let go this far above their support [m]."""
SPACING = 0.05
"""Between the candidate spots of a surface [m]; the outermost ones are besides."""
SAME_SPOT = 0.005
"""[m]"""
AMPLE = 0.25
"""A surface with more than this to every side [m] is large."""
QUICK_TARGETS = 10
"""Poses tried before a thing is believed not to go to a place."""
MARGIN = 0.015
"""Kept from a surface's edge, and between things [m]."""


class Place:
    """place(thing, fixture)"""

    name: ClassVar[str] = "place"
    kinds: ClassVar[tuple[str, str]] = ("movable", "fixture")

    def operators(self, scene: Scene, facts: Facts) -> Iterator[Operator]:
        for thing, support in ground(kinds_of(scene), self.kinds):
            covered = {Clear(support)} if support in scene.movable_names else set()
            yield Operator(
                skill=self.name,
                args=(thing, support),
                needs=frozenset({Holding(thing), *covered}) | way_open(scene, support),
                adds=frozenset({On(thing, support), HandEmpty(), Released(thing)}),
                deletes=frozenset({Holding(thing), *covered}),
            )

    def spots(self, workspace: Workspace, state: State, thing: str, support: str) -> Iterator[Array]:
        """Free points `(3,)` [m] of the support's surface, the nearest to its middle first; of a large one, the nearest to where
        the arm is at home."""
        scene = workspace.scene
        shape = scene.shape_of(support)
        assert shape.surface is not None
        frame = pose_of(scene, state, support)
        radius = scene.shape_of(thing).reach(_stood_up(state, thing).matrix @ _in_hand(state).matrix)
        home = frame.inverse.transform(workspace.home.pos)
        for x, y in _grid(shape.surface, radius + MARGIN, home):
            point = frame.transform((x, y, shape.surface.z))
            apart = all(self._apart(workspace, state, point, radius, other) for other in state.poses if other != thing)
            if apart and not scene.is_covered(point, radius + MARGIN, support) and not scene.in_swing(point, radius, support):
                yield point

    def _apart(self, workspace: Workspace, state: State, point: Array, radius: float, other: str) -> bool:
        reach = radius + workspace.scene.shape_of(other).reach(state.poses[other].matrix) + MARGIN
        return bool(np.linalg.norm(state.poses[other].pos[:2] - point[:2]) > reach)

    def targets(
        self,
        workspace: Workspace,
        state: State,
        thing: str,
        support: str,
        rng: np.random.Generator,
        done: Sequence[Array] = (),
    ) -> Iterator[Pose]:
        """Tcp poses to let go at: spot by spot, the hand's home orientation first, then turned about the vertical. None that is
        left at a spot that has come to be one of those `done`, `(3,)` [m]."""
        hand = _stood_up(state, thing)
        upright = _levelled(hand, workspace.home)
        turns = [0.0, np.pi / 2, -np.pi / 2, np.pi / 4, -np.pi / 4]
        if _heading(hand) is not None:  # leaning into something: never from behind
            turns = [0.0, 0.4, -0.4, 0.8, -0.8]
        shape = workspace.scene.shape_of(thing)
        for point in workspace.order(list(self.spots(workspace, state, thing, support)), rng):
            for yaw in workspace.order(turns, rng):
                if any(np.hypot(*(point - other)[:2]) < SAME_SPOT for other in done):
                    break
                quat = quat_mul(quat_from_rotvec((0.0, 0.0, yaw)), upright)
                # the thing, not the tcp, goes over the spot
                put = Pose(np.zeros(3), quat) @ _in_hand(state)
                yield Pose(point - put.pos + (0.0, 0.0, shape.above(put.matrix) + RELEASE_GAP), quat)

    def possible(self, workspace: Workspace, state: State, args: tuple[str, ...], rng: np.random.Generator) -> bool:
        """Whether what is held in `state` could be put down: a quick test of the last poses alone, not of the whole ways there."""
        thing, support = args
        targets = islice(self.targets(workspace, state, thing, support, rng), QUICK_TARGETS)
        return any(workspace.fits(state, goal) and next(workspace.ways(state, goal), None) is not None for goal in targets)

    def refine(
        self, workspace: Workspace, state: State, args: tuple[str, ...], rng: np.random.Generator
    ) -> Iterator[Refinement]:
        thing, support = args
        done: list[Array] = []
        """Where it could be put, and what had to be done then could not: to turn it there is tried last."""
        given: list[Pose] = []
        for seen in (done, ()):
            if seen is not done and not done:
                return  # nothing was left out
            targets = self.targets(workspace, state, thing, support, rng, seen)
            fresh = (pose for pose in targets if not any(_same(pose, other) for other in given))
            for way, carry in workspace.approaches("carry", state, fresh, True, rng):
                for refinement in self._release(workspace, state, thing, way, carry, rng):
                    yield refinement
                    done.append((carry.end @ _in_hand(state)).pos)
                    given.append(carry.end)

    def _release(
        self, workspace: Workspace, state: State, thing: str, way: Way, carry: Segment, rng: np.random.Generator
    ) -> Iterator[Refinement]:
        """The rest after `carry`, if it can be done."""
        assert state.held is not None
        q, goal = carry.q[-1], carry.end
        put = goal @ state.held.tcp_from_object
        left = replace(state, q=q, tcp=goal, held=None, opening=workspace.open_width).moved(thing, put)
        back = next(workspace.ways_back(left, goal, way))
        retreat = workspace.travel("retreat", left, back, False, rng)
        if retreat is not None:
            after = replace(left, q=retreat.q[-1], tcp=back[-1])
            yield (carry, gripper_action("open", q, goal, False), retreat), after


class Stack(Place):
    """stack(thing, other movable)"""

    name: ClassVar[str] = "stack"
    kinds: ClassVar[tuple[str, str]] = ("movable", "carrier")

    def spots(self, workspace: Workspace, state: State, thing: str, support: str) -> Iterator[Array]:
        """The middle of the other thing's top, and nothing else."""
        shape = workspace.scene.shape_of(support)
        assert shape.surface is not None
        yield pose_of(workspace.scene, state, support).transform((0.0, 0.0, shape.surface.z))


def _grid(surface: Surface, inset: float, home: Array) -> list[tuple[float, float]]:
    """Points of a surface `inset` away from its edges: first the one nearest to `home` `(3,)` that has `AMPLE` about it, or the
    middle of a smaller surface, then outwards. All in the surface's frame [m]."""
    spans, centre = [], []
    for half, at in ((surface.half_x, home[0]), (surface.half_y, home[1])):
        n, outermost = max(0, int((half - inset) / SPACING)), max(0.0, half - inset)
        spans.append(sorted({k * SPACING for k in range(-n, n + 1)} | {-outermost, outermost}))
        ample = max(0.0, half - AMPLE)
        centre.append(min(max(float(at), -ample), ample))
    points = [(x, y) for x in spans[0] for y in spans[1]]
    return sorted(points, key=lambda p: (round(float(np.hypot(p[0] - centre[0], p[1] - centre[1])), 6), p))


def _same(a: Pose, b: Pose) -> bool:
    return bool(np.allclose(error_between(a, b), 0.0, atol=1e-6))


def _in_hand(state: State) -> Pose:
    """`tcp_from_object` of what is held."""
    assert state.held is not None
    return state.held.tcp_from_object


def _heading(tcp: Pose) -> float | None:
    """Where a hand that leans points to, about the vertical [rad]; None for one that points down."""
    x, y = tcp.matrix[:2, 2]
    return float(np.arctan2(y, x)) if np.hypot(x, y) > 0.2 else None


def _stood_up(state: State, thing: str) -> Pose:
    """The tcp's pose, turned so that what is held stands upright on the side that is nearly down."""
    axes = state.poses[thing].matrix
    up = axes[:, int(np.abs(axes[2]).argmax())]
    return Pose(state.tcp.pos, quat_mul(turn_towards(up, np.array([0.0, 0.0, np.sign(up[2])])), state.tcp.quat))


def _levelled(tcp: Pose, home: Pose) -> Array:
    """The orientation `(4,) wxyz` nearest to home's yaw that keeps the hand's tilt, so that what is held stays upright.
    A hand that leans is turned to lean away from the arm's base."""
    heading, inverse = _heading(tcp), tcp.quat * np.array([1.0, -1.0, -1.0, -1.0])
    turn = rotvec_from_quat(quat_mul(home.quat, inverse))[2] if heading is None else -heading
    return quat_mul(quat_from_rotvec((0.0, 0.0, turn)), tcp.quat)
