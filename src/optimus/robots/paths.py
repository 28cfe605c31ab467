"""Where a robot's files are: beside the robot file, at an absolute path, or inside an installed Python package."""

from __future__ import annotations

from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

from optimus.errors import RobotFileError

PACKAGE = "package:"


def find_model(reference: str, folder: Path) -> Path:
    """The file that `reference` names: a path (relative ones start at `folder`), or `package:NAME/END`, a file of an installed
    distribution whose path ends with END. `RobotFileError` says what is missing."""
    if reference.startswith(PACKAGE):
        return _in_package(reference)
    path = folder / Path(reference).expanduser()
    if not path.is_file():
        raise RobotFileError(f"no model file {path}")
    return path.resolve()


def _in_package(reference: str) -> Path:
    """The file of `package:NAME/END`."""
    name, _, end = reference.removeprefix(PACKAGE).partition("/")
    try:
        found = distribution(name)
    except (PackageNotFoundError, ValueError) as error:
        raise RobotFileError(f"the package {name!r} of {reference} is not installed: pip install {name}") from error
    # some wheels put their data below a prefix of their own (cmeel.prefix/share/...): the end of the path is enough
    files = [file.as_posix() for file in found.files or ()]
    matches = [file for file in files if f"/{file}".endswith(f"/{end}")]
    if len(matches) == 1:
        return Path(str(found.locate_file(matches[0]))).resolve()
    if matches:
        raise RobotFileError(f"{reference} fits several files of {name}: {', '.join(matches)}")
    there = [file for file in files if file.endswith(".urdf")] or [file for file in files if file.endswith(".xml")]
    raise RobotFileError(f"no file {end} in the package {name}; its models: {', '.join(there) or 'none'}")


def find_mesh(uri: str, urdf: Path) -> Path:
    """The file of a mesh in a URDF: a path from the URDF's folder, `file://` or `package://NAME/...`, where NAME is a folder in or
    above the URDF's, as ROS lays its packages out. `RobotFileError` when it is not there."""
    if uri.startswith("package://"):
        inside = uri.removeprefix("package://")
        below_name = inside.partition("/")[2]
        choices = [above / end for end in (inside, below_name) for above in urdf.parents]
    else:
        choices = [urdf.parent / uri.removeprefix("file://")]
    for path in choices:
        if path.is_file():
            return path.resolve()
    raise RobotFileError(f"{urdf} names a mesh that is not there: {uri}")
