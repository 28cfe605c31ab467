"""The one loop in which an agent meets an environment, and what it leaves behind: an `Episode`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from optimus.control import JOINT_SCALE
from optimus.data.episode import (
    GRIPPER,
    INSTRUCTION,
    RECEPTACLE,
    STATE_COLUMNS,
    TOLD,
    VIEWS,
    Episode,
    Observation,
)
from optimus.env import RECORDED_STATE, ManipulationEnv
from optimus.predicates import holds
from optimus.world import World

JOINT_TREMBLE = 0.005
"""Under joint control every joint trembles by this much besides the hand [rad], one standard deviation."""
AT_REST = 2e-4
"""A hand that came no farther in a step goes nowhere [m]."""
LAST_LOOK = 12
"""Steps for which the world is still watched when the agent is done, so that what it let go can settle."""


class Agent(Protocol):
    """The expert and every policy."""

    def act(self, observation: Observation) -> NDArray[np.float32] | None:
        """The action `(n,)`, gripper last, or None when it has nothing more to do."""
        ...


class Meddler(Protocol):
    """Has a hand in what is executed, not in what is recorded as the answer."""

    def next(self, observation: Observation, label: NDArray[np.float32], slack: float) -> NDArray[np.float64]:
        """What to add to the action `label` `(n,)` before it is executed; `slack` says how much may happen now, 0 to 1."""
        ...


@dataclass(frozen=True)
class Perturbation:
    """Pushes on the executed action while the label stays the agent's own answer (the idea of DART, Laskey et al. 2017).

    Two kinds: a tremble at every step, which no single action survives unchanged, and now and then a shove over a few steps,
    which takes the arm to where a policy that errs will find itself. Standard deviations, in metres and radians.
    """

    tremble: float = 0.004
    tremble_tilt: float = 0.01
    """About the horizontal axes. Demonstrations hold the hand upright, so without this none says what to do when it is not: small
    errors of a policy add up to a tilt that it has never seen, and all else goes wrong with it."""
    tremble_yaw: float = 0.03
    shove: float = 0.03
    shove_tilt: float = 0.08
    shove_yaw: float = 0.20
    shoves: float = 0.05
    """Probability that a shove begins at a step."""
    shove_steps: int = 3
    pauses: float = 0.03
    """Probability that a pause begins at a step: the arm stands still while the answer is to go on. Without it, only a
    gripper at work is ever seen at a standstill, and a policy that has come to one stays there."""
    longest_pause: int = 12
    """[steps]"""
    hesitations: float = 0.5
    """Probability that the gripper, told to open or to shut, does so late: until then all stands still and the answer is to act.
    Without it, a hand that has come to rest where it is to shut, or to open, is only ever seen staying as it is (after a release),
    and so a policy stays there for ever."""
    longest_hesitation: int = 20
    """[steps]; longer than a policy looks back, or what it sees after a while of rest was never shown to it."""
    overshoots: float = 0.5
    """Probability that the hand goes on as it came before it rests with a late gripper. Without it, none says what to do below the
    place of a release: a policy that opens the hand a few steps late has pressed what it holds onto the ground, and stays there."""
    overshoot: float = 0.012
    """Farthest that it goes on [m] ..."""
    overshoot_steps: int = 4
    """... and in how many steps."""
    steady: float = 0.3
    """Share of a push that is left while the hand has hold of what is not free to come along. Without any, every door is drawn
    open along one and the same arc: a policy a few millimetres off it knows no way back, and loses the handle."""


class Pushes:
    """The pushes of one episode, drawn from its own generator: of the hand, whatever moves the arm, and under joint control
    of each joint a little besides, for there the elbow errs too."""

    def __init__(self, config: Perturbation, rng: np.random.Generator, env: ManipulationEnv) -> None:
        self.config, self._rng, self._env = config, rng, env
        self._shove, self._left = np.zeros(6), 0
        self._still = 0
        self._told, self._gripper, self._late = 0.0, 0.0, 0
        """What the gripper is told to do (0: nothing yet), what it does, and for how many steps more it will not obey."""
        self._at, self._way = np.full(3, np.nan), np.zeros(3)
        """Where the hand was at the step before, and how far it had come in that step [m]."""
        self._onwards, self._coasting = np.zeros(6), 0
        """The motion of a step beyond where the hand was to stop, and for how many steps more."""

    def next(self, observation: Observation, label: NDArray[np.float32], slack: float) -> NDArray[np.float64]:
        """What to add to the next action `(n,)`, scaled by `slack` (0: no push does no harm now, 1: any)."""
        c, rng = self.config, self._rng
        at = observation["robot0_eef_pos"].astype(float)
        self._at, self._way = at, np.nan_to_num(at - self._at)
        tremble = rng.normal(size=6) * _spread(c.tremble, c.tremble_tilt, c.tremble_yaw)
        begins, shove = rng.uniform() < c.shoves, rng.normal(size=6) * _spread(c.shove, c.shove_tilt, c.shove_yaw)
        if begins and self._left == 0:
            self._shove, self._left = shove / c.shove_steps, c.shove_steps
        moved = tremble + (self._shove if self._left else 0.0)
        self._left = max(0, self._left - 1)
        pauses, length = rng.uniform() < c.pauses, int(rng.integers(2, c.longest_pause + 1))
        if pauses and self._still == 0:
            self._still = length
        noise = np.append(self._arm(slack * moved, slack), 0.0)
        if self._still and slack > 0:
            noise[:GRIPPER] -= label[:GRIPPER]
        self._still = max(0, self._still - 1)
        if self._acts(label):
            return noise
        onwards = self._arm(self._onwards if self._coasting else np.zeros(6), 0.0)
        self._coasting = max(0, self._coasting - 1)
        return np.append(onwards - label[:GRIPPER], self._gripper - label[GRIPPER]).astype(np.float64)

    def _acts(self, label: NDArray[np.float32]) -> bool:
        """Whether the gripper does now what it is told, or is late."""
        told, config = float(label[GRIPPER]), self.config
        late, steps = self._rng.uniform() < config.hesitations, int(self._rng.integers(1, config.longest_hesitation + 1))
        if told != self._told:
            self._late = steps if late and self._told else 0
            self._told = told
            self._overshoot()
        if self._late == 0:
            self._gripper = told
        self._late = max(0, self._late - 1)
        return self._gripper == told

    def _overshoot(self) -> None:
        """Draw whether, and how far, the hand goes on along the way that it came."""
        config, speed = self.config, float(np.linalg.norm(self._way))
        goes, length = self._rng.uniform() < config.overshoots, self._rng.uniform(0.0, config.overshoot)
        self._coasting = config.overshoot_steps if goes and speed > AT_REST else 0
        if self._coasting:
            self._onwards = np.append(self._way / speed * length / config.overshoot_steps, np.zeros(3))

    def _arm(self, moved: NDArray[np.float64], slack: float) -> NDArray[np.float64]:
        """The arm's part of an action that moves the hand by `moved` `(6,)`: position [m], rotation vector [rad]."""
        env = self._env
        noise = env.controller.action_for(moved, env.data)
        if env.control == "joint":
            noise += slack * self._rng.normal(size=noise.shape) * JOINT_TREMBLE / JOINT_SCALE
        return noise


def _spread(place: float, tilt: float, yaw: float) -> NDArray[np.float64]:
    """Deviations of a motion `(6,)`: position [m], rotation vector [rad]."""
    return np.array([place, place, place, tilt, tilt, yaw])


@dataclass(eq=False)
class Log:
    """What a rollout appends to, step by step."""

    observations: list[Observation]
    actions: list[NDArray[np.float32]]
    executed: list[NDArray[np.float32]]
    objects: list[NDArray[np.float64]]
    states: list[NDArray[np.float64]]


def rollout(
    env: ManipulationEnv,
    observation: Observation,
    agent: Agent,
    name: str,
    push: Callable[[Observation, NDArray[np.float32]], NDArray[np.float64] | None] = lambda seen, label: None,
    watch: Callable[[ManipulationEnv], None] = lambda env: None,
) -> Episode:
    """Run `agent` from the environment's present state (of which `observation` is the view) to success, its end or the horizon.

    `push(observation, label)` gives what to add to the executed action, or None;
    `watch(env)` is called before every step (films, measurements). By the paper's rule, which never asks for release, an episode
    has succeeded (`info["paper_success"]`) as soon as the goal is met, whatever becomes of it afterwards.
    """
    log = Log([], [], [], [], [])
    start = env.snapshot()
    success, truncated, idle, by_paper = False, False, 0, env.problem.paper_success(env.state())
    still = np.zeros(env.action_size, np.float32)
    while not (success or truncated or idle >= LAST_LOOK):
        watch(env)
        action = agent.act(observation)
        idle = idle + 1 if action is None else 0
        if action is None:
            still[GRIPPER] = log.actions[-1][GRIPPER] if log.actions else -1.0
        label = still.copy() if action is None else action
        noise = push(observation, label) if action is not None else None
        done = label if noise is None else np.clip(label + noise, -1.0, 1.0).astype(np.float32)
        log.observations.append(observation)
        log.actions.append(label)
        log.executed.append(done)
        log.objects.append(env.object_positions())
        log.states.append(env.snapshot(RECORDED_STATE))
        observation, _, success, truncated, found = env.step(done)
        by_paper = by_paper or found["paper_success"]
    watch(env)
    episode = _episode(env, log, start, name, success, "" if success else failure_of(env, truncated))
    return replace(episode, info={**episode.info, "paper_success": by_paper})


def failure_of(env: ManipulationEnv, truncated: bool) -> str:
    """Why the goal does not hold: the first of its atoms that does not, and whether time ran out."""
    state = env.state()
    missing = sorted(str(a) for a in env.problem.goal if not holds(env.world.scene, state, a))
    return f"{'out of time' if truncated else 'ended'} without {missing[0] if missing else 'success'}"


def _episode(env: ManipulationEnv, log: Log, start: NDArray[np.float64], name: str, success: bool, failure: str) -> Episode:
    # what the objects' places and the states say is not written a second time as an observation
    keys = [k for k in log.observations[0] if k not in TOLD]
    return Episode(
        task=env.task.name,
        seed=env.episode_seed,
        agent=name,
        observations={k: np.stack([o[k] for o in log.observations]) for k in keys},
        actions=np.stack(log.actions),
        executed=np.stack(log.executed),
        initial_state=start,
        objects=np.stack(log.objects).astype(np.float32),
        object_names=env.world.scene.movable_names,
        success=success,
        failure=failure,
        info={
            "variant": env.problem.variant,
            "control": env.control,
            "goal": sorted(str(a) for a in env.problem.goal),
            VIEWS: env.world.views,
            STATE_COLUMNS: state_columns(env.world),
            INSTRUCTION: env.problem.instruction,
            "words": env.problem.words,
            **({RECEPTACLE: env.problem.receptacle} if env.problem.receptacle else {}),
        },
        states=np.stack(log.states),
    )


def state_columns(world: World) -> dict[str, dict[str, int]]:
    """Where things are in a row of `Episode.states`, see `STATE_COLUMNS`: the time comes first."""
    return {"objects": {n: 1 + i for n, i in world.movable_qpos.items()}, "doors": {n: 1 + i for n, i in world.door_qpos.items()}}
