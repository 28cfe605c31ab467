"""Correction: the policy acts, the expert says what it would have done (the idea of DAgger, Ross et al. 2011).

A perturbation finds the states that noise leads to; only the policy finds those that its own errors lead to. Policy and expert take
turns, so that most episodes still end in success and pass for demonstrations: their labels are the expert's throughout, who plans
again from what the policy has done (`closed_loop.SHARED`).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from optimus.data.episode import IMAGE_SIZE, Observation
from optimus.errors import CheckpointError

if TYPE_CHECKING:
    from optimus.learn.agent import PolicyAgent
    from optimus.task import Task


@dataclass(frozen=True)
class Turns:
    """How policy and expert take turns."""

    policy: Path
    """The run folder of the policy that acts."""
    policy_steps: float = 40.0
    """Mean length of its turns."""
    expert_steps: float = 12.0
    """Mean length of the expert's."""
    policy_until: int | None = None
    """From a step drawn up to this one on the expert acts alone, so that the episode comes to its end; None: never."""

    @property
    def record(self) -> dict[str, object]:
        """What a dataset says about it, JSON-able: of the policy its folder's name, and a name of its weights."""
        from optimus.learn.checkpoint import weights_of

        said = {**vars(self), "policy": self.policy.name, "weights": weights_of(self.policy)}
        return {name: value for name, value in said.items() if value is not None}


def _changed(run: Path) -> int:
    """When the weights of a run were written: what is known of older ones does not hold for them."""
    from optimus.learn.checkpoint import MODEL_FILE

    file = run / MODEL_FILE
    return file.stat().st_mtime_ns if file.exists() else 0


@lru_cache(maxsize=1)
def _agent(run: Path, changed: int) -> PolicyAgent:
    # imported here: collecting without a policy needs no torch
    import torch

    from optimus.learn.agent import trained_agent

    torch.set_num_threads(1)
    return trained_agent(run)


def is_told(run: Path) -> bool:
    """`PolicyInputs.told` of the policy of a run folder."""
    return _is_told(run, _changed(run))


@lru_cache(maxsize=1)
def _is_told(run: Path, changed: int) -> bool:
    from optimus.learn import checkpoint

    return checkpoint.load(run).inputs.told


def require_usual_eyes(turns: Turns, cameras: tuple[str, ...]) -> None:
    """`CheckpointError` if the policy that is to act sees otherwise than by these `cameras`, as collection does."""
    from optimus.learn import checkpoint

    inputs = checkpoint.load(turns.policy).inputs
    if inputs.told:
        return
    if not cameras:
        raise CheckpointError("a policy looks at images: corrections cannot be collected without them")
    if inputs.frame != (IMAGE_SIZE, IMAGE_SIZE) or inputs.cameras != cameras or inputs.views:
        usual = f"images of {IMAGE_SIZE} x {IMAGE_SIZE} by {', '.join(cameras)}"
        raise CheckpointError(f"{turns.policy} was not trained on {usual}, as are collected; name another run")


def require_same_work(turns: Turns, task: Task, control: str, robot: str, gripper: str) -> None:
    """`CheckpointError` if the policy that is to act was trained for another task (other objects are the same one), another way of
    control, another use of the gripper, or with another robot (`robot` as records have it)."""
    from optimus.learn import checkpoint

    inputs = checkpoint.load(turns.policy, control=control).inputs
    learned_task, trained_with = inputs.task, inputs.robot
    if task.name.partition("@")[0] not in [name.partition("@")[0] for name in checkpoint.tasks_of(learned_task)]:
        raise CheckpointError(f"{turns.policy} was trained for task {learned_task!r}, not {task.name!r}; name another run")
    if (learned := checkpoint.gripper_of(turns.policy)) != gripper:
        raise CheckpointError(f"{turns.policy} was trained with gripper {learned!r}, not {gripper!r}; name another run, or that")
    if trained_with != robot:
        have, wanted = task.robot_text(trained_with), task.robot_text(robot)
        raise CheckpointError(f"{turns.policy} was trained with robot {have}, not {wanted}; name another run, or that robot")


class Corrections:
    """The turns of one episode: adds to the expert's action what makes it the policy's, while it is the policy's turn."""

    def __init__(self, turns: Turns, rng: np.random.Generator) -> None:
        self.turns, self._rng = turns, rng
        self._agent = _agent(turns.policy, _changed(turns.policy))
        self._agent.reset(int(rng.integers(2**31)))
        self._policys = bool(rng.uniform() < 0.7)
        until = turns.policy_until
        self._left = math.inf if until is None else float(rng.integers(1, until + 1))
        """Steps until the expert acts alone."""

    def next(self, observation: Observation, label: NDArray[np.float32], slack: float) -> NDArray[np.float64]:
        """What to add to the expert's action `(n,)`."""
        self._left -= 1
        if self._left < 0:
            return np.zeros(label.shape)
        answer = self._agent.act(observation).astype(np.float64)
        mean = self.turns.policy_steps if self._policys else self.turns.expert_steps
        if self._rng.uniform() < 1.0 / mean:
            self._policys = not self._policys
        return answer - label if self._policys else np.zeros_like(answer)
