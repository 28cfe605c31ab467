"""Where files come from and go to: the robot's model, the cache, the home, free space."""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path

from optimus.data.atomic import make_folder
from optimus.doctor.finding import Finding
from optimus.errors import AssetError, StorageError
from optimus.robots.menagerie import cache_folder, fetch

LITTLE_SPACE, NO_SPACE = 2.0, 0.2
"""Free space [GB] below which a warning is due (a thousand demonstrations take about 5 GB), or nothing will work."""


def why_unwritable(folder: Path) -> str:
    """Why no file can be made in `folder`; empty where one can."""
    try:
        with tempfile.TemporaryFile(dir=folder) as file:  # tried, not asked: root may not write where the disk is read-only
            file.write(b"written")
    except OSError as error:
        return error.strerror or str(error)
    return ""


def cache() -> Finding:
    """The folder for robot models and the library of objects."""
    folder = cache_folder()
    try:
        make_folder(folder)
    except StorageError as error:
        why = getattr(error.__cause__, "strerror", None) or str(error)
    else:
        why = why_unwritable(folder)
    if why:
        mend = "set OPTIMUS_CACHE to a folder that you can write to: export OPTIMUS_CACHE=/tmp/optimus"
        return Finding("cache", "broken", f"cannot write to {folder}: {why}", mend)
    return Finding("cache", "works", str(folder))


def home() -> Finding:
    """The home: other programs' settings and the user's own objects go there, nothing that cannot go elsewhere."""
    folder = Path.home()
    if why := why_unwritable(folder):
        mend = "set OPTIMUS_CACHE, OPTIMUS_OBJECTS (for objects of your own) and MPLCONFIGDIR to folders elsewhere"
        return Finding("home", "optional", f"cannot write to {folder}: {why}", mend)
    return Finding("home", "works", str(folder))


def folder() -> Finding:
    """The present folder, where `runs/x` and `data/x` would lie."""
    here = Path.cwd()
    if why := why_unwritable(here):
        mend = "give --out a folder elsewhere, or go to another one"
        return Finding("folder", "optional", f"cannot write to {here}: {why}", mend)
    return Finding("folder", "works", str(here))


def disk() -> Finding:
    """Free space where the cache and the present folder are; the smaller one decides."""
    places = [_existing(cache_folder()), Path.cwd()]
    free = {str(place): round(shutil.disk_usage(place).free / 1e9, 2) for place in places}
    place, least = min(free.items(), key=lambda item: item[1])
    says, figures = f"{least:g} GB free at {place}", {"free_gb": free}
    if least >= LITTLE_SPACE:
        return Finding("disk", "works", says, figures=figures)
    mend = "make room, or set OPTIMUS_CACHE and --out to another disk"
    return Finding("disk", "broken" if least < NO_SPACE else "optional", says, mend, figures)


def _existing(path: Path) -> Path:
    while not path.exists() or not os.access(path, os.R_OK):
        path = path.parent
    return path


def robot() -> Finding:
    """The Panda's model, verified; fetched if it is not there."""
    try:
        return Finding("robot", "works", f"Franka Emika Panda in {fetch()}")
    except AssetError as error:
        says, _, remedy = str(error).partition(" Remedy: ")
        return Finding("robot", "broken", says, remedy or "set MENAGERIE_ROOT to a copy of MuJoCo Menagerie")
    except StorageError as error:
        return Finding("robot", "broken", str(error), "set OPTIMUS_CACHE to a folder that you can write to")
