"""From an action to joint torques: three ways of control, by name."""

from optimus.control.controller import CONTROL_HZ, JOINT_SCALE, POSITION_SCALE, ROTATION_SCALE, SCALE, Controller
from optimus.control.ik import InverseKinematics
from optimus.control.joint import JointTarget
from optimus.control.osc import OperationalSpace
from optimus.errors import UnknownNameError
from optimus.world import World

_ALL: tuple[type[OperationalSpace | InverseKinematics | JointTarget], ...] = (OperationalSpace, InverseKinematics, JointTarget)
CONTROLS = {c.name: c for c in _ALL}
"""Every way of control, by name."""


def require_control(name: str) -> str:
    """`name` if it is a way of control; `UnknownNameError` listing them if not."""
    if name not in CONTROLS:
        raise UnknownNameError("control", name, CONTROLS)
    return name


def controller(name: str, world: World) -> Controller:
    """The controller of that name for a compiled scene; `UnknownNameError` listing them if there is none."""
    return CONTROLS[require_control(name)](world)


__all__ = [
    "CONTROLS",
    "CONTROL_HZ",
    "JOINT_SCALE",
    "POSITION_SCALE",
    "ROTATION_SCALE",
    "SCALE",
    "Controller",
    "controller",
    "require_control",
]
