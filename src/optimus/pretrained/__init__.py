"""Small policies that come with the package: `pretrained:NAME` wherever the folder of a training run is asked for."""

from __future__ import annotations

import hashlib
import shutil
from pathlib import Path

from optimus.data.atomic import written_aside
from optimus.errors import UnknownNameError
from optimus.robots.menagerie import cache_folder

PREFIX = "pretrained:"
SHIPPED = Path(__file__).parent
CONFIG_FILE, MODEL_FILE = "config.json", "model.safetensors"
"""What every policy's folder holds."""


def names() -> list[str]:
    """The policies there are, by the task they were trained for."""
    return sorted(path.parent.name for path in SHIPPED.glob(f"*/{CONFIG_FILE}"))


def run_folder(run: Path | str) -> Path:
    """`run`; for `pretrained:NAME`, a copy of that policy in the user's cache, where outcomes may be written beside it.
    `UnknownNameError` lists the names."""
    name = str(run)
    if not name.startswith(PREFIX):
        return Path(run)
    name = name.removeprefix(PREFIX)
    if name not in names():
        raise UnknownNameError("pretrained policy", name, names())
    files = [SHIPPED / name / file for file in (CONFIG_FILE, MODEL_FILE)]
    digest = hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()[:12]
    folder = cache_folder() / "pretrained" / f"{name}-{digest}"
    if not folder.is_dir():
        with written_aside(folder, marker=CONFIG_FILE) as made:
            made.mkdir(parents=True)
            for file in files:
                shutil.copyfile(file, made / file.name)
    return folder
