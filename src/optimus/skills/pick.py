"""Pick: take a movable off what it rests on, and lift it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import ClassVar

import numpy as np

from optimus.logic import Facts, Operator, ground
from optimus.predicates import Clear, HandEmpty, Holding, On, Released, kinds_of
from optimus.scene import Scene
from optimus.se3 import Pose, quat_from_rotvec, quat_mul
from optimus.skills.skill import Refinement, Workspace, gripper_action
from optimus.state import Held, State


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
                needs=frozenset({HandEmpty(), Clear(thing), On(thing, support)}),
                adds=frozenset({Holding(thing), *uncovered}),
                deletes=frozenset({HandEmpty(), On(thing, support), Released(thing)}),
            )

    def grasps(self, workspace: Workspace, state: State, thing: str) -> list[Pose]:
        """Tcp poses to take `thing` at, `base_from_tcp`: those nearest to the hand's home orientation first."""
        at, shape = state.poses[thing], workspace.scene.shape_of(thing)
        if shape.symmetric:
            # its yaw cannot be seen, so no answer may depend on it
            at = Pose(at.pos, quat_mul(quat_from_rotvec((0.0, 0.0, -_yaw(at))), at.quat))
        poses = [at @ grasp.pose for grasp in shape.grasps]
        return sorted(poses, key=lambda pose: round(workspace.turn_from_home(pose), 6))

    def refine(
        self, workspace: Workspace, state: State, args: tuple[str, ...], rng: np.random.Generator
    ) -> Iterator[Refinement]:
        thing = args[0]
        height = workspace.transit_height(state)
        for goal in workspace.order(self.grasps(workspace, state, thing), rng):
            corners = workspace.over_and_down(state, goal, height)
            reach = workspace.travel("reach", state, corners, False, rng, via=True)
            if reach is None:
                continue
            q = reach.q[-1]
            held = Held(thing, goal.inverse @ state.poses[thing])
            taken = replace(state, q=q, tcp=goal, held=held, opening=0.0)
            up = goal.shifted((0.0, 0.0, max(workspace.transit_height(taken) - goal.pos[2], workspace.style.approach)))
            lift = workspace.travel("lift", taken, [up], True, rng)
            if lift is None:
                continue
            after = replace(taken, q=lift.q[-1], tcp=up).moved(thing, up @ held.tcp_from_object)
            yield (reach, gripper_action("close", q, goal, True), lift), after


def _yaw(pose: Pose) -> float:
    """The angle of the pose's x axis about the vertical [rad]."""
    return float(np.arctan2(pose.matrix[1, 0], pose.matrix[0, 0]))
