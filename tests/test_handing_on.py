"""Policies as others meet them: load and act, ONNX files, cards, state instead of images; and files that are not to be trusted."""

from __future__ import annotations

import json
import pickle
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Literal

import numpy as np
import pytest
import torch

import optimus
from optimus.data.episode import OBJECT_POSITIONS, OBJECT_TURNS, Episode
from optimus.data.store import EpisodeStore
from optimus.data.windows import WindowConfig, Windows
from optimus.env import ManipulationEnv
from optimus.errors import CheckpointError, DatasetError, OptimusError
from optimus.evaluate import evaluate, random_starts
from optimus.learn.agent import PolicyAgent
from optimus.learn.card import write_card
from optimus.learn.checkpoint import load, read_config, write_config
from optimus.learn.gradient import LossConfig, Runtime
from optimus.learn.policy import PolicyInputs
from optimus.learn.presets import preset
from optimus.learn.recipe import TrainConfig
from optimus.learn.train import fresh_policy, train
from optimus.tasks import task
from synthetic import CAMERAS, make_dataset, make_episode

torch.set_num_threads(1)  # tests run in several processes

SHORT = TrainConfig(steps=2, loss=LossConfig(runs=2), evaluations=1, held_out_runs=2, runtime=Runtime(1, False), device="cpu")
PROPRIOCEPTION = {"robot0_eef_pos": 3, "robot0_eef_quat": 4, "robot0_gripper_qpos": 2, "robot0_target_error": 6}


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return make_dataset(tmp_path_factory.mktemp("data") / "set", 4, 12).path


@pytest.fixture(scope="module")
def run(dataset: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("run") / "run"
    train(dataset, folder, SHORT, preset("quick-mlp").policy, watch="none")
    return folder


def frames(episode: Episode) -> list[dict[str, np.ndarray]]:
    return [{name: array[t] for name, array in episode.observations.items()} for t in range(len(episode))]


def test_a_run_is_loaded_and_acts(run: Path) -> None:
    policy = optimus.load_policy(run, "likeliest")
    seen = frames(make_episode(3, 4))
    first = [policy.act(frame) for frame in seen]
    policy.reset()
    np.testing.assert_array_equal(first, [policy.act(frame) for frame in seen])
    with pytest.raises(CheckpointError, match="no trained policy"):
        optimus.load_policy(run.parent)


def test_a_policy_of_a_continuous_gripper_says_how_far_to_shut(run: Path, tmp_path: Path) -> None:
    other = tmp_path / "run"
    shutil.copytree(run, other)
    config = read_config(other)
    config["dataset"]["config"]["gripper"] = "continuous"
    write_config(other, config)
    frame = frames(make_episode(3, 1))[0]
    binary, continuous = (optimus.load_policy(folder).act(frame) for folder in (run, other))
    assert binary[6] in (-1, 1) and -1 < continuous[6] < 1
    np.testing.assert_array_equal(continuous[:6], binary[:6])
    with pytest.raises(CheckpointError, match=r"continuous gripper.*'likeliest'"):
        optimus.load_policy(other, "likeliest")


def test_torch_is_imported_only_where_it_is_used() -> None:
    code = "import sys, optimus; optimus.load_policy; sys.exit('torch' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_the_true_size_is_recorded_and_told(run: Path) -> None:
    count = sum(p.numel() for p in load(run).parameters())
    assert read_config(run)["parameters"] == count
    card = (run / "README.md").read_text()
    assert f"{count:,} parameters" in card and "Not evaluated yet" in card and "load_policy" in card


def test_the_card_tells_success_with_its_interval(run: Path, tmp_path: Path) -> None:
    folder = tmp_path / "run"
    shutil.copytree(run, folder)
    report = {"task": "square", "states": "random", "successes": 43, "episodes": 50, "interval": [0.738, 0.93]}
    (folder / "evaluation-random.json").write_text(json.dumps(report))
    write_card(folder)
    assert "| square | random | 43 of 50 | 74 to 93 % |" in (folder / "README.md").read_text()
    (folder / "evaluation-random.json").write_text(json.dumps({**report, "distinct_states": 29}))
    write_card(folder)
    assert "| square | random (29 different) | 43 of 50 | 74 to 93 % |" in (folder / "README.md").read_text()


@pytest.mark.parametrize(("name", "head"), [("quick", None), ("quick-rnn", "bet")])
def test_an_onnx_file_answers_as_torch_does(name: str, head: str | None, tmp_path: Path) -> None:
    for package in ("onnx", "onnxscript"):
        pytest.importorskip(package, reason=f"needs {package}, of the extra `onnx`")
    runtime = pytest.importorskip("onnxruntime", reason="needs onnxruntime, of the extra `onnx`")
    from optimus.learn.onnx_file import export_onnx

    config = preset(name, head).policy  # type: ignore[arg-type]
    policy = fresh_policy(config, PolicyInputs("square", CAMERAS, PROPRIOCEPTION, 1, keypose=12), 0).eval()
    policy.action_scale[:6] = torch.tensor([0.3, 0.3, 0.3, 0.7, 0.7, 0.7])
    policy.low_mean.normal_(0, 0.1, generator=torch.Generator().manual_seed(0))
    export_onnx(policy, tmp_path / "policy.onnx")
    session = runtime.InferenceSession(str(tmp_path / "policy.onnx"), providers=["CPUExecutionProvider"])
    about = session.get_modelmeta().custom_metadata_map
    assert json.loads(about["optimus.inputs"])["cameras"] == list(CAMERAS) and about["optimus.executed"] == "1"
    agent, tokens = PolicyAgent(policy, "likeliest"), np.full((config.context, config.trunk.token), 7, np.float32)
    for t, frame in enumerate(frames(make_episode(3, config.context + 3))):
        action, tokens, weights, means = session.run(None, {**frame, "tokens": tokens, "first": np.array(t == 0)})
        np.testing.assert_allclose(action[0], agent.act(frame), atol=1e-5)
        assert weights.sum() == pytest.approx(1, abs=1e-5)
        np.testing.assert_allclose(means[weights.argmax(), :6].clip(-1, 1), action[0, :6], atol=1e-6)


@pytest.mark.parametrize("head", ["gaussian", "flow"])
def test_an_onnx_file_of_a_policy_with_a_continuous_gripper(head: Literal["gaussian", "flow"], tmp_path: Path) -> None:
    for package in ("onnx", "onnxscript"):
        pytest.importorskip(package, reason=f"needs {package}, of the extra `onnx`")
    runtime = pytest.importorskip("onnxruntime", reason="needs onnxruntime, of the extra `onnx`")
    from optimus.learn.onnx_file import ExportError, export_onnx

    config = preset("quick-mlp", head).policy
    policy = fresh_policy(config, PolicyInputs("square", CAMERAS, PROPRIOCEPTION, 1, keypose=12), 0).eval()
    export_onnx(policy, tmp_path / "policy.onnx", "continuous")
    session = runtime.InferenceSession(str(tmp_path / "policy.onnx"), providers=["CPUExecutionProvider"])
    assert json.loads(session.get_modelmeta().custom_metadata_map["optimus.gripper"]) == "continuous"
    frame = frames(make_episode(3, 1))[0]
    tokens = np.zeros((config.context, config.trunk.token), np.float32)
    action = session.run(["action"], {**frame, "tokens": tokens, "first": np.array(True)})[0]
    assert np.all(np.abs(action[:, 6]) < 1.0)
    if head == "gaussian":  # whose continuous answer has nothing drawn in it
        np.testing.assert_allclose(action[0], PolicyAgent(policy, "continuous").act(frame), atol=1e-5)
    odd = fresh_policy(config, PolicyInputs("square", CAMERAS, PROPRIOCEPTION, 1, frame=None, keypose=12), 0)
    with pytest.raises(ExportError, match="pictures of different sizes"):
        export_onnx(odd, tmp_path / "odd.onnx")


def test_without_images_a_policy_is_told_where_things_are(dataset: Path, tmp_path: Path) -> None:
    config = preset("quick", observe="state").policy
    policy = train(dataset, tmp_path / "run", SHORT, config, watch="none")
    assert policy.inputs.cameras == () and policy.inputs.proprioception[OBJECT_POSITIONS] == 3
    assert not any(name.startswith(("encoders", "locate")) for name, _ in policy.named_parameters())
    agent, episode = optimus.load_policy(tmp_path / "run", "likeliest"), make_episode(3, 1)
    low = {name: array for name, array in frames(episode)[0].items() if not name.endswith("_image")}
    here, there = np.array([0.1, 0.1, 0], np.float32), np.array([-0.1, 0.1, 0], np.float32)
    first = agent.act({**low, OBJECT_POSITIONS: here})
    agent.reset()
    assert not np.array_equal(first, agent.act({**low, OBJECT_POSITIONS: there}))
    with pytest.raises(CheckpointError, match=r"needs .*object_positions"):
        agent.act(low)
    with pytest.raises(CheckpointError, match=r"object_positions of shape \(3,\), the observation has \(6,\)"):
        agent.act({**low, OBJECT_POSITIONS: np.zeros(6, np.float32)})


def test_an_environment_tells_where_things_are(taught: tuple[Path, Path], tmp_path: Path) -> None:
    env = ManipulationEnv(task("stack"), images=False, positions=True)
    seen, _ = env.reset(seed=3)
    np.testing.assert_allclose(seen[OBJECT_POSITIONS].reshape(-1, 3), env.object_positions(), atol=1e-6)
    assert env.observation_space.contains(seen)
    store = EpisodeStore.open(taught[0])
    windows = Windows(store, store.seeds[:1], WindowConfig(images=False))
    seen, _ = env.reset(seed=store.seeds[0])
    for name in (OBJECT_POSITIONS, OBJECT_TURNS):  # learned from what was recorded, told by the simulator
        np.testing.assert_allclose(windows.proprioception[name][0], seen[name], atol=1e-5)
    policy = train(taught[0], tmp_path / "run", SHORT, preset("quick-mlp", "mse", "state").policy, watch="none")
    assert policy.inputs.proprioception[OBJECT_TURNS] == 12
    assert evaluate(tmp_path / "run", random_starts(1), "random", workers=1).episodes == 1


class Bomb:
    """Leaves a mark where it is unpickled."""

    def __init__(self, mark: Path) -> None:
        self.mark = mark

    def __reduce__(self) -> tuple[object, tuple[Path]]:
        return Path.touch, (self.mark,)


@pytest.mark.parametrize("how", ["pickle", "torch"])
def test_pickled_code_is_refused_and_never_run(how: str, run: Path, dataset: Path, tmp_path: Path) -> None:
    mark = tmp_path / "executed"
    bomb = tmp_path / "bomb"
    if how == "pickle":
        bomb.write_bytes(pickle.dumps({"embed.weight": Bomb(mark)}))
    else:
        torch.save({"embed.weight": Bomb(mark)}, bomb)
    shutil.copytree(run, tmp_path / "run")
    shutil.copytree(dataset, tmp_path / "set")
    shutil.copy(bomb, tmp_path / "run" / "model.safetensors")
    with pytest.raises(CheckpointError, match="is damaged"):
        optimus.load_policy(tmp_path / "run")
    state = next((tmp_path / "run" / "train_state").glob("*.safetensors"))
    shutil.copy(bomb, state)
    with pytest.raises(CheckpointError, match="is damaged"):
        train(dataset, tmp_path / "run", SHORT, preset("quick-mlp").policy, watch="none")
    shutil.copy(bomb, tmp_path / "set" / "episodes" / "00000001.safetensors")
    with pytest.raises(DatasetError, match="00000001"):
        EpisodeStore.open(tmp_path / "set").read(1)
    shutil.copy(bomb, tmp_path / "run" / "config.json")
    with pytest.raises(CheckpointError, match="cannot read"):
        optimus.load_policy(tmp_path / "run")
    assert not mark.exists()
    pickle.loads(pickle.dumps(Bomb(mark)))
    assert mark.exists()  # it would have gone off


def test_a_configuration_that_makes_no_sense_is_named(run: Path, tmp_path: Path) -> None:
    shutil.copytree(run, tmp_path / "run")
    config = read_config(run)
    for part, kind in (("trunk", "mamba"), ("head", "os.system"), ("encoder", "vit")):
        changed = {**config, "policy": {**config["policy"], part: {**config["policy"][part], "kind": kind}}}
        (tmp_path / "run" / "config.json").write_text(json.dumps(changed))
        with pytest.raises(CheckpointError, match="does not describe a policy"):
            optimus.load_policy(tmp_path / "run")


def test_data_that_does_not_fit_the_first_weights_is_named(run: Path, tmp_path: Path) -> None:
    def made(name: str, cameras: tuple[str, ...], actions: int) -> Path:
        from optimus.data.curate import CurationConfig, curate

        store = EpisodeStore.create(tmp_path / name, "square", cameras, {"position_scale": 1.0})
        for seed in range(4):
            wide = np.repeat(make_episode(seed, 12).actions, 2, 1)[:, -actions:]
            store.write(make_episode(seed, 12, cameras=cameras, actions=wide, executed=wide))
        curate(store.path, CurationConfig())
        return store.path

    for name, data, said in (
        ("cameras", made("a", ("side", "wrist"), 7), r"trained with cameras = \('front', 'wrist'\), not \('side', 'wrist'\)"),
        ("actions", made("b", CAMERAS, 8), "trained with actions = 7, not 8"),
    ):
        with pytest.raises(CheckpointError, match=said):
            train(data, tmp_path / name, SHORT, initial=run, watch="none")
    frame = frames(make_episode(0, 1))[0]
    with pytest.raises(CheckpointError, match="needs front_image"):
        optimus.load_policy(run).act({("side_image" if name == "front_image" else name): x for name, x in frame.items()})
    with pytest.raises(CheckpointError, match=r"shape \(84, 84, 3\)"):
        optimus.load_policy(run).act({**frame, "front_image": np.zeros((40, 40, 3), np.uint8)})


def test_export_says_what_is_missing(run: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from optimus.learn.onnx_file import export_onnx

    monkeypatch.setitem(sys.modules, "onnxscript", None)
    monkeypatch.setitem(sys.modules, "onnx", None)
    with pytest.raises(OptimusError, match=r"optimus-tamp\[onnx\]"):
        export_onnx(load(run), tmp_path / "policy.onnx")
