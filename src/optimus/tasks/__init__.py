"""Every task, by name. Adding one touches its own file and this table."""

from __future__ import annotations

from dataclasses import replace
from importlib import import_module
from typing import TYPE_CHECKING

from optimus.errors import UnknownNameError

if TYPE_CHECKING:
    from optimus.task import Task

TASKS: dict[str, str] = {
    "stack": "optimus.tasks.stack:STACK",
    "stack-three": "optimus.tasks.stack:STACK_THREE",
    "stack-four": "optimus.tasks.stack:STACK_FOUR",
    "stack-five": "optimus.tasks.stack:STACK_FIVE",
    "stack-adapt": "optimus.tasks.stack_adapt:STACK_ADAPT",
    "pick-place": "optimus.tasks.pick_place:PICK_PLACE",
    "pick-place-two": "optimus.tasks.pick_place_many:PICK_PLACE_TWO",
    "pick-place-three": "optimus.tasks.pick_place_many:PICK_PLACE_THREE",
    "pick-place-four": "optimus.tasks.pick_place_many:PICK_PLACE_FOUR",
    "shelf": "optimus.tasks.shelf:SHELF",
    "shelf-receptacle": "optimus.tasks.shelf:SHELF_RECEPTACLE",
    "microwave": "optimus.tasks.microwave:MICROWAVE",
    "microwave-receptacle": "optimus.tasks.microwave:MICROWAVE_RECEPTACLE",
    "microwave-adapt": "optimus.tasks.microwave:MICROWAVE_ADAPT",
}
"""Name -> `module:attribute`; a task's module is imported when the task is first asked for."""


def task(name: str) -> Task:
    """The task of that name, or of `module:ATTRIBUTE` for one outside the package; `UnknownNameError` lists the known ones.
    After an `@` comes what it is done with: `pick-place@72`, `shelf@mug,bottle-1` (`optimus.assets.catalogue.keys_of`)."""
    base, _, objects = name.partition("@")
    found = _named(base)
    if not objects:
        return found
    from optimus.assets.catalogue import ObjectSet

    return found.over(name, ObjectSet(objects))


def with_objects(name: str, objects: str | None) -> str:
    """The name of that task with those objects, whichever it had."""
    return name if objects is None else f"{name.partition('@')[0]}@{objects}"


def _named(name: str) -> Task:
    from optimus.task import Task

    place = TASKS.get(name, name)
    module, _, attribute = place.partition(":")
    if not attribute:
        raise UnknownNameError("task", name, TASKS)
    try:
        names = vars(import_module(module))
    except (ImportError, ValueError) as error:
        away = isinstance(error, ModuleNotFoundError) and error.name == module.partition(".")[0]
        hint = f"; put its folder into PYTHONPATH: {error}" if away else f": {error}"
        raise UnknownNameError("task", f"{name} (module:NAME{hint})", TASKS) from error
    if attribute not in names:
        raise UnknownNameError("task", name, [f"{module}:{key}" for key, value in names.items() if isinstance(value, Task)])
    if not isinstance(found := names[attribute], Task):
        raise UnknownNameError("task", f"{name} (a {type(found).__name__}, not a Task)", TASKS)
    return found if found.name == name else replace(found, name=name)  # what records call it must lead back to it
