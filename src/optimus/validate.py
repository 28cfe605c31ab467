"""Is this plan true? An independent check: a model compiled afresh, a finer resolution, none of the planner's own geometry."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from optimus.control import CONTROL_HZ
from optimus.control.osc import KP
from optimus.expert import TimeLaw
from optimus.logic import OBSTRUCTS, Atom, Facts
from optimus.motion.lines import distance
from optimus.motion.plan import Plan, Segment, Step
from optimus.predicates import PREDICATES, holds
from optimus.replay import Replay
from optimus.scene import Scene
from optimus.se3 import Array, Pose, error_between, interpolate
from optimus.state import State

SAMPLE_STEP = 0.01
"""Largest joint change between checked configurations [rad]; the planner's own are up to 0.35 rad apart."""
JOIN = 1e-6
"""Segments join when no joint changes by more than this [rad]."""
JUMP = 0.4
"""A larger change between neighbouring waypoints is a jump, not a motion [rad]."""
POSE_POSITION, POSE_ANGLE = 0.001, 0.005
"""How well a declared pose agrees with what the model says [m, rad]."""
UNSEEN = Pose.of((np.inf, 0.0, 0.0))
"""Of a thing that the replay knows nothing of: far from wherever it is declared to be."""
STRAY = 0.005
"""How far the tcp may be, between waypoints, from the line of poses that the follower takes [m]."""
RESPONSE = 2.0 / float(np.sqrt(KP))
"""The arm follows its target as a critically damped system of stiffness `KP`: with this mean delay, over which it evens out how
fast the target moves. Speeds are averages over that time [s]."""
TURNED = 0.02
"""A door is where it is declared to be within this [rad]."""


@dataclass(frozen=True)
class Violation:
    """What is wrong with a plan, and where."""

    what: str
    """`shape`, `continuity`, `limits`, `speed`, `pose`, `collision`, `state`, `needs`, `adds`, `deletes` or `goal`."""
    step: int
    """The index of the plan's step; its length for the goal."""
    segment: int = -1
    """The index of the step's segment; -1 if it is the step's own fault."""
    index: int = -1
    """The waypoint, or the one before."""
    amount: float = 0.0
    """How much: rad, m, or times what is allowed (speed)."""
    detail: str = ""

    def __str__(self) -> str:
        where = f"step {self.step}" + (f", segment {self.segment}" if self.segment >= 0 else "")
        where += f", waypoint {self.index}" if self.index >= 0 else ""
        return f"{self.what} ({where}): {self.detail}" + (f" [{self.amount:.4g}]" if self.amount else "")


def validate(plan: Plan, scene: Scene, goal: Facts, law: TimeLaw | None = None) -> list[Violation]:
    """Everything that is wrong with a plan for `goal` in `scene`, carried out by the time law; nothing for a valid plan.

    Joint speeds are those of the nominal motion along the path: only a push, which no plan foresees, makes the follower faster.
    """
    check = _Check(scene, plan.start, law or TimeLaw())
    before = plan.start
    for number, step in enumerate(plan.steps):
        check.step = number
        check.effects("needs", step.operator.needs, before, True)
        if not check.carry_out(step):
            return check.found
        check.effects("adds", step.operator.adds, step.after, True)
        check.effects("deletes", step.operator.deletes - step.operator.adds, step.after, False)
        before = step.after
    check.step = len(plan.steps)
    check.effects("goal", goal, before, True)
    return check.found


class _Check:
    """One plan under examination, and what was found."""

    def __init__(self, scene: Scene, start: State, law: TimeLaw) -> None:
        self.scene, self.law = scene, law
        self.replay = Replay(scene, start)
        self.found: list[Violation] = []
        self.step = 0
        self._segment = -1

    def _report(self, what: str, index: int = -1, amount: float = 0.0, detail: str = "") -> None:
        self.found.append(Violation(what, self.step, self._segment, index, float(amount), detail))

    # ---- symbols

    def effects(self, what: str, atoms: Facts, state: State, wanted: bool) -> None:
        """Each of `atoms` must hold in `state`, or not."""
        scene = self.scene
        names = {*scene.movable_names, *scene.fixture_poses, *(d.name for d in scene.doors)}
        for atom in sorted(a for a in atoms if a.predicate != OBSTRUCTS):  # that one is no fact of the world
            known = atom.predicate in PREDICATES and names.issuperset(atom.args)
            if not known or _well_formed_holds(scene, state, atom) != wanted:
                self._report(what, detail=f"{atom} should{'' if wanted else ' not'} hold" if known else f"unknown: {atom}")

    # ---- motions

    def carry_out(self, step: Step) -> bool:
        """Go through a step's segments; False if they are too malformed to go on."""
        for number, segment in enumerate(step.segments):
            self._segment = number
            if not self._is_well_formed(segment):
                return False
            self._continuity(segment)
            self._limits(segment)
            self._poses(segment)
            self._speeds(segment)
            self._free(segment, step.operator.args[1:])
        self._segment = -1
        self._compare(step.after)
        return True

    def _is_well_formed(self, segment: Segment) -> bool:
        dof, q = len(self.replay.world.arm_qpos), segment.q
        good = q.ndim == 2 and q.shape[1] == dof and len(q) == len(segment.poses) > 0 and bool(np.isfinite(q).all())
        good &= len(q) == 1 or not segment.gripper_action
        good &= all(n in self.replay.world.door_qpos and len(angles) == len(q) for n, angles in segment.doors.items())
        if not good:
            self._report("shape", detail=f"{segment.name}: q {q.shape} and {len(segment.poses)} poses")
        return bool(good)

    def _continuity(self, segment: Segment) -> None:
        gaps = np.abs(np.diff(np.vstack([self.replay.state.q, segment.q]), axis=0)).max(axis=1)
        if gaps[0] > JOIN:
            self._report("continuity", 0, gaps[0], f"{segment.name} does not begin where the arm is")
        for i in np.flatnonzero(gaps[1:] > JUMP):
            self._report("continuity", int(i), gaps[1 + i], f"{segment.name} jumps")

    def _limits(self, segment: Segment) -> None:
        low, high = self.replay.world.arm_range.T
        over = np.maximum(low - segment.q, segment.q - high)
        for i in np.flatnonzero((over > 0).any(axis=1)):
            self._report("limits", int(i), over[i].max(), f"{self.scene.robot.joints[int(over[i].argmax())]}")

    def _poses(self, segment: Segment) -> None:
        """The declared poses are the model's, and half way between two the tcp is near the line that the follower takes."""
        for i, pose in enumerate(segment.poses):
            off = error_between(pose, self.replay.place(segment, i))
            if not _is_near(off):
                self._report("pose", i, float(np.linalg.norm(off[:3])), f"{segment.name}: the tcp is elsewhere")
        for i, (a, b) in enumerate(pairwise(segment.poses)):
            off = error_between(interpolate(a, b, 0.5), self.replay.place(segment, i + 0.5))
            if np.linalg.norm(off[:3]) > STRAY:
                self._report("pose", i, float(np.linalg.norm(off[:3])), f"{segment.name} strays from its line")

    def _speeds(self, segment: Segment) -> None:
        """Joint speeds, averaged over the controller's `RESPONSE`, at every control step."""
        speed = min(self.law.speed, segment.speed)
        steps = [distance(a, b) / speed for a, b in pairwise(segment.poses)]
        times = np.concatenate([[0.0], np.cumsum(steps)])
        at = np.append(np.arange(0.0, max(times[-1] - RESPONSE, 0.0), 1 / CONTROL_HZ), max(times[-1] - RESPONSE, 0.0))
        first, last = (np.column_stack([np.interp(t, times, joint) for joint in segment.q.T]) for t in (at, at + RESPONSE))
        if times[-1] <= RESPONSE:
            first, last = segment.q[:1], segment.q[-1:]  # also where poses do not change: joints must not either
        ratio = np.abs(last - first) / RESPONSE / np.array(self.scene.robot.speed_limits)
        if ratio.max() > 1.0:
            worst, joint = np.unravel_index(int(ratio.argmax()), ratio.shape)
            index = int(np.searchsorted(times, at[worst], side="right")) - 1
            self._report("speed", index, ratio.max(), f"{segment.name}: {self.scene.robot.joints[int(joint)]}, of its limit")

    def _free(self, segment: Segment, supports: tuple[str, ...]) -> None:
        """Free all the way, at the finer resolution: each pair that meets is reported once, where it meets deepest."""
        if segment.gripper_action:
            self.replay.finish(segment)
        deepest: dict[tuple[str, str], tuple[float, int]] = {}
        for at in _samples(segment.q):
            self.replay.place(segment, at)
            for c in self.replay.collisions(supports):
                deepest[c.a, c.b] = max(deepest.get((c.a, c.b), (0.0, 0)), (c.depth, int(at)))
        for (a, b), (depth, i) in deepest.items():
            self._report("collision", i, depth, f"{segment.name}: {a} meets {b}")
        if not segment.gripper_action:
            self.replay.finish(segment)

    def _compare(self, declared: State) -> None:
        """What a step says that it leads to, against what its motions led to."""
        here = self.replay.state
        held = [None if s.held is None else s.held.name for s in (declared, here)]
        if held[0] != held[1]:
            self._report("state", detail=f"holds {held[1]}, not {held[0]}")
        off = float(np.abs(declared.q - here.q).max())
        if off > JOIN:
            self._report("state", amount=off, detail="the arm is elsewhere")
        expected = {"tcp": here.tcp, **here.poses}
        for name, pose in {"tcp": declared.tcp, **declared.poses}.items():
            error = error_between(expected.get(name, UNSEEN), pose)
            if not _is_near(error):
                self._report("state", amount=float(np.linalg.norm(error[:3])), detail=f"{name} is elsewhere")
        for name, angle in declared.doors.items():
            if abs(angle - here.doors.get(name, np.inf)) > TURNED:
                self._report("state", detail=f"{name} is open by {here.doors.get(name)}, not {angle} rad")


def _well_formed_holds(scene: Scene, state: State, atom: Atom) -> bool | None:
    """Whether `atom` holds; None if it has too many or too few names."""
    return holds(scene, state, atom) if len(atom.args) == len(PREDICATES[atom.predicate].kinds) else None


def _is_near(error: Array) -> bool:
    return bool(np.linalg.norm(error[:3]) <= POSE_POSITION and np.linalg.norm(error[3:]) <= POSE_ANGLE)


def _samples(q: Array) -> Iterator[float]:
    """Fractional waypoints of a joint path `(T, dof)`, `SAMPLE_STEP` apart or nearer."""
    for i, step in enumerate(np.abs(np.diff(q, axis=0)).max(axis=1, initial=0.0)):
        pieces = max(1, int(np.ceil(step / SAMPLE_STEP)))
        yield from (i + k / pieces for k in range(pieces))
    yield float(len(q) - 1)
