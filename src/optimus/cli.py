"""The command line: one verb a stage, folders in, folders out. The only place that parses arguments and catches errors."""

from __future__ import annotations

import json as jsonlib
import logging
import sys
from collections.abc import Callable
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Any, Literal

import tyro
from tqdm import tqdm

from optimus.errors import OptimusError, UnknownNameError

TaskName = Annotated[str, tyro.conf.Positional, tyro.conf.arg(metavar="TASK", help="a task's name; `optimus tasks` lists them")]
RobotName = Annotated[str | None, tyro.conf.arg(metavar="ROBOT", help="a robot's name or robot file; by default the task's own")]
Folder = Annotated[Path, tyro.conf.Positional]


def _say(result: dict[str, Any], json: bool, text: str) -> None:
    """The verb's answer, last on standard output: one JSON object, or a few words."""
    sys.stdout.write((jsonlib.dumps(result) if json else text) + "\n")


@contextmanager
def _bar(total: int | None, what: str, unit: str):
    with tqdm(total=total, desc=what, unit=unit, file=sys.stderr, dynamic_ncols=True, mininterval=0.5) as bar:
        yield bar


def _counter(bar: Any) -> Callable[[int, int], None]:
    def progress(done: int, successes: int) -> None:
        if done != successes:
            bar.set_postfix(successes=successes)
        bar.n = done
        bar.refresh()

    return progress


def _robot(name: str | None) -> Any:
    """The robot that takes the place of the task's own; None for that one."""
    from optimus.robots.catalogue import robot as robot_named

    return None if name is None else robot_named(name)


def tasks(json: bool = False) -> None:
    """List the tasks.

    Try: optimus tasks
    """
    from optimus.registration import gym_id
    from optimus.tasks import TASKS
    from optimus.tasks import task as task_named

    all_tasks = [task_named(name) for name in TASKS]
    rows = [{"name": t.name, "summary": t.summary, "horizon": t.horizon, "gym": gym_id(t.name)} for t in all_tasks]
    _say({"tasks": rows}, json, "\n".join(f"{r['name']:<14} {r['summary']}  [{r['gym']}]" for r in rows))


def show(
    task: TaskName,
    plan: bool = False,
    check: bool = False,
    seed: int = 0,
    out: Path | None = None,
    robot: RobotName = None,
    json: bool = False,
) -> None:
    """Write a picture of a task's start, or with --plan of the expert's plan.

    Try:
        optimus show stack --seed 3
        optimus show stack --plan --check --seed 3 --out plan.png
        optimus show stack --robot ur5e

    Args:
        plan: draw the plan, one skill after another, with its motions (blue: hand empty, orange: carrying)
        check: with --plan: refuse a plan that does not stand up to an independent check of its motions and effects
        seed: which problem
        out: the PNG to write; by default TASK-SEED[-plan].png here
    """
    from optimus.demonstrate import ExpertConfig
    from optimus.show import sentence, show_plan, show_scene
    from optimus.tasks import task as task_named

    chosen = task_named(task)
    if check and not plan:
        raise OptimusError("--check is for plans: add --plan")
    out = out or Path(f"{task}-{seed}{'-plan' if plan else ''}.png")
    if plan:
        found = show_plan(chosen, seed, out, ExpertConfig(check=check), _robot(robot))
        text = "; ".join(f"{i}. {sentence(s.operator)}" for i, s in enumerate(found.steps, 1))
    else:
        text = show_scene(chosen, seed, out, _robot(robot))
    _say({"picture": str(out), "shows": text}, json, f"{text}\n{out}")


def collect(
    task: TaskName,
    out: Path,
    episodes: int = 200,
    seed: int = 0,
    workers: int = 0,
    perturb: bool = True,
    stall: int = 5,
    check: bool = False,
    policy: Path | None = None,
    control: str = "osc",
    robot: RobotName = None,
    json: bool = False,
) -> None:
    """Collect demonstrations by the expert into a folder; a second call goes on where the first was stopped.

    Try:
        optimus collect stack --episodes 300 --out data/stack
        optimus collect stack --episodes 100 --out data/corrections --policy runs/stack --seed 5000000

    Args:
        out: the dataset's folder
        episodes: successful demonstrations wanted
        seed: of the first attempt; the next ones follow
        workers: processes; 0 takes every core (the dataset does not depend on it)
        perturb: push the arm off its path now and then, the label staying the expert's own answer
        stall: steps for which the gripper alone acts at a grasp or a release
        check: leave out plans that do not stand up to an independent check of their motions and effects
        policy: a run folder whose policy takes turns with the expert; the labels stay the expert's (corrections)
        control: how actions move the arm: osc (operational space), ik (the same actions by inverse kinematics), or joint
    """
    from dataclasses import asdict

    from optimus.collect import CollectConfig
    from optimus.collect import collect as run_collect
    from optimus.correct import Turns
    from optimus.demonstrate import ExpertConfig
    from optimus.expert import TimeLaw
    from optimus.rollout import Perturbation

    expert = ExpertConfig(law=TimeLaw(stall=stall), perturbation=Perturbation() if perturb else None, check=check)
    turns = Turns(policy) if policy else None
    config = CollectConfig(task, out, episodes, seed, workers, expert, turns, control=control, robot=_robot(robot))
    with _bar(episodes, f"collect {task}", "demo") as bar:
        result = run_collect(config, lambda done: _counter(bar)(done, done))
    text = f"{result.demonstrations} demonstrations of {result.attempts} attempts in {out}; failures: {result.failures or 'none'}"
    _say({"dataset": str(out), **asdict(result)}, json, text)


def curate(dataset: Folder, max_length_sd: float = 2.0, json: bool = False) -> None:
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
    _say({**counts, "reasons": {str(k): v for k, v in result.dropped.items()}}, json, text)


def train(
    dataset: Folder,
    out: Path,
    minutes: float = 10.0,
    steps: int | None = None,
    seed: int = 0,
    corrections: Path | None = None,
    initial: Path | None = None,
    json: bool = False,
) -> None:
    """Train a policy on a dataset by behaviour cloning; a second call goes on where the first was stopped.

    Try:
        optimus train data/stack --out runs/stack --minutes 12
        optimus train data/stack --corrections data/corrections --initial runs/stack --out runs/better

    Args:
        out: the run's folder
        minutes: time to train for; the learning rate anneals over it
        steps: train for this many gradient steps instead
        corrections: a second dataset, from `optimus collect --policy`, to train on as well
        initial: a run folder whose weights to begin with
    """
    from optimus.data.store import EpisodeStore
    from optimus.learn.train import Progress, TrainConfig
    from optimus.learn.train import train as run_train

    _curate_if_needed(dataset, EpisodeStore.open(dataset))
    with _bar(None, "train", "step") as bar:

        def progress(p: Progress) -> None:
            bar.total, bar.n = p.steps, p.step
            shown = ("loss", "held_out_action_error_mm", "labels_per_second")
            bar.set_postfix({k: f"{p.metrics[k]:.3g}" for k in shown if k in p.metrics}, refresh=False)
            bar.update(0)

        config = TrainConfig(steps=steps, minutes=minutes, seed=seed)
        run_train(dataset, out, config, None, progress, corrections, initial)
    _say({"run": str(out)}, json, str(out))


def _curate_if_needed(dataset: Path, store: Any) -> None:
    from optimus.data.curate import curate as run_curate
    from optimus.data.curate import load_curation
    from optimus.errors import DatasetError

    try:
        known = load_curation(dataset)
        if set(known.kept) | set(known.dropped) == set(store.seeds):
            return
    except DatasetError:
        pass
    run_curate(dataset)


def evaluate(
    run: Folder,
    dataset: Path | None = None,
    episodes: int = 50,
    states: Literal["validation", "random"] = "validation",
    seed: int = 0,
    workers: int = 0,
    component: Literal["sampled", "likeliest", "paper"] = "sampled",
    task: str | None = None,
    videos: Path | None = None,
    json: bool = False,
) -> None:
    """Measure a policy's success: k of n, with its 95 % interval and the causes of failure.

    Try:
        optimus evaluate runs/stack --dataset data/stack --episodes 50
        optimus evaluate runs/stack --states random --videos films

    Args:
        dataset: whose validation states to start from; needed for --states validation
        states: start from the validation demonstrations' states, or from fresh random ones
        component: of the action mixture: one sampled by its sharpened weight (`paper`: by its weight), or the likeliest
        task: refuse a policy that was trained for another task
        videos: write short films of successes and failures to this folder
    """
    from optimus.data.atomic import write_json
    from optimus.errors import CheckpointError
    from optimus.evaluate import evaluate as run_evaluate
    from optimus.evaluate import film_outcomes, random_starts, validation_starts
    from optimus.learn import checkpoint

    trained_for = checkpoint.load(run, task).inputs.task
    if states == "validation" and dataset is None:
        raise CheckpointError("--states validation needs --dataset DIR (or use --states random)")
    if states == "validation" and dataset is not None:
        starts = validation_starts(dataset, episodes)
    else:
        starts = random_starts(episodes, seed)
    with _bar(episodes, f"evaluate {trained_for}", "episode") as bar:
        report = run_evaluate(run, starts, states, seed, workers, component, _counter(bar)).as_dict()
    write_json(run / f"evaluation-{states}.json", report)
    if videos is not None:
        film_outcomes(run, starts, report, seed, component, videos)
    _say({"run": str(run), **report}, json, f"{_rate(report)}; failures: {report['failures']}")


def _rate(report: dict[str, Any]) -> str:
    """`45 of 50 (79 to 96 %)`, and over how few initial states where some came twice."""
    low, high = report["interval"]
    few = report["distinct_states"] < report["episodes"]
    repeated = f", from {report['distinct_states']} distinct initial states" if few else ""
    return f"{report['successes']} of {report['episodes']} ({100 * low:.0f} to {100 * high:.0f} %{repeated})"


def run(
    task: TaskName,
    out: Path,
    minutes: float = 20.0,
    demonstrations: int | None = None,
    episodes: int = 50,
    seed: int = 0,
    workers: int = 0,
    corrections: bool = True,
    json: bool = False,
) -> None:
    """The main job: collect, curate, train, evaluate and report, within a budget of minutes. Resumable.

    Try: optimus run pick-place --minutes 20 --out runs/pick-place

    Args:
        out: the folder for everything; `report.html` in it is what to look at
        minutes: for all stages together
        demonstrations: how many to collect; by default what the budget allows
        episodes: evaluation episodes
        corrections: spend half of the training on a first policy, and then learn from the expert's answers to its mistakes
    """
    from optimus.run import RunConfig
    from optimus.run import run as run_all

    bars: dict[str, Any] = {}

    def progress(stage: str, done: int, total: int, note: dict[str, str]) -> None:
        for other in [s for s in bars if s != stage]:
            bars.pop(other).close()
        if stage not in bars:
            bars[stage] = tqdm(total=total, desc=stage, file=sys.stderr, dynamic_ncols=True, mininterval=0.5)
        bars[stage].total, bars[stage].n = total, done
        if note:
            bars[stage].set_postfix(note, refresh=False)
        bars[stage].update(0)
        if done == total:
            bars[stage].refresh()

    result = run_all(RunConfig(task, out, minutes, demonstrations, episodes, seed, workers, corrections), progress)
    for bar in bars.values():
        bar.close()
    _say(result, json, f"{_rate(result['evaluation'])}\n{result['report']}")


def bench(
    what: Annotated[Literal["expert", "collect", "step", "action", "render"], tyro.conf.Positional],
    task: TaskName,
    episodes: int = 20,
    seed: int = 0,
    workers: int = 1,
    check: bool = False,
    control: str = "osc",
    robot: RobotName = None,
    json: bool = False,
) -> None:
    """Measure: the expert's success and planning time, collection, one environment step, one action, one frame.

    Try:
        optimus bench expert stack --episodes 100 --seed 1000 --control joint --json
        optimus bench collect stack --episodes 40 --workers 2 --json

    Args:
        episodes: how many to run (frames or actions, for render and action)
        workers: processes (expert and collect); 0 takes every core
        check: with expert: validate every plan independently, and count the invalid ones as failures
        control: how actions move the arm: osc, ik or joint
    """
    from optimus.bench import BENCHES, BenchConfig

    if check and what != "expert":
        raise OptimusError("--check is for plans: it goes with `bench expert` alone")
    with _bar(episodes, f"bench {what} {task}", "episode") as bar:
        config = BenchConfig(task, episodes, seed, workers, control, _robot(robot), check)
        result = BENCHES[what](config, _counter(bar))
    _say(result, json, "\n".join(f"{key:<24} {value}" for key, value in result.items()))


VERBS = {f.__name__: f for f in (tasks, show, collect, curate, train, evaluate, run, bench)}


def main() -> None:
    """The `optimus` command. Exit status: 0, 2 for an error that the user can mend, 130 when interrupted."""
    logging.basicConfig(level=logging.WARNING, format="%(levelname)s %(name)s: %(message)s")
    try:
        if len(sys.argv) > 1 and not sys.argv[1].startswith("-") and sys.argv[1] not in VERBS:
            raise UnknownNameError("verb", sys.argv[1], VERBS)
        tyro.extras.subcommand_cli_from_dict(VERBS, prog="optimus", description=__doc__)
    except OptimusError as error:
        sys.stderr.write(f"optimus: {error}\n")
        raise SystemExit(2) from None
    except KeyboardInterrupt:
        sys.stderr.write("optimus: interrupted; the same command goes on from here\n")
        raise SystemExit(130) from None


if __name__ == "__main__":
    main()
