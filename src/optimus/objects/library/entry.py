"""How an entry of the library is written down, and the colours and materials it is made of."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from optimus.objects import solids
from optimus.objects.blueprint import Blueprint
from optimus.objects.shapes import Rgba

if TYPE_CHECKING:
    import trimesh

# coefficients of sliding friction
METAL = 0.55
GLAZED = 0.6
PLASTIC = 0.65
PAPER = 0.7
WOOD = 0.75
CLAY = 0.8
RUBBER = 1.0


def colour(code: str) -> Rgba:
    """From the web's notation: `#e0a030`."""
    r, g, b = (int(code[k : k + 2], 16) / 255 for k in (1, 3, 5))
    return (r, g, b, 1.0)


WHITE = colour("#ecebe4")
BLACK = colour("#303236")
GREY = colour("#8d9299")
SILVER = colour("#b9bfc6")
RED = colour("#c8372d")
ORANGE = colour("#e8802a")
YELLOW = colour("#eec332")
GOLD = colour("#d4a52f")
GREEN = colour("#4a9a4c")
DARK_GREEN = colour("#2f6b45")
TEAL = colour("#2a9a94")
BLUE = colour("#2f68b8")
SKY = colour("#74b4dc")
PURPLE = colour("#7b4fa3")
PINK = colour("#e68aa6")
BROWN = colour("#8a5a34")
TAN = colour("#c59a63")
TERRACOTTA = colour("#c2673f")
CREAM = colour("#eadcb8")


def entry(
    name: str, words: str, mass: float, friction: float, rgba: Rgba, make: Callable[[], solids.Solid], symmetric: bool = False
) -> Blueprint:
    """`name` is the category and a number; `mass` in kg; `make` gives the solid in millimetres."""
    return Blueprint(name, name.rsplit("-", 1)[0], words, mass, friction, rgba, partial(_mesh, make), symmetric)


def _mesh(make: Callable[[], solids.Solid]) -> trimesh.Trimesh:
    return solids.mesh(make())
