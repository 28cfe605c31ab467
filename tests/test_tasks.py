"""Every task: its starts are what the paper says, and the expert's plans are valid and succeed in physics."""

import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from conftest import SOLVED
from optimus.collision import CollisionChecker
from optimus.demonstrate import ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.errors import OptimusError, UnknownNameError
from optimus.logic import Atom
from optimus.motion.plan import Infeasible
from optimus.objects.shapes import slab
from optimus.planner import solve
from optimus.predicates import Clear, Holding, Open, Released, facts_of
from optimus.robots import PANDA
from optimus.scene import Fixture
from optimus.skills import Workspace
from optimus.task import Problem
from optimus.tasks import task
from optimus.world import compile_scene


@pytest.mark.parametrize("name", SOLVED)
def test_valid_plans_succeed(name: str) -> None:
    env = ManipulationEnv(task(name), images=False)
    attempt = demonstrate(env, 11, ExpertConfig(check=True))
    assert attempt.success, (attempt.failure, attempt.info.get("violations"))


@pytest.mark.parametrize(("name", "variant"), [("stack-adapt", "base on target"), ("microwave-adapt", "door free")])
def test_the_two_branches_come_equally_often(name: str, variant: str) -> None:
    count = sum(task(name).problem(seed).variant == variant for seed in range(200))
    assert 70 <= count <= 130  # 4.2 standard deviations about 100


def test_the_branches_ask_for_different_plans() -> None:
    for name, plain, longer in (
        ("stack-adapt", ("pick", "stack"), ("pick", "place", "pick", "stack")),
        ("microwave-adapt", ("open", "pick", "place"), ("pick", "place", "open", "pick", "place")),
    ):
        env, seen = ManipulationEnv(task(name), images=False), {}
        for seed in range(20):
            env.reset(seed=seed)
            if env.problem.variant not in seen:
                plan = solve(Workspace(env.world), env.state(), env.problem.goal, np.random.default_rng(0))
                assert not isinstance(plan, Infeasible), plan
                seen[env.problem.variant] = plan.skeleton
        assert sorted(seen.values(), key=len) == [plain, longer]


@pytest.mark.parametrize(("name", "count"), [("stack", 2), ("stack-three", 3), ("stack-four", 4), ("stack-five", 5)])
def test_blocks_start_apart_within_their_range(name: str, count: int) -> None:
    reach = {2: 0.08, 3: 0.10, 4: 0.12, 5: 0.14}[count]
    for seed in range(50):
        problem = task(name).problem(seed)
        points = np.array([pose.pos for pose in problem.poses.values()])
        assert len(points) == count and np.abs(points[:, :2] - (0.5, 0.0)).max() <= reach
        gaps = [np.linalg.norm(a[:2] - b[:2]) for i, a in enumerate(points) for b in points[:i]]
        assert min(gaps) > 0.056  # diagonals of two small blocks


def test_a_door_that_something_fixed_blocks_is_said_to_be_blocked() -> None:
    problem = task("microwave").problem(0)
    post = Fixture("post", slab(0.03, 0.03, 0.25, (0.5, 0.5, 0.5, 1.0)), (0.52, 0.0, 0.125))
    scene = replace(problem.scene, fixtures=(*problem.scene.fixtures, post))
    env = ManipulationEnv(replace(task("microwave"), draw=lambda rng: replace(problem, scene=scene)), images=False)
    env.reset(seed=0)
    found = solve(Workspace(env.world), env.state(), env.problem.goal, np.random.default_rng(0))
    assert isinstance(found, Infeasible)
    assert found.skill == "open" and "door" in found.objects and "post" in found.blockers, found


def test_things_behind_a_shut_door_are_out_of_reach_until_it_is_open() -> None:
    env = ManipulationEnv(task("microwave"), images=False)
    env.reset(seed=0)
    facts = facts_of(env.world.scene, env.state())
    assert Open("door") not in facts
    assert Open("door") in facts_of(env.world.scene, env.state().swung("door", 1.6))


def test_roofs_and_open_sky() -> None:
    scene = task("shelf").problem(0).scene
    rungs = {name: scene.fixture_poses[name].pos for name in ("lower", "middle")}
    assert all(scene.is_roofed(point, 0.0) for point in rungs.values())
    assert not scene.is_roofed(rungs["lower"] - (0.4, 0.0, 0.0), 0.1)
    assert not task("stack").problem(0).scene.is_roofed(np.array([0.5, 0.0, 0.02]), 0.1)


def test_a_pulled_door_may_touch_the_fingers_by_its_bar_alone() -> None:
    problem = task("microwave").problem(0)
    world = compile_scene(problem.scene)
    env = ManipulationEnv(task("microwave"), images=False)
    env.reset(seed=0)
    plan = solve(Workspace(env.world), env.state(), frozenset({Open("door")}), np.random.default_rng(0))
    assert not isinstance(plan, Infeasible)
    swing = next(s for s in plan.segments if s.doors)
    # fingers pressed 3 mm into the bar from either side
    state = replace(env.state(), q=swing.q[0], opening=2 * problem.scene.doors[0].bar.radius - 0.006)
    checker = CollisionChecker(world)
    checker.look_at(state, pulled="door")
    assert checker.check(swing.q[0]) is None
    checker.look_at(state)
    assert checker.check(swing.q[0]) is not None
    checker.look_at(state.swung("door", 1.45), pulled="door")
    assert checker.check(swing.q[-1]) is None
    checker.look_at(state.swung("door", 0.3), pulled="door")  # the door swings, the hand stays: they meet elsewhere
    assert checker.check(swing.q[0]) is not None


def test_a_task_of_ones_own_is_called_what_leads_back_to_it(monkeypatch: pytest.MonkeyPatch) -> None:
    mine = ModuleType("mine_module")
    mine.MINE = replace(task("stack"), summary="another")  # type: ignore[attr-defined]
    mine.NUMBER = 7  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "mine_module", mine)
    found = task("mine_module:MINE")
    assert (found.name, found.summary) == ("mine_module:MINE", "another") and task(found.name) == found
    with pytest.raises(UnknownNameError, match="a int, not a Task"):
        task("mine_module:NUMBER")
    with pytest.raises(OptimusError, match="horizon"):
        replace(found, horizon=0)


def test_a_fingerprint_is_of_what_is_drawn_and_of_the_robots_file_wherever_it_lies(tmp_path: Path) -> None:
    stack = task("stack")
    model, copy = (tmp_path / name / "arm.xml" for name in ("a", "b"))
    for path in (model, copy):
        path.parent.mkdir()
        path.write_text("<mujoco/>")
    arms = [replace(PANDA, source=str(path)) for path in (model, copy)]
    of_files = [stack.fingerprint(3, arm) for arm in arms]
    assert of_files[0] == of_files[1] and stack.fingerprint(3) == stack.fingerprint(3, PANDA)
    copy.write_text("<mujoco></mujoco>")

    def drawn(edit: Callable[[Problem], Problem]) -> str:
        return replace(stack, draw=lambda rng: edit(stack.draw(rng))).fingerprint(3)

    edits = [
        drawn(lambda p: replace(p, poses={**p.poses, "cubeA": p.poses["cubeA"].shifted((1e-6, 0.0, 0.0))})),
        drawn(lambda p: replace(p, goal=p.goal - {Released("cubeA")})),
        drawn(lambda p: replace(p, scene=replace(p.scene, fixtures=(replace(p.scene.fixtures[0], yaw=1e-6),)))),
        stack.fingerprint(3, replace(PANDA, camera_fovy=70.0)),
        stack.fingerprint(3, arms[1]),
        stack.fingerprint(4),
    ]
    assert len({stack.fingerprint(3), of_files[0], *edits}) == 8


@pytest.mark.parametrize(("goal", "rises"), [(Clear("cubeB"), "cubeA"), (Holding("cubeA"), "cubeA")])
def test_a_goal_of_clearing_or_holding_is_met_once_the_thing_is_lifted(goal: Atom, rises: str) -> None:
    plain = task("stack").problem(0)
    low = plain.poses["cubeB"]
    start = {**plain.poses, "cubeA": low.shifted((0.0, 0.0, 0.045))}
    problem = replace(plain, poses=start, goal=frozenset({goal}))
    env = ManipulationEnv(replace(task("stack"), draw=lambda rng: problem), images=False)
    attempt = demonstrate(env, 0, ExpertConfig())
    assert attempt.success
    assert env.state().poses[rises].pos[2] > start[rises].pos[2] + 0.005


def test_what_is_done_already_is_not_demonstrated() -> None:
    problem = replace(task("stack").problem(0), goal=frozenset({Clear("cubeA")}))
    env = ManipulationEnv(replace(task("stack"), draw=lambda rng: problem), images=False)
    attempt = demonstrate(env, 0, ExpertConfig())
    assert attempt.episode is None and "met at the start" in attempt.failure
