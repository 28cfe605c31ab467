"""Small policies that come with the package: `pretrained:NAME` wherever a policy to play is asked for."""

from __future__ import annotations

import hashlib
import shutil
from pathlib import Path

from optimus.data.atomic import written_aside
from optimus.errors import UnknownNameError
from optimus.robots.menagerie import cache_folder

PREFIX = "pretrained:"
SHIPPED = Path(__file__).parent
CONFIG_FILE = "config.json"
"""In every policy's folder."""


def names() -> list[str]:
    """The policies there are, by the task they were trained for."""
    return sorted(path.parent.name for path in SHIPPED.glob(f"*/{CONFIG_FILE}"))


def trained_folder(run: Path | str) -> Path:
    """`run_folder`; of a folder of the main job (`optimus run`) that of its policy."""
    folder = run_folder(run)
    of_job = folder / "policy"
    return of_job if not (folder / CONFIG_FILE).exists() and (of_job / CONFIG_FILE).exists() else folder


def run_folder(run: Path | str) -> Path:
    """`run`; for `pretrained:NAME`, a copy of that policy in the user's cache, where outcomes may be written beside it.
    `UnknownNameError` lists the names."""
    name = str(run)
    if not name.startswith(PREFIX):
        return Path(run)
    name = name.removeprefix(PREFIX)
    if name not in names():
        raise UnknownNameError("pretrained policy", name, names())
    shipped = SHIPPED / name
    digest = hashlib.sha256(b"".join(file.read_bytes() for file in sorted(shipped.iterdir()))).hexdigest()[:12]
    folder = cache_folder() / "pretrained" / f"{name}-{digest}"
    if not folder.is_dir():
        with written_aside(folder, marker=CONFIG_FILE) as made:
            shutil.copytree(shipped, made)
    return folder
