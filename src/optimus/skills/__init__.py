"""Every skill, by name. A skill is one file; adding one touches that file and this table."""

from optimus.skills.door import CloseDoor, OpenDoor
from optimus.skills.pick import Pick
from optimus.skills.place import Place, Stack
from optimus.skills.skill import Skill, Style, Workspace

SKILLS: dict[str, Skill] = {skill.name: skill for skill in (Pick(), Place(), Stack(), OpenDoor(), CloseDoor())}

__all__ = ["SKILLS", "Skill", "Style", "Workspace"]
