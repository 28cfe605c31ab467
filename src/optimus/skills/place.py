"""Place: put what is held down on a fixture. Stack: put it down on another movable. They differ in where, not in how."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import chain, islice
from typing import ClassVar

import numpy as np

from optimus.collision import Blocked
from optimus.logic import Facts, Operator, ground
from optimus.motion.plan import Segment
from optimus.objects.shapes import Shape
from optimus.predicates import Clear, HandEmpty, Holding, On, Released, kinds_of, pose_of, way_open
from optimus.scene import Scene
from optimus.se3 import Array, Pose, error_between, quat_from_rotvec, quat_mul, rotvec_from_quat, turn_towards
from optimus.skills import room
from optimus.skills.room import MARGIN
from optimus.skills.skill import Refinement, Way, Workspace, gripper_action
from optimus.state import State

RELEASE_GAP = 0.001
"""Things are let go this far above their support [m]."""
SAME_SPOT = 0.005
"""[m]"""
QUICK_TARGETS = 10
"""Poses tried before a thing is believed not to go to a place."""


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
        for x, y in room.grid(shape.surface, (radius + MARGIN, radius + MARGIN), home):
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
        done: Sequence[Pose] = (),
        crowded: bool = False,
    ) -> Iterator[Pose]:
        """Tcp poses to let go at: spot by spot, the hand's home orientation first, then turned about the vertical. None that is
        left at a spot where it has been let go at one of those `done`. `crowded`: those near the edges first."""
        hand = _stood_up(state, thing)
        upright = _levelled(hand, workspace.home)
        turns = [0.0, np.pi / 2, -np.pi / 2, np.pi / 4, -np.pi / 4]
        if _heading(hand) is not None:  # leaning into something: never from behind
            turns = [0.0, 0.4, -0.4, 0.8, -0.8]
        shape = workspace.scene.shape_of(thing)
        tried = ((point, turns) for point in workspace.order(list(self.spots(workspace, state, thing, support)), rng))
        if not room.is_large(workspace.scene, support):
            tight = self._tight(workspace, state, thing, support, upright, max(turns) if _heading(hand) is not None else np.pi)
            tried = chain(tight, reversed(list(tried))) if crowded else chain(tried, tight)
        point = None
        for point, yaws in tried:
            for yaw in workspace.order(yaws, rng):
                if any(np.hypot(*(point - (pose @ _in_hand(state)).pos)[:2]) < SAME_SPOT for pose in done):
                    break
                yield _over(point, yaw, upright, state, shape)
        if point is None:  # what stands there takes up all the room
            others = (name for name in room.standing_on(workspace.scene, state, support) if name != thing)
            workspace.failures.extend(("room", Blocked(name, thing)) for name in others)

    def _tight(
        self, workspace: Workspace, state: State, thing: str, support: str, upright: Array, largest: float
    ) -> Iterator[tuple[Array, list[float]]]:
        """The nooks in which the fingers have room to open, each with the one turn."""
        shape = workspace.scene.shape_of(thing)
        for point, yaw in self.nooks(workspace, state, thing, support, upright, largest):
            goal = _over(point, yaw, upright, state, shape)
            if workspace.hand_is_free(_let_go(workspace, state, thing, goal), goal):
                yield point, [yaw]

    def nooks(
        self, workspace: Workspace, state: State, thing: str, support: str, upright: Array, largest: float
    ) -> Iterator[tuple[Array, float]]:
        """Points `(3,)` [m] of the support's surface where there is room for the thing if the hand `upright` is turned by that much
        [rad] and the thing lies along the surface's sides: those nearest to its edges first, for what comes after."""
        scene = workspace.scene
        shape, surface = scene.shape_of(thing), scene.shape_of(support).surface
        assert surface is not None
        put, frame = Pose(np.zeros(3), upright) @ _in_hand(state), pose_of(scene, state, support)
        home = frame.inverse.transform(workspace.home.pos)
        height = float(frame.transform((0.0, 0.0, surface.z))[2])
        others = room.obstacles(scene, state, thing, support, height)
        along = np.arctan2(frame.matrix[1, 0], frame.matrix[0, 0]) - _heading_of_sides(put)
        for yaw in sorted((float(np.remainder(along + k * np.pi / 2 + np.pi, 2 * np.pi) - np.pi) for k in range(4)), key=abs):
            turned = Pose(np.zeros(3), quat_mul(quat_from_rotvec((0.0, 0.0, yaw)), put.quat))
            covered = room.outline(shape, turned)
            half = np.abs(covered @ frame.matrix[:2, :2]).max(0)
            if abs(yaw) > largest + 1e-6 or half[0] > surface.half_x or half[1] > surface.half_y:
                continue
            for x, y in reversed(room.grid(surface, half + MARGIN, home, room.FINE)):
                point = frame.transform((x, y, surface.z))
                if room.is_free(scene, support, covered + point[:2], height, others):
                    yield point, yaw

    def possible(self, workspace: Workspace, state: State, args: tuple[str, ...], rng: np.random.Generator) -> bool:
        """Whether what is held in `state` could be put down: a quick test of the last poses alone, not of the whole ways there."""
        thing, support = args
        targets = islice(self.targets(workspace, state, thing, support, rng), QUICK_TARGETS)
        return any(workspace.fits(state, goal) and next(workspace.ways(state, goal), None) is not None for goal in targets)

    def refine(
        self, workspace: Workspace, state: State, args: tuple[str, ...], rng: np.random.Generator
    ) -> Iterator[Refinement]:
        (thing, support), crowded = args, workspace.crowded
        done: list[Pose] = []
        """Where it could be let go, and what had to be done then could not: to turn it there is tried last."""
        for seen in (done, ()):
            if seen is not done and not done:
                return  # nothing was left out
            targets = self.targets(workspace, state, thing, support, rng, seen, crowded)
            fresh = (pose for pose in targets if not any(_same(pose, other) for other in done))
            for way, carry in workspace.approaches("carry", state, fresh, True, rng):
                for refinement in self._release(workspace, state, thing, way, carry, rng):
                    yield refinement
                    done.append(carry.end)

    def _release(
        self, workspace: Workspace, state: State, thing: str, way: Way, carry: Segment, rng: np.random.Generator
    ) -> Iterator[Refinement]:
        """The rest after `carry`, if it can be done."""
        q, goal = carry.q[-1], carry.end
        if not workspace.fingers_move(state, q):
            return
        left = replace(_let_go(workspace, state, thing, goal), q=q)
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

    def nooks(
        self, workspace: Workspace, state: State, thing: str, support: str, upright: Array, largest: float
    ) -> Iterator[tuple[Array, float]]:
        """None: there is one spot on top of a thing."""
        return iter(())


def _over(point: Array, yaw: float, upright: Array, state: State, shape: Shape) -> Pose:
    """The tcp's pose at which the thing, not the tcp, is over the point, the hand turned by `yaw` [rad]."""
    quat = quat_mul(quat_from_rotvec((0.0, 0.0, yaw)), upright)
    put = Pose(np.zeros(3), quat) @ _in_hand(state)
    return Pose(point - put.pos + (0.0, 0.0, shape.above(put.matrix) + RELEASE_GAP), quat)


def _let_go(workspace: Workspace, state: State, thing: str, goal: Pose) -> State:
    """The state once the thing is let go with the tcp at `goal`, but for the arm's configuration."""
    return replace(state, tcp=goal, held=None, opening=workspace.open_width).moved(thing, goal @ _in_hand(state))


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


def _heading_of_sides(put: Pose) -> float:
    """Where a level side of a thing points to, about the vertical [rad]."""
    x, y = put.matrix[:2, int(np.abs(put.matrix[2]).argmin())]
    return float(np.arctan2(y, x))


def _levelled(tcp: Pose, home: Pose) -> Array:
    """The orientation `(4,) wxyz` nearest to home's yaw that keeps the hand's tilt, so that what is held stays upright.
    A hand that leans is turned to lean away from the arm's base."""
    heading, inverse = _heading(tcp), tcp.quat * np.array([1.0, -1.0, -1.0, -1.0])
    turn = rotvec_from_quat(quat_mul(home.quat, inverse))[2] if heading is None else -heading
    return quat_mul(quat_from_rotvec((0.0, 0.0, turn)), tcp.quat)
