"""Makes every task a Gymnasium environment: `import optimus; gymnasium.make("optimus/Stack-v0")`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import gymnasium

from optimus.tasks import TASKS
from optimus.tasks import task as task_named


def gym_id(task: str) -> str:
    """`pick-place` -> `optimus/PickPlace-v0`."""
    return f"optimus/{''.join(word.capitalize() for word in task.split('-'))}-v0"


ANY = "optimus/Task-v0"
"""The environment of whichever task is named: `gymnasium.make(ANY, task="pick-place@mug")`."""


def made_by(task: str) -> tuple[str, dict[str, Any]]:
    """What Gymnasium makes the environment of a task by: an id, and what to give with it."""
    return (gym_id(task), {}) if task in TASKS else (ANY, {"task": task})


def make_env(task: str, **options: Any) -> gymnasium.Env[Any, Any]:
    """The environment of a task by name; `options` as for `ManipulationEnv`, and cameras as datasets record them."""
    from optimus.env import ManipulationEnv
    from optimus.scene import Camera

    if isinstance(cameras := options.get("cameras"), (list, tuple)):
        options["cameras"] = [Camera.of(c) if isinstance(c, Mapping) else c for c in cameras]
    return ManipulationEnv(task_named(task), **options)


def register() -> None:
    """Register every task with Gymnasium; none is imported before it is made."""
    if ANY not in gymnasium.registry:
        gymnasium.register(id=ANY, entry_point="optimus.registration:make_env")
    for name in TASKS:
        if gym_id(name) not in gymnasium.registry:
            gymnasium.register(id=gym_id(name), entry_point="optimus.registration:make_env", kwargs={"task": name})
