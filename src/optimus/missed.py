"""A grasp that goes amiss: the hand is led beside the thing, and shuts there on nothing.

What a policy that errs at a grasp finds itself in, and what no other perturbation shows: things slip out of a hand in the air, and
are pushed while it is away.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from optimus.env import ManipulationEnv
from optimus.expert import STEERING
from optimus.motion.plan import Plan, Segment, Step
from optimus.se3 import Pose, error_between

ASIDE = (0.04, 0.065)
"""How far beside the place of the grasp, across the line along which the fingers shut [m]."""
ABOVE = 0.03
"""How far back along the way that the hand comes, at most [m]."""
NEAR = 0.1
"""It is led aside once it is this near to the grasp [m]."""
STEP, TURN = 0.03, 0.2
"""How far ahead of the hand it is drawn to, at most [m], [rad]."""
THERE = 0.008
"""[m]"""
PATIENCE = 20
"""Steps after which it goes on, wherever it has come to."""
SHUT_FOR = (2, 10)
"""[steps]"""


class Led(Protocol):
    """The expert, as far as it has to be known of."""

    @property
    def plan(self) -> Plan: ...
    @property
    def doing(self) -> tuple[Step, Segment] | None:
        """The skill that it is at, and which of its motions."""
        ...

    def give_up(self) -> None:
        """Plan again before the next answer."""
        ...


class MissedGrasp:
    """Leads the hand astray at one grasp of an episode, drawn by lot: sideways first, then down, where it shuts. From then on until
    it is let go the expert plans anew at every step, for the way straight back would lead through the thing."""

    def __init__(self, rng: np.random.Generator, env: ManipulationEnv, expert: Led) -> None:
        self.at: int | None = None
        """The step at which it was led aside; None as long as it has not been."""
        self._env, self._expert, self._step = env, expert, -1
        taken = [step.operator.args[0] for step in expert.plan.steps if _reach(step) is not None]
        self._of = taken[int(rng.integers(len(taken)))] if taken else ""
        """The thing or door that is missed."""
        self._aside, self._above = rng.uniform(*ASIDE) * rng.choice([-1.0, 1.0]), rng.uniform(0.0, ABOVE)
        self._way: list[Pose] = []
        """Where it has yet to be led."""
        self._patience, self._shut = PATIENCE, int(rng.integers(SHUT_FOR[0], SHUT_FOR[1] + 1))

    def next(self, label: NDArray[np.float32]) -> NDArray[np.float64] | None:
        """What to add to the expert's action `label` `(n,)`; None while nothing is amiss."""
        self._step += 1
        tcp = self._env.state().tcp
        if self.at is None and not self._begins(tcp):
            return None
        if self._way and (self._patience == 0 or float(np.linalg.norm(self._way[0].pos - tcp.pos)) < THERE):
            self._way.pop(0)
            self._patience = PATIENCE
        if not self._way and self._shut == 0:
            return None
        if len(self._way) < 2:
            self._expert.give_up()
        if self._way:
            self._patience -= 1
            return self._drawn(error_between(self._way[0], tcp), -1.0) - label
        self._shut -= 1
        return self._drawn(np.zeros(6), 1.0) - label

    def _begins(self, tcp: Pose) -> bool:
        """Whether it is at that grasp; from then on it is known where the hand will be led."""
        doing = self._expert.doing
        if doing is None or doing[1] is not _reach(doing[0]) or doing[0].operator.args[0] != self._of:
            return False
        end = doing[1].end
        if float(np.linalg.norm(end.pos - tcp.pos)) > NEAR:
            return False
        across, onwards = end.matrix[:, 0], end.matrix[:, 2]  # the fingers shut along the second axis
        if abs(across[2]) > 0.5:  # not into what the thing stands on
            across = across * np.sign(across[2] * self._aside)
        low = Pose(end.pos + self._aside * across - self._above * onwards, end.quat)
        self._way = [low.shifted(-max(0.0, float(onwards @ (low.pos - tcp.pos))) * onwards), low]
        self.at = self._step
        return True

    def _drawn(self, twist: NDArray[np.float64], gripper: float) -> NDArray[np.float64]:
        """The action that has the arm drawn to `twist` `(6,)` ahead of the hand [m, rad], wherever it was drawn to before."""
        controller, data = self._env.controller, self._env.data
        for part, most in ((slice(0, 3), STEP), (slice(3, 6), TURN)):
            twist[part] *= min(1.0, most / max(1e-9, float(np.linalg.norm(twist[part]))))
        arm = controller.action_for(twist, data) - controller.target_error(data) / STEERING[self._env.control].scale
        return np.append(arm, gripper)


def _reach(step: Step) -> Segment | None:
    """The motion of a skill that ends where the fingers are to shut, if it has one."""
    return next((motion for motion, after in pairwise(step.segments) if after.gripper_action and after.shut), None)
