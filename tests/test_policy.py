"""The policy's parts, against formulas, finite differences and numpy; the agent, against whole windows."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Literal

import numpy as np
import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from optimus.data.episode import OBJECT_POSITIONS, OBJECT_TURNS, Episode
from optimus.data.store import EpisodeStore
from optimus.data.turns import as_columns
from optimus.data.windows import WindowConfig, Windows
from optimus.errors import CheckpointError, UnknownNameError
from optimus.learn import checkpoint
from optimus.learn.agent import PolicyAgent
from optimus.learn.encoder import Encoder, EncoderConfig, SpatialSoftmax
from optimus.learn.gradient import LossConfig, batch_loss, windows_of
from optimus.learn.heads import Mixture, MixtureConfig, MixtureHead
from optimus.learn.onnx_runtime import is_installed
from optimus.learn.policy import Policy, PolicyConfig, PolicyInputs
from optimus.learn.train import fresh_policy
from optimus.learn.trunk import LSTMConfig, Transformer, TransformerConfig, TrunkConfig, dropout
from synthetic import CAMERAS, make_dataset, make_episode

torch.set_num_threads(1)  # tests run in several processes

PROPRIOCEPTION = {"robot0_eef_pos": 3, "robot0_eef_quat": 4, "robot0_gripper_qpos": 2, "robot0_target_error": 6}
INPUTS = PolicyInputs("square", CAMERAS, PROPRIOCEPTION, 1, keypose=12)


@pytest.fixture(scope="module")
def policy() -> Policy:
    return fresh_policy(PolicyConfig(), INPUTS, seed=0).eval()


@pytest.fixture(scope="module")
def store(tmp_path_factory: pytest.TempPathFactory) -> EpisodeStore:
    return make_dataset(tmp_path_factory.mktemp("data"), 3)


@pytest.fixture(scope="module")
def windows(store: EpisodeStore) -> Windows:
    return Windows(store, range(3), WindowConfig())


def observation(episode: Episode, step: int) -> dict[str, np.ndarray]:
    return {name: array[step] for name, array in episode.observations.items()}


def test_spatial_softmax_points_at_a_single_peak() -> None:
    maps = torch.full((1, 2, 5, 9), -50.0)
    maps[0, 0, 4, 0], maps[0, 1, 2, 6] = 50.0, 50.0
    x, y = SpatialSoftmax()(maps).reshape(2, 2)
    torch.testing.assert_close(x, torch.tensor([-1.0, 0.5]))
    torch.testing.assert_close(y, torch.tensor([1.0, 0.0]))


def test_keypoints_are_moved_with_the_crop() -> None:
    torch.manual_seed(0)
    encoder = Encoder(EncoderConfig())
    images = torch.randint(0, 255, (100, 76, 76, 3), dtype=torch.uint8)
    shifts = torch.rand(100, 2)
    bare = torch.cat([encoder._located(part, False) for part in images.split(7)])
    moved = torch.cat([bare[:, :32] + shifts[:, :1], bare[:, 32:] + shifts[:, 1:]], 1)
    torch.testing.assert_close(encoder(images, shifts), encoder.project(moved))


def test_one_component_is_a_normal_distribution() -> None:
    mean, deviation = torch.randn(4, 1, 3), torch.rand(4, 1, 3) + 0.1
    actions = torch.randn(4, 3)
    expected = torch.distributions.Normal(mean[:, 0], deviation[:, 0]).log_prob(actions).sum(-1)
    torch.testing.assert_close(Mixture(torch.zeros(4, 1), mean, deviation).log_density(actions), expected)


def test_a_mixture_integrates_to_one() -> None:
    mixture = Mixture(torch.tensor([0.3, -1.0]), torch.tensor([[-0.5], [0.4]]), torch.tensor([[0.1], [0.3]]))
    x = torch.linspace(-4, 4, 20001)
    assert math.isclose(float(torch.trapezoid(mixture.log_density(x[:, None]).exp(), x)), 1, abs_tol=1e-4)


@settings(max_examples=5)
@given(seed=st.integers(0, 1000))
def test_the_loss_has_the_gradient_of_finite_differences(seed: int) -> None:
    generator = torch.Generator().manual_seed(seed)
    mean, logits, spread, actions = (
        torch.randn(shape, generator=generator, dtype=torch.float64) for shape in ((2, 5, 7), (2, 5), (2, 5, 7), (2, 7))
    )
    weight = torch.ones(7, dtype=torch.float64)
    inputs = [x.requires_grad_() for x in (logits, mean, spread)]
    assert torch.autograd.gradcheck(lambda a, b, c: Mixture(a, b, c.exp() + 0.03).log_density(actions, weight), inputs)


def test_components_are_sampled_by_weight() -> None:
    share = torch.tensor([0.1, 0.6, 0.3])
    mixture = Mixture(share.log().expand(20000, 3), torch.arange(3.0)[:, None].expand(20000, 3, 1), torch.ones(20000, 3, 1))
    answers = mixture.sampled(torch.Generator().manual_seed(0))[:, 0]
    counted = torch.stack([(answers == k).float().mean() for k in range(3)])
    torch.testing.assert_close(counted, share, atol=0.02, rtol=0)
    assert (mixture.likeliest() == 1).all()


def test_deviations_have_a_floor_and_means_are_bounded() -> None:
    head = MixtureHead(MixtureConfig(min_deviation=0.03), 8, 7)
    mixture = head(100 * torch.randn(50, 8))
    assert mixture.deviation.min() >= 0.03
    assert mixture.mean.abs().max() <= 1
    bounded = MixtureHead(MixtureConfig(min_deviation=0.03, max_deviation=0.1), 8, 7)(100 * torch.randn(50, 8)).deviation
    assert bounded[..., :6].min() >= 0.03 and bounded[..., :6].max() <= 0.1
    assert bounded[..., 6].min() >= 0.03 and bounded[..., 6].max() > 1


def test_a_position_sees_itself_and_those_before_it() -> None:
    torch.manual_seed(0)
    trunk = Transformer(TransformerConfig(), 8)
    tokens = torch.randn(2, 8, 128)
    changed = tokens.clone()
    changed[:, 5] = torch.randn(2, 128)
    same = (trunk(tokens) - trunk(changed)).abs().amax((0, 2)) < 1e-5
    assert same.tolist() == [True] * 5 + [False] * 3


def test_dropout_keeps_the_mean_and_follows_its_generator() -> None:
    x = torch.ones(20000)
    first, again = (dropout(x, 0.1, torch.Generator().manual_seed(3)) for _ in range(2))
    torch.testing.assert_close(first, again)
    assert math.isclose(float(first.mean()), 1, abs_tol=0.02)
    assert dropout(x, 0.1, None) is x


def test_windows_of_a_run_are_its_slices() -> None:
    run = torch.randn(3, 11, 5)
    windows = windows_of(run, 8)
    assert windows.shape == (3, 4, 8, 5)
    for k in range(4):
        torch.testing.assert_close(windows[:, k], run[:, k : k + 8])


def test_normalisation_is_inside_and_inverts(windows: Windows) -> None:
    policy = fresh_policy(PolicyConfig(), PolicyInputs.of("square", windows), 0)
    policy.fit_normalisation(windows)
    actions = torch.from_numpy(windows.actions)
    normal = policy.normalise(actions)
    torch.testing.assert_close(policy.denormalise(normal), actions)
    assert math.isclose(float(normal[:, :3].abs().max()), 0.9, rel_tol=1e-5)
    torch.testing.assert_close(policy.action_scale[:3], policy.action_scale[:1].expand(3))
    torch.testing.assert_close(normal[:, 6], actions[:, 6])


def test_both_signs_of_a_quaternion_are_one_rotation(policy: Policy) -> None:
    x = {name: torch.randn(2, size) for name, size in PROPRIOCEPTION.items()}
    flipped = {**x, "robot0_eef_quat": -x["robot0_eef_quat"]}
    torch.testing.assert_close(policy._low(x), policy._low(flipped))
    quaternion = torch.tensor([[0.0, 0.0, math.sin(0.3), math.cos(0.3)]])  # 0.6 rad about z
    columns = policy._low({**{n: v[:1] for n, v in x.items()}, "robot0_eef_quat": quaternion})[0, 3:9]
    expected = torch.tensor([math.cos(0.6), math.sin(0.6), 0, -math.sin(0.6), math.cos(0.6), 0])
    torch.testing.assert_close(columns, expected)


def test_what_the_hand_has_before_it_is_the_same_wherever_both_are() -> None:
    """Hand and objects moved and turned together, by scipy: told from the base everything changes, told from the hand nothing."""
    rng = np.random.default_rng(0)
    told = {**PROPRIOCEPTION, OBJECT_POSITIONS: 6, OBJECT_TURNS: 12}
    policy = Policy(PolicyConfig(observe="state"), PolicyInputs("two", (), told, 2))
    turn, move = Rotation.random(rng=rng), rng.normal(size=3)
    hand, objects = Rotation.random(rng=rng), Rotation.random(2, rng=rng)
    place, places = rng.normal(size=3), rng.normal(size=(2, 3))

    def low(hand: Rotation, objects: Rotation, place: np.ndarray, places: np.ndarray) -> torch.Tensor:
        seen = {"robot0_eef_pos": place, "robot0_eef_quat": hand.as_quat(), OBJECT_POSITIONS: places.ravel()}
        seen |= {OBJECT_TURNS: as_columns(objects.as_matrix()).ravel()}
        seen |= {name: np.zeros(PROPRIOCEPTION[name]) for name in ("robot0_gripper_qpos", "robot0_target_error")}
        return policy._low({name: torch.as_tensor(seen[name], dtype=torch.float32)[None] for name in told})[0]

    here = low(hand, objects, place, places)
    there = low(turn * hand, turn * objects, turn.apply(place) + move, turn.apply(places) + move)
    torch.testing.assert_close(here[-18:], there[-18:], atol=1e-5, rtol=0)
    assert not torch.allclose(here[:-18], there[:-18], atol=1e-2)
    before = hand.inv().apply(places - place)
    np.testing.assert_allclose(here[-18:-12].reshape(2, 3).numpy(), before, atol=1e-5)


def test_labels_of_repeated_frames_do_not_count(policy: Policy, windows: Windows) -> None:
    batch = windows.batch([0])  # seven repeats and the first frame
    spoilt = replace(batch, actions=np.where(batch.weight[..., None] > 0, batch.actions, 0.7).astype(np.float32))
    losses = [float(batch_loss(policy, b, LossConfig(), None, False)[0].detach()) for b in (batch, spoilt)]
    assert losses[0] == losses[1]
    assert batch.weight.sum() == 1


@pytest.mark.parametrize("supervise", ["all", "last"])
def test_a_run_teaches_what_its_windows_teach_apart(
    policy: Policy, store: EpisodeStore, windows: Windows, supervise: Literal["all", "last"]
) -> None:
    runs = Windows(store, range(3), WindowConfig(windows=4))
    config = LossConfig(supervise=supervise, location_weight=0.0)
    one, apart = (batch_loss(policy, b, config, None, False)[0] for b in (runs.batch([13]), windows.batch([10, 11, 12, 13])))
    torch.testing.assert_close(one, apart)


def test_the_gripper_goes_by_the_majority_of_the_weight(policy: Policy, monkeypatch: pytest.MonkeyPatch) -> None:
    """A component of small weight is drawn now and then: it moves the arm, it does not open the hand."""
    episode, mean = make_episode(5, 2), torch.zeros(1, 2, 7)
    mean[0, :, 6] = torch.tensor([0.9, -0.9])
    for share, answer in ((0.9, 1), (0.6, 1), (0.4, -1), (0.1, -1)):
        mixture = Mixture(torch.tensor([[share, 1 - share]]).log(), mean, torch.ones_like(mean))
        monkeypatch.setattr(policy, "answers", lambda _, mixture=mixture: mixture)
        agent = PolicyAgent(policy)
        assert {agent.act(observation(episode, 0))[6] for _ in range(20)} == {answer}


def test_the_agent_answers_as_the_policy_does_on_whole_windows(policy: Policy) -> None:
    _check_answers(PolicyAgent(policy, "likeliest"))


@pytest.mark.skipif(not is_installed(), reason="no ONNX Runtime: pip install 'optimus-tamp[onnx]'")
@pytest.mark.parametrize("trunk", [TransformerConfig(layers=1), LSTMConfig()], ids=lambda trunk: trunk.kind)
def test_a_compiled_agent_answers_as_the_policy_does_on_whole_windows(trunk: TrunkConfig) -> None:
    policy = fresh_policy(PolicyConfig(trunk=trunk), PolicyInputs("square", CAMERAS, PROPRIOCEPTION, 1), seed=0).eval()
    _check_answers(PolicyAgent(policy, "likeliest", compiled=True))


def _check_answers(agent: PolicyAgent) -> None:
    episode, policy = make_episode(5, 12), agent.policy
    agent.reset(0)
    answers = [agent.act(observation(episode, t)) for t in range(12)]
    for t in (0, 3, 11):
        frames = np.maximum(np.arange(t - 7, t + 1), 0)
        images = {c: torch.from_numpy(episode.observations[f"{c}_image"][frames, 4:80, 4:80])[None] for c in policy.inputs.cameras}
        low = {n: torch.from_numpy(episode.observations[n][frames])[None] for n in PROPRIOCEPTION}
        with torch.inference_mode():
            features = policy.features(policy.tokens(policy.frames(images, low)))[:, -1]
            expected = policy.denormalise(policy.answers(features).likeliest())[0].numpy()
        np.testing.assert_allclose(answers[t][:6], expected[:6].clip(-1, 1), atol=1e-5)
        assert answers[t][6] in (-1, 1)
        assert answers[t].dtype == np.float32 and answers[t].shape == (7,)


def test_without_onnx_runtime_a_policy_is_not_compiled(policy: Policy, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("optimus.learn.onnx_runtime.NEEDED", ("onnx", "no_such_package"))
    with pytest.raises(CheckpointError, match=r"needs onnx, no_such_package; pip install 'optimus-tamp\[onnx\]'"):
        PolicyAgent(policy, compiled=True)


def test_the_agent_is_a_function_of_its_seed(policy: Policy) -> None:
    episode, agent = make_episode(1, 6), PolicyAgent(policy)

    def answers(seed: int) -> np.ndarray:
        agent.reset(seed)
        return np.stack([agent.act(observation(episode, t)) for t in range(6)])

    first = answers(1)
    different = answers(2)
    np.testing.assert_array_equal(answers(1), first)
    assert not np.array_equal(different, first)


def test_the_agent_says_what_an_observation_lacks(policy: Policy) -> None:
    seen = observation(make_episode(0, 1), 0)
    del seen["wrist_image"]
    with pytest.raises(CheckpointError, match="needs wrist_image, the observation has"):
        PolicyAgent(policy).act(seen)


def test_an_action_looks_at_the_newest_frame_alone(policy: Policy) -> None:
    """What `optimus bench action` shows the seconds of: one image a camera, whatever the context."""
    episode, agent, seen = make_episode(0, 5), PolicyAgent(policy), []
    hooks = [e.register_forward_hook(lambda m, inputs, out: seen.append(len(inputs[0]))) for e in policy.encoders.children()]
    for step in range(5):
        agent.act(observation(episode, step))
    for hook in hooks:
        hook.remove()
    assert seen == [1] * 5 * len(CAMERAS)


def test_a_checkpoint_reads_back(policy: Policy, tmp_path: Path) -> None:
    checkpoint.write_config(tmp_path, policy.description())
    checkpoint.save(tmp_path, policy)
    loaded = checkpoint.load(tmp_path, task="square")
    assert (loaded.config, loaded.inputs) == (policy.config, policy.inputs)
    for name, value in policy.state_dict().items():
        torch.testing.assert_close(loaded.state_dict()[name], value, rtol=0, atol=0)


def test_checkpoints_that_do_not_fit_are_named(policy: Policy, tmp_path: Path) -> None:
    with pytest.raises(CheckpointError, match="holds no trained policy"):
        checkpoint.load(tmp_path)
    checkpoint.write_config(tmp_path, policy.description())
    with pytest.raises(CheckpointError, match="has not reached its first checkpoint"):
        checkpoint.load(tmp_path)
    checkpoint.save(tmp_path, policy)
    with pytest.raises(CheckpointError, match="trained for task 'square', not 'stack'"):
        checkpoint.load(tmp_path, task="stack")
    wider = replace(policy.config, trunk=TransformerConfig(width=64))
    checkpoint.write_config(tmp_path, Policy(wider, policy.inputs).description())
    with pytest.raises(CheckpointError, match="has shape"):
        checkpoint.load(tmp_path)
    checkpoint.write_config(tmp_path, policy.description())
    model = tmp_path / "model.safetensors"
    model.write_bytes(model.read_bytes()[:1000])
    with pytest.raises(CheckpointError, match="damaged"):
        checkpoint.load(tmp_path)
    (tmp_path / "config.json").write_text(json.dumps({"model": "of somebody else"}))
    with pytest.raises(CheckpointError, match="does not describe a training run"):
        checkpoint.load(tmp_path)


def test_an_observation_that_makes_no_sense_is_refused(policy: Policy) -> None:
    episode, agent = make_episode(1, 6), PolicyAgent(policy)
    usual = observation(episode, 0)
    listed = {name: value.tolist() if value.ndim == 1 else value for name, value in usual.items()}
    np.testing.assert_array_equal(PolicyAgent(policy).act(listed), agent.act(usual))  # type: ignore[arg-type]
    name = next(iter(PROPRIOCEPTION))
    with pytest.raises(CheckpointError, match=f"{name} holds NaN"):
        agent.act({**usual, name: np.full_like(usual[name], np.nan)})
    for wrong in ("abc", [[1.0], [1.0, 2.0]]):
        with pytest.raises(CheckpointError, match=f"{name} is no array of numbers"):
            agent.act({**usual, name: wrong})  # type: ignore[dict-item]
    agent.reset(seed=np.int64(3))  # type: ignore[arg-type]
    with pytest.raises(UnknownNameError, match="unknown component 'wrong'; valid: continuous, likeliest, paper, sampled"):
        PolicyAgent(policy, "wrong")  # type: ignore[arg-type]
