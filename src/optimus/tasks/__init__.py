"""Every task, by name. Adding one touches its own file and this table."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

from optimus.errors import UnknownNameError

if TYPE_CHECKING:
    from optimus.task import Task

TASKS: dict[str, str] = {
    "stack": "optimus.tasks.stack:STACK",
    "pick-place": "optimus.tasks.pick_place:PICK_PLACE",
}
"""Name -> `module:attribute`; a task's module is imported when the task is first asked for."""


def task(name: str) -> Task:
    """The task of that name; `UnknownNameError` lists the known ones."""
    if name not in TASKS:
        raise UnknownNameError("task", name, TASKS)
    module, attribute = TASKS[name].split(":")
    return getattr(import_module(module), attribute)
