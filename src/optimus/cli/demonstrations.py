"""`collect`, `curate`, `imitability`: from a task to demonstrations worth learning from."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from tyro.conf import Positional, arg

from optimus.cli.options import (
    Backend,
    ControlName,
    Dataset,
    FirstSeed,
    Json,
    ObjectsName,
    PlanningSeconds,
    RobotName,
    TaskName,
    Workers,
    chosen_budget,
    chosen_robot,
)
from optimus.cli.output import bar, counts, say
from optimus.errors import OptimusError

if TYPE_CHECKING:
    from optimus.collect import Tally


Corner = Annotated[tuple[float, float, float] | None, arg(metavar="X Y Z")]
Datasets = Annotated[tuple[Path, ...], Positional, arg(metavar="DATASET...", help="folders, from `optimus collect`")]


def collect(
    task: TaskName,
    out: Path,
    episodes: int = 200,
    seed: FirstSeed = 0,
    workers: Workers = 0,
    backend: Backend = "local",
    images: bool = True,
    perturb: bool = True,
    mishaps: float = 0.0,
    gripper: Literal["binary", "continuous"] = "binary",
    stall: int = 5,
    grasps: Literal["fixed", "random"] = "fixed",
    ik: Literal["fixed", "random"] = "fixed",
    motion: Literal["straight", "sampled"] = "straight",
    speed: float = 0.35,
    check: bool = False,
    planning_seconds: PlanningSeconds = None,
    policy: Path | None = None,
    control: ControlName = "osc",
    robot: RobotName = None,
    objects: ObjectsName = None,
    json: Json = False,
) -> None:
    """Collect demonstrations by the expert into a folder; a second call goes on where the first was stopped.

    Try:
        optimus collect stack --episodes 300 --out data/stack
        optimus collect stack --episodes 5000 --out data/states --no-images    (`optimus render` adds images)
        optimus collect stack --episodes 300 --out data/sampled --motion sampled --grasps random --ik random --no-perturb
        optimus collect stack --episodes 300 --out data/mishaps --mishaps 0.5
        optimus collect stack --episodes 100 --out data/corrections --policy runs/stack --seed 5000000

    Args:
        out: the dataset's folder
        episodes: successful demonstrations wanted
        images: render what the cameras see; without, `optimus render` can do so later, exactly alike
        perturb: push the arm off its path now and then, the label staying the expert's own answer
        mishaps: share of the episodes in which a thing is pushed, slips out of the hand, or is missed by a grasp, so that the way
            back is learned too
        gripper: told to be open or shut, or led from one to the other over the stall
        stall: steps for which the gripper alone acts at a grasp or a release
        grasps: grasps and placements in a fixed order, the least turned first, or at random
        ik: ways of the arm to reach a pose by their distance, or at random; matters where no straight way is taken
        motion: straight ways first, or all but the last stretch as the sampling planner finds it
        speed: of the hand along its way [m/s]
        check: leave out plans that do not stand up to an independent check of their motions and effects
        policy: a run folder or pretrained:NAME whose policy takes turns with the expert; the labels stay the expert's (corrections)
    """
    from optimus.collect import CollectConfig
    from optimus.collect import collect as run_collect
    from optimus.correct import Turns
    from optimus.demonstrate import ExpertConfig
    from optimus.expert import TimeLaw
    from optimus.pretrained import trained_folder
    from optimus.rollout import Perturbation
    from optimus.skills import Style
    from optimus.tasks import with_objects

    style, law = Style(grasps=grasps, ik=ik, motion=motion), TimeLaw(speed=speed, stall=stall, gripper=gripper)
    pushed, budget = Perturbation() if perturb else None, chosen_budget(planning_seconds)
    expert = ExpertConfig(style, law, budget, pushed, check=check, mishaps=mishaps)
    config = CollectConfig(
        task=with_objects(task, objects),
        out=out,
        episodes=episodes,
        seed=seed,
        workers=workers,
        expert=expert,
        turns=Turns(trained_folder(policy)) if policy else None,
        control=control,
        robot=chosen_robot(robot),
        images=images,
        backend=backend,
    )
    with bar(episodes, f"collect {task}", "demo") as shown:
        result = run_collect(config, lambda tally: _show(shown, tally))
    text = f"{result.demonstrations} demonstrations of {result.attempts} attempts in {out}; failures: {counts(result.failures)}"
    say({"dataset": str(out), **asdict(result)}, json, text)


def _show(bar: Any, tally: Tally) -> None:
    """What there is, how fast it grows, the share of attempts that succeed, and why most of the others do not."""
    bar.initial, bar.n = tally.had, tally.successes
    reasons = [f"{n} {reason}" for reason, n in tally.failures.most_common(2)]
    more = len(tally.failures) - len(reasons)
    notes = [f"success {tally.successes / max(1, tally.attempts):.0%}", *reasons, *([f"{more} other reasons"] if more else [])]
    bar.set_postfix_str("; ".join(notes), refresh=False)
    bar.refresh()


def curate(
    dataset: Dataset,
    max_length_sd: float = 2.0,
    length_over: Literal["skeleton", "all"] = "skeleton",
    workspace_min: Corner = None,
    workspace_max: Corner = None,
    in_view: tuple[str, ...] = (),
    max_tracking_error: float | None = None,
    keep_retried: bool = False,
    validation_share: float = 0.1,
    seed: int = 0,
    json: Json = False,
) -> None:
    """Choose the demonstrations worth learning from and split them; nothing is rewritten. Only successes by the strict rule pass.

    Try:
        optimus curate data/stack
        optimus curate data/stack --length-over all --workspace-min 0.2 -0.4 -0.1 --workspace-max 0.8 0.4 0.6  (the paper's)
        optimus curate data/stack --in-view agentview --max-tracking-error 0.01

    Args:
        max_length_sd: leave out episodes longer than the mean by this many standard deviations
        length_over: ... of the episodes with the same plan skeleton, or of all
        workspace_min: lower corner of the box that the hand has to stay in [m]
        workspace_max: upper corner of that box [m]
        in_view: fixed cameras that have to see the hand and every object at every step
        max_tracking_error: largest median distance of the hand from the planned path [m]
        keep_retried: keep episodes in which the expert had to plan again
        validation_share: of the episodes kept, held out with their initial states for validation
        seed: decides which ones
    """
    from optimus.data.curate import CurationConfig
    from optimus.data.curate import curate as run_curate

    config = CurationConfig(
        max_length_sd=max_length_sd,
        length_over=length_over,
        workspace_min=workspace_min,
        workspace_max=workspace_max,
        in_view=in_view,
        max_tracking_error=max_tracking_error,
        keep_retried=keep_retried,
        validation_share=validation_share,
        seed=seed,
    )
    result = run_curate(dataset, config)
    counts = {"train": len(result.train), "validation": len(result.validation), "dropped": len(result.dropped)}
    lines = [f"{'rule':<20}{'removed':>9}{'alone':>9}"]
    lines += [f"{rule:<20}{n['removed']:>9}{n['alone']:>9}" for rule, n in result.rules.items()]
    lines += [", ".join(f"{n} {k}" for k, n in counts.items())]
    say({**counts, "rules": result.rules, "reasons": {str(k): v for k, v in result.dropped.items()}}, json, "\n".join(lines))


def imitability(datasets: Datasets, json: Json = False) -> None:
    """How far apart the actions are that were taken in alike situations: what is left to chance is what no policy can imitate.
    Smaller is easier. Compares ways of collecting one task, over equally many episodes (docs/imitability.md).

    Try: optimus imitability data/stack data/stack-sampled
    """
    from optimus.data.imitability import compared

    if not datasets:
        raise OptimusError("name at least one DATASET, a folder of `optimus collect`")
    results = dict(zip(map(str, datasets), compared(datasets), strict=True))
    rows = [f"{'':<26}{'episodes':>9}{'steps':>7}{'drift mm':>10}{'doubt':>7}{'alike mm':>10}{'compared':>10}"]
    for name, r in results.items():
        score = f"{1e3 * r.drift:>10.1f}{r.doubt:>7.2f}{1e3 * r.alike:>10.1f}{r.compared:>10.0%}"
        rows.append(f"{name:<26}{r.episodes:>9}{r.steps:>7.0f}{score}")
        for phase, p in r.phases.items():
            rows.append(f"  {phase:<24}{'':>9}{p['steps']:>7.0f}{1e3 * p['drift']:>10.1f}{p['doubt']:>7.2f}")
    say({name: asdict(r) for name, r in results.items()}, json, "\n".join(rows))
