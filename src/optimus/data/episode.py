"""`Episode`: one run of one agent, the plain-numpy record in which the simulator and the learner meet."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

GRIPPER = -1
"""Index of the gripper in an action, whatever moves the arm: -1 opens, +1 shuts it. Before it stands the arm's part."""

OSC = "osc"
"""The way of control where none is recorded."""

TASKS_OWN = "the task's own"
"""The robot where none is recorded; others are recorded by name."""


def arm_parts(control: str, size: int) -> tuple[slice, ...]:
    """The parts of an action of `size` numbers that move the arm, each in one unit: all joints together under joint control,
    else delta position (3) and delta rotation vector (3), base frame."""
    return (slice(0, size - 1),) if control == "joint" else (slice(0, 3), slice(3, 6))


INSTRUCTION = "instruction"
"""In an episode's `info`: what was wanted, in plain English; episodes of older data sets have none."""

PROPRIOCEPTION: dict[str, int] = {
    "robot0_eef_pos": 3,
    "robot0_eef_quat": 4,
    "robot0_gripper_qpos": 2,
    "robot0_target_error": 6,
}
"""Names and sizes of the low-dimensional observations: tcp position [m], tcp quaternion (xyzw, as robosuite has it),
finger positions [m], and the controller's target minus the tcp (position [m], rotation vector [rad]). Under joint control
`robot0_joint_pos` and `robot0_joint_target_error` `(dof,)` [rad] stand in place of the last."""

IMAGE_SUFFIX = "_image"
IMAGE_SIZE = 84

Observation = dict[str, NDArray[Any]]
"""One step: the arrays of `PROPRIOCEPTION` as float32 `(n,)`, and `<camera>_image` as uint8 `(84, 84, 3)`."""


@dataclass(frozen=True, eq=False)
class Episode:
    """One run of one agent in one task.

    `observations[name]` has shape `(T, ...)`: what was seen before each action. `actions` `(T, n)` float32 are the labels:
    the agent's own answer to each observation. `executed` `(T, n)` float32 is what was applied; it differs from `actions`
    only where the episode was perturbed on purpose. `initial_state` `(n,)` float64 is the simulator's full physics state
    before the first action, from which the episode can be started again. `objects` `(T, k, 3)` float32 are the positions [m] of
    the scene's movable bodies in the base frame, as `object_names` orders them (privileged: never a policy's input).
    """

    task: str
    seed: int
    agent: str
    observations: dict[str, NDArray[Any]]
    actions: NDArray[np.float32]
    executed: NDArray[np.float32]
    initial_state: NDArray[np.float64]
    objects: NDArray[np.float32]
    object_names: tuple[str, ...]
    success: bool
    failure: str = ""
    """Why it failed; empty for a success."""
    skeleton: tuple[str, ...] = ()
    """The plan's skills in order, e.g. `("pick", "stack")`; empty for a policy."""
    info: dict[str, Any] = field(default_factory=dict)
    """JSON-able facts: variant of the scene, instruction, what the objects are called (`words`), tracking error, retries."""

    def __len__(self) -> int:
        return len(self.actions)

    @property
    def cameras(self) -> tuple[str, ...]:
        """The names of the cameras, without the `_image` suffix, in order."""
        return tuple(k.removesuffix(IMAGE_SUFFIX) for k in self.observations if k.endswith(IMAGE_SUFFIX))
