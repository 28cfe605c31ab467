"""`tasks` and `show`: what there is to solve, and what it looks like."""

from __future__ import annotations

from pathlib import Path

from optimus.cli.options import Json, ObjectsName, PlanningSeconds, RobotName, TaskName, chosen_budget, chosen_robot
from optimus.cli.output import say
from optimus.errors import OptimusError


def tasks(json: Json = False) -> None:
    """List the tasks.

    Try: optimus tasks
    """
    from optimus.registration import gym_id
    from optimus.tasks import TASKS
    from optimus.tasks import task as task_named

    all_tasks = [task_named(name) for name in TASKS]
    rows = [
        {"name": t.name, "summary": t.summary, "instruction": t.problem(0).instruction, "horizon": t.horizon, "gym": gym_id(t.name)}
        for t in all_tasks
    ]
    width = max(len(name) for name in TASKS)
    say({"tasks": rows}, json, "\n".join(f"{r['name']:<{width}} {r['summary']}  [{r['gym']}]" for r in rows))


def show(
    task: TaskName,
    plan: bool = False,
    film: bool = False,
    check: bool = False,
    planning_seconds: PlanningSeconds = None,
    seed: int = 0,
    out: Path | None = None,
    robot: RobotName = None,
    objects: ObjectsName = None,
    json: Json = False,
) -> None:
    """Write a picture of a task's start, or with --plan of the expert's plan.

    Try:
        optimus show stack --seed 3
        optimus show stack --plan --check --seed 3 --out plan.png
        optimus show stack --robot ur5e
        optimus show stack --film --out stack.webp

    Args:
        plan: draw the plan, one skill after another, with its motions (blue: hand empty, orange: carrying)
        film: write a short looping film of the expert instead (WebP; GIF if --out says so)
        check: with --plan: refuse a plan that does not stand up to an independent check of its motions and effects
        seed: which problem
        out: the file to write; by default TASK-SEED[-plan].png or TASK-SEED.webp here
    """
    from optimus.demonstrate import ExpertConfig
    from optimus.show import sentence, show_plan, show_scene
    from optimus.tasks import task as task_named
    from optimus.tasks import with_objects

    chosen = task_named(with_objects(task, objects))
    if film and plan:
        raise OptimusError("either --film or --plan: a plan is a picture, a film shows it carried out")
    if check and not plan:
        raise OptimusError("--check is for plans: add --plan")
    if planning_seconds is not None and not plan:
        raise OptimusError("--planning-seconds is for plans: add --plan")
    if film:
        from optimus.show import show_film

        out = out or Path(f"{task}-{seed}.webp")
        episode = show_film(chosen, seed, out, chosen_robot(robot))
        text = f"{', '.join(episode.skeleton) or chosen.summary}: {len(episode)} steps"
        return say({"film": str(out), "shows": text, "steps": len(episode)}, json, f"{text}\n{out}")
    out = out or Path(f"{task.replace(':', '-')}-{seed}{'-plan' if plan else ''}.png")
    if plan:
        config = ExpertConfig(budget=chosen_budget(planning_seconds), check=check)
        found = show_plan(chosen, seed, out, config, chosen_robot(robot))
        text = "; ".join(f"{i}. {sentence(s.operator)}" for i, s in enumerate(found.steps, 1))
    else:
        text = show_scene(chosen, seed, out, chosen_robot(robot))
    say({"picture": str(out), "shows": text}, json, f"{text}\n{out}")
