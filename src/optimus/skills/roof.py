"""How a hand gets out from under a roof, and so in."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from optimus.scene import Scene
from optimus.se3 import Array, Pose, quat_mul, turn_towards

MARGIN = 0.10
"""The hand reaches this far beyond the tcp, sideways [m]."""
BACKED = 0.08
"""So far along its own heading the hand backs off before it goes straight for the open [m]."""
RAISED = (0.0, 0.6)
"""By so much the hand is raised towards pointing down on its way out [rad]: near to the arm's base there is not always room to
lean. Less than 45 degrees, so that it stays clear on which side what it holds is to stand."""
DOWN = np.array([0.0, 0.0, -1.0])
AHEAD = np.array([1.0, 0.0, 0.0])
"""Shelves and boxes are open towards the arm's base."""


def is_under(scene: Scene, goal: Pose) -> bool:
    """Whether a hand from above could not get to `goal`."""
    return scene.is_roofed(goal.pos, MARGIN)


def ways_out(scene: Scene, goal: Pose) -> Iterator[list[Pose]]:
    """Corners from `goal` to the open sky: back a little and then straight towards the arm's base, all along the level direction in
    which the hand leans, or along the hand itself."""
    axis = goal.matrix[:, 2]
    lean = float(np.hypot(*axis[:2]))
    level = np.array([*axis[:2], 0.0]) / lean if lean > 0.2 else AHEAD
    backed = goal.shifted(-BACKED * level)
    for angle in RAISED:
        yield from _until_open(scene, [backed], AHEAD, angle)
    if level[0] < 1.0 - 1e-6:
        yield from _until_open(scene, [goal], level)
    yield from _until_open(scene, [goal], axis)


def _until_open(scene: Scene, corners: list[Pose], direction: Array, raised: float = 0.0) -> Iterator[list[Pose]]:
    """`corners` and one more, against `direction` from the last, that is under the open sky; nothing if that is far away."""
    last = corners[-1]
    for length in np.arange(0.05, 0.7, 0.05):
        out = last.shifted(-length * direction)
        if not is_under(scene, out):
            yield [*corners, Pose(out.pos, quat_mul(turn_towards(out.matrix[:, 2], DOWN, raised), out.quat))]
            return
