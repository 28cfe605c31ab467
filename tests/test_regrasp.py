"""A can stands in a narrow bin, where the hand has to come from above, and is to go into a low cabinet, where it has to lean."""

import numpy as np
import pytest

from optimus.demonstrate import ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.logic import applicable, obstructs
from optimus.motion.plan import Infeasible, Plan
from optimus.objects.furniture import bin_of, box_open_in_front
from optimus.objects.shapes import block, cylinder, slab
from optimus.planner import Budget, operators_of, solve, with_unblocking
from optimus.predicates import On, Released, facts_of
from optimus.robots import PANDA
from optimus.scene import Fixture, Movable, Scene
from optimus.se3 import Pose
from optimus.skills import Workspace
from optimus.task import Problem, Task
from optimus.tasks import task

GREY, RED = (0.6, 0.6, 0.6, 1.0), (0.8, 0.2, 0.2, 1.0)
BLOCKS = {"one": (0.35, 0.30), "two": (0.35, 0.42)}
"""Others that have nothing to do with it, and where they stand [m]."""


def draw(rng: np.random.Generator) -> Problem:
    fixtures = (
        Fixture("table", slab(0.5, 0.6, 0.04, GREY), (0.5, 0.0, -0.02)),
        Fixture("bin", bin_of(0.13, 0.10, GREY), (0.48, -0.25, 0.05)),
        Fixture("cabinet", box_open_in_front(0.20, 0.40, 0.19, GREY), (0.75, 0.15, 0.095)),
    )
    movables = (*(Movable(name, block(0.04, GREY)) for name in BLOCKS), Movable("can", cylinder(0.02, 0.08, RED)))
    poses = {"can": Pose.of((0.48, -0.25, 0.05)), **{name: Pose.of((x, y, 0.02)) for name, (x, y) in BLOCKS.items()}}
    scene = Scene(PANDA, fixtures, movables, task("stack").problem(0).scene.cameras)
    return Problem(scene, poses, frozenset({On("can", "cabinet"), Released("can")}))


@pytest.fixture
def env() -> ManipulationEnv:
    env = ManipulationEnv(Task("cabinet", "a can from a bin into a cabinet", draw, 600), images=False)
    env.reset(seed=0)
    return env


def test_no_single_grasp_serves_both_ends_and_yet_there_is_a_plan(env: ManipulationEnv) -> None:
    start, goal = env.state(), env.problem.goal
    found = solve(Workspace(env.world), start, goal, np.random.default_rng(0), Budget(skeletons=1))
    assert isinstance(found, Infeasible) and found.objects == ("can", "bin")
    plan = solve(Workspace(env.world), start, goal, np.random.default_rng(0))
    assert isinstance(plan, Plan), plan
    assert [str(step.operator) for step in plan.steps] == [
        "pick(can, bin)",
        "place(can, table)",
        "pick(can, table)",
        "place(can, cabinet)",
    ]
    # it did not come by it by trying whatever else is four steps long
    assert plan.stats["skeletons"] <= 3


def test_what_has_nothing_to_do_with_a_failure_is_not_tried_again_for_it(env: ManipulationEnv) -> None:
    goal = env.problem.goal | {On("one", "two")}
    plan = solve(Workspace(env.world), env.state(), goal, np.random.default_rng(0), Budget(seconds=20))
    assert isinstance(plan, Plan), plan
    assert plan.skeleton == ("pick", "stack", "pick", "place", "pick", "place") and plan.stats["skeletons"] == 2


def test_physics_confirms_the_change_of_grasp(env: ManipulationEnv) -> None:
    attempt = demonstrate(env, 0, ExpertConfig(check=True))
    assert attempt.success and attempt.info["retries"] == 0, attempt.failure


def test_a_thing_in_the_way_of_its_own_placing_is_put_down_elsewhere_first(env: ManipulationEnv) -> None:
    facts = facts_of(env.world.scene, env.state())
    named = {str(o): o for o in operators_of(Workspace(env.world), facts)}
    learned = frozenset({obstructs("can", named["place(can, cabinet)"])})
    after = {str(o): o for o in with_unblocking(tuple(named.values()), learned)}
    held = after["pick(can, bin)"].apply(facts | learned)
    assert not applicable(after["place(can, cabinet)"], held)
    again = after["pick(can, table)"].apply(after["place(can, table)"].apply(held))
    assert applicable(after["place(can, cabinet)"], again)
