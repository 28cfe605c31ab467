"""Pick: take a movable off what it rests on, and lift it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import ClassVar

import numpy as np

from optimus.logic import Facts, Operator, ground
from optimus.motion.lines import distance
from optimus.motion.plan import Segment
from optimus.objects.shapes import SECTORS, STANDS, Shape, stands, unrolled
from optimus.predicates import Clear, HandEmpty, Holding, On, Released, kinds_of, pose_of, way_open
from optimus.scene import Scene
from optimus.se3 import Array, Pose, quat_from_rotvec, quat_mul
from optimus.skills.skill import Refinement, Way, Workspace, gripper_action
from optimus.state import Held, State

UPRIGHT = tuple(np.radians((0.0, -30.0, -45.0, -60.0, -75.0, -90.0)))
"""Turns of a grasp about the line on which the fingers close, the first choice first [rad]."""
LEANING = tuple(np.radians((45.0, -75.0, 60.0, 37.5, -60.0, 30.0, -45.0, 52.5, -37.5, -30.0, 75.0, 90.0, -90.0)))
"""The same where there is a roof: with the hand either way up."""

SIDEWAYS = (*UPRIGHT, *(-turn for turn in UPRIGHT if turn), np.pi)
"""Turns of the grasps of a thing that lies on its side, or stands on its head: they are meant for one that stands [rad]."""

TURNED = tuple(np.radians((-11.0, 11.0, -22.0, 22.0)))
"""Under a roof, where few ways in are left, a grasp that was tried is also taken turned by this about the line on which the fingers
close [rad]: the pads touch the same places."""
BETWEEN = np.radians(16.0)
"""A grasp that was tried counts as the nearest of these leans, if it is this near [rad]."""
MISS_RADIUS = 0.01
"""A grasp this near to one that came up empty is not tried again [m], turns as in `lines.distance`."""
OFF_CENTRE = 20.0
"""To take a thing a metre off its centre of mass is as bad as to turn by this [rad]."""


class Pick:
    """pick(thing, support)"""

    name: ClassVar[str] = "pick"

    def operators(self, scene: Scene, facts: Facts) -> Iterator[Operator]:
        kinds = kinds_of(scene)
        for thing, support in ground(kinds, ("movable", "support")):
            uncovered = {Clear(support)} if support in scene.movable_names else set()
            yield Operator(
                skill=self.name,
                args=(thing, support),
                needs=frozenset({HandEmpty(), Clear(thing), On(thing, support)}) | way_open(scene, support),
                adds=frozenset({Holding(thing), *uncovered}),
                deletes=frozenset({HandEmpty(), On(thing, support), Released(thing)}),
            )

    def grasps(self, workspace: Workspace, state: State, thing: str) -> Iterator[Pose]:
        """Tcp poses to take `thing` at, `base_from_tcp`: from above before leaning, those nearest to the hand's home orientation
        first. Where the thing stands or goes under a roof, leaning comes first."""
        at, shape, purpose = state.poses[thing], workspace.scene.shape_of(thing), workspace.purpose
        if shape.symmetric:
            # its turn about its axis cannot be seen, so no answer may depend on it
            at = Pose(at.pos, quat_mul(quat_from_rotvec((0.0, 0.0, -_yaw(at))), at.quat)) if stands(at) else unrolled(at)
        points = [at.pos] if purpose is None else [at.pos, pose_of(workspace.scene, state, purpose.support).pos]
        roofed = any(workspace.scene.is_roofed(p, 0.0) for p in points)
        leans = LEANING if roofed else UPRIGHT
        com = at.transform(shape.inertia.com) if shape.inertia is not None else at.pos
        for poses in _by_lean(shape, at, leans, roofed):
            for tilt in leans:
                yield from sorted(poses[tilt], key=lambda pose: (_effort(workspace, pose, tilt, com), round(pose.quat[0], 6)))

    def refine(
        self, workspace: Workspace, state: State, args: tuple[str, ...], rng: np.random.Generator
    ) -> Iterator[Refinement]:
        thing, purpose = args[0], workspace.purpose
        misfits: list[Pose] = []

        def goals() -> Iterator[Pose]:
            for goal in workspace.order(list(self.grasps(workspace, state, thing)), rng):
                if _has_missed(workspace, thing, state.poses[thing].inverse @ goal):
                    continue
                if not workspace.fits(state, goal):
                    misfits.append(goal)
                elif purpose is None or purpose.possible(_held(state, thing, goal)):
                    yield goal

        for way, reach in workspace.approaches("reach", state, goals(), False, rng):
            yield from self._lift(workspace, state, thing, way, reach, rng)
        if purpose is not None:  # whether it would have done to take the thing otherwise, is for the planner to know
            any(purpose.possible(_held(state, thing, goal)) for goal in misfits)

    def _lift(
        self, workspace: Workspace, state: State, thing: str, way: Way, reach: Segment, rng: np.random.Generator
    ) -> Iterator[Refinement]:
        """The rest after `reach`, if it can be done."""
        q, goal = reach.q[-1], reach.end
        taken = replace(_held(state, thing, goal), q=q)
        assert taken.held is not None
        if not workspace.fingers_move(taken, q):
            return
        for back in workspace.ways_back(taken, goal, way):
            lift = workspace.travel("lift", taken, back, True, rng)
            if lift is not None:
                after = replace(taken, q=lift.q[-1], tcp=back[-1]).moved(thing, back[-1] @ taken.held.tcp_from_object)
                yield (reach, gripper_action("close", q, goal, True), lift), after
                return


def _held(state: State, thing: str, tcp: Pose) -> State:
    """`state` with `thing` in the hand, where it stands."""
    return replace(state, tcp=tcp, held=Held(thing, tcp.inverse @ state.poses[thing]), opening=0.0)


def _has_missed(workspace: Workspace, thing: str, grasp: Pose) -> bool:
    """Whether a grasp is nearly one that has come up empty before."""
    return any(distance(grasp, other) < MISS_RADIUS for name, other in workspace.missed if name == thing)


def _by_lean(shape: Shape, at: Pose, leans: tuple[float, ...], roofed: bool) -> Iterator[dict[float, list[Pose]]]:
    """The grasps of a shape by how far they lean [rad]: those of a shape of primitives turned to each lean; those that were tried,
    and all of a thing that does not stand, under the lean that each is nearest to, if any is near, and after them, under a roof,
    their turns."""
    if not shape.verified and at.matrix[2, 2] > STANDS:
        yield {tilt: [at @ grasp.pose @ _turn(tilt) for grasp in shape.grasps] for tilt in leans}
        return
    tried = _verified(shape, at) if shape.verified else [at @ grasp.pose @ _turn(t) for t in SIDEWAYS for grasp in shape.grasps]
    for turns in ((0.0,), TURNED) if roofed else ((0.0,),):
        found: dict[float, list[Pose]] = {tilt: [] for tilt in leans}
        for pose in (pose @ _turn(turn) for turn in turns for pose in tried):
            tilt = _tilt(pose)
            nearest = min(leans, key=lambda lean: abs(lean - tilt))
            if abs(nearest - tilt) < BETWEEN:
                found[nearest].append(pose)
        yield found


def _turn(angle: float) -> Pose:
    """A turn about the line on which the fingers close [rad]."""
    return Pose.of(rotvec=(0.0, angle, 0.0))


def _verified(shape: Shape, at: Pose) -> list[Pose]:
    """The grasps of a shape as they were tried, with the hand either way up; of a body of revolution, from all around."""
    around = range(SECTORS) if shape.symmetric else range(1)
    turns = [at @ Pose.of(rotvec=(0.0, 0.0, 2 * np.pi * k / SECTORS)) for k in around]
    other_way_up = Pose.of(rotvec=(0.0, 0.0, np.pi))
    return [pose for turn in turns for g in shape.grasps for pose in (turn @ g.pose, turn @ g.pose @ other_way_up)]


def _tilt(pose: Pose) -> float:
    """How far a hand leans from pointing down [rad]; negative when its x axis, level in a grasp from above, points down."""
    matrix = pose.matrix
    return float(np.copysign(np.arccos(np.clip(-matrix[2, 2], -1.0, 1.0)), matrix[2, 0] or -1.0))


def _effort(workspace: Workspace, pose: Pose, tilt: float, com: Array) -> float:
    """What speaks against a grasp: to turn, and to hold a thing far from its centre of mass `com` `(3,)` [rad]."""
    return round(_turned(workspace, pose, tilt) + OFF_CENTRE * float(np.linalg.norm((pose.pos - com)[:2])), 6)


def _turned(workspace: Workspace, pose: Pose, tilt: float) -> float:
    """How far from the preferred yaw: home's for a hand that points down; leaning away from the arm's base otherwise [rad]."""
    if tilt == 0.0:
        return workspace.turn_from_home(pose)
    x, y = pose.matrix[:2, 2]
    return abs(float(np.arctan2(y, x)))


def _yaw(pose: Pose) -> float:
    """The angle of the pose's x axis about the vertical [rad]."""
    return float(np.arctan2(pose.matrix[1, 0], pose.matrix[0, 0]))
