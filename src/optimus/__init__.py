"""OPTIMUS: from the description of a manipulation task to a trained visuomotor policy, with no human demonstrator."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from optimus.learn.agent import PolicyAgent
    from optimus.learn.heads import Component

__version__ = "0.1.0"

# MuJoCo chooses its GL library when it is first imported, so this cannot wait. Off-screen EGL where there may be no display;
# software rendering in the thread that asks for it, since rollouts are parallel across processes (docs/performance.md).
if sys.platform == "linux":
    os.environ.setdefault("MUJOCO_GL", "egl")
    os.environ.setdefault("LP_NUM_THREADS", "0")

from optimus.registration import register

register()


def load_policy(run: Path | str, component: Component = "sampled", compiled: bool = False) -> PolicyAgent:
    """The policy in the folder of a training run, or that of `pretrained:NAME`, to act with: `reset()`, then `act(observation)`
    step by step.

    `act` takes what `optimus/...` environments observe (a dictionary of arrays) and gives the action `(n,)` float32.
    `CheckpointError` if there is no policy in the folder, or it is damaged. See
    `optimus.learn.agent.PolicyAgent` for `component` and `compiled`.
    """
    from optimus.learn.agent import trained_agent  # torch takes seconds, and most of the package does without
    from optimus.pretrained import trained_folder

    return trained_agent(trained_folder(run), component, compiled)
