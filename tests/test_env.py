"""The environment: Gymnasium's own checker, determinism, restarts, control."""

import threading
from dataclasses import replace

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import optimus
from optimus.control import POSITION_SCALE
from optimus.control.osc import OperationalSpace
from optimus.control.pose_target import MAX_GAP
from optimus.data.episode import PROPRIOCEPTION
from optimus.env import ManipulationEnv
from optimus.errors import ActionError, ModelError, UnknownNameError
from optimus.registration import gym_id
from optimus.robots import PANDA
from optimus.scene import Camera
from optimus.se3 import Pose, look_at
from optimus.tasks import TASKS, task
from optimus.world import compile_scene


@pytest.mark.parametrize("name", ["stack", "pick-place-two", "shelf-receptacle", "microwave-adapt"])
@pytest.mark.filterwarnings("error")
def test_gymnasium_finds_nothing_to_say(name: str) -> None:
    assert optimus.__version__ and all(gym_id(other) in gymnasium.registry for other in TASKS)
    check_env(gymnasium.make(gym_id(name)).unwrapped, skip_render_check=True)


def test_a_robot_is_taken_by_its_name() -> None:
    assert ManipulationEnv(task("stack"), images=False, robot="panda").world.scene.robot == PANDA
    with pytest.raises(UnknownNameError, match=r"unknown robot 'pandaa'; valid: .*panda, ur5e"):
        ManipulationEnv(task("stack"), images=False, robot="pandaa")


def test_observations_have_robosuite_names() -> None:
    env = gymnasium.make("optimus/Stack-v0")
    seen, _ = env.reset(seed=1)
    assert set(PROPRIOCEPTION) | {"agentview_image", "robot0_eye_in_hand_image"} == set(seen)
    assert seen["agentview_image"].shape == (84, 84, 3) and seen["agentview_image"].dtype == np.uint8
    assert seen["agentview_image"].std() > 10  # a picture, not a blank


def play(env: ManipulationEnv, seed: int, steps: int = 6) -> list[dict[str, np.ndarray]]:
    rng = np.random.default_rng(seed)
    seen, _ = env.reset(seed=seed)
    out = [seen]
    for _ in range(steps):
        out.append(env.step(rng.uniform(-1, 1, 7).astype(np.float32))[0])
    return out


@pytest.mark.parametrize("name", TASKS)
def test_the_same_seed_gives_the_same_bits(name: str) -> None:
    env = ManipulationEnv(task(name))
    first = play(env, 5)
    play(env, 6)
    for a, b in zip(first, play(env, 5), strict=True):
        for key in a:
            np.testing.assert_array_equal(a[key], b[key])


def test_a_snapshot_starts_the_same_episode() -> None:
    env = ManipulationEnv(task("stack"), images=False)
    env.reset(seed=3)
    start = env.snapshot()
    ends = []
    for options in (None, {"state": start}):
        env.reset(seed=3, options=options)
        for _ in range(10):
            env.step(np.array([0.2, 0.1, -0.3, 0, 0, 0.1, 1], np.float32))
        ends.append(env.snapshot())
    np.testing.assert_array_equal(ends[0], ends[1])


def test_starts_differ_and_do_not_overlap() -> None:
    seen = set()
    for seed in range(30):
        poses = task("stack").problem(seed).poses
        a, b = poses["cubeA"].pos[:2], poses["cubeB"].pos[:2]
        assert np.linalg.norm(a - b) > (0.02 + 0.025) * np.sqrt(2)
        assert max(np.abs(np.array([a, b]) - (0.5, 0.0)).max(), 0) <= 0.08
        seen.add(tuple(a))
    assert len(seen) == 30


@pytest.mark.parametrize("place", [(0.5, 0.3, 0.5), (2.0, 0.4, 0.02), (np.nan, 0.3, 0.02)])
def test_a_start_that_is_not_at_rest_is_refused(place: tuple[float, float, float]) -> None:
    problem = task("stack").problem(0)
    drawn = replace(problem, poses={**problem.poses, "cubeA": Pose.of(place)})
    env = ManipulationEnv(replace(task("stack"), draw=lambda rng: drawn), images=False)
    with pytest.raises(ModelError, match="rests on nothing at the start"):
        env.reset(seed=0)


def test_the_tcp_goes_where_it_is_sent() -> None:
    env = ManipulationEnv(task("stack"), images=False)
    seen, _ = env.reset(seed=0)
    start = seen["robot0_eef_pos"].astype(float)
    for _ in range(10):
        env.step(np.array([0.2, -0.3, 0.1, 0, 0, 0, -1], np.float32))
    for _ in range(20):
        seen, *_ = env.step(np.array([0, 0, 0, 0, 0, 0, -1], np.float32))
    expected = start + POSITION_SCALE * 10 * np.array([0.2, -0.3, 0.1])
    np.testing.assert_allclose(seen["robot0_eef_pos"], expected, atol=0.002)


def test_the_target_does_not_wind_up_nor_leave_its_box() -> None:
    env = ManipulationEnv(task("stack"), images=False)
    env.reset(seed=0)
    for _ in range(60):
        env.step(np.array([0, 0, -1, 0, 0, 0, 1], np.float32))
    controller = env.controller
    assert isinstance(controller, OperationalSpace)
    assert np.linalg.norm(controller.target_error(env.data)[:3]) <= MAX_GAP + 1e-9
    assert controller.target.pos[2] >= env.world.scene.low[2]


def test_equal_scenes_share_one_model() -> None:
    problem = task("pick-place").problem
    by_variant = {problem(s).variant: compile_scene(problem(s).scene) for s in range(20)}
    assert len(by_variant) == 3
    assert compile_scene(problem(0).scene) is by_variant[problem(0).variant]


def test_an_action_is_so_many_finite_numbers() -> None:
    env = ManipulationEnv(task("stack"), images=False)
    env.reset(seed=0)
    for wrong in (np.full(7, np.nan), np.zeros(6), np.zeros(9)):
        with pytest.raises(ActionError, match="7 finite numbers"):
            env.step(wrong.astype(np.float32))
    env.step(np.zeros(7, np.float32))


def test_a_camera_looks_straight_down_as_well() -> None:
    """A thing at +x is above the image's middle, one at +y to the left of it: as the view from just beside the vertical has it."""
    down = Camera("down", (0.5, 0.0, 0.9), (0.5, 0.0, 0.0))
    nearly = Camera("nearly", (0.5 - 1e-3, 0.0, 0.9), (0.5, 0.0, 0.0))
    env = ManipulationEnv(task("stack"), cameras=["agentview", down, nearly])
    seen, _ = env.reset(seed=0)
    assert [name for name in seen if name.endswith("_image")] == ["agentview_image", "down_image", "nearly_image"]
    assert seen["down_image"].std() > 5
    away = np.abs(seen["down_image"].astype(float) - seen["nearly_image"]).mean()
    turned = np.abs(seen["down_image"].astype(float) - np.rot90(seen["nearly_image"], 2)).mean()
    assert away < turned / 3
    for q, z in ((look_at((0, 0, 1), (0, 0, 0)), 1.0), (look_at((1, 0, 0), (0, 0, 0), (1, 0, 0)), 0.0)):
        assert np.isclose(np.linalg.norm(q), 1) and np.isclose(Pose(np.zeros(3), q).matrix[2, 2], z)


def test_cameras_that_cannot_see_are_refused() -> None:
    for eye, target, fovy in (((0, 0, 1), (0, 0, 1), 45), ((0, 0, np.nan), (0, 0, 0), 45), ((0, 0, 1), (0, 0, 0), 0)):
        with pytest.raises(ModelError, match="camera 'mine'"):
            Camera("mine", eye, target, fovy)
    with pytest.raises(ModelError, match="'agentview' there is more than one camera"):
        ManipulationEnv(task("stack"), cameras=[Camera("agentview", (1, 0, 1), (0, 0, 0))])
    with pytest.raises(UnknownNameError, match="agentview"):
        ManipulationEnv(task("stack"), cameras=["sideview"])


def test_every_thread_draws_with_a_context_of_its_own() -> None:
    seen: list[np.ndarray] = []

    def draw() -> None:
        seen.append(ManipulationEnv(task("stack"), cameras=["agentview"]).reset(seed=1)[0]["agentview_image"])

    draw()
    for thread in (threading.Thread(target=draw), threading.Thread(target=draw)):
        thread.start()
        thread.join()
    draw()
    assert len(seen) == 4
    for image in seen[1:]:
        np.testing.assert_array_equal(image, seen[0])
