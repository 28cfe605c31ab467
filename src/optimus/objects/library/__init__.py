"""The library: 72 household objects in 26 categories, drawn here as parametric solids.

Nothing is built on import; `LIBRARY["mug-1"].solid()` makes a mesh.
"""

from __future__ import annotations

from optimus.objects.blueprint import Blueprint
from optimus.objects.library import cups, food, home, kitchen, tools, toys, vessels

_THINGS = (*cups.THINGS, *vessels.THINGS, *kitchen.THINGS, *home.THINGS, *tools.THINGS, *food.THINGS, *toys.THINGS)

LIBRARY: dict[str, Blueprint] = {thing.name: thing for thing in _THINGS}
"""By name; the order is fixed, for it numbers the objects in data that was collected."""

SMALL: tuple[str, ...] = (
    "mug-1", "cup-1", "bowl-1", "vase-1", "bottle-1", "can-1", "jar-1", "pitcher-2", "pot-3", "basket-1",
    "box-1", "book-1", "magnet-1", "hammer-1", "fruit-1", "candle-1", "weight-1", "chess-1", "block-1",
)  # fmt: skip
"""The simplest to handle, of as many categories."""
