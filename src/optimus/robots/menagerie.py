"""Robot models of MuJoCo Menagerie: fetched once, verified by SHA-256, made fast to draw, cached."""

import contextlib
import hashlib
import json
import logging
import os
import shutil
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path

from optimus.errors import AssetError, StorageError
from optimus.robots import decimate
from optimus.robots.sources import Manifest, Source, default_sources, sha256_file

log = logging.getLogger(__name__)

RECORD = "optimus.json"  # digests of what was written; without it a folder is not a cached model


def fetch(
    model: str = "franka_emika_panda", *, cache: Path | None = None, sources: Sequence[Source] | None = None
) -> Path:
    """The folder of a robot's model, ready for `mujoco.MjSpec.from_file(folder / "panda.xml")`.

    The first call fetches, verifies and decimates (seconds), later ones verify the copy (milliseconds).
    Safe under concurrent calls and sudden ends: a folder appears whole or not at all. `AssetError` says what
    was tried when no source answers, `StorageError` when the cache cannot be written.
    """
    manifest = Manifest.named(model)
    root = (cache or cache_folder()) / "models"
    target = root / f"{model}-{manifest.digest[:12]}-v{decimate.VERSION}"
    if _intact(target):
        return target
    try:
        root.mkdir(parents=True, exist_ok=True)
        with _lock(root / f"{target.name}.lock"):
            if not _intact(target):
                _build(manifest, target, default_sources(manifest) if sources is None else sources)
    except OSError as error:
        remedy = "set OPTIMUS_CACHE to another folder"
        raise StorageError(f"cannot write the model cache {root}: {error} ({remedy})") from error
    return target


def cache_folder() -> Path:
    """`$OPTIMUS_CACHE`, else the platform's cache folder for this program."""
    if own := os.environ.get("OPTIMUS_CACHE"):
        return Path(own)
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "optimus"
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local") / "optimus"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "optimus"


def _intact(folder: Path) -> bool:
    """Whether every file is there as it was written."""
    try:
        digests: dict[str, str] = json.loads((folder / RECORD).read_text(encoding="utf-8"))
        return all(sha256_file(folder / name) == digest for name, digest in digests.items())
    except (OSError, ValueError):
        return False


def _build(manifest: Manifest, target: Path, sources: Sequence[Source]) -> None:
    """Write the model beside `target`, then rename it into place."""
    for left in target.parent.glob(f".{target.name}-*"):  # a process that was killed; we hold the lock
        shutil.rmtree(left, ignore_errors=True)
    scratch = tempfile.TemporaryDirectory(
        prefix=f".{target.name}-", dir=target.parent, ignore_cleanup_errors=True
    )
    with scratch as name:
        stage = Path(name) / "model"
        for path, content in _gather(manifest, sources, Path(name)).items():
            (stage / path).parent.mkdir(parents=True, exist_ok=True)
            (stage / path).write_bytes(content)
        decimate.prepare(stage, manifest.entry, exclude=manifest.exclude, keep=manifest.keep)
        pairs = ", ".join(f"{a} and {b}" for a, b in manifest.exclude)
        text = decimate.CHANGES.format(upstream=manifest.upstream, license=manifest.license, pairs=pairs)
        (stage / "CHANGES").write_text(text, encoding="utf-8")
        files = sorted(path for path in stage.rglob("*") if path.is_file())
        record = {path.relative_to(stage).as_posix(): sha256_file(path) for path in files}
        (stage / RECORD).write_text(json.dumps(record, indent=1), encoding="utf-8")
        if target.exists():  # damaged, else we were not here
            target.rename(Path(name) / "damaged")
        try:
            stage.rename(target)
        except OSError:
            if not _intact(target):  # where locks do not work, another process may have been first
                raise
    log.info("model %s is in %s", manifest.model, target)


def _gather(manifest: Manifest, sources: Sequence[Source], scratch: Path) -> dict[str, bytes]:
    """The content of every file, by its path, from the first source that has them all."""
    causes: list[str] = []
    for number, source in enumerate(sources):
        folder = scratch / f"source{number}"
        folder.mkdir()
        try:
            return _verified(manifest, source.locate(folder))
        except Exception as error:  # noqa: BLE001 - whatever a source fails of, it becomes a cause in the message below
            causes.append(f"{source.name}: {' '.join(str(error).split()) or type(error).__name__}")
            level = logging.WARNING if source.named_by_user else logging.INFO
            log.log(level, "no %s from %s", manifest.model, causes[-1])
    tried = "; ".join(f"({i}) {cause}" for i, cause in enumerate(causes, start=1)) or "no source at all"
    raise AssetError(
        f"no source gave the model {manifest.model}. Tried {tried}. Remedy: put MuJoCo Menagerie's folder"
        f" {manifest.model} ({manifest.entry}, LICENSE, assets/) into a folder of yours and set"
        " MENAGERIE_ROOT to the latter"
    )


def _verified(manifest: Manifest, folder: Path) -> dict[str, bytes]:
    content: dict[str, bytes] = {}
    for name, accepted in manifest.files.items():
        path = folder / name
        if not path.is_file():
            raise AssetError(f"{name} is missing in {folder}")
        content[name] = path.read_bytes()
        if (found := hashlib.sha256(content[name]).hexdigest()) not in accepted:
            raise AssetError(f"{name} has SHA-256 {found}, not {' or '.join(accepted)}")
    return content


@contextlib.contextmanager
def _lock(path: Path) -> Iterator[None]:
    """Let one process build at a time; the system frees the lock of a process that ends, however it ends.

    Where the system has no such locks, two may build, and the second finds the first one's result.
    """
    with contextlib.ExitStack() as stack:
        with contextlib.suppress(ImportError, OSError):
            import fcntl

            stream = stack.enter_context(path.open("w"))
            fcntl.flock(stream, fcntl.LOCK_EX)
        yield
