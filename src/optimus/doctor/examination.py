"""The examination itself, part by part, in the order in which the parts need one another."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from optimus.doctor import drawing, files, machine
from optimus.doctor.finding import Finding


def examine(progress: Callable[[str], None] = lambda name: None) -> list[Finding]:
    """Try everything; takes some seconds, and fetches the robot's model if it is not there. `progress(part)` is called before
    each part."""
    findings: list[Finding] = []

    def tried(name: str, trial: Callable[[], Finding]) -> Finding:
        progress(name)
        findings.append(trial())
        return findings[-1]

    tried("packages", machine.packages)
    tried("processor", machine.processor)
    tried("cache", files.cache)
    tried("home", files.home)
    tried("folder", files.folder)
    tried("disk", files.disk)
    robot = tried("robot", files.robot)
    tried("renderer", partial(drawing.renderer, with_robot=robot.verdict == "works"))
    tried("films", machine.films)
    tried("gpu", machine.gpu)
    for name in machine.EXTRAS:
        tried(name, partial(machine.extra, name))
    return findings
