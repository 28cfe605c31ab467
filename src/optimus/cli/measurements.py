"""`bench`: measurements that anyone can repeat."""

from __future__ import annotations

from typing import Annotated, Literal

from tyro.conf import Positional, arg

from optimus.cli.options import ControlName, FirstSeed, Json, ObjectsName, RobotName, TaskName, Workers, chosen_robot
from optimus.cli.output import bar, counter, say, table
from optimus.errors import OptimusError


def bench(
    what: Annotated[Literal["expert", "collect", "read", "step", "action", "render"], Positional, arg(help="what to measure")],
    task: TaskName,
    episodes: int = 20,
    seed: FirstSeed = 0,
    workers: Workers = 1,
    check: bool = False,
    where: bool = False,
    control: ControlName = "osc",
    robot: RobotName = None,
    objects: ObjectsName = None,
    json: Json = False,
) -> None:
    """Measure: the expert's success and planning time, collection, reading for training, one step, one action, one frame.

    Try:
        optimus bench expert stack --episodes 100 --seed 1000 --control joint --json
        optimus bench expert microwave-adapt --episodes 10 --workers 2 --where
        optimus bench collect stack --episodes 40 --workers 2 --json
        optimus bench read stack --episodes 500

    Args:
        episodes: how many to run (for render, action and read: frames, actions, batches)
        check: with expert: validate every plan independently, and count the invalid ones as failures
        where: with expert: afterwards, plan for the first few seeds again and find out where the time goes
    """
    from optimus.bench import BENCHES, BenchConfig
    from optimus.tasks import with_objects

    for name, asked in (("check", check), ("where", where)):
        if asked and what != "expert":
            raise OptimusError(f"--{name} is for plans: it goes with `bench expert` alone")
    with bar(episodes, f"bench {what} {task}", "episode") as shown:
        config = BenchConfig(with_objects(task, objects), episodes, seed, workers, control, chosen_robot(robot), check, where)
        result = BENCHES[what](config, counter(shown))
    say(result, json, table(result))
