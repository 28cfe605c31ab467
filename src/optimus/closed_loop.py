"""`ClosedLoop`: the expert as an agent that watches what becomes of its plan, and plans again from what it sees."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from optimus.data.episode import Observation
from optimus.env import ManipulationEnv
from optimus.expert import PlanFollower, TimeLaw
from optimus.motion.plan import Infeasible, Plan
from optimus.planner import Budget, solve
from optimus.rollout import LAST_LOOK
from optimus.se3 import Pose
from optimus.skills import Workspace

MOST_RETRIES = 3
"""Times that an episode's plan is given up for another."""
RETRY_SECONDS = 3.0
"""Planning again is given up after this [s of CPU]."""
EMPTY = "empty hand"
EMPTY_FOR = 4
"""An empty hand is believed after this many steps: fingers may lose touch for one."""
STUCK_FOR = 40
"""Steps without progress along a path, or at its end, after which it is given up."""
LOOK_AFTER = LAST_LOOK - 2
"""Steps after the plan's end in which what it let go may settle."""


class ClosedLoop:
    """Follows a plan; plans again, at most `MOST_RETRIES` times, when its hand turns out to be empty, when it gets no further, or
    when the plan is through and the goal is not reached. Looks at the simulated world's state, as only an expert may."""

    def __init__(
        self, env: ManipulationEnv, workspace: Workspace, plan: Plan, law: TimeLaw, rng: np.random.Generator, budget: Budget
    ) -> None:
        self.retries: list[str] = []
        """Why it planned again, each time."""
        self.errors: list[float] = []
        """Distance of the tcp from the planned path at each step of motion [m]."""
        self._env, self._workspace, self._rng, self._law = env, workspace, rng, law
        self._budget = replace(budget, seconds=RETRY_SECONDS)
        self._follow(plan)

    def _follow(self, plan: Plan) -> None:
        self._follower = PlanFollower(plan, self._law, self._env.control)
        self._follower.errors = self.errors
        self._empty = self._stuck = self._over = 0
        """Steps for which the hand has been empty, the arm has got no further, the plan has been over."""
        self._mark: tuple[object, float] = (None, -1.0)
        """The segment, and how far along it [m], of the step before."""

    @property
    def slack(self) -> float:
        """See `PlanFollower.slack`."""
        return self._follower.slack

    def act(self, observation: Observation) -> NDArray[np.float32] | None:
        """The action for this observation; None when there is nothing more to do."""
        answer = self._follower.act(observation)
        trouble = self._trouble(answer is None)
        if not trouble or len(self.retries) >= MOST_RETRIES:
            return answer
        self.retries.append(trouble)
        if trouble == EMPTY:
            self._workspace.missed += self._grasp()
        plan = solve(self._workspace, self._env.state(), self._env.problem.goal, self._rng, self._budget)
        if isinstance(plan, Infeasible):
            self._empty = self._stuck = 0
            return answer
        self._follow(plan)
        return self._follower.act(observation)

    def _grasp(self) -> list[tuple[str, Pose]]:
        """The latest grasp of the plan so far: what it takes, and `object_from_tcp`."""
        plan, before = self._follower.plan, self._follower.plan.start
        latest: list[tuple[str, Pose]] = []
        for step in plan.steps:
            thing = step.operator.args[0]
            if thing in before.poses:
                shut = [s for s in step.segments if s.gripper_action and s.shut]
                latest = [(thing, before.poses[thing].inverse @ s.end) for s in shut] or latest
            if self._follower.segment in step.segments:
                return latest
            before = step.after
        return []

    def _trouble(self, over: bool) -> str:
        """What went wrong, in a few words; empty if nothing did."""
        if over:
            self._over += 1
            return "ended without success" if self._over == LOOK_AFTER else ""
        segment = self._follower.segment
        carrying = segment is not None and segment.shut and not segment.gripper_action and not segment.doors
        self._empty = self._empty + 1 if carrying and self._env.state().held is None else 0
        moved = (segment, round(self._follower.progress, 3))
        self._stuck = self._stuck + 1 if moved == self._mark else 0
        self._mark = moved
        if self._empty >= EMPTY_FOR:
            return EMPTY
        return "stuck" if self._stuck >= STUCK_FOR else ""
