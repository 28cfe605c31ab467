"""`run`: everything from the task to the report."""

from __future__ import annotations

from pathlib import Path

from optimus.cli.options import ControlName, Json, ObjectsName, RobotName, TaskName, Workers, chosen_robot
from optimus.cli.output import StageBars, rate, say


def run(
    task: TaskName,
    out: Path,
    minutes: float = 20.0,
    demonstrations: int | None = None,
    episodes: int = 50,
    seed: int = 0,
    workers: Workers = 0,
    corrections: bool = False,
    mishaps: float = 0.0,
    control: ControlName = "osc",
    robot: RobotName = None,
    objects: ObjectsName = None,
    json: Json = False,
) -> None:
    """The main job: collect, curate, train, evaluate and report, within a budget of minutes. Resumable.

    Try:
        optimus run pick-place --minutes 20 --out runs/pick-place
        optimus run pick-place --minutes 20 --out runs/hardy --mishaps 0.5    (a policy that takes again what slipped)
        optimus run stack --minutes 30 --out runs/ur5e --robot ur5e --control joint

    Args:
        out: the folder for everything; `report.html` in it is what to look at
        minutes: for all stages together
        demonstrations: how many to collect; by default what the budget allows
        episodes: evaluation episodes
        seed: of the first demonstration (the next ones follow), of the training and of the evaluation
        mishaps: share of the demonstrations in which a thing is pushed, slips or is missed by a grasp, as `optimus collect` has it
        corrections: spend half of the training on a first policy, and then learn from the expert's answers to its mistakes too
    """
    from optimus.run import RunConfig
    from optimus.run import run as run_all
    from optimus.tasks import with_objects

    arm, name = chosen_robot(robot), with_objects(task, objects)
    config = RunConfig(name, out, minutes, demonstrations, episodes, seed, workers, corrections, control, arm, mishaps)
    bars = StageBars()
    result = run_all(config, bars)
    bars.close()
    say(result, json, f"{rate(result['evaluation'])}\n{result['report']}")
