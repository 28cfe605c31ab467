"""The independent check of plans: it finds nothing in what the planner makes, and each kind of fault where one is put in."""

from collections.abc import Callable
from dataclasses import replace

import mujoco
import numpy as np
import pytest

from conftest import SOLVED
from optimus import demonstrate
from optimus.env import ManipulationEnv
from optimus.logic import Atom
from optimus.motion.plan import Plan, Segment, Step
from optimus.planner import solve
from optimus.predicates import Holding, On
from optimus.se3 import Array, Pose
from optimus.skills import Style, Workspace
from optimus.state import State
from optimus.tasks import task
from optimus.validate import SAMPLE_STEP, Violation, _samples, validate
from optimus.world import World, compile_scene

Fault = Callable[[Plan], Plan]


def planned(name: str, seed: int, style: Style | None = None) -> tuple[ManipulationEnv, Plan]:
    env = ManipulationEnv(task(name), images=False)
    env.reset(seed=seed)
    found = solve(Workspace(env.world, style or Style()), env.state(), env.problem.goal, np.random.default_rng(seed))
    assert isinstance(found, Plan), found
    return env, found


@pytest.fixture(scope="module")
def stack() -> tuple[ManipulationEnv, Plan]:
    return planned("stack", 1)


def kinds(env: ManipulationEnv, plan: Plan) -> set[str]:
    return {v.what for v in validate(plan, env.world.scene, env.problem.goal)}


@pytest.mark.parametrize("name", SOLVED)
def test_the_planner_s_own_plans_are_valid(name: str) -> None:
    env, plan = planned(name, 0)  # as all those are of `test_planner.plan_for`
    assert validate(plan, env.world.scene, env.problem.goal) == []


# ---- faults, each put into a valid plan


def with_segment(plan: Plan, step: int, segment: int, change: Callable[[Segment], Segment]) -> Plan:
    segments = list(plan.steps[step].segments)
    segments[segment] = change(segments[segment])
    return with_step(plan, step, lambda s: replace(s, segments=tuple(segments)))


def with_step(plan: Plan, step: int, change: Callable[[Step], Step]) -> Plan:
    steps = list(plan.steps)
    steps[step] = change(steps[step])
    return replace(plan, steps=tuple(steps))


def with_states(plan: Plan, change: Callable[[State], State]) -> Plan:
    return Plan(change(plan.start), tuple(replace(s, after=change(s.after)) for s in plan.steps), plan.stats)


def with_path(world: World, segment: Segment, q: Array) -> Segment:
    """The segment along another joint path, its poses those of the model."""
    data, poses = mujoco.MjData(world.model), []
    for row in q:
        data.qpos[world.arm_qpos] = row
        mujoco.mj_kinematics(world.model, data)
        poses.append(world.tcp(data))
    return replace(segment, q=q, poses=tuple(poses))


def bump(length: int, height: float) -> Array:
    """`(length,)`: from zero to `height` and back, smoothly."""
    return height * np.sin(np.linspace(0.0, np.pi, length)) ** 2


def test_a_waypoint_in_the_table(stack: tuple[ManipulationEnv, Plan]) -> None:
    env, plan = stack

    def dip(segment: Segment) -> Segment:
        q = segment.q.copy()
        q[:, 1] += bump(len(q), 0.5)  # the shoulder bends forward, the hand goes down
        return with_path(env.world, segment, q)

    found = validate(with_segment(plan, 0, 0, dip), env.world.scene, env.problem.goal)
    collisions = [v for v in found if v.what == "collision"]
    assert any("robot meets table" in v.detail and v.step == 0 and v.segment == 0 and v.amount > 0.001 for v in collisions)
    assert {v.what for v in found} <= {"collision", "speed"}


def test_a_joint_line_that_strays_from_the_line_of_the_hand(stack: tuple[ManipulationEnv, Plan]) -> None:
    env, plan = stack
    # hardly any waypoints: the follower would take the straight lines between, the arm's joints curve away from them
    sparse = with_segment(plan, 0, 0, lambda s: with_path(env.world, s, np.vstack([s.q[:-1:30], s.q[-1:]])))
    assert "pose" in kinds(env, sparse)


def test_samples_are_near_each_other_and_reach_every_waypoint() -> None:
    q = np.array([[0.0, 0.0], [0.1, -0.3], [0.1, -0.3], [0.1001, -0.3]])
    at = list(_samples(q))
    path = np.array([[np.interp(t, range(4), joint) for joint in q.T] for t in at])
    assert np.abs(np.diff(path, axis=0)).max() <= SAMPLE_STEP + 1e-12
    assert {0.0, 1.0, 2.0, 3.0} <= set(at) and at == sorted(at)


def test_a_joint_jump(stack: tuple[ManipulationEnv, Plan]) -> None:
    env, plan = stack

    def jump(segment: Segment) -> Segment:
        q = segment.q.copy()
        q[len(q) // 2 :, 6] += 0.5
        return with_path(env.world, segment, q)

    found = validate(with_segment(plan, 0, 0, jump), env.world.scene, env.problem.goal)
    jumps = [v for v in found if v.what == "continuity"]
    # within the segment, and where the next one begins at an arm that is elsewhere now
    assert [v.segment for v in jumps] == [0, 1] and abs(jumps[0].amount - 0.5) < 0.2


def test_a_segment_that_begins_elsewhere(stack: tuple[ManipulationEnv, Plan]) -> None:
    env, plan = stack
    late = with_segment(plan, 1, 0, lambda s: replace(s, q=s.q[1:], poses=s.poses[1:]))
    assert [v.what for v in validate(late, env.world.scene, env.problem.goal)] == ["continuity"]


def test_a_joint_beyond_its_limit(stack: tuple[ManipulationEnv, Plan]) -> None:
    env, plan = stack
    high = env.world.arm_range[5, 1]

    def bend(segment: Segment) -> Segment:
        q = segment.q.copy()
        q[:, 5] += bump(len(q), high + 0.05 - q[len(q) // 2, 5])
        return with_path(env.world, segment, q)

    found = [v for v in validate(with_segment(plan, 0, 2, bend), env.world.scene, env.problem.goal) if v.what == "limits"]
    assert found and all(v.detail == "joint6" and v.segment == 2 for v in found)
    assert 0.0 < max(v.amount for v in found) < 0.06


def test_a_joint_that_would_have_to_be_too_fast(stack: tuple[ManipulationEnv, Plan]) -> None:
    env, plan = stack
    law_speeds = [v for v in kinds(env, plan) if v == "speed"]
    slow = replace(env.world.scene.robot, speed_limits=(0.3,) * 7)
    scene = replace(env.world.scene, robot=slow)
    found = validate(plan, scene, env.problem.goal)
    assert not law_speeds and {v.what for v in found} == {"speed"} and all(v.amount > 1.0 for v in found)


def test_poses_that_are_not_the_arm_s(stack: tuple[ManipulationEnv, Plan]) -> None:
    env, plan = stack
    moved = with_segment(plan, 0, 0, lambda s: replace(s, poses=(*s.poses[:3], s.poses[3].shifted((0, 0, 0.004)), *s.poses[4:])))
    found = validate(moved, env.world.scene, env.problem.goal)
    assert [(v.what, v.index) for v in found] == [("pose", 3)] and abs(found[0].amount - 0.004) < 5e-4


def test_a_thing_in_the_way(stack: tuple[ManipulationEnv, Plan]) -> None:
    env, plan = stack
    way = plan.steps[1].segments[0].poses
    middle = way[2 * len(way) // 3]
    # cubeB hangs where cubeA is carried along, in every state, so that no state is at fault
    blocked = with_states(plan, lambda s: s.moved("cubeB", Pose.of(middle.pos)))
    found = validate(blocked, env.world.scene, env.problem.goal)
    hits = [v.detail for v in found if v.what == "collision" and v.step == 1]
    assert "carry: cubeA meets cubeB" in hits


def test_another_thing_moved_where_the_hand_goes_down(stack: tuple[ManipulationEnv, Plan]) -> None:
    env, plan = stack
    beside = plan.start.poses["cubeA"].shifted((0.0, 0.0, 0.05))
    found = validate(with_states(plan, lambda s: s.moved("cubeB", beside)), env.world.scene, env.problem.goal)
    assert any(v.what == "collision" and "cubeB meets robot" in v.detail and v.step == 0 for v in found)


def test_what_is_held_may_press_on_its_support_a_little(stack: tuple[ManipulationEnv, Plan]) -> None:
    env, plan = stack
    for depth, meets in ((0.002, False), (0.005, True)):
        sunk = replace(plan, start=plan.start.moved("cubeA", plan.start.poses["cubeA"].shifted((0.0, 0.0, -depth))))
        found = validate(sunk, env.world.scene, env.problem.goal)
        assert any("cubeA meets table" in v.detail for v in found) == meets


def test_things_that_only_touch_each_other_are_no_fault_of_the_plan(stack: tuple[ManipulationEnv, Plan]) -> None:
    env, plan = stack
    sunk = with_states(plan, lambda s: s.moved("cubeB", s.poses["cubeB"].shifted((0.0, 0.0, -0.002))))
    assert validate(sunk, env.world.scene, env.problem.goal) == []


def test_a_grasp_beside_the_thing(stack: tuple[ManipulationEnv, Plan]) -> None:
    env, plan = stack
    away = plan.start.poses["cubeA"].shifted((0.0, 0.0, -0.06))
    found = validate(replace(plan, start=plan.start.moved("cubeA", away)), env.world.scene, env.problem.goal)
    assert any(v.what == "state" and v.step == 0 and v.detail == "holds None, not cubeA" for v in found)


@pytest.mark.parametrize(
    ("kind", "atom"), [("adds", On("cubeB", "cubeA")), ("needs", Holding("cubeB")), ("needs", Atom("Nonsense", ("cubeA",)))]
)
def test_a_wrong_fact(stack: tuple[ManipulationEnv, Plan], kind: str, atom: Atom) -> None:
    env, plan = stack
    wrong = {kind: getattr(plan.steps[0].operator, kind) | {atom}}
    changed = with_step(plan, 0, lambda s: replace(s, operator=replace(s.operator, **wrong)))
    found = validate(changed, env.world.scene, env.problem.goal)
    assert [(v.what, v.step) for v in found] == [(kind, 0)] and str(atom) in found[0].detail


def test_a_fact_that_stays_and_a_goal_that_is_missed(stack: tuple[ManipulationEnv, Plan]) -> None:
    env, plan = stack
    still = with_step(plan, 1, lambda s: replace(s, operator=replace(s.operator, deletes=frozenset({On("cubeA", "cubeB")}))))
    assert kinds(env, still) == set(), "what an operator also adds, it does not delete"
    wrong = replace(plan.steps[1].operator, adds=frozenset(), deletes=frozenset({On("cubeA", "cubeB")}))
    assert kinds(env, with_step(plan, 1, lambda s: replace(s, operator=wrong))) == {"deletes"}
    assert kinds(env, replace(plan, steps=plan.steps[:1])) == {"goal"}


def test_a_state_that_the_motions_do_not_lead_to(stack: tuple[ManipulationEnv, Plan]) -> None:
    env, plan = stack
    shifted = with_step(
        plan, 1, lambda s: replace(s, after=s.after.moved("cubeA", s.after.poses["cubeA"].shifted((0.004, 0.0, 0.0))))
    )
    found: list[Violation] = validate(shifted, env.world.scene, env.problem.goal)
    assert [v.what for v in found] == ["state"] and "cubeA" in str(found[0])


def test_nonsense_is_reported_not_raised(stack: tuple[ManipulationEnv, Plan]) -> None:
    env, plan = stack
    for q in (np.zeros((3, 7)), np.zeros((1, 5)), np.full((1, 7), np.nan)):
        bad = with_segment(plan, 0, 1, lambda s, q=q: replace(s, q=q))
        assert "shape" in kinds(env, bad)


def test_the_check_has_its_own_model(stack: tuple[ManipulationEnv, Plan]) -> None:
    """A planner whose model lost a collision would be found out."""
    env, plan = stack
    beside = plan.start.poses["cubeA"].shifted((0.0, 0.0, 0.05))
    blind = with_states(plan, lambda s: s.moved("cubeB", beside))
    model = compile_scene(env.world.scene).model
    saved = model.geom_contype.copy(), model.geom_conaffinity.copy()
    try:
        model.geom_contype[:], model.geom_conaffinity[:] = 0, 0
        assert "collision" in kinds(env, blind)
    finally:
        model.geom_contype[:], model.geom_conaffinity[:] = saved


def test_an_invalid_plan_is_a_failure_with_its_faults(monkeypatch: pytest.MonkeyPatch) -> None:
    env = ManipulationEnv(task("stack"), images=False)
    slow = replace(env.world.scene, robot=replace(env.world.scene.robot, speed_limits=(0.3,) * 7))
    monkeypatch.setattr(demonstrate, "validate", lambda plan, scene, goal, law: validate(plan, slow, goal, law))
    attempt = demonstrate.demonstrate(env, 1, demonstrate.ExpertConfig(check=True))
    assert attempt.episode is None and attempt.failure == "invalid plan: speed"
    assert attempt.info["violations"] and "joint" in attempt.info["violations"][0]
    assert demonstrate.demonstrate(env, 1, demonstrate.ExpertConfig()).success
