"""Every object by name: the library, made when first asked for and cached, and what the user has added."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from functools import lru_cache
from importlib import resources
from itertools import chain, count
from pathlib import Path
from typing import TYPE_CHECKING, Any

from optimus.assets import store
from optimus.errors import AssetError, UnknownNameError
from optimus.objects.blueprint import Blueprint
from optimus.objects.library import LIBRARY, SMALL
from optimus.objects.shapes import Shape
from optimus.robots.menagerie import cache_folder
from optimus.workers import executor

if TYPE_CHECKING:  # what makes objects loads trimesh and MuJoCo; to look one up shall be quick
    from optimus.assets.thing import Facts, Thing

SETS: dict[str, tuple[str, ...]] = {
    "19": SMALL,
    "72": tuple(LIBRARY),
    "unseen": tuple(name for name in LIBRARY if name not in SMALL),
}
"""Named sets of the library; `unseen` are those of 72 that are not of 19."""


MAKERS = (
    *(f"assets/{name}.py" for name in ("antipodal", "convex", "trial", "thing")),
    *("spec.py", "robots/model.py", "robots/catalogue.py"),
)
"""The code, besides the library's own, that decides what an object becomes."""


def user_folder() -> Path:
    """Where added objects lie: `$OPTIMUS_OBJECTS`, else the platform's data folder for this program."""
    if os.environ.get("OPTIMUS_OBJECTS"):
        return Path(os.environ["OPTIMUS_OBJECTS"]).expanduser()
    return Path(os.environ.get("XDG_DATA_HOME") or Path.home() / ".local/share") / "optimus" / "objects"


@lru_cache(maxsize=1)
def library_folder() -> Path:
    """Where the library's objects lie once they are made; another one for every version of the code that makes them."""
    package = Path(__file__).parent.parent
    digest = hashlib.sha256(str(store.FORMAT).encode())
    for path in [*sorted((package / "objects").rglob("*.py")), *(package / name for name in MAKERS)]:
        digest.update(path.read_bytes())
    return cache_folder() / "objects" / digest.hexdigest()[:16]


def added() -> dict[str, Path]:
    """The user's own objects: name -> folder."""
    root = user_folder()
    return folders_in(root) if root.is_dir() else {}


def folders_in(folder: Path) -> dict[str, Path]:
    """The prepared objects in a folder: name -> their folder."""
    return {p.name: p for p in sorted(folder.iterdir()) if (p / store.RECORD).is_file()}


def keys_of(objects: str) -> dict[str, str]:
    """Names, and where to find them (see `shape`), of the objects that `19`, `72`, `unseen`, `NAME,NAME...` (or categories) or a
    FOLDER of prepared objects stands for."""
    if objects in SETS:
        return {name: name for name in SETS[objects]}
    if Path(objects).is_dir() and folders_in(Path(objects)):
        return {name: str(path) for name, path in folders_in(Path(objects)).items()}
    known = [*LIBRARY, *added()]
    found: list[str] = []
    for name in objects.split(","):
        if name in known:
            found.append(name)
        elif name in (categories := by_category()):
            found += categories[name]
        else:
            raise UnknownNameError("object", name, [*SETS, *sorted(categories), *known])
    return {name: name for name in found}


def by_category() -> dict[str, list[str]]:
    """The names of the objects of each category of the library, which are the same everywhere, and of the user's others."""
    found: dict[str, list[str]] = {}
    for blueprint in LIBRARY.values():
        found.setdefault(blueprint.category, []).append(blueprint.name)
    fixed = set(found)
    for name, folder in added().items():
        with suppress(AssetError):  # a damaged one is complained of when it is asked for
            if (category := store.record(folder).get("category", "own")) not in fixed:
                found.setdefault(category, []).append(name)
    return found


def folder_of(name: str) -> Path:
    """Where an object lies, made first if it is one of the library that is not there yet."""
    if (Path(name) / store.RECORD).is_file():
        return Path(name)
    own = added()
    if name in own:
        return own[name]
    if name not in LIBRARY:
        raise UnknownNameError("object", name, [*LIBRARY, *own])
    folder = library_folder() / name
    if not (folder / store.RECORD).is_file():
        make(name)
    return folder


@lru_cache(maxsize=256)
def shape(name: str) -> Shape:
    """The shape of an object: the same one every time in a process."""
    return store.load(folder_of(name))


class ObjectSet(Mapping[str, Shape]):
    """Shapes by name, each read when it is first asked for."""

    def __init__(self, objects: str) -> None:
        """`objects` as `keys_of` takes it."""
        self._keys = keys_of(objects)

    def __getitem__(self, name: str) -> Shape:
        return shape(self._keys[name])

    def __iter__(self) -> Iterator[str]:
        return iter(self._keys)

    def __len__(self) -> int:
        return len(self._keys)


def facts_of(blueprint: Blueprint) -> Facts:
    """The facts of a blueprint."""
    from optimus.assets.thing import Facts

    b = blueprint
    return Facts(b.name, b.category, b.words, b.mass, b.friction, b.rgba, b.symmetric)


def make(name: str) -> None:
    """Make one object of the library and put it into the cache."""
    from optimus.assets.thing import prepare

    blueprint = LIBRARY[name]
    try:
        # several processes may come to need it at once, and each makes the same
        keep(prepare(blueprint.solid(), facts_of(blueprint)), library_folder() / name, replace=False)
    except AssetError as error:
        raise AssetError(f"{name} {error}") from error


def keep(thing: Thing, folder: Path, replace: bool = True) -> None:
    """Write a thing with its picture; `replace` as `store.save` takes it."""
    from optimus.assets.picture import picture, png

    store.save(thing, folder, png(picture(thing.shape)), replace)


def missing() -> list[str]:
    """Objects of the library that are not in the cache."""
    return [name for name in LIBRARY if not (library_folder() / name / store.RECORD).is_file()]


def make_all(names: Iterable[str], workers: int, progress: Callable[[], None]) -> None:
    """Make objects of the library, several at a time; each is kept as soon as it is there."""
    with executor(workers) as pool:
        futures = []
        for name in names:
            futures.append(pool.submit(make, name))
            futures[-1].add_done_callback(lambda _: progress())
        for future in futures:
            future.result()


def described(name: str) -> dict[str, Any]:
    """What is known of an object, JSON-able; `success` is how often the expert picked and placed it, of how many, if measured."""
    about = store.record(folder_of(name))
    return {**about, "success": measured().get(about["name"])}


@lru_cache(maxsize=1)
def measured() -> dict[str, tuple[int, int]]:
    """Successes and episodes of the expert's pick-place, by object, as last measured for docs/results/objects.md."""
    found = json.loads(resources.files("optimus.assets").joinpath("success.json").read_text())
    return {name: (int(k), int(n)) for name, (k, n) in found["objects"].items()}


def add(thing: Thing) -> str:
    """Put a thing among the user's own objects, under its name or, if that is taken, the next free one; the name it has there."""
    taken = {*SETS, *by_category(), *LIBRARY, *added()}
    wanted = thing.facts.name
    name = next(n for n in chain([wanted], (f"{wanted}-{k}" for k in count(2))) if n not in taken)
    named = replace(thing, facts=replace(thing.facts, name=name), shape=replace(thing.shape, kind=name))
    keep(named, user_folder() / name)
    return name


def remove(name: str) -> None:
    """Take one of the user's own objects away."""
    own = added()
    if name not in own:
        raise UnknownNameError("object of your own", name, own)
    shutil.rmtree(own[name])


