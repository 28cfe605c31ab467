"""`train` and `evaluate`: from a dataset to a policy, and how good it is."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from tyro.conf import arg

from optimus.cli.options import Dataset, Json, ObjectsName, RobotName, RunFolder, Workers, chosen_robot
from optimus.cli.output import bar, counter, rate, say

if TYPE_CHECKING:
    from collections.abc import Callable

    from optimus.evaluate import Start
    from optimus.learn.train import Progress

Episodes = Annotated[int, arg(help="how many to play")]
ExpectedTask = Annotated[str | None, arg(metavar="TASK", help="refuse a policy that was trained for another task")]


def train(
    dataset: Dataset,
    out: Path,
    minutes: float = 10.0,
    steps: int | None = None,
    seed: int = 0,
    corrections: Path | None = None,
    initial: Path | None = None,
    json: Json = False,
) -> None:
    """Train a policy on a dataset by behaviour cloning; a second call goes on where the first was stopped.

    Try:
        optimus train data/stack --out runs/stack --minutes 12
        optimus train data/stack --corrections data/corrections --initial runs/stack --out runs/better

    Args:
        out: the run's folder
        minutes: time to train for; the learning rate anneals over it
        steps: train for this many gradient steps instead
        seed: of the first weights and of the order of the data
        corrections: a second dataset, from `optimus collect --policy`, to train on as well
        initial: a run folder whose weights to begin with
    """
    from optimus.learn.train import TrainConfig
    from optimus.learn.train import train as run_train

    _curate_if_needed(dataset)
    with bar(None, "train", "step") as shown:
        config = TrainConfig(steps=steps, minutes=minutes, seed=seed)
        run_train(dataset, out, config, None, _training(shown), corrections, initial)
    say({"run": str(out)}, json, str(out))


def _training(bar: Any) -> Callable[[Progress], None]:
    def progress(p: Progress) -> None:
        bar.total, bar.n = p.steps, p.step
        shown = ("loss", "held_out_action_error_mm", "labels_per_second")
        bar.set_postfix({k: f"{p.metrics[k]:.3g}" for k in shown if k in p.metrics}, refresh=False)
        bar.update(0)

    return progress


def _curate_if_needed(dataset: Path) -> None:
    """Curate, unless it has been done and every episode was there then."""
    from optimus.data.curate import curate, load_curation
    from optimus.data.store import EpisodeStore
    from optimus.errors import DatasetError

    store = EpisodeStore.open(dataset)
    try:
        known = load_curation(dataset)
        if set(known.kept) | set(known.dropped) == set(store.seeds):
            return
    except DatasetError:
        pass
    curate(dataset)


def evaluate(
    run: RunFolder,
    dataset: Path | None = None,
    episodes: Episodes = 50,
    states: Literal["validation", "random"] = "validation",
    seed: int = 0,
    workers: Workers = 0,
    component: Literal["sampled", "likeliest", "paper"] = "sampled",
    task: ExpectedTask = None,
    videos: Path | None = None,
    robot: RobotName = None,
    objects: ObjectsName = None,
    json: Json = False,
) -> None:
    """Measure a policy's success: k of n, with its 95 % interval and the causes of failure.

    Try:
        optimus evaluate runs/stack --dataset data/stack --episodes 50
        optimus evaluate runs/stack --states random --videos films
        optimus evaluate runs/pick-place --states random --objects unseen

    Args:
        dataset: whose validation states to start from; needed for --states validation
        states: start from the validation demonstrations' states, or from fresh random ones
        seed: of the policy's draws, and of random states
        component: of the action mixture: one sampled by its sharpened weight (`paper`: by its weight), or the likeliest
        videos: write short films of successes and failures to this folder
    """
    from optimus import evaluate as evaluation
    from optimus.data.atomic import write_json
    from optimus.learn import checkpoint

    trained_for = checkpoint.load(run, task).inputs.task
    arm = evaluation.trained_robot(run, chosen_robot(robot))
    starts = _starts(run, states, dataset, episodes, seed, objects)
    with bar(episodes, f"evaluate {trained_for}", "episode") as shown:
        report = evaluation.evaluate(run, starts, states, seed, workers, component, counter(shown), arm).as_dict()
    write_json(run / f"evaluation-{states}.json", report)
    if videos is not None:
        evaluation.film_outcomes(run, starts, report, seed, component, videos, arm)
    say({"run": str(run), **report}, json, f"{rate(report)}; failures: {report['failures']}")


def _starts(run: Path, states: str, dataset: Path | None, episodes: int, seed: int, objects: str | None) -> list[Start]:
    from optimus.errors import CheckpointError
    from optimus.evaluate import random_starts, require_same_problems, validation_starts

    if states == "random":
        return random_starts(episodes, seed, objects)
    if objects is not None:
        raise CheckpointError("--objects are for --states random: validation states have the dataset's own")
    if dataset is None:
        raise CheckpointError("--states validation needs --dataset DIR (or use --states random)")
    require_same_problems(run, dataset)
    return validation_starts(dataset, episodes)
