"""Robot files: TOML that names a model and what is where in it; all that can be derived from the model may be left out."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from optimus.errors import RobotFileError
from optimus.objects.shapes import Vec3
from optimus.robots.derive import CAMERA_POS, CAMERA_TARGET, derive
from optimus.robots.model import assemble, names
from optimus.robots.paths import find_model
from optimus.robots.robot import GRIPPER_PREFIX, Mount, Quat, Robot
from optimus.se3 import Array, quat_from_rotvec, quat_mul

POSE_KEYS = {"pos", "rpy"}
KEYS = {
    "": {"name", "model", "joints", "home", "hand", "tcp", "base", "gripper", "camera", "torque_limits", "speed_limits"},
    "gripper": {"model", "mount", "joints", "bodies", "actuator", "shut", "open", "pad"},
    "gripper.mount": {"body", *POSE_KEYS},
    "gripper.pad": {"pos", "half"},
    "tcp": POSE_KEYS,
    "base": POSE_KEYS,
    "camera": {"pos", "target", "fovy"},
}
"""What each table may hold; "" is the file itself."""
NEEDED = {
    "": ("model", "joints", "home", "gripper"),
    "gripper": ("joints", "bodies"),
    "gripper.mount": ("body",),
    "gripper.pad": ("pos", "half"),
}
"""What each table must hold, if it is there."""


def read_robot(path: Path) -> Robot:
    """The robot of a robot file (docs/add_a_robot.md); what it leaves out is derived from the model. `RobotFileError` names
    what is wrong, and what there is instead."""
    try:
        raw = tomllib.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError as error:
        raise RobotFileError(f"no robot file {path}") from error
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise RobotFileError(f"{path} is not a robot file: {error}") from error
    try:
        return _robot(raw, path)
    except RobotFileError as error:
        raise RobotFileError(f"{path}: {error}") from error


def _robot(raw: dict[str, Any], path: Path) -> Robot:
    top = _Table("", raw)
    gripper = top.table("gripper")
    mount = _mount(gripper, path.parent)
    source = str(find_model(top.word("model"), path.parent))
    robot = _as_written(top, mount, source, path.stem)
    spec = assemble(source, mount)
    _require("joint", [*robot.joints, *robot.fingers], spec.joints)
    _require("body", [*robot.finger_bodies, robot.hand], spec.bodies)
    _require("actuator", [robot.gripper_actuator] if robot.gripper_actuator else [], spec.actuators)
    return derive(robot, spec, {key for key in ("shut", "open") if key in gripper.raw})


def _as_written(top: _Table, mount: Mount | None, source: str, name: str) -> Robot:
    """The robot as far as the file goes; limits that it leaves out are empty."""
    gripper, tcp, base, camera = (top.table(key) for key in ("gripper", "tcp", "base", "camera"))
    prefix, pad = "" if mount is None else GRIPPER_PREFIX, gripper.table("pad")
    joints = top.words("joints")
    count = len(joints)
    eye, looked_at = camera.vector("pos", CAMERA_POS), camera.vector("target", CAMERA_TARGET)
    if eye == looked_at:
        raise RobotFileError(f"[camera] stands at what it looks at: {list(eye)}")
    robot = Robot(
        name=top.word("name", name),
        source=source,
        joints=joints,
        fingers=_two(gripper, "joints", prefix),
        finger_bodies=_two(gripper, "bodies", prefix),
        hand=top.word("hand", None if mount is None else mount.body),
        tcp=tcp.vector("pos"),
        tcp_quat=tcp.turn(),
        home=top.numbers("home", count),
        torque_limits=top.positive("torque_limits", count) if "torque_limits" in top.raw else (),
        speed_limits=top.positive("speed_limits", count) if "speed_limits" in top.raw else (),
        finger_shut=gripper.pair("shut"),
        finger_open=gripper.pair("open"),
        gripper_actuator=prefix + gripper.word("actuator") if "actuator" in gripper.raw else None,
        pad_pos=pad.vector("pos") if pad.raw else None,
        pad_half=pad.vector("half"),
        camera_pos=eye,
        camera_target=looked_at,
        base_pos=base.vector("pos"),
        base_quat=base.turn(),
        mount=mount,
    )
    return replace(robot, camera_fovy=camera.positive("fovy", 1)[0]) if "fovy" in camera.raw else robot


def _two(gripper: _Table, key: str, prefix: str) -> tuple[str, str]:
    first, second = gripper.words(key, 2)
    return prefix + first, prefix + second


def _mount(gripper: _Table, folder: Path) -> Mount | None:
    if "model" not in gripper.raw:
        if "mount" in gripper.raw:
            raise RobotFileError("gripper.mount says where a gripper of its own goes, but gripper.model names none")
        return None
    place = gripper.table("mount")
    if not place.raw:
        raise RobotFileError("[gripper] has a model of its own, so it needs a mount: the arm's body that carries it")
    return Mount(str(find_model(gripper.word("model"), folder)), place.word("body"), place.vector("pos"), place.turn())


def _require(kind: str, wanted: Iterable[str], there: list[Any]) -> None:
    known = {thing.name for thing in there}
    for name in wanted:
        if name not in known:
            raise RobotFileError(f"no {kind} {name!r} in the model; there are: {names(there)}")


@dataclass(frozen=True)
class _Table:
    """A table of the file, with what it must and may hold."""

    where: str
    raw: dict[str, Any]

    def __post_init__(self) -> None:
        place = self._place
        if not isinstance(self.raw, dict):
            raise RobotFileError(f"{place} is not a table")
        unknown = sorted(set(self.raw) - KEYS[self.where])
        if unknown:
            raise RobotFileError(f"{place} has unknown keys: {', '.join(unknown)}; valid: {', '.join(sorted(KEYS[self.where]))}")
        missing = [key for key in NEEDED.get(self.where, ()) if key not in self.raw]
        if self.raw and missing:
            raise RobotFileError(f"{place} lacks {', '.join(missing)}")

    @property
    def _place(self) -> str:
        return f"[{self.where}]" if self.where else "the file"

    def _name(self, key: str) -> str:
        return f"{self.where}.{key}" if self.where else key

    def table(self, key: str) -> _Table:
        """A table in this one; empty if it is not there."""
        return _Table(self._name(key), self.raw.get(key, {}))

    def word(self, key: str, default: str | None = None) -> str:
        """A name; the file lacks what has no default either."""
        if key not in self.raw and default is None:
            raise RobotFileError(f"{self._place} lacks {key}")
        value = self.raw.get(key, default)
        if not isinstance(value, str) or not value:
            raise RobotFileError(f"{self._name(key)} is not a name: {value!r}")
        return value

    def words(self, key: str, count: int | None = None) -> tuple[str, ...]:
        """So many different names; any number of them without `count`."""
        value = self.raw[key]
        if not isinstance(value, list) or not value or not all(isinstance(v, str) for v in value):
            raise RobotFileError(f"{self._name(key)} is not a list of names: {value!r}")
        if (count is not None and len(value) != count) or len(set(value)) != len(value):
            raise RobotFileError(f"{self._name(key)} should be {count or 'some'} different names: {value!r}")
        return tuple(value)

    def numbers(self, key: str, count: int, default: Sequence[float] = ()) -> tuple[float, ...]:
        """So many numbers; `default`, or zeros, where the file has none."""
        value = self.raw.get(key, [*default] or [0.0] * count)
        value = value if isinstance(value, list) else [value]
        if len(value) != count or not all(isinstance(v, (int, float)) and not isinstance(v, bool) for v in value):
            raise RobotFileError(f"{self._name(key)} should be {count} number{'s' if count > 1 else ''}: {self.raw[key]!r}")
        if not all(map(math.isfinite, value)):
            raise RobotFileError(f"{self._name(key)} should be finite: {self.raw[key]!r}")
        return tuple(float(v) for v in value)

    def positive(self, key: str, count: int) -> tuple[float, ...]:
        """So many numbers above zero."""
        if min(value := self.numbers(key, count)) <= 0:
            raise RobotFileError(f"{self._name(key)} should be above 0: {self.raw[key]!r}")
        return value

    def vector(self, key: str, default: Vec3 = (0.0, 0.0, 0.0)) -> Vec3:
        """Three numbers."""
        x, y, z = self.numbers(key, 3, default)
        return (x, y, z)

    def pair(self, key: str) -> tuple[float, float]:
        """Two numbers."""
        a, b = self.numbers(key, 2)
        return (a, b)

    def turn(self) -> Quat:
        """The rotation `rpy` [rad] (about x, then y, then z, of the outer frame, as in URDF), wxyz."""
        roll, pitch, yaw = self.vector("rpy")
        about: list[Array] = [quat_from_rotvec(v) for v in ((0.0, 0.0, yaw), (0.0, pitch, 0.0), (roll, 0.0, 0.0))]
        w, x, y, z = (float(c) for c in quat_mul(quat_mul(about[0], about[1]), about[2]))
        return (w, x, y, z)
