"""One process at a time in a folder."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from optimus.data.atomic import make_folder
from optimus.errors import StorageError

LOCK_FILE = ".lock"


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Nobody else who asks for it works in this folder (made if need be) until the block ends; `StorageError` if somebody does.

    The system gives the folder free when the process dies, however it does. Nothing is left behind, no folder either in which
    nothing else was written. Where there are no locks (another system, some network folders) nobody is kept out.
    """
    try:
        import fcntl  # of POSIX systems
    except ImportError:
        yield
        return
    make_folder(folder)
    try:
        file = (folder / LOCK_FILE).open("a")
    except OSError as error:
        raise StorageError(f"cannot write to {folder}: {error.strerror or error}") from error
    with file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise StorageError(f"another process is at work in {folder}; wait for it, or name another folder") from None
        except OSError:
            pass
        try:
            yield
        finally:
            with suppress(OSError):
                (folder / LOCK_FILE).unlink()
                folder.rmdir()  # only an empty one goes
