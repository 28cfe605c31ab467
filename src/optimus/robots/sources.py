"""Where a robot's model can come from: the user's own folder, the Menagerie downloader, a wheel that has it.

A source is a name and a function from a scratch folder to the folder that holds the model's files. It raises
an error with the cause when it has nothing to offer. What it brings is not trusted: the caller verifies every
file.
"""

import hashlib
import json
import os
import subprocess
import sys
import urllib.error
import urllib.request
import zipfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib import resources
from pathlib import Path
from typing import Any

from optimus.errors import AssetError, UnknownNameError

FOLDER_VARIABLES = ("MENAGERIE_ROOT", "OPTIMUS_ASSETS")
PROBE_TIMEOUT = 5.0  # [s] the downloader itself would try three times for a minute each
PIP_TIMEOUT = 300.0  # [s]


@dataclass(frozen=True)
class Manifest:
    """Which files make a model, with the SHA-256 digests accepted for each (upstream has mended some)."""

    model: str
    entry: str
    license: str
    upstream: str
    wheel: Mapping[str, str]
    files: Mapping[str, tuple[str, ...]]
    exclude: tuple[tuple[str, str], ...] = ()  # pairs of bodies that shall not touch
    keep: tuple[str, ...] = ()  # visual meshes that a camera sees from close by, not to be decimated
    digest: str = field(default="", compare=False)

    @classmethod
    def named(cls, model: str) -> "Manifest":
        """The pinned manifest of that model; `UnknownNameError` lists the known ones."""
        folder = resources.files("optimus.robots") / "manifests"
        known = {Path(entry.name).stem: entry for entry in folder.iterdir() if entry.name.endswith(".json")}
        if model not in known:
            raise UnknownNameError("robot model", model, known)
        text = known[model].read_text(encoding="utf-8")
        raw: dict[str, Any] = json.loads(text)
        raw["files"] = {name: tuple(digests) for name, digests in raw["files"].items()}
        raw["exclude"] = tuple((a, b) for a, b in raw["exclude"])
        return cls(**raw, digest=hashlib.sha256(text.encode()).hexdigest())


@dataclass(frozen=True)
class Source:
    """One place to ask; `locate(scratch)` returns the folder that holds the manifest's files."""

    name: str
    locate: Callable[[Path], Path]
    named_by_user: bool = False


def default_sources(manifest: Manifest) -> list[Source]:
    """The sources in the order they are asked: the user's own folders, the downloader, the wheel."""
    folders = [
        Source(f"{variable}={value}", lambda _scratch, root=value: _local_folder(Path(root), manifest), True)
        for variable in FOLDER_VARIABLES
        if (value := os.environ.get(variable))
    ]
    return [
        *folders,
        Source("the mujoco-menagerie downloader", lambda _scratch: _from_downloader(manifest)),
        Source(f"pip download {manifest.wheel['requirement']}", lambda path: _from_wheel(manifest, path)),
    ]


def sha256_file(path: Path) -> str:
    """Hex SHA-256 of a file."""
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def _local_folder(root: Path, manifest: Manifest) -> Path:
    for folder in (root / manifest.model, root):
        if (folder / manifest.entry).is_file():
            return folder
    raise AssetError(f"no {manifest.model}/{manifest.entry} in it")


def _from_downloader(manifest: Manifest) -> Path:
    """Ask the `mujoco-menagerie` package, which pins one archive of each model by digest.

    Its own download would keep an offline user waiting for minutes, so the archive's address is tried first.
    """
    import mujoco_menagerie

    robot = mujoco_menagerie.get(manifest.model)
    cache = mujoco_menagerie.Cache()
    cache.root = None  # MENAGERIE_ROOT is a source of its own, asked before
    if not cache.is_cached(robot):
        url = f"{cache.base_url}/{robot.asset}"
        try:
            with urllib.request.urlopen(urllib.request.Request(url, method="HEAD"), timeout=PROBE_TIMEOUT):
                pass
        except (urllib.error.URLError, OSError, ValueError) as error:
            raise AssetError(f"{url}: {getattr(error, 'reason', error)}") from error
    return cache.resolve(robot, progress=None)


def _from_wheel(manifest: Manifest, scratch: Path) -> Path:
    """Download the wheel with the user's own pip configuration and extract the folder; installs nothing."""
    command = [sys.executable, "-m", "pip", "download", manifest.wheel["requirement"], "--dest", str(scratch)]
    command += ["--no-deps", "--only-binary", ":all:", "--retries", "1", "--no-input", "--quiet"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=PIP_TIMEOUT, check=False)
    except subprocess.TimeoutExpired as error:
        raise AssetError(f"no answer in {PIP_TIMEOUT:.0f} s") from error
    if done.returncode:
        lines = [line for line in done.stderr.splitlines() if line.strip()]
        raise AssetError(lines[-1].strip() if lines else f"pip ended with status {done.returncode}")
    wheels = list(scratch.glob("*.whl"))
    if len(wheels) != 1:
        raise AssetError(f"pip left {len(wheels)} wheels, not one")
    if (found := sha256_file(wheels[0])) != manifest.wheel["sha256"]:
        raise AssetError(f"{wheels[0].name} has SHA-256 {found}, not {manifest.wheel['sha256']}")
    folder = scratch / "extracted"
    with zipfile.ZipFile(wheels[0]) as archive:
        for name in manifest.files:
            target = folder / name
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(archive.read(f"{manifest.wheel['folder']}/{name}"))
    return folder
