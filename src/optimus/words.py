"""Plain English for what a scene holds and what a goal asks for: "put the blue mug on the right platform".

What a person would say, from what a camera shows: colours and kinds, and where two things share those, which side they are on.
Left and right are the robot's own (the base frame's +y is left), near and far are along +x.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import lru_cache

import numpy as np

from optimus.assets import store
from optimus.assets.catalogue import added
from optimus.logic import Atom, Facts
from optimus.objects.library import LIBRARY
from optimus.objects.shapes import Rgba, Shape
from optimus.predicates import On, Released
from optimus.scene import Scene
from optimus.se3 import Pose

COLOURS: dict[str, tuple[int, int, int]] = {
    "red": (217, 33, 33),
    "orange": (235, 130, 35),
    "yellow": (240, 185, 30),
    "green": (60, 155, 70),
    "teal": (45, 150, 135),
    "sky blue": (120, 180, 220),
    "blue": (40, 90, 200),
    "purple": (135, 65, 160),
    "pink": (232, 140, 170),
    "brown": (145, 95, 55),
    "tan": (198, 158, 105),
    "white": (245, 244, 240),
    "light grey": (205, 206, 210),
    "grey": (140, 143, 148),
    "dark grey": (80, 85, 95),
    "black": (30, 31, 34),
}
"""The names that are used, each with a typical colour (sRGB, 0 to 255)."""
SIDE_BY_SIDE = 0.03
"""Things that are less apart than this [m] along an axis are not told apart by it."""
SENTENCES = {
    "Holding": "pick up {0}",
    "HandEmpty": "let go of what is held",
    "Clear": "clear {0}",
    "Open": "open {0}",
    "Shut": "close {0}",
}
"""What is said of a fact that is wanted; `On` has a preposition of its own, `Released` goes without saying."""


@lru_cache(maxsize=256)
def colour_name(rgba: Rgba) -> str:
    """The nearest of `COLOURS`, by distance in CIE L*a*b* (which is near to how different colours look)."""
    wanted = _lab(np.array(rgba[:3]))
    return min(COLOURS, key=lambda name: float(np.linalg.norm(_lab(np.array(COLOURS[name]) / 255) - wanted)))


def _lab(rgb: np.ndarray) -> np.ndarray:
    """CIE 1976 L*a*b* of an sRGB colour in 0 to 1 (IEC 61966-2-1, white point D65)."""
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    matrix = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
    xyz = matrix @ linear / (0.9505, 1.0, 1.0890)
    f = np.where(xyz > (6 / 29) ** 3, np.cbrt(xyz), xyz / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


def words_of(shape: Shape) -> str:
    """A noun phrase for a shape, without article: what the library or the user's own objects say of it, else colour and kind."""
    return _known(shape.kind) or f"{colour_name(shape.rgba)} {shape.kind.replace('-', ' ').replace('_', ' ')}"


@lru_cache(maxsize=256)
def _known(kind: str) -> str:
    if kind in LIBRARY:
        return LIBRARY[kind].words
    own = added()
    return str(store.record(own[kind])["words"]) if kind in own else ""


def names_in(scene: Scene, poses: Mapping[str, Pose]) -> dict[str, str]:
    """A noun phrase with its article for every thing of the scene, no two the same; `poses` are where the movables are."""
    plain = {m.name: m.words or words_of(m.shape) for m in scene.movables}
    plain |= {f.name: f.words or f.name.replace("_", " ") for f in scene.fixtures}
    plain |= {d.name: d.name.replace("_", " ") for d in scene.doors}
    places = {name: pose.pos for name, pose in {**scene.fixture_poses, **poses}.items()}
    places |= {d.name: np.array(d.hinge) for d in scene.doors}
    found: dict[str, str] = {}
    for phrase in dict.fromkeys(plain.values()):
        alike = [name for name, words in plain.items() if words == phrase]
        sides = _sides([places[name] for name in alike]) if len(alike) > 1 else [""]
        found |= {name: f"the {side} {phrase}".replace("  ", " ") for name, side in zip(alike, sides, strict=True)}
    return found


def _sides(places: Sequence[np.ndarray]) -> list[str]:
    """A word or two for each place by which it differs from the others; numbers from the left where no side tells them apart."""
    points = np.array(places)
    across, along = _ends(points[:, 1], "right", "left"), _ends(points[:, 0], "near", "far")
    for said in (across, along, [f"{x} {y}".strip() for x, y in zip(along, across, strict=True)]):
        if all(said) and len(set(said)) == len(said):
            return said
    order = np.lexsort((points[:, 0], -points[:, 1]))
    return [("first", "second", "third", "fourth", "fifth", "sixth")[i] if i < 6 else f"number {i + 1}" for i in np.argsort(order)]


def _ends(values: np.ndarray, low: str, high: str) -> list[str]:
    """`low` or `high` for each value, by the middle of their range; nothing where they hardly differ."""
    if np.ptp(values) < SIDE_BY_SIDE:
        return [""] * len(values)
    middle = (values.min() + values.max()) / 2
    return [high if value > middle else low for value in values]


def instruction(scene: Scene, poses: Mapping[str, Pose], goal: Facts) -> str:
    """The goal as one would tell somebody: what has to be done first comes first."""
    names = names_in(scene, poses)
    placed = {a.args[0]: a.args[1] for a in goal if a.predicate == On.name}
    ordered = sorted(placed, key=lambda thing: (_depth(thing, placed), _rank(scene, thing)))
    parts = [_placing(scene, thing, placed[thing], names, again=i > 0) for i, thing in enumerate(ordered)]
    parts += [_wish(atom, names) for atom in sorted(goal) if atom.predicate not in (On.name, Released.name)]
    if len(parts) < 2:
        return parts[0] if parts else "do nothing"
    in_turn = any(_depth(thing, placed) > 1 for thing in placed)
    return f"{', '.join(parts[:-1])} and {'then ' if in_turn else ''}{parts[-1]}"


def _depth(thing: str, placed: Mapping[str, str]) -> int:
    """How many of the goal's own things are below it: those have to be there first. A circle, which nothing can satisfy, ends."""
    below, seen = placed[thing], {thing}
    while below in placed and below not in seen:
        seen.add(below)
        below = placed[below]
    return len(seen)


def _rank(scene: Scene, thing: str) -> int:
    return scene.movable_names.index(thing)


def _placing(scene: Scene, thing: str, support: str, names: Mapping[str, str], again: bool) -> str:
    preposition = "in" if _contains(scene.shape_of(support)) else "on"
    return f"{'' if again else 'put '}{names[thing]} {preposition} {names[support]}"


def _contains(shape: Shape) -> bool:
    """Whether what rests on it lies within its walls."""
    return shape.surface is not None and shape.surface.z < shape.half_extents[2] - 1e-3


def _wish(atom: Atom, names: Mapping[str, str]) -> str:
    return SENTENCES.get(atom.predicate, f"make true: {atom}").format(*(names[a] for a in atom.args))


def slug(text: str) -> str:
    """A name for a file or folder."""
    return re.sub(r"[^a-z0-9@.=+]+", "-", text.lower()).strip("-")
