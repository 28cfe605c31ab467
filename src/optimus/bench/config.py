"""What to measure with."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from typing import Any

from optimus.conditions import USUAL, Conditions
from optimus.control import require_control
from optimus.data.episode import OSC
from optimus.env import ManipulationEnv
from optimus.errors import require_at_least
from optimus.planner import Budget
from optimus.robots import Robot
from optimus.tasks import task as task_named

Progress = Callable[[int, int], None]
"""`(done, successes)`"""


@dataclass(frozen=True)
class BenchConfig:
    """What to measure with."""

    task: str
    episodes: int = 20
    seed: int = 0
    workers: int = 1
    control: str = OSC
    robot: Robot | None = None
    """Takes the place of the task's own."""
    check: bool = False
    """Validate every plan of the expert independently."""
    where: bool = False
    """Find out where planning time goes."""
    conditions: Conditions = USUAL
    """What episodes are played under."""
    budget: Budget = field(default_factory=Budget)
    """What the expert's plans may cost."""

    def __post_init__(self) -> None:
        require_at_least(1, episodes=self.episodes)
        require_at_least(0, seed=self.seed, workers=self.workers)
        task_named(self.task)
        require_control(self.control)

    def env(self, images: bool) -> ManipulationEnv:
        task, worlds = self.conditions.of(task_named(self.task)), self.conditions.world
        return ManipulationEnv(task, images=images, control=self.control, robot=self.robot, worlds=worlds)

    @property
    def about(self) -> dict[str, Any]:
        robot = self.robot or task_named(self.task).problem(self.seed).scene.robot
        about = {"task": self.task, "control": self.control, "robot": robot.name}
        return {**about, **({"conditions": asdict(self.conditions)} if self.conditions.said else {})}
