"""`collect` and `curate`: from a task to demonstrations worth learning from."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

from optimus.cli.options import ControlName, Dataset, FirstSeed, Json, ObjectsName, RobotName, TaskName, Workers, chosen_robot
from optimus.cli.output import bar, counter, say

if TYPE_CHECKING:
    from optimus.demonstrate import ExpertConfig


def collect(
    task: TaskName,
    out: Path,
    episodes: int = 200,
    seed: FirstSeed = 0,
    workers: Workers = 0,
    perturb: bool = True,
    stall: int = 5,
    check: bool = False,
    policy: Path | None = None,
    control: ControlName = "osc",
    robot: RobotName = None,
    objects: ObjectsName = None,
    json: Json = False,
) -> None:
    """Collect demonstrations by the expert into a folder; a second call goes on where the first was stopped.

    Try:
        optimus collect stack --episodes 300 --out data/stack
        optimus collect stack --episodes 100 --out data/corrections --policy runs/stack --seed 5000000

    Args:
        out: the dataset's folder
        episodes: successful demonstrations wanted
        perturb: push the arm off its path now and then, the label staying the expert's own answer
        stall: steps for which the gripper alone acts at a grasp or a release
        check: leave out plans that do not stand up to an independent check of their motions and effects
        policy: a run folder whose policy takes turns with the expert; the labels stay the expert's (corrections)
    """
    from optimus.collect import CollectConfig
    from optimus.collect import collect as run_collect
    from optimus.correct import Turns
    from optimus.tasks import with_objects

    expert, turns = _expert(perturb, stall, check), Turns(policy) if policy else None
    arm = chosen_robot(robot)
    config = CollectConfig(with_objects(task, objects), out, episodes, seed, workers, expert, turns, control=control, robot=arm)
    with bar(episodes, f"collect {task}", "demo") as shown:
        result = run_collect(config, lambda done: counter(shown)(done, done))
    text = f"{result.demonstrations} demonstrations of {result.attempts} attempts in {out}; failures: {result.failures or 'none'}"
    say({"dataset": str(out), **asdict(result)}, json, text)


def _expert(perturb: bool, stall: int, check: bool) -> ExpertConfig:
    from optimus.demonstrate import ExpertConfig
    from optimus.expert import TimeLaw
    from optimus.rollout import Perturbation

    return ExpertConfig(law=TimeLaw(stall=stall), perturbation=Perturbation() if perturb else None, check=check)


def curate(dataset: Dataset, max_length_sd: float = 2.0, json: Json = False) -> None:
    """Choose the demonstrations worth learning from and split them 90/10; nothing is rewritten.

    Try: optimus curate data/stack

    Args:
        max_length_sd: leave out episodes longer than the mean of their plan skeleton by this many standard deviations
    """
    from optimus.data.curate import CurationConfig
    from optimus.data.curate import curate as run_curate

    result = run_curate(dataset, CurationConfig(max_length_sd=max_length_sd))
    counts = {"train": len(result.train), "validation": len(result.validation), "dropped": len(result.dropped)}
    text = ", ".join(f"{n} {k}" for k, n in counts.items())
    say({**counts, "reasons": {str(k): v for k, v in result.dropped.items()}}, json, text)
