"""Stack as other cameras see it, for Figure A.1's camera ablation: the same problems, another fixed camera."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from optimus.scene import Camera
from optimus.task import Problem, Task
from optimus.tasks.stack import STACK

CLOSE = Camera("agentview", (0.80, 0.0, 0.22), (0.50, 0.0, 0.04), 50.0)
"""From low and near: the blocks are large, their distance is hard to tell, and the hand often covers them."""
DISTANT = Camera("agentview", (1.60, 0.0, 1.10), (0.49, 0.0, 0.10), 45.0)
"""From afar: everything is in view, and a block is four pixels wide."""


def _seen_by(camera: Camera, attribute: str) -> Task:
    def draw(rng: np.random.Generator) -> Problem:
        problem = STACK.draw(rng)
        return replace(problem, scene=replace(problem.scene, cameras=(camera,)))

    return replace(STACK, name=f"{__name__}:{attribute}", draw=draw)


STACK_CLOSE = _seen_by(CLOSE, "STACK_CLOSE")
STACK_DISTANT = _seen_by(DISTANT, "STACK_DISTANT")
