"""Conditions that demonstrations did not know: a thing that is pushed or slips during execution, other friction and mass.

The same for every agent, the expert and policies alike, and a function of the episode's seed. Nobody is told.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Literal, get_args

import mujoco
import numpy as np

from optimus.env import ManipulationEnv
from optimus.errors import OptimusError, UnknownNameError
from optimus.scene import Scene
from optimus.task import Task
from optimus.world import World, compile_scene

Perturb = Literal["push", "slip"]
"""`push`: once, at a step drawn from `PUSH_AT`, a movable thing that is not held, drawn by lot, is struck through its centre in a
level direction drawn by lot: an impulse of its mass times `PUSH_SPEED`. `slip`: once, when a thing has been held for as many
steps as are drawn from `SLIP_AFTER`, the fingers' force fails for `SLIP_STEPS` steps, and gravity has what they held."""

PERTURBATIONS: tuple[Perturb, ...] = get_args(Perturb)

PUSH_AT = (10, 60)
"""First and last step (of 50 ms) at which a push may come; where everything is held then, it comes as soon as something is not."""
PUSH_SPEED = 0.6
"""[m/s]; with the friction of the objects on the table a block of 4 cm then slides or tumbles on by some 2 cm."""
SLIP_AFTER = (10, 25)
"""Steps; the first few are the gripper's own, on what the thing stands on."""
SLIP_STEPS = 4
SLIP_FORCE_LEFT = 0.0
"""Share of the fingers' force that is left while they slip."""


@dataclass(frozen=True)
class Conditions:
    """What an episode is played under."""

    perturb: Perturb | None = None
    friction: float = 1.0
    """Scales the sliding, torsional and rolling friction of everything."""
    mass: float = 1.0
    """Scales mass and inertia of the movable things."""
    horizon: int | None = None
    """Most steps, where that is fewer than the task's own."""

    def __post_init__(self) -> None:
        if self.perturb is not None and self.perturb not in PERTURBATIONS:
            raise UnknownNameError("perturbation", self.perturb, PERTURBATIONS)
        for name in ("friction", "mass"):
            value = getattr(self, name)
            if not (math.isfinite(value) and 0.01 <= value <= 100.0):
                raise OptimusError(f"{name} is scaled by 0.01 to 100, not by {value}")
        if self.horizon is not None and self.horizon < 1:
            raise OptimusError(f"an episode has at least one step, not {self.horizon}")

    @property
    def said(self) -> str:
        """In a few words, for file names and tables; empty for the usual ones."""
        parts = [self.perturb or "", *(f"{n}-{getattr(self, n):g}" for n in ("friction", "mass") if getattr(self, n) != 1.0)]
        parts.append(f"at-most-{self.horizon}-steps" if self.horizon is not None else "")
        return "+".join(filter(None, parts))

    def of(self, task: Task) -> Task:
        """The task with the horizon of these conditions."""
        return task if self.horizon is None else replace(task, horizon=min(task.horizon, self.horizon))

    def world(self, scene: Scene) -> World:
        """The scene with this friction and mass."""
        usual = self.friction == self.mass == 1.0
        return compile_scene(scene) if usual else _altered(scene, self.friction, self.mass)

    def mishap(self, seed: int) -> Mishap:
        """What is going to happen in the episode of that seed."""
        return Mishap(self.perturb, np.random.default_rng([seed, 4]))


@lru_cache(maxsize=8)
def _altered(scene: Scene, friction: float, mass: float) -> World:
    world = World(scene)
    model = world.model
    model.geom_friction[:] *= friction
    movable = [world.body_ids[name] for name in scene.movable_names]
    model.body_mass[movable] *= mass
    model.body_inertia[movable] *= mass
    mujoco.mj_setConst(model, mujoco.MjData(model))
    return world


class Mishap:
    """Watches an episode (call it before every step), and lets happen once what is to happen."""

    def __init__(self, kind: Perturb | None, rng: np.random.Generator) -> None:
        self.at: int | None = None
        """The step at which it happened; None as long as it has not."""
        self.kind: Perturb | None = kind
        self._rng = rng
        low, high = PUSH_AT if kind == "push" else SLIP_AFTER
        self._wait = int(rng.integers(low, high + 1))
        self._step = self._held = 0

    def __call__(self, env: ManipulationEnv) -> None:
        if self.kind == "push" and self.at is None and self._step >= self._wait:
            self._push(env)
        elif self.kind == "slip":
            self._slip(env)
        self._step += 1

    def _push(self, env: ManipulationEnv) -> None:
        held = env.state().held
        free = [name for name in env.world.movable_dof if held is None or name != held.name]
        if not free:
            return
        name, angle = free[int(self._rng.integers(len(free)))], self._rng.uniform(-np.pi, np.pi)
        at = env.world.movable_dof[name]
        env.data.qvel[at : at + 2] += PUSH_SPEED * np.array([np.cos(angle), np.sin(angle)])
        self.at = self._step

    def _slip(self, env: ManipulationEnv) -> None:
        model, data = env.world.model, env.data
        fingers = model.jnt_dofadr[np.isin(model.jnt_qposadr, env.world.finger_qpos)]
        if self.at is None:
            self._held = self._held + 1 if env.state().held is not None else 0
            self.at = self._step if self._held >= self._wait else None
        failing = self.at is not None and self._step < self.at + SLIP_STEPS
        data.qfrc_applied[fingers] = -(1 - SLIP_FORCE_LEFT) * data.qfrc_actuator[fingers] if failing else 0.0


USUAL = Conditions()
"""Nothing happens, and everything is as in demonstrations."""
