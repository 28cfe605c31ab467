"""The live viewer: what it draws is what there is, and a real browser shows it without complaint."""

import json
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path

import mujoco
import numpy as np
import pytest
import trimesh

pytest.importorskip("viser", reason="the viewer is served by viser: pip install 'optimus-tamp[view]'")

from browser import SCREENSHOTS, keep, page, requires_no_sideways_scrolling
from optimus.collect import CollectConfig, collect
from optimus.data.curate import curate
from optimus.data.episode import MISHAP
from optimus.data.store import EpisodeStore
from optimus.demonstrate import ExpertConfig, plan_for
from optimus.env import ManipulationEnv
from optimus.errors import DatasetError, OptimusError, UnknownNameError
from optimus.learn import checkpoint
from optimus.learn.agent import PolicyAgent
from optimus.learn.presets import preset
from optimus.learn.train import TrainConfig, train
from optimus.motion.plan import Infeasible, Plan
from optimus.rollout import Perturbation
from optimus.tasks import task
from optimus.view import Address, View, open_view
from optimus.view.episode_view import EpisodeView
from optimus.view.meshes import surfaces
from optimus.view.policy_view import Fans, PolicyView
from optimus.view.scene_view import SceneView
from optimus.view.timeline import timeline

ANY_PORT = Address(port=0)
NO_PLAN = 7036
"""A seed of `shelf` whose block stands where no grasp reaches it."""


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("view") / "data"
    collect(CollectConfig("stack", folder, 3, workers=1))
    curate(folder)
    return folder


@pytest.fixture(scope="module")
def run(data: Path) -> Path:
    train(data, data.parent / "run", TrainConfig(steps=2))
    return data.parent / "run"


@pytest.fixture(scope="module")
def stack() -> Iterator[View]:
    view = open_view("stack", seed=3, address=ANY_PORT)
    yield view
    view.close()


@pytest.mark.parametrize("name", ["microwave", "pick-place"])
def test_what_is_drawn_is_where_mujoco_sees_it(name: str) -> None:
    """Rays from all around meet the triangles as far away as MuJoCo's own ray casting meets the model."""
    env = ManipulationEnv(task(name), images=False)
    env.reset(seed=0)
    model, data, rng = env.world.model, env.data, np.random.default_rng(0)
    parts = []
    for s in surfaces(model):
        placed = s.vertices @ data.xmat[s.body].reshape(3, 3).T + data.xpos[s.body]
        parts.append(trimesh.Trimesh(placed, s.faces, process=False))
    drawn, groups = trimesh.util.concatenate(parts), np.array([1, 1, 1, 0, 0, 0], np.uint8)
    assert isinstance(drawn, trimesh.Trimesh)
    differences, hit = [], np.zeros(1, np.int32)
    for start in rng.normal(size=(300, 3)):
        start = np.array([0.4, 0.0, 0.1]) + 1.2 * start / np.linalg.norm(start) * (1, 1, 0.5) + (0, 0, 0.6)
        way = rng.uniform((0.0, -0.3, 0.0), (0.7, 0.3, 0.5)) - start
        way /= np.linalg.norm(way)
        far = mujoco.mj_ray(model, data, start, way, groups, True, -1, hit)
        points, _, _ = drawn.ray.intersects_location([start], [way], multiple_hits=True)
        near = min((float(np.linalg.norm(p - start)) for p in points), default=-1.0)
        differences.append(abs(near - far))
    assert np.mean(np.array(differences) < 2e-3) > 0.97, np.sort(differences)[-10:]


@pytest.mark.parametrize("name", ["stack", "microwave"])
def test_a_timeline_moves_without_a_jump_from_start_to_goal(name: str) -> None:
    env = ManipulationEnv(task(name), images=False)
    env.reset(seed=3)
    plan = plan_for(env, 3, ExpertConfig()).plan
    assert isinstance(plan, Plan)
    moments = timeline(plan, env.world.scene)
    seconds, qpos = np.array([m.seconds for m in moments]), np.array([m.qpos for m in moments])
    assert np.all(np.diff(seconds) >= 0) and seconds[-1] > 1
    arm = qpos[:, env.world.arm_qpos]
    assert np.allclose(arm[0], plan.start.q) and np.allclose(arm[-1], plan.steps[-1].after.q)
    assert np.abs(np.diff(arm, axis=0)).max() < 0.25  # [rad] within a twentieth of a second
    assert [m.step for m in moments] == sorted(m.step for m in moments)
    assert sum(m.key for m in moments) >= 2 * len(plan.steps)
    for thing, at in env.world.movable_qpos.items():
        assert np.allclose(qpos[-1, at : at + 3], plan.steps[-1].after.poses[thing].pos, atol=2e-3)


def test_it_serves_this_machine_alone_unless_told_otherwise(stack: View) -> None:
    host, port = stack.url.removeprefix("http://").split(":")
    assert host == "127.0.0.1"
    listening = [line.split()[1] for line in Path("/proc/net/tcp").read_text().splitlines()[1:] if line.split()[3] == "0A"]
    assert f"0100007F:{int(port):04X}" in listening and f"00000000:{int(port):04X}" not in listening
    with pytest.raises(OptimusError, match=f"127.0.0.1:{port}.*--port"):
        open_view("stack", address=Address(port=int(port)))


def test_what_cannot_be_shown_is_named(tmp_path: Path) -> None:
    with pytest.raises(UnknownNameError, match=r"stakc.*valid: .*stack"):
        open_view("stakc", address=ANY_PORT)
    with pytest.raises(OptimusError, match=r"neither a dataset \(dataset.json\) nor a policy"):
        open_view(str(tmp_path), address=ANY_PORT)
    with socket.create_server(("127.0.0.1", 0)) as taken, pytest.raises(OptimusError, match="cannot serve"):
        open_view("stack", address=Address(port=taken.getsockname()[1]))


def test_a_plan_its_slider_and_the_grasps(stack: View) -> None:
    shown = stack.shown
    assert isinstance(shown, SceneView) and isinstance(shown.found, Plan)
    assert shown.stage.count("ghosts") == sum(m.key for m in shown.moments) >= 4
    with page() as (opened, wrong):
        opened.goto(stack.url)
        assert "pick cubeA up" in opened.locator("#skeleton b").inner_text()
        canvas = opened.locator("canvas").first
        opened.wait_for_timeout(2500)
        before = canvas.screenshot()
        slider = opened.get_by_role("slider").first
        slider.press("End")
        opened.locator("#skeleton b", has_text="stack cubeA on cubeB").wait_for()
        slider.press("ArrowLeft")
        opened.wait_for_timeout(500)
        assert shown.player.index == len(shown.moments) - 2
        assert canvas.screenshot() != before
        shown.player.slider.value = 0.8
        keep(opened, "view-plan")
        shown.show_grasps("cubeA")
        accepted, refused = shown.grasps_of("cubeA")
        assert accepted and refused
        text = opened.locator("#grasps").inner_text()
        assert f"{len(accepted)} of {len(accepted) + len(refused)}" in text and "refused" in text
        assert len(shown.stage.segments("grasps")) == 4 * (len(accepted) + len(refused))
        opened.wait_for_timeout(500)
        keep(opened, "view-grasps")
        shown.show_grasps("none")
        opened.set_viewport_size({"width": 360, "height": 640})
        opened.wait_for_timeout(500)
        requires_no_sideways_scrolling(opened)
        keep(opened, "view-phone")
        assert shown.stage.count("grasps") == 0
        assert wrong == []


def test_why_there_is_no_plan() -> None:
    view = open_view("shelf", seed=NO_PLAN, address=ANY_PORT)
    try:
        shown = view.shown
        assert isinstance(shown, SceneView) and isinstance(shown.found, Infeasible)
        assert shown.stage.count("marks") >= 2 and shown.stage.count("ghosts") == 0
        with page() as (opened, wrong):
            opened.goto(view.url)
            text = opened.locator("#why-not").inner_text()
            assert shown.found.reason in text and "pick(object" in text
            assert all(name in text for name in shown.found.blockers)
            opened.wait_for_timeout(1500)
            keep(opened, "view-why-not")
            assert wrong == []
        shown.solve(7000)  # another problem, in the same page
        assert isinstance(shown.found, Plan) and shown.stage.count("marks") == 0
    finally:
        view.close()


def test_what_plays_goes_on_after_another_choice_and_after_an_error(data: Path) -> None:
    view = open_view(str(data), seed=1, address=ANY_PORT)
    try:
        shown = view.shown
        assert isinstance(shown, EpisodeView)
        player, lengths = shown.player, {s: len(EpisodeStore.open(data).read(s)) for s in EpisodeStore.open(data).seeds}
        longest, shortest = max(lengths, key=lengths.__getitem__), min(lengths, key=lengths.__getitem__)
        shown.load(longest)
        player.slider.value = (lengths[longest] - 3) / 20
        shown.load(shortest)
        shown._show(lengths[longest] - 1)  # as a slider says that was moved meanwhile
        show, failed = player._show, []

        def failing(index: int) -> None:
            failed.append(index)
            raise IndexError(index)

        player._show = failing
        player.play()
        _until(lambda: bool(failed) and not player._playing.is_set())
        player._show = show
        player.play()
        _until(lambda: player.index > failed[0] + 2)
    finally:
        view.close()


def _until(so: Callable[[], bool], seconds: float = 20.0) -> None:
    end = time.monotonic() + seconds
    while not so():
        assert time.monotonic() < end
        time.sleep(0.02)


def test_an_episode_in_step(data: Path) -> None:
    view = open_view(str(data), seed=1, address=ANY_PORT)
    try:
        shown = view.shown
        assert isinstance(shown, EpisodeView) and shown.episode.seed == 1
        stored = EpisodeStore.open(data).read(1)
        world = ManipulationEnv(task("stack"), images=False).world
        at = world.movable_qpos[stored.object_names[0]]
        assert np.abs(shown.qpos[:, at : at + 3] - stored.objects[:, 0]).max() < 1e-4
        with page() as (opened, wrong):
            opened.goto(view.url)
            assert f"steps: {len(stored)}" in opened.locator("#facts").inner_text()
            shown.player.slider.value = 2.0
            opened.wait_for_timeout(1500)
            assert shown.player.index == 40
            seen = stored.observations["agentview_image"][40]
            assert shown.picture is not None
            assert np.array_equal(shown.picture[::3, : 3 * 84 : 3], seen)
            keep(opened, "view-episode")
            assert wrong == []
    finally:
        view.close()


@contextmanager
def killed_in_the_end(process: subprocess.Popen[str]) -> Iterator[None]:
    """Or a test that fails would wait for it for ever."""
    try:
        yield
    finally:
        process.kill()


def test_a_policy_live(run: Path) -> None:
    """By the command itself: pictures are drawn where the policy plays, in a thread of its own."""
    # one that has learned something ends its episode in seconds: for the picture alone
    policy = str(run) if SCREENSHOTS is None else "pretrained:stack"
    command = [sys.executable, "-m", "optimus.cli", "view", policy, "--port", "0", "--json"]
    # a shell's background job is deaf to the interrupt, and so would be this
    hearing = partial(signal.signal, signal.SIGINT, signal.SIG_DFL)
    pipe = subprocess.PIPE
    with subprocess.Popen(command, stdout=pipe, stderr=pipe, text=True, preexec_fn=hearing) as served, killed_in_the_end(served):
        assert served.stdout is not None
        try:
            url = json.loads(served.stdout.readline())["url"]
            with page() as (opened, wrong):
                opened.goto(url)
                clock = opened.locator("#facts div").nth(1)
                before = clock.inner_text()
                opened.wait_for_timeout(2500)
                assert float(clock.inner_text().split()[1]) > float(before.split()[1])
                keep(opened, "view-policy")
                assert wrong == []
        finally:
            served.send_signal(signal.SIGINT)
        assert served.wait(20) == 130
        assert "Traceback" not in (served.stderr.read() if served.stderr else "")


def test_a_policy_of_two_tasks_that_is_told_the_state_plays_the_first_without_pictures(data: Path, tmp_path: Path) -> None:
    train(data, tmp_path / "told", TrainConfig(steps=2), preset("quick", observe="state").policy)
    config = json.loads((tmp_path / "told" / "config.json").read_text())
    config["inputs"]["task"] = checkpoint.joint_task(["stack", "stack-three"])
    (tmp_path / "told" / "config.json").write_text(json.dumps(config))
    view = open_view(str(tmp_path / "told"), address=ANY_PORT)
    try:
        assert isinstance(view.shown, PolicyView)
        shown, deadline = view.shown, time.monotonic() + 60
        while shown.steps < 3 and time.monotonic() < deadline:
            time.sleep(0.1)
        assert shown.steps >= 3
    finally:
        view.close()


def test_the_fan_is_the_mixture_that_the_policy_acted_on(run: Path, data: Path) -> None:
    """What a policy does that takes the likeliest component is the mean of greatest weight in the fan."""
    policy = checkpoint.load(run)
    fans, episode = Fans(policy.modules()), EpisodeStore.open(data).read(1)
    action = PolicyAgent(policy, "likeliest").act({k: v[0] for k, v in episode.observations.items()})
    mixture = fans.latest
    assert mixture is not None
    best = int(mixture.logits.reshape(-1).argmax())
    mean = policy.denormalise(mixture.mean.reshape(-1, *mixture.mean.shape[-2:])[-1])[best]
    assert np.allclose(mean[:3].numpy(), action[:3], atol=1e-6)


def test_an_episode_without_images_is_seen_as_it_was_whatever_happened_in_it(tmp_path: Path) -> None:
    """A push is no action: doing again what was done would show another scene."""
    pushed = ExpertConfig(perturbation=Perturbation(), mishaps=1.0)
    collect(CollectConfig("stack", tmp_path, 2, workers=1, images=False, expert=pushed))
    store = EpisodeStore.open(tmp_path)
    with pytest.raises(DatasetError, match="holds no episode 77"):
        open_view(str(tmp_path), seed=77, address=ANY_PORT)
    view = open_view(str(tmp_path), address=ANY_PORT)
    try:
        shown = view.shown
        assert isinstance(shown, EpisodeView) and shown.picture is None
        assert {store.header(seed).info[MISHAP]["kind"] for seed in store.seeds} & {"push", "slip"}
        for seed in store.seeds:
            shown.load(seed)
            states = store.read(seed).states
            assert states is not None
            np.testing.assert_array_equal(shown.qpos, states[:, 1 : 1 + shown.qpos.shape[1]])
            shown.player.slider.value = 1.0
    finally:
        view.close()


@pytest.mark.parametrize("port", [-1, 99999])
def test_a_port_that_there_is_not(port: int) -> None:
    with pytest.raises(OptimusError, match="port"):
        open_view("stack", address=Address(port=port))
