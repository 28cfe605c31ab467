"""The planner: search a skeleton, bind it lazily with backtracking, learn from geometric failure, try the next."""

from __future__ import annotations

import math
import time
from collections import Counter
from collections.abc import Hashable, Iterator
from dataclasses import dataclass, field, replace

import numpy as np

from optimus.errors import require_at_least
from optimus.logic import Atom, Facts, Operator, Skeleton, obstructs, skeletons
from optimus.motion.lines import UNREACHABLE
from optimus.motion.plan import Infeasible, Plan, Step
from optimus.objects.shapes import stands, unrolled
from optimus.predicates import Holding, On, Released, facts_of, holds
from optimus.scene import Scene
from optimus.se3 import Pose
from optimus.skills import SKILLS, Workspace
from optimus.skills.pick import Pick
from optimus.skills.place import Place
from optimus.skills.skill import OutOfTime, Purpose
from optimus.state import State

REACH = {UNREACHABLE.b, "the workspace's edge"}
"""What limits the arm where nothing is in its way."""
WITHIN = 0.05
"""A hand takes a thing no further from its surface than this [m]."""
OUT_OF_TIME = "planning time spent"


@dataclass(frozen=True)
class Budget:
    """When to give up."""

    seconds: float | None = None
    """CPU time, if that is to count: what a seed gives then depends on the machine."""
    effort: int | None = 150_000
    """Poses and collisions asked for (`Workspace.effort`): some 10 s of CPU."""
    skeletons: int = 50
    refinements: int = 8
    """Ways of one skill tried before the planner backtracks to the one before it."""

    def __post_init__(self) -> None:
        require_at_least(0, planning_seconds=self.seconds, planning_effort=self.effort)


@dataclass(eq=False)
class _Binding:
    """One attempt to refine a skeleton, and the deepest point at which it failed."""

    workspace: Workspace
    rng: np.random.Generator
    budget: Budget
    deepest: int = -1
    blame: Counter[str] = field(default_factory=Counter)
    culprit: Operator | None = None
    aim: Operator | None = None
    """What the culprit was to pick its thing up for, if no way to hold it would have done for that."""
    put_down: Operator | None = None
    """What the culprit takes its thing for, or the culprit itself if it puts one down."""
    involved: set[str] = field(default_factory=set)
    """What had to do with the latest failure."""
    trying: Operator | None = None
    """What it was at when it ran out of time."""
    vain: dict[Hashable, Counter[str]] = field(default_factory=dict)
    """Pick-ups known to be for nothing, and what was in the way of what they were for."""
    beyond_help: str | None = None
    """What the latest failure was about, if it would fail as well from wherever else this stood."""

    def bind(self, skeleton: Skeleton, state: State, depth: int = 0) -> tuple[Step, ...] | None:
        """The steps that carry `skeleton` out from `state`, or None."""
        if not skeleton:
            return ()
        operator = skeleton[0]
        aim = _put_down(skeleton) if operator.skill == Pick.name else None
        self.trying = aim or operator
        case = (operator, aim, _surroundings(self.workspace, state, operator.args[0]))
        if case in self.vain:
            self._remember(skeleton, depth, self.vain[case], aim)
            self.beyond_help = operator.args[0]
            return None
        self.workspace.failures.clear()
        answers: list[bool] = []
        self.workspace.purpose = None if aim is None else self._purpose(aim, answers)
        self.workspace.crowded = any(puts_down(o) and o.args[1:] == operator.args[1:] for o in skeleton[1:])
        for tried, (segments, after) in enumerate(self._refinements(operator, state)):
            rest, self.involved, self.beyond_help = None, set(operator.args), None
            if all(holds(self.workspace.scene, after, atom) for atom in operator.adds):
                rest = self.bind(skeleton[1:], after, depth + 1)
            if rest is not None:
                return (Step(operator, segments, after), *rest)
            if not self._could_help(operator):
                return None
            if tried + 1 >= self.budget.refinements:
                break
            self.workspace.failures.clear()
        blame, in_vain = self.blame_on(operator), bool(answers) and not any(answers)
        if in_vain:
            self.vain[case] = blame
        self.beyond_help = operator.args[0] if in_vain else None
        self._remember(skeleton, depth, blame, aim if in_vain else None)
        return None

    def _purpose(self, aim: Operator, answers: list[bool]) -> Purpose:
        """What a thing is picked up for; every answer to whether that could be done is noted."""
        skill, rng = SKILLS[aim.skill], np.random.default_rng(0)
        assert isinstance(skill, Place)

        def possible(state: State) -> bool:
            answers.append(skill.possible(self.workspace, state, aim.args, rng))
            return answers[-1]

        return Purpose(aim.args[1], possible)

    def _refinements(self, operator: Operator, state: State) -> Iterator[tuple[tuple, State]]:
        return SKILLS[operator.skill].refine(self.workspace, state, operator.args, self.rng)

    def blame_on(self, operator: Operator) -> Counter[str]:
        """What was in the way of it lately."""
        names = [name for _, blocked in self.workspace.failures for name in (blocked.a, blocked.b)]
        return Counter(n for n in names if n not in ("robot", *operator.args[:1]))

    def _remember(self, skeleton: Skeleton, depth: int, blame: Counter[str], aim: Operator | None) -> None:
        operator, put_down = skeleton[0], _put_down(skeleton)
        self.involved = {*blame, *operator.args, *(put_down.args if put_down else ())}
        if depth > self.deepest:
            self.deepest, self.culprit, self.blame, self.aim, self.put_down = depth, operator, blame, aim, put_down

    def _could_help(self, operator: Operator) -> bool:
        """Whether to do `operator` otherwise could undo the latest failure: not if it moved a thing that had nothing to do with it,
        nor stands now where something was to go; nor if it put elsewhere what can be put nowhere from there."""
        if self.beyond_help == operator.args[0]:
            return False
        things = operator.args if puts_down(operator) else operator.args[:1]
        return operator.args[0] not in self.workspace.scene.movable_names or not self.involved.isdisjoint(things)


def puts_down(operator: Operator) -> bool:
    """Whether it lets go of its first argument."""
    return isinstance(SKILLS.get(operator.skill), Place)


def _put_down(skeleton: Skeleton) -> Operator | None:
    """The first operator of `skeleton` that puts down what the very first one deals with."""
    return next((o for o in skeleton if o.args[:1] == skeleton[0].args[:1] and puts_down(o)), None)


def _surroundings(workspace: Workspace, state: State, thing: str) -> Hashable:
    """All that decides whether some way of holding `thing` does for what comes next, wherever it stands now on the same support."""
    others = [(name, pose.pos.tobytes(), pose.quat.tobytes()) for name, pose in sorted(state.poses.items()) if name != thing]
    roofed = thing in state.poses and workspace.scene.is_roofed(state.poses[thing].pos, 0.0)
    return tuple(others), tuple(sorted(state.doors.items())), roofed


def operators_of(workspace: Workspace, facts: Facts) -> tuple[Operator, ...]:
    """Every ground operator of the scene."""
    return tuple(o for skill in SKILLS.values() for o in skill.operators(workspace.scene, facts))


def with_unblocking(operators: tuple[Operator, ...], learned: Facts) -> tuple[Operator, ...]:
    """The operators, those that pick a thing up also deleting what was learned of its being in the way. A thing that is in the way
    of its own being put somewhere has to be put down elsewhere first: so it stands otherwise, and can be taken otherwise."""

    def frees(operator: Operator, atom: Atom) -> bool:
        blocker, _, *args = atom.args
        own = args[:1] == [blocker]
        return operator.args[:1] == (blocker,) and (puts_down(operator) if own else operator.skill == Pick.name)

    freed = {o: frozenset(a for a in learned if frees(o, a)) for o in operators}
    return tuple(replace(o, deletes=o.deletes | freed[o]) if freed[o] else o for o in operators)


def solve(
    workspace: Workspace,
    state: State,
    goal: Facts,
    rng: np.random.Generator,
    budget: Budget | None = None,
    effort: float = math.inf,
) -> Plan | Infeasible:
    """A plan from `state` to `goal`, or why there is none. Never raises for a problem without a solution. It gives up after
    `effort`, or the budget's if that is less."""
    budget = budget or Budget()
    began, effort_before = time.process_time(), workspace.effort
    workspace.deadline = math.inf if budget.seconds is None else began + budget.seconds
    workspace.most = effort_before + min(effort, math.inf if budget.effort is None else budget.effort)
    state = _as_seen(workspace.scene, state)
    facts, learned = _facts(workspace.scene, state, goal), frozenset()
    if far := _far_off(workspace, state, goal - facts):
        return far
    ground_operators = operators_of(workspace, facts)
    failed: set[tuple[str, ...]] = set()
    last = Infeasible("no sequence of skills reaches the goal")
    of_goal: Infeasible | None = None  # what stands fast is in the way of the goal itself: detours may fail for other reasons
    vain: dict[Hashable, Counter[str]] = {}
    for tried in range(budget.skeletons):
        operators = with_unblocking(ground_operators, learned)
        skeleton = _next(skeletons(facts | learned, goal, operators), failed)
        if skeleton is None:
            return last if of_goal is None else of_goal
        binding = _Binding(workspace, rng, budget, vain=vain)
        try:
            steps = binding.bind(skeleton, state)
        except OutOfTime:
            latest = _explain(binding) if binding.culprit or tried == 0 else last
            return _out_of_time(latest if of_goal is None else of_goal)
        if steps is not None:
            spent = {"seconds": time.process_time() - began, "effort": workspace.effort - effort_before}
            stats = {**spent, "skeletons": tried + 1, "learned": sorted(map(str, learned))}
            return Plan(state, steps, stats)
        failed.add(tuple(map(str, skeleton)))
        last = _explain(binding)
        if _fixed_in_the_way(binding, last, goal):
            of_goal = last
        learned = learned | _lesson(binding, workspace, learned)
    return last if of_goal is None else of_goal


def _far_off(workspace: Workspace, state: State, wanted: Facts) -> Infeasible | None:
    """What is to be taken and lies where no arm of this length comes, if anything does: all else would only be tried in vain."""
    shoulder, far = workspace.kinematics.span
    for atom in sorted(wanted):
        thing = atom.args[0]
        if atom.predicate not in (On.name, Holding.name) or thing not in state.poses or (state.held and state.held.name == thing):
            continue
        size = float(np.linalg.norm(workspace.scene.shape_of(thing).half_extents)) + WITHIN
        if float(np.linalg.norm(state.poses[thing].pos - shoulder)) - size > far:
            return Infeasible("out of reach", Pick.name, (thing,), (UNREACHABLE.b,))
    return None


def _fixed_in_the_way(binding: _Binding, failure: Infeasible, goal: Facts) -> bool:
    """Whether what failed was wanted itself, and nothing that can be moved was in its way."""
    what = binding.aim or binding.culprit
    wanted = what is not None and any(atom in goal for atom in what.adds if atom.predicate != Released.name)
    return wanted and not {*failure.blockers}.intersection(binding.workspace.scene.movable_names)


def _as_seen(scene: Scene, state: State) -> State:
    """Of a body of revolution that lies on its side, the turn about its axis is unknown, and might as well be none."""
    lying = [n for n, pose in state.poses.items() if scene.shape_of(n).symmetric and not stands(pose)]
    for name in lying:
        state = state.moved(name, unrolled(state.poses[name]))
        if state.held is not None and state.held.name == name:
            state = replace(state, held=replace(state.held, tcp_from_object=state.tcp.inverse @ state.poses[name]))
    return state


def _facts(scene: Scene, state: State, goal: Facts) -> Facts:
    """All that holds; and that what leans on something, or lies across an edge, is on a fixture below it: it can be taken from
    there. Not on the one where it is to go, for there it is not yet."""
    facts = facts_of(scene, state)
    resting = {atom.args[0] for atom in facts if atom.predicate == On.name}
    loose = [name for name in state.poses if name not in resting and (state.held is None or state.held.name != name)]
    found = ([On(name, below) for below in _below(scene, state.poses[name])] for name in loose)
    return facts | {atom for atoms in found for atom in [a for a in atoms if a not in goal][:1]}


def _below(scene: Scene, pose: Pose) -> list[str]:
    """The fixtures under a thing, the highest surface first."""
    heights: dict[str, float] = {}
    for fixture in scene.fixtures:
        if (surface := fixture.shape.surface) is not None:
            local = scene.fixture_poses[fixture.name].inverse.transform(pose.pos)
            if abs(local[0]) <= surface.half_x and abs(local[1]) <= surface.half_y and local[2] > surface.z:
                heights[fixture.name] = float(pose.pos[2] - local[2]) + surface.z
    return sorted(heights, key=lambda name: -heights[name])


def _next(candidates: Iterator[Skeleton], failed: set[tuple[str, ...]]) -> Skeleton | None:
    return next((s for s in candidates if tuple(map(str, s)) not in failed), None)


def _lesson(binding: _Binding, workspace: Workspace, learned: Facts) -> Facts:
    """The movables that stood in the way of the skill that could not be done. If nothing new did, and some other
    way to hold the thing would do, then no way to take it as it stands serves to put it where it was to go."""
    if binding.culprit is None:
        return frozenset()
    culprit, put_down = binding.aim or binding.culprit, binding.put_down
    found = frozenset(obstructs(name, culprit) for name in binding.blame if name in workspace.scene.movable_names)
    if found <= learned and put_down is not None and binding.aim is None:
        found |= {obstructs(put_down.args[0], put_down)}
    return found


def _out_of_time(last: Infeasible) -> Infeasible:
    """What was in the way so far need not have stayed so."""
    return last if last.reason == OUT_OF_TIME else replace(last, reason=f"{OUT_OF_TIME}, so far: {last.reason}")


def _explain(binding: _Binding) -> Infeasible:
    o, blame = binding.aim or binding.culprit, binding.blame
    if o is None:  # time was spent on the very first skill
        if (o := binding.trying) is None:
            return Infeasible(OUT_OF_TIME)
        if not (blame := binding.blame_on(o)):
            return Infeasible(OUT_OF_TIME, o.skill, o.args)
    blockers = tuple(name for name, _ in blame.most_common())
    reason = "no room" if binding.aim or not blockers else "no collision-free way"
    if blockers and REACH.issuperset(blockers):
        reason = "out of reach"
    return Infeasible(reason, o.skill, o.args, blockers)

