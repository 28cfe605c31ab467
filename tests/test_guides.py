"""The code in the guides runs, and does what they say."""

import re
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from optimus.closed_loop import ClosedLoop
from optimus.demonstrate import ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.errors import ModelError, UnknownNameError
from optimus.expert import TimeLaw
from optimus.goals import require_consistent
from optimus.logic import Atom
from optimus.motion.plan import Plan
from optimus.objects.shapes import cup
from optimus.planner import Budget, solve
from optimus.predicates import PREDICATES, HandEmpty, Holding, On, Open, Shut, holds
from optimus.rollout import rollout
from optimus.show import show_plan
from optimus.skills import SKILLS, Workspace
from optimus.task import Task
from optimus.tasks import task

DOCS = Path(__file__).parent.parent / "docs"


def run_guide(guide: str, name: str) -> ModuleType:
    """The guide's first block of Python as a module of that name."""
    found = re.search(r"```python\n(.*?)```", (DOCS / guide).read_text(), re.DOTALL)
    assert found
    module = ModuleType(name)
    sys.modules[name] = module
    exec(compile(found.group(1), guide, "exec"), module.__dict__)
    return module


@pytest.fixture
def swap() -> Iterator[ModuleType]:
    yield run_guide("add_a_task.md", "swap_task")
    del sys.modules["swap_task"]


def test_the_task_of_the_guide_is_solved(swap: ModuleType) -> None:
    env = ManipulationEnv(task("swap_task:SWAP"), images=False)
    attempts = [demonstrate(env, seed, ExpertConfig(check=True)) for seed in range(2)]
    assert all(a.success for a in attempts), [a.failure for a in attempts]
    # two objects, each where the other belongs: nothing need be moved twice
    assert {a.episode.skeleton for a in attempts if a.episode} == {("pick", "place", "pick", "place")}


def test_what_a_task_can_get_wrong_is_said(swap: ModuleType) -> None:
    problem = swap.SWAP.problem(0)
    with pytest.raises(ModelError, match=r"the goal names lid; the scene has .*left"):
        replace(problem, goal=frozenset({Atom("On", ("lid", "left"))}))
    with pytest.raises(ModelError, match=r"On\(left, cup\) is asked for, but left is no movable; those are cup, block"):
        replace(problem, goal=frozenset({Atom("On", ("left", "cup"))}))
    with pytest.raises(ModelError, match=r"Under\(cup, left\) is asked for; what can be is .*On"):
        replace(problem, goal=frozenset({Atom("Under", ("cup", "left"))}))
    with pytest.raises(ModelError, match="poses"):
        replace(problem, poses={})
    with pytest.raises(ModelError, match=r"names of their own.*: cup"):
        replace(swap.SCENE, movables=(*swap.SCENE.movables, swap.SCENE.movables[0]))
    with pytest.raises(ModelError, match="left is behind the door hatch; the scene's are none"):
        replace(swap.SCENE, fixtures=tuple(replace(f, door="hatch" if f.name == "left" else None) for f in swap.SCENE.fixtures))
    with pytest.raises(ModelError, match=r"cylinder of half-sizes .* above zero"):
        cup(0.005, 0.1, (1, 0, 0, 1))
    with pytest.raises(ModelError, match=r"SWAP: `draw` gives a tuple, where a Problem is wanted"):
        replace(swap.SWAP, draw=lambda rng: (problem, rng)).problem(0)
    with pytest.raises(ModelError, match=r"a problem's poses hold \(0, 0, 0\), a tuple, where Pose is wanted"):
        replace(problem, poses=dict.fromkeys(problem.poses, (0, 0, 0)))
    with pytest.raises(ModelError, match=r"a problem's poses hold None, a NoneType"):
        replace(problem, poses=dict.fromkeys(problem.poses))
    with pytest.raises(ModelError, match=r"a problem's goal hold 'On\(cup, left\)', a str, where Atom is wanted"):
        replace(problem, goal=frozenset({"On(cup, left)"}))
    with pytest.raises(ModelError, match="one has none"):
        replace(swap.SCENE, movables=(replace(swap.SCENE.movables[0], name=""), *swap.SCENE.movables[1:]))
    with pytest.raises(ModelError, match=r"the goal has block and cup on tray, which carries one thing"):
        require_consistent(frozenset({On("cup", "tray"), On("block", "tray")}), {"tray"})
    require_consistent(frozenset({On("cup", "tray"), On("block", "tray")}))  # furniture carries any number
    with pytest.raises(ModelError, match=r"the horizon is a number of steps, not '600'"):
        replace(swap.SWAP, horizon="600")
    drawn = iter(range(100))
    restless = replace(swap.SWAP, draw=lambda rng: replace(problem, variant=str(next(drawn))))
    with pytest.raises(ModelError, match="another problem each time for one seed; draw with its rng alone"):
        restless.fingerprint(0)
    together = replace(problem, poses=dict.fromkeys(problem.poses, problem.poses["cup"]))
    overlapping = replace(swap.SWAP, draw=lambda rng: together)
    with pytest.raises(ModelError, match=r"cup and block overlap by \d+ mm|block and cup overlap by \d+ mm"):
        ManipulationEnv(overlapping, images=False).reset(seed=0)
    with pytest.raises(UnknownNameError, match=r"NOTHING'; valid: .*swap_task:SWAP"):
        task("swap_task:NOTHING")
    with pytest.raises(UnknownNameError, match="Empty module name"):
        task(":NOTHING")


CONTRADICTIONS = {
    "cup on left and on right at once": {On("cup", "left"), On("cup", "right")},
    "block on cup on block": {On("cup", "block"), On("block", "cup")},
    "cup held and let go of": {Holding("cup"), On("cup", "left")},
    "block held and let go of": {Holding("block"), HandEmpty()},
    "block and cup held": {Holding("cup"), Holding("block")},
    "door open and shut at once": {Open("door"), Shut("door")},
}


@pytest.mark.parametrize("said", list(CONTRADICTIONS))
def test_a_goal_that_contradicts_itself_is_refused(said: str) -> None:
    with pytest.raises(ModelError, match=f"the goal .*{said}"):
        require_consistent(frozenset(CONTRADICTIONS[said]))


def test_what_the_hand_does_not_span_is_said_and_what_it_does_is_moved(swap: ModuleType) -> None:
    def with_cup(radius: float) -> Task:
        movables = (replace(swap.SCENE.movables[0], shape=cup(radius, 0.075, (1, 0, 0, 1))), *swap.SCENE.movables[1:])
        scene = replace(swap.SCENE, movables=movables)
        return replace(swap.SWAP, draw=lambda rng: replace(swap.draw(rng), scene=scene))

    with pytest.raises(ModelError, match=r"cup is 76 mm across .* panda opens 80 mm"):
        with_cup(0.038).problem(0)
    env = ManipulationEnv(with_cup(0.036), images=False)
    assert all(demonstrate(env, seed, ExpertConfig()).success for seed in range(3))


def test_the_skill_of_the_guide_is_planned_with_and_done(tmp_path: Path) -> None:
    before = set(PREDICATES), set(SKILLS)
    try:
        guide = run_guide("add_a_skill.md", "present_skill")
        env = ManipulationEnv(task("stack"), images=False)
        observation, _ = env.reset(seed=0)
        goal, workspace, rng = frozenset({guide.Presented("cubeB")}), Workspace(env.world), np.random.default_rng(0)
        plan = solve(workspace, env.state(), goal, rng)
        assert isinstance(plan, Plan) and plan.skeleton == ("pick", "present")
        env.problem = replace(env.problem, goal=goal)
        presenting = replace(task("stack"), draw=lambda rng: env.problem)
        assert show_plan(presenting, 0, tmp_path / "plan.png").skeleton == plan.skeleton  # the gripper has nothing to do in it
        rollout(env, observation, ClosedLoop(env, workspace, plan, TimeLaw(), rng, Budget()), "expert")
        assert holds(env.world.scene, env.state(), guide.Presented("cubeB"))
    finally:
        for table, known in zip((PREDICATES, SKILLS), before, strict=True):
            for name in set(table) - known:
                del table[name]
