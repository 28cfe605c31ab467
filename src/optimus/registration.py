"""Makes every task a Gymnasium environment: `import optimus; gymnasium.make("optimus/Stack-v0")`."""

from __future__ import annotations

from typing import Any

import gymnasium

from optimus.tasks import TASKS
from optimus.tasks import task as task_named


def gym_id(task: str) -> str:
    """`pick-place` -> `optimus/PickPlace-v0`."""
    return f"optimus/{''.join(word.capitalize() for word in task.split('-'))}-v0"


def make_env(task: str, **options: Any) -> gymnasium.Env[Any, Any]:
    """The environment of a task by name; `options` as for `ManipulationEnv`."""
    from optimus.env import ManipulationEnv

    return ManipulationEnv(task_named(task), **options)


def register() -> None:
    """Register every task with Gymnasium; none is imported before it is made."""
    for name in TASKS:
        if gym_id(name) not in gymnasium.registry:
            gymnasium.register(id=gym_id(name), entry_point="optimus.registration:make_env", kwargs={"task": name})
