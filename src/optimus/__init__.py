"""OPTIMUS: from the description of a manipulation task to a trained visuomotor policy, with no human demonstrator."""

import os
import sys

__version__ = "0.1.0"

# MuJoCo chooses its GL library when it is first imported, so this cannot wait. Off-screen EGL where there may be no display;
# software rendering in the thread that asks for it, since rollouts are parallel across processes (docs/performance.md).
if sys.platform == "linux":
    os.environ.setdefault("MUJOCO_GL", "egl")
    os.environ.setdefault("LP_NUM_THREADS", "0")

from optimus.registration import register

register()
