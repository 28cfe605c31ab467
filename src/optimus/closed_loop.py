"""`ClosedLoop`: the expert as an agent that watches what becomes of its plan, and plans again from what it sees."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from optimus.data.episode import Observation
from optimus.env import ManipulationEnv
from optimus.expert import PlanFollower, TimeLaw
from optimus.motion.lines import distance
from optimus.motion.plan import Infeasible, Plan, Segment, Step
from optimus.planner import Budget, solve
from optimus.rollout import LAST_LOOK
from optimus.se3 import Pose, error_between
from optimus.skills import Workspace
from optimus.state import State

EMPTY = "empty hand"
MOVED = "something was moved"
ASTRAY = "led astray"
LOOK_AFTER = LAST_LOOK - 2
"""Steps after the plan's end in which what it let go may settle."""
STAYED = 0.015
"""What the plan supposes to stand still does so within this [m]."""
DOOR_STAYED = 0.15
"""... and doors within this [rad]."""
HOMEWARDS, HOMEWARDS_TURN = 0.02, 0.1
"""The way home a step [m], [rad]."""
AT_HOME = 0.05
"""[m], turns as in `lines.distance`"""
LOST = -0.3
"""What has fallen below this [m] comes to rest nowhere: nobody waits for it."""
RESTS = 0.05
"""Where a thing that was moved will stay is known below this speed [m/s]."""


@dataclass(frozen=True)
class Vigilance:
    """What the expert watches for while it follows a plan."""

    retries: int = 3
    """Times that an episode's plan is given up for another."""
    empty_for: int = 4
    """An empty hand is believed after this many steps: fingers may lose touch for one."""
    stuck_for: int = 40
    """Steps without progress along a path after which it is given up."""
    others: bool = False
    """Somebody else acts too: look whether things and doors still are where the plan supposes them; that a thing was lost is not
    the grasp's fault; and where there is no plan any more, go home, and end if there is none from there either: an answer by a
    plan that does not hold is none."""
    patience: int = 10
    """Steps on the way home until planning is tried again that failed ..."""
    vain: int = 6
    """... and how often before the episode ends; at home, twice."""
    effort: int = 40_000
    """Planning again is given up after this (`Workspace.effort`), or ..."""
    times: float = 3.0
    """... so many times what the first plan took, if that is more."""


ALONE = Vigilance()
SHARED = Vigilance(retries=30, empty_for=2, stuck_for=25, others=True, effort=20_000)


class ClosedLoop:
    """Follows a plan; plans again when its hand turns out to be empty, when it gets no further, when the plan is through and the
    goal is not reached, or (see `Vigilance`) when somebody else has changed what the plan is about. Looks at the simulated
    world's state, as only an expert may."""

    def __init__(
        self,
        env: ManipulationEnv,
        workspace: Workspace,
        plan: Plan,
        law: TimeLaw,
        rng: np.random.Generator,
        budget: Budget,
        vigilance: Vigilance = ALONE,
    ) -> None:
        self.retries: list[str] = []
        """Why it planned again, each time."""
        self.stale = 0
        """Steps that it went home because its plan did not hold any more and there was no other yet."""
        self.errors: list[float] = []
        """Distance of the tcp from the planned path at each step of motion [m]."""
        self.infeasible = ""
        """Why there was no plan when last there was none."""
        self._env, self._workspace, self._rng, self._law = env, workspace, rng, law
        self._budget, self._vigilance = budget, vigilance
        self._effort = max(vigilance.effort, vigilance.times * plan.stats["effort"])
        self._wait = self._vain = 0
        """Steps until planning is tried again, and how often it has failed on end with everything at rest."""
        self._falling = False
        """Whether something was in motion when it failed."""
        self._astray = False
        self._follow(plan)

    def _follow(self, plan: Plan) -> None:
        self._follower = PlanFollower(plan, self._law, self._env.control)
        self._follower.errors = self.errors
        self._empty = self._stuck = self._over = self._moved = 0
        """Steps for which the hand has been empty, the arm has got no further, the plan has been over, things were elsewhere."""
        self._mark: tuple[object, float] = (None, -1.0)
        """The segment, and how far along it [m], of the step before."""

    @property
    def plan(self) -> Plan:
        """What it follows now."""
        return self._follower.plan

    @property
    def doing(self) -> tuple[Step, Segment] | None:
        """The skill that it is at, and which of its motions; None when its plan is done."""
        segment, done = self._follower.segment, self._follower.steps_done
        return None if segment is None else (self.plan.steps[done], segment)

    def give_up(self) -> None:
        """The hand is where the plan is no answer, as only who led it there knows: plan again before the next one."""
        self._astray = True

    def slack(self, steady: float) -> float:
        """See `PlanFollower.slack`."""
        return self._follower.slack(steady)

    def act(self, observation: Observation) -> NDArray[np.float32] | None:
        """The action for this observation; None when there is nothing more to do."""
        if self._vain >= self._vigilance.vain:
            return None
        answer = self._follower.act(observation)
        trouble, astray = self._trouble(answer is None), self._astray
        self._astray = False
        if astray:
            self.retries += [ASTRAY] if self.retries[-1:] != [ASTRAY] else []
            return self._plan_again(observation, answer)
        if self._wait > 0:
            self._wait = self._wait - 1 if self._in_motion() or not self._falling else 0
            return self._homewards() if self._wait > 0 else self._plan_again(observation, answer)
        if not trouble:
            return answer
        if len(self.retries) >= self._vigilance.retries:
            return None if self._vigilance.others else answer
        self.retries.append(trouble)
        if trouble == EMPTY and not self._vigilance.others:
            self._workspace.missed += self._grasp()
        return self._plan_again(observation, answer)

    def _plan_again(self, observation: Observation, answer: NDArray[np.float32] | None) -> NDArray[np.float32] | None:
        plan = self._solve(self._env.state())
        if isinstance(plan, Infeasible):
            self.infeasible = str(plan)
            self._empty = self._stuck = self._moved = 0
            if not self._vigilance.others:
                return answer
            self._falling = self._in_motion()
            if not self._falling and self._wait == 0:  # who is led astray asks more often than it is worth trying
                home = distance(self._env.state().tcp, self._workspace.home) < AT_HOME
                self._vain += self._vigilance.vain // 2 if home else 1
            self._wait = self._vigilance.patience
            return self._homewards()
        self._vain = self._wait = 0
        self._follow(plan)
        return self._follower.act(observation)

    def _solve(self, now: State) -> Plan | Infeasible:
        # what a plan leads to is at rest and untouched: it would inherit from its start what is measured there
        state = replace(now, touched=frozenset(), speeds={})
        if state.held is None:
            state = replace(state, opening=self._workspace.open_width)  # by a plan's first motion, whatever they shut on
        plan = solve(self._workspace, state, self._env.problem.goal, self._rng, self._budget, self._effort)
        if isinstance(plan, Infeasible) and self._vigilance.others and state.held is not None:
            # somebody has taken it so that there is no going on, or where it still stands: let go, and take it as usual
            empty = replace(state, held=None, opening=self._workspace.open_width)
            plan = solve(self._workspace, empty, self._env.problem.goal, self._rng, self._budget, self._effort)
        return plan

    def _in_motion(self) -> bool:
        state = self._env.state()
        held = state.held.name if state.held else ""
        there = [name for name, pose in state.poses.items() if name != held and pose.pos[2] > LOST]
        return any(state.speeds.get(name, 0.0) > RESTS for name in there)

    def _homewards(self) -> NDArray[np.float32]:
        """Where there is no plan from here there may be one from home: slowly there, the hand open, until there is one. Things that
        still move have the time to come to rest."""
        self.stale += 1
        twist = error_between(self._workspace.home, self._env.state().tcp)
        twist[:3] *= min(1.0, HOMEWARDS / max(1e-9, float(np.linalg.norm(twist[:3]))))
        twist[3:] *= min(1.0, HOMEWARDS_TURN / max(1e-9, float(np.linalg.norm(twist[3:]))))
        arm = self._env.controller.action_for(twist, self._env.data)
        return np.append(arm, -1.0).clip(-1.0, 1.0).astype(np.float32)

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
        watch = self._vigilance
        if over:
            self._over += 1
            return "ended without success" if self._over == LOOK_AFTER else ""
        segment = self._follower.segment
        carrying = segment is not None and segment.shut and not segment.gripper_action and not segment.doors
        self._empty = self._empty + 1 if carrying and self._env.state().held is None else 0
        moved = (segment, round(self._follower.progress, 3))
        self._stuck = self._stuck + 1 if moved == self._mark else 0
        self._mark = moved
        if self._empty >= watch.empty_for:
            return EMPTY
        self._moved = self._moved + 1 if watch.others and self._elsewhere() else 0
        if self._moved >= watch.empty_for:
            return MOVED
        return "stuck" if self._stuck >= watch.stuck_for else ""

    def _elsewhere(self) -> bool:
        """Whether a thing or a door that the plan does not move at present is elsewhere than it supposes, and will stay there."""
        plan, done, segment = self._follower.plan, self._follower.steps_done, self._follower.segment
        if done >= len(plan.steps) or segment is None:
            return False
        step, before, state = plan.steps[done], plan.steps[done - 1].after if done else plan.start, self._env.state()
        busy = {before.held.name} if before.held else set[str]()
        if segment.shut or any(s.shut for s in step.segments[: step.segments.index(segment)]):
            busy.add(step.operator.args[0])
        swung = {door for s in step.segments for door in s.doors}
        if any(abs(angle - before.doors[d]) > DOOR_STAYED for d, angle in state.doors.items() if d not in swung):
            return True
        for name in state.poses.keys() - busy:
            taken = state.held is not None and state.held.name == name
            away = float(np.linalg.norm(state.poses[name].pos - before.poses[name].pos))
            if away > STAYED and (taken or state.speeds.get(name, 0.0) < RESTS):
                return True
        return False
