"""`evaluate` and `export-policy`: how good a policy is, and on to elsewhere."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from tyro.conf import arg

from optimus.cli.options import (
    Friction,
    Json,
    Mass,
    ObjectsName,
    PerturbName,
    RobotName,
    RunFolder,
    Workers,
    chosen_robot,
)
from optimus.cli.output import bar, counter, counts, rate, say
from optimus.errors import CheckpointError

if TYPE_CHECKING:
    from optimus.evaluate import Start

Episodes = Annotated[int, arg(help="how many to play")]
ExpectedTask = Annotated[str | None, arg(metavar="TASK", help="refuse a policy that was not trained for it; of several: which")]


def evaluate(
    run: RunFolder,
    dataset: Path | None = None,
    episodes: Episodes = 50,
    states: Literal["validation", "random"] | None = None,
    repeats: int = 1,
    checkpoint: Literal["last", "best", "both"] = "last",
    seed: int = 0,
    workers: Workers = 0,
    component: Literal["sampled", "likeliest", "paper"] = "sampled",
    task: ExpectedTask = None,
    videos: Path | None = None,
    robot: RobotName = None,
    objects: ObjectsName = None,
    perturb: PerturbName = None,
    friction: Friction = 1.0,
    mass: Mass = 1.0,
    horizon: int | None = None,
    compile: bool = False,
    json: Json = False,
) -> None:
    """Measure a policy's success: k of n, with its 95 % interval and the causes of failure. Every outcome is written to the run's
    folder, as JSON and as JSON lines; interrupted, the same command goes on.

    Try:
        optimus evaluate pretrained:pick-place
        optimus evaluate runs/stack --dataset data/stack --episodes 50 --repeats 3 --checkpoint both
        optimus evaluate runs/stack --videos films --perturb push --friction 0.7
        optimus evaluate runs/pick-place --objects unseen

    Args:
        dataset: whose validation states to start from; needed for --states validation
        states: start from the validation demonstrations' states, or from fresh random ones; by default the former where there is a
            --dataset
        repeats: play this often from each of them, the policy drawing anew
        checkpoint: the last one, the one of the lowest held-out error, or both, one after the other
        seed: of the policy's draws, and of random states
        component: of the action mixture: one sampled by its sharpened weight (`paper`: by its weight), or the likeliest
        videos: write short films of successes and failures to this folder (with --checkpoint both, to `last` and `best` in it)
        horizon: most steps of an episode, where that is fewer than the task's own
        compile: have ONNX Runtime compute the network (extra `onnx`): some seconds in each process, then an action takes two thirds
            of the time (optimus-30m) or less (quick), equal but for rounding
    """
    from optimus import evaluate as evaluation
    from optimus.conditions import Conditions
    from optimus.data.atomic import make_folder
    from optimus.filming import film_outcomes
    from optimus.learn import checkpoint as checkpoints
    from optimus.learn.card import write_card
    from optimus.pretrained import trained_folder

    if repeats < 1:
        raise CheckpointError(f"--repeats {repeats} is not positive")
    if videos is not None:
        make_folder(videos)
    run, states = trained_folder(run), states or ("random" if dataset is None else "validation")
    conditions, arm = Conditions(perturb, friction, mass, horizon), chosen_robot(robot)
    results: dict[str, Any] = {}
    for which in ("last", "best") if checkpoint == "both" else (checkpoint,):
        folder = evaluation.policy_folder(run, which)
        trained_for = checkpoints.load(folder, task).inputs.task
        starts = _starts(folder, states, dataset, episodes, seed, objects, task) * repeats
        with bar(len(starts), f"evaluate {trained_for} ({which})", "episode") as shown:
            label = evaluation.states_label(states, task, objects)
            how = (component, counter(shown), arm, conditions, compile)
            report = evaluation.evaluate(folder, starts, label, seed, workers, *how, keep=True)
        report.write(folder)
        write_card(folder)
        results[which] = report.as_dict()
        if videos is not None:
            films = videos / which if checkpoint == "both" else videos
            film_outcomes(folder, starts, results[which], seed, component, films, arm, conditions=conditions, compiled=compile)
    text = "\n".join(f"{which}: {rate(r)}; failures: {counts(r['failures'])}" for which, r in results.items())
    said = results if checkpoint == "both" else results[checkpoint]
    say({"run": str(run), **said}, json, text if checkpoint == "both" else text.partition(": ")[2])


def export_policy(run: RunFolder, onnx: Path, overwrite: bool = False, json: Json = False) -> None:
    """Write a policy as one ONNX file: an observation in, an action out, crops and normalisation inside.

    Try:
        optimus export-policy runs/stack --onnx stack.onnx

    Args:
        onnx: the file to write
        overwrite: replace the file that is there already
    """
    from optimus.data.atomic import make_folder, require_free
    from optimus.learn import checkpoint
    from optimus.learn.onnx_file import export_onnx
    from optimus.pretrained import trained_folder

    require_free(onnx, overwrite)
    make_folder(onnx.parent)
    folder = trained_folder(run)
    export_onnx(checkpoint.load(folder), onnx, checkpoint.gripper_of(folder))
    say({"run": str(run), "onnx": str(onnx), "bytes": onnx.stat().st_size}, json, str(onnx))


def _starts(
    run: Path, states: str, dataset: Path | None, episodes: int, seed: int, objects: str | None, task: str | None
) -> list[Start]:
    from optimus.evaluate import random_starts, require_same_problems, validation_starts

    if states == "random":
        return random_starts(episodes, seed, objects, task)
    if objects is not None:
        raise CheckpointError("--objects are for --states random: validation states have the dataset's own")
    if dataset is None:
        raise CheckpointError("--states validation needs --dataset DIR (or use --states random)")
    require_same_problems(run, dataset, task)
    return validation_starts(dataset, episodes)
