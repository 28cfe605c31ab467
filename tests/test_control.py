"""Three ways of control: the arm goes where it is sent, the expert works with each, and a dataset remembers which it was."""

import dataclasses
import json
import shutil
from pathlib import Path

import gymnasium
import mujoco
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

from optimus.collect import CollectConfig, collect
from optimus.conditions import Conditions
from optimus.control import CONTROLS, JOINT_SCALE, controller
from optimus.control.joint import MAX_LEAD, JointTarget
from optimus.control.osc import OperationalSpace
from optimus.correct import Turns
from optimus.data.curate import curate
from optimus.data.store import EpisodeStore
from optimus.data.windows import WindowConfig, Windows
from optimus.demonstrate import ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.errors import CheckpointError, DatasetError, UnknownNameError
from optimus.evaluate import play, random_starts
from optimus.kinematics import Kinematics
from optimus.learn.agent import PolicyAgent
from optimus.learn.checkpoint import load
from optimus.learn.train import TrainConfig, train
from optimus.robots.catalogue import robot
from optimus.rollout import Perturbation
from optimus.se3 import Pose, error_between, quat_from_rotvec, quat_mul
from optimus.tasks import task

NAMES = tuple(CONTROLS)


def make(name: str, images: bool = False, problem: str = "stack") -> ManipulationEnv:
    return ManipulationEnv(task(problem), images=images, control=name)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.filterwarnings("error")
def test_gymnasium_finds_nothing_to_say(name: str) -> None:
    check_env(gymnasium.make("optimus/Stack-v0", control=name).unwrapped, skip_render_check=True)


def test_an_unknown_control_is_named_with_the_valid_ones(tmp_path: Path) -> None:
    with pytest.raises(UnknownNameError, match="ik, joint, osc"):
        make("torque")
    with pytest.raises(UnknownNameError, match="ik, joint, osc"):
        controller("torque", make("osc").world)
    with pytest.raises(UnknownNameError, match="ik, joint, osc"):
        collect(CollectConfig("stack", tmp_path / "d", 1, control="torque"))
    assert not (tmp_path / "d").exists()


def send(env: ManipulationEnv, goal: Pose, steps: int = 60) -> Pose:
    """Where the tcp is after being sent to `goal`: for joint control to a configuration that MuJoCo says is there."""
    if env.control == "joint":
        configuration = next(Kinematics(env.world).solutions(goal, env.world.home))
        env.data.qpos[env.world.arm_qpos], before = configuration, env.data.qpos[env.world.arm_qpos].copy()
        mujoco.mj_kinematics(env.world.model, env.data)
        assert np.linalg.norm(env.world.tcp(env.data).pos - goal.pos) < 1e-3
        env.data.qpos[env.world.arm_qpos] = before
        mujoco.mj_forward(env.world.model, env.data)
    for _ in range(steps):
        seen = env._proprioception()
        if env.control == "joint":
            now = seen["robot0_joint_pos"] + seen["robot0_joint_target_error"]
            delta = (configuration - now) / JOINT_SCALE  # pyright: ignore[reportPossiblyUnboundVariable]
        else:
            tcp, missing = env.world.tcp(env.data), seen["robot0_target_error"].astype(float)
            target = Pose(tcp.pos + missing[:3], quat_mul(quat_from_rotvec(missing[3:]), tcp.quat))
            delta = env.controller.action_for(error_between(goal, target), env.data)
        env.step(np.array([*np.clip(delta, -0.5, 0.5), -1.0], np.float32))
    return env.world.tcp(env.data)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("move", [(0.10, 0.15, 0.05, 0.0, 0.0, 0.8), (-0.08, -0.20, 0.12, 0.3, -0.2, -0.5)])
def test_the_tcp_reaches_a_commanded_pose(name: str, move: tuple[float, ...]) -> None:
    env = make(name)
    env.reset(seed=0)
    home = env.world.tcp(env.data)
    goal = Pose(home.pos + move[:3], quat_mul(quat_from_rotvec(move[3:]), home.quat))
    missing = error_between(goal, send(env, goal))
    assert np.linalg.norm(missing[:3]) < 0.002 and np.linalg.norm(missing[3:]) < 0.01


@pytest.mark.parametrize("robot_name", ["panda", "ur5e"])
def test_the_law_is_khatib_s_written_out_with_inverses(robot_name: str) -> None:
    env = ManipulationEnv(task("stack"), images=False, robot=robot(robot_name))
    env.reset(seed=0)
    law, data, model, world = OperationalSpace(env.world), env.data, env.world.model, env.world
    rng, dof = np.random.default_rng(0), len(world.arm_dof)
    limits = np.array(world.scene.robot.torque_limits)
    within = 0
    for _ in range(20):
        data.qpos[world.arm_qpos] = rng.uniform(world.arm_range[:, 0], world.arm_range[:, 1])
        data.qvel[world.arm_dof] = rng.normal(size=dof) * 0.1
        mujoco.mj_step1(model, data)
        tcp = world.tcp(data)
        law.target = Pose(tcp.pos + rng.normal(size=3) * 0.005, quat_mul(quat_from_rotvec(rng.normal(size=3) * 0.02), tcp.quat))
        whole, jacp, jacr = np.zeros((model.nv, model.nv)), np.zeros((3, model.nv)), np.zeros((3, model.nv))
        mujoco.mj_fullM(model, data, whole)
        mujoco.mj_jacSite(model, data, jacp, jacr, world.tcp_site)
        jac, mass = np.vstack([jacp, jacr])[:, world.arm_dof], whole[np.ix_(world.arm_dof, world.arm_dof)]
        q, speed = data.qpos[world.arm_qpos], data.qvel[world.arm_dof]
        task_mass = np.linalg.inv(jac @ np.linalg.inv(mass) @ jac.T + 1e-3 * np.eye(6))
        low, high = world.arm_range[:, 0] + 0.15 - q, q - world.arm_range[:, 1] + 0.15
        pull = 30 * (world.home - q) + 400 * (np.maximum(low, 0) - np.maximum(high, 0)) - 2 * np.sqrt(30) * speed
        relax = mass @ (pull - jac.T @ np.linalg.inv(jac @ jac.T + 1e-5 * np.eye(6)) @ jac @ pull)
        relax -= jac.T @ task_mass @ jac @ np.linalg.inv(mass) @ relax
        drawn = jac.T @ task_mass @ (400 * error_between(law.target, tcp) - 40 * jac @ speed)
        free = drawn + relax + data.qfrc_bias[world.arm_dof] + model.dof_damping[world.arm_dof] * speed
        np.testing.assert_allclose(law.torque(data), np.clip(free, -limits, limits), rtol=1e-6, atol=1e-6)
        within += int(np.sum(np.abs(free) < limits))
    assert within > 20 * dof / 2  # most of it is the law, not its limits


@pytest.mark.parametrize("name", NAMES)
def test_a_push_on_the_action_moves_the_hand_as_meant(name: str) -> None:
    env = make(name)
    env.reset(seed=0)
    before, twist = env.world.tcp(env.data), np.array([0.03, -0.02, 0.01, 0.0, 0.0, 0.1])
    push = env.controller.action_for(twist, env.data)
    assert push.shape == (env.action_size - 1,)
    env.step(np.array([*push, -1.0], np.float32))
    for _ in range(15):
        env.step(np.array([*np.zeros_like(push), -1.0], np.float32))
    np.testing.assert_allclose(error_between(env.world.tcp(env.data), before), twist, atol=0.004)


@pytest.mark.parametrize("name", NAMES)
def test_pressing_on_the_table_does_not_wind_up(name: str) -> None:
    env = make(name)
    env.reset(seed=0)
    down = env.controller.action_for(np.array([0, 0, -0.05, 0, 0, 0]), env.data)
    for _ in range(60):
        env.step(np.array([*np.clip(down, -1, 1), 1.0], np.float32))
    error = env.controller.target_error(env.data)
    if name == "joint":
        assert np.abs(error).max() < MAX_LEAD + 0.005  # it gave way a little since
        limits = env.world.arm_range
        assert isinstance(env.controller, JointTarget)
        assert np.all((env.controller.target >= limits[:, 0]) & (env.controller.target <= limits[:, 1]))
    else:
        target = env.world.tcp(env.data).pos + error[:3]
        assert np.all(target >= np.array(env.world.scene.low) - 1e-9)
    assert np.abs(env.controller.torque(env.data)).max() <= max(env.world.scene.robot.torque_limits)
    assert env.world.tcp(env.data).pos[2] > -0.02


def test_targets_keep_to_the_box_of_their_own_scene() -> None:
    env = make("ik")
    env.reset(seed=0)
    scene = dataclasses.replace(env.world.scene, low=(0.4, -0.1, 0.2), high=(0.6, 0.1, 0.3))
    env.task = dataclasses.replace(env.task, draw=lambda rng: dataclasses.replace(env.problem, scene=scene))
    env.reset(seed=0)
    for action in np.random.default_rng(0).uniform(-1, 1, (40, 7)).astype(np.float32):
        seen, *_ = env.step(action)
        target = seen["robot0_eef_pos"] + seen["robot0_target_error"][:3]
        assert np.all(target > np.array(scene.low) - 1e-5) and np.all(target < np.array(scene.high) + 1e-5)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("perturbation", [None, Perturbation()])
def test_the_expert_stacks_with_every_control(name: str, perturbation: Perturbation | None) -> None:
    env = make(name)
    for seed in range(3):
        attempt = demonstrate(env, seed, ExpertConfig(perturbation=perturbation))
        assert attempt.success, attempt.failure
        assert attempt.episode is not None and attempt.episode.actions.shape[1] == env.action_size
        assert attempt.info["control"] == name
        if perturbation is None:
            errors = 1e3 * np.array(attempt.tracking)
            assert np.median(errors) < 3 and np.percentile(errors, 99) < 15  # [mm]
        else:
            assert np.any(attempt.episode.actions != attempt.episode.executed)


def test_the_expert_answers_to_where_the_joint_target_is_and_not_when() -> None:
    """Held still for a while in mid-way, the expert says the same thing all along, and then goes on to the end."""
    from optimus.expert import PlanFollower
    from optimus.motion.plan import Plan
    from optimus.planner import solve
    from optimus.skills import Workspace

    env = make("joint")
    seen, _ = env.reset(seed=2)
    plan = solve(Workspace(env.world), env.state(), env.problem.goal, np.random.default_rng(0))
    assert isinstance(plan, Plan)
    follower, still = PlanFollower(plan, control="joint"), np.array([*np.zeros(7), -1.0], np.float32)
    for _ in range(8):
        action = follower.act(seen)
        assert action is not None
        seen, *_ = env.step(action)
    answers = []
    for _ in range(12):
        seen, *_ = env.step(still)
        answers.append(follower.act(seen))
    np.testing.assert_allclose(answers[-1], answers[-4], atol=1e-3)
    assert np.abs(answers[-1][:7]).max() > 0.05
    done = False
    while not done:
        action = follower.act(seen)
        seen, _, done, late, _ = env.step(still if action is None else action)
        assert not late


@pytest.fixture(scope="module")
def joint_taught(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """A joint-control dataset of stack, and a policy that has hardly looked at it."""
    folder = tmp_path_factory.mktemp("joint")
    collect(CollectConfig("stack", folder / "data", 4, workers=1, control="joint"))
    curate(folder / "data")
    train(folder / "data", folder / "policy", TrainConfig(steps=2))
    return folder / "data", folder / "policy"


def test_a_joint_dataset_is_read_learned_from_and_acted_on(joint_taught: tuple[Path, Path]) -> None:
    data, run = joint_taught
    store = EpisodeStore.open(data)
    assert store.control == "joint" and store.config["joint_scale"] == JOINT_SCALE and "position_scale" not in store.config
    windows = Windows(store, store.seeds, WindowConfig())
    assert windows.actions.shape[1] == 8
    assert {n: a.shape[1] for n, a in windows.proprioception.items() if "joint" in n} == {
        "robot0_joint_pos": 7,
        "robot0_joint_target_error": 7,
    }
    policy = load(run, control="joint")
    assert (policy.inputs.actions, policy.inputs.control) == (8, "joint")
    seen, _ = make("joint", images=True).reset(seed=5)
    answer = PolicyAgent(policy).act(seen)
    assert answer.shape == (8,) and answer[-1] in (-1.0, 1.0)
    episode, _ = play(run, random_starts(1)[0], seed=0, conditions=Conditions(horizon=20))
    assert episode.info["control"] == "joint" and episode.executed.shape[1] == 8


def test_controls_do_not_mix(joint_taught: tuple[Path, Path], taught: tuple[Path, Path], tmp_path: Path) -> None:
    joint_data, joint_run = joint_taught
    with pytest.raises(CheckpointError, match="'joint', not 'osc'"):
        collect(CollectConfig("stack", tmp_path / "c", 1, workers=1, turns=Turns(joint_run)))
    assert not (tmp_path / "c").exists()
    with pytest.raises(DatasetError, match="control = 'joint', not 'ik'"):
        collect(CollectConfig("stack", joint_data, 5, workers=1, control="ik"))
    with pytest.raises(CheckpointError, match="'joint', not 'osc'"):
        train(taught[0], tmp_path / "r", TrainConfig(steps=1), initial=joint_run)
    with pytest.raises(DatasetError, match="control = 'joint', not 'osc'"):
        train(taught[0], tmp_path / "s", TrainConfig(steps=1), corrections=joint_data)


def test_a_policy_takes_turns_under_its_own_control(joint_taught: tuple[Path, Path], tmp_path: Path) -> None:
    config = CollectConfig("stack", tmp_path, 1, workers=1, control="joint", turns=Turns(joint_taught[1], policy_steps=2.0))
    assert collect(config).demonstrations == 1


def test_a_run_from_before_controls_were_recorded_loads_and_goes_on(taught: tuple[Path, Path], tmp_path: Path) -> None:
    run = tmp_path / "run"
    shutil.copytree(taught[1], run)
    config = json.loads((run / "config.json").read_text())
    assert config["inputs"].pop("control") == "osc" and config["inputs"].pop("actions") == 7
    (run / "config.json").write_text(json.dumps(config))
    assert load(run, control="osc").inputs.actions == 7
    train(taught[0], run, TrainConfig(steps=3))  # nothing is left to do
