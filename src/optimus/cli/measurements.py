"""`bench`: measurements that anyone can repeat."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from tyro.conf import Positional, arg

from optimus.cli.options import (
    ControlName,
    FirstSeed,
    Friction,
    Json,
    Mass,
    ObjectsName,
    PerturbName,
    PlanningSeconds,
    PresetName,
    RobotName,
    Workers,
    chosen_budget,
    chosen_robot,
)
from optimus.cli.output import bar, counter, say, table
from optimus.errors import OptimusError

TaskOrNone = Annotated[str | None, Positional, arg(metavar="TASK", help="a task's name; none with --preset")]


def bench(
    what: Annotated[
        Literal["expert", "collect", "read", "step", "action", "render"], Positional, arg(help="what to measure")
    ],
    task: TaskOrNone = None,
    preset: PresetName | None = None,
    rounds: int = 5,
    compile: bool = True,
    device: Literal["cpu", "cuda"] = "cpu",
    batch: int = 16,
    episodes: int = 20,
    seed: FirstSeed = 0,
    workers: Workers = 1,
    check: bool = False,
    where: bool = False,
    planning_seconds: PlanningSeconds = None,
    control: ControlName = "osc",
    robot: RobotName = None,
    objects: ObjectsName = None,
    perturb: PerturbName = None,
    friction: Friction = 1.0,
    mass: Mass = 1.0,
    json: Json = False,
) -> None:
    """Measure: the expert's success and planning time, collection, reading for training, one environment step, one action, one
    frame; and with --preset a step of training (`step`) or an action (`action`) of that network, beside the same computed plainly.

    Try:
        optimus bench expert stack --episodes 100 --seed 1000 --control joint --json
        optimus bench expert microwave-adapt --episodes 10 --workers 2 --where
        optimus bench expert stack --episodes 50 --perturb push
        optimus bench collect stack --episodes 40 --workers 2 --json
        optimus bench read stack --episodes 500
        optimus bench step --preset optimus-30m --json
        optimus bench action --preset optimus-30m
        optimus bench step --preset optimus-30m --device cuda --batch 512 --json

    Args:
        preset: with step and action: the network to measure, on made-up data; no task and no dataset is needed
        rounds: with --preset: how often a step is timed (an action: ten times as often; a step on a GPU: for some seconds)
        compile: with action --preset, on the CPU: time it computed by ONNX Runtime as well, if that is installed
        device: with --preset: what computes; on a GPU, elapsed time, with the data resident there
        batch: with step --preset --device cuda: windows in a step
        episodes: how many to run (for render, action and read: frames, actions, batches)
        check: with expert: validate every plan independently, and count the invalid ones as failures
        where: with expert: afterwards, plan for the first few seeds again and find out where the time goes
    """
    from optimus.bench import BENCHES, BenchConfig
    from optimus.conditions import Conditions
    from optimus.tasks import with_objects

    conditions = Conditions(perturb, friction, mass)
    of_the_expert = {
        "check": check,
        "where": where,
        "planning-seconds": planning_seconds is not None,
        "perturb, --friction and --mass": conditions != Conditions(),
    }
    for name, asked in of_the_expert.items():
        if asked and what != "expert":
            raise OptimusError(f"--{name}: this goes with `bench expert` alone")
    if device == "cuda" and preset is None:
        raise OptimusError("--device cuda: this goes with --preset; a TASK is measured on the CPU")
    if preset is not None:
        if task is not None:
            raise OptimusError(f"--preset {preset} is measured on made-up data; leave out {task}")
        say(result := _of_preset(what, preset, rounds, seed, compile, device, batch), json, table(result))
        return
    if task is None:
        raise OptimusError("name a TASK (`optimus tasks` lists them), or a --preset for step and action")
    with bar(episodes, f"bench {what} {task}", "episode") as shown:
        named, budget = with_objects(task, objects), chosen_budget(planning_seconds)
        config = BenchConfig(named, episodes, seed, workers, control, chosen_robot(robot), check, where, conditions, budget)
        result = BENCHES[what](config, counter(shown))
    say(result, json, table(result))


def _of_preset(what: str, preset: str, rounds: int, seed: int, compile: bool, device: str, batch: int) -> dict[str, Any]:
    from optimus.bench.gpu import GPU_WAYS, bench_gpu_action, bench_gpu_step
    from optimus.bench.policy import bench_gradient_step, bench_policy_action

    if what not in ("step", "action"):
        raise OptimusError(f"--preset is measured by `bench step` and `bench action`, not by `bench {what}`")
    if rounds < 1:
        raise OptimusError(f"--rounds {rounds} is not positive")
    if batch < 1:
        raise OptimusError(f"--batch {batch} is not positive")
    rounds = 10 * rounds if what == "action" else rounds if device == "cpu" else GPU_WAYS
    with bar(rounds, f"bench {what} {preset}", "round") as shown:
        if device == "cuda":
            on_gpu = bench_gpu_action if what == "action" else bench_gpu_step
            return on_gpu(preset, rounds if what == "action" else batch, seed, counter(shown))
        if what == "step":
            return bench_gradient_step(preset, rounds, seed, counter(shown))
        return bench_policy_action(preset, rounds, seed, compile, counter(shown))
