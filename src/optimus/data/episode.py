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

BINARY, CONTINUOUS = "binary", "continuous"
RECEPTACLE = "receptacle"
"""In `Episode.info`: the sizes of the furniture, where they are drawn."""
"""What an action tells the gripper: to open or to shut, by its sign, which is meant where nothing is recorded; or where to be, from
-1 open to 1 shut and pressing (the gripper aims beyond where its fingers meet)."""

TASKS_OWN = "the task's own"
"""The robot where none is recorded; others are recorded by name."""


def arm_parts(control: str, size: int) -> tuple[slice, ...]:
    """The parts of an action of `size` numbers that move the arm, each in one unit: all joints together under joint control,
    else delta position (3) and delta rotation vector (3), base frame."""
    arm = size - 1  # imported actions may have fewer numbers: a position alone, or nothing but the gripper
    parts = (slice(0, arm),) if control == "joint" else (slice(0, min(3, arm)), slice(3, min(6, arm)))
    return tuple(part for part in parts if part.start < part.stop)


MISHAP = "mishap"
"""In `Episode.info`, where a thing was pushed, slipped or was missed: its `kind` (`optimus.demonstrate`), and `at` which step."""
IMPORTED = "imported"
"""The setting of a data set that says of which format it came."""
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

OBJECT_POSITIONS = "object_positions"
"""Where an agent that is told the scene's state instead of seeing it finds the movables' positions `(3 k,)` [m], as the scene
orders them. Datasets hold them in `objects`."""

OBJECT_TURNS = "object_turns"
"""... and how they are turned: the first two columns of each one's rotation `(6 k,)`."""

HAND = {"robot0_eef_pos", "robot0_eef_quat"}
"""Observations that tell where the hand is."""

DOOR_ANGLES = "door_angles"
"""... and how far the doors are open `(d,)` [rad], where the scene has doors."""

TOLD = (OBJECT_POSITIONS, OBJECT_TURNS, DOOR_ANGLES)
"""What an agent that is told the scene's state has besides the proprioception."""

IMAGE_SUFFIX = "_image"
DEPTH_SUFFIX = "_depth"
"""`(T, h, w)` float32: distance along the camera's axis [m]."""
SEGMENTATION_SUFFIX = "_segmentation"
"""`(T, h, w)` uint8: 0 where there is nothing of note, else 1 + the index into the episode's `info[SEGMENTED]`."""
IMAGE_SIZE = 84

VIEWS = "views"
"""In `Episode.info`: the fixed cameras, name -> `pos` `(3,)` [m] and `quat` wxyz in the base frame (it looks along its -z, and
its y is up), `fovy` [deg]."""
RENDERED = "rendered"
"""In a dataset's settings: how its images were made, where they are not those of collection; of that, its `VIEWS`: cameras of its
own, each `name`, `pos` and `target` [m] in the base frame, `fovy` [deg]."""
STATE_COLUMNS = "state_columns"
"""In `Episode.info`: `objects` and `doors`, name -> the column of `states` at which an object's pose begins (position [m],
quaternion wxyz), or in which a door's angle [rad] is."""
SEGMENTED = "segmented"
"""In `Episode.info`: the names that segmentation images refer to."""

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
    """JSON-able facts: variant of the scene, instruction, what the objects are called (`words`), timings, tracking error, retries,
    versions, `VIEWS`, `STATE_COLUMNS`."""
    states: NDArray[np.float64] | None = None
    """`(T, n)`: the simulator's time [s], positions and velocities (MuJoCo's qpos and qvel) at each observation, from which it
    can be rendered again; None where nobody recorded them."""

    def __len__(self) -> int:
        return len(self.actions)

    @property
    def cameras(self) -> tuple[str, ...]:
        """The names of the cameras, without the `_image` suffix, in order."""
        return tuple(k.removesuffix(IMAGE_SUFFIX) for k in self.observations if k.endswith(IMAGE_SUFFIX))
