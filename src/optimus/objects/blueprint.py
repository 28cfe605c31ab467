"""Blueprints: objects whose shape is a mesh, made when it is asked for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from optimus.objects.shapes import Rgba

if TYPE_CHECKING:
    import trimesh


@dataclass(frozen=True)
class Blueprint:
    """An object of the library."""

    name: str
    """Category and number: `mug-2`; unique."""
    category: str
    words: str
    """An English noun phrase without its article, unique in the library: `blue mug with a round handle`."""
    mass: float
    """[kg]"""
    friction: float
    """Coefficient of sliding friction."""
    rgba: Rgba
    solid: Callable[[], trimesh.Trimesh]
    """Makes the mesh: metres, z up as the object stands, the origin on the ground it stands on; watertight and of one piece."""
    symmetric: bool = False
    """True for a body of revolution about z: its yaw means nothing."""
