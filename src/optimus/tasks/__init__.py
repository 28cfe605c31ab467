"""Every task, by name."""

from optimus.errors import UnknownNameError
from optimus.task import Task
from optimus.tasks.pick_place import PICK_PLACE
from optimus.tasks.stack import STACK

TASKS: dict[str, Task] = {task.name: task for task in (STACK, PICK_PLACE)}


def task(name: str) -> Task:
    """The task of that name; `UnknownNameError` lists the known ones."""
    if name not in TASKS:
        raise UnknownNameError("task", name, TASKS)
    return TASKS[name]
