"""The renderer, tried in a process of its own: a GL library that does not work may take the whole process with it.

`python -m optimus.doctor.drawing [robot]` draws, and answers with one line of JSON.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from typing import Any

from optimus.doctor.finding import Finding
from optimus.statistics import quantiles

FRAMES = 40
SECONDS = 120.0
"""After which the other process is given up."""
PLAIN = """<mujoco><worldbody><light pos="0 0 2"/><geom type="plane" size="1 1 .1"/><geom size=".1" pos="0 0 .1" rgba="1 0 0 1"/>
<camera name="agentview" pos="0 -.6 .5" xyaxes="1 0 0 0 .6 .8"/></worldbody></mujoco>"""
MESA = (
    "install Mesa's EGL (Debian, Ubuntu: apt-get install libegl1 libgl1 libgles2 libgl1-mesa-dri;"
    " Fedora: mesa-libEGL mesa-dri-drivers)"
)


def renderer(with_robot: bool) -> Finding:
    """Whether pictures can be drawn without a display, by what, and how fast."""
    backend = os.environ.get("MUJOCO_GL", "")
    command = [sys.executable, "-m", "optimus.doctor.drawing", *(["robot"] if with_robot else [])]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return Finding("renderer", "broken", f"no picture within {SECONDS:.0f} s (MUJOCO_GL={backend})", _mend(backend))
    try:
        figures: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    except (IndexError, ValueError):
        lines = [line for line in done.stderr.splitlines() if line.strip()] or [f"it ended with status {done.returncode}"]
        return Finding("renderer", "broken", f"cannot draw (MUJOCO_GL={backend}): {lines[-1].strip()}", _mend(backend))
    if figures["colours"] < 2:
        return Finding("renderer", "broken", f"draws nothing (MUJOCO_GL={backend}, {figures['renderer']})", _mend(backend), figures)
    scene = "the stack task" if with_robot else "a plain scene"
    says = f"{figures['renderer']}: {figures['frame_ms']['median']:.1f} ms for a picture of {scene} in 84 x 84"
    return Finding("renderer", "works", says, figures=figures)


def _mend(backend: str) -> str:
    """What to do, by the library that was asked for."""
    if backend == "egl":
        return f"{MESA}, or set MUJOCO_GL=osmesa where libosmesa6 is installed"
    return f"unset MUJOCO_GL, for EGL is what this program takes of itself; if that does not work either, {MESA}"


def draw(with_robot: bool) -> dict[str, Any]:
    """Draw some pictures: by what, in how many CPU milliseconds each, and how many colours one has."""
    import mujoco
    import numpy as np
    from OpenGL import GL

    if with_robot:
        from optimus.tasks import task

        model, data = _start_of(task("stack"))
    else:
        model = mujoco.MjModel.from_xml_string(PLAIN)
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
    times = []
    picture = np.zeros((84, 84, 3), np.uint8)
    with mujoco.Renderer(model, 84, 84) as made:
        for _ in range(FRAMES):
            began = time.process_time()
            made.update_scene(data, "agentview")
            picture = made.render()
            times.append(time.process_time() - began)
        name = GL.glGetString(GL.GL_RENDERER)
    colours = len(np.unique(picture.reshape(-1, 3), axis=0))
    words = name.decode() if isinstance(name, bytes) else str(name)
    return {"renderer": words, "frame_ms": quantiles(times[1:], 95, scale=1e3), "colours": colours}


def _start_of(task: Any) -> tuple[Any, Any]:
    from optimus.env import ManipulationEnv

    env = ManipulationEnv(task, images=False)
    env.reset(seed=0)
    return env.world.model, env.data


if __name__ == "__main__":
    sys.stdout.write(json.dumps(draw("robot" in sys.argv[1:])) + "\n")
