"""Encoders, trunks and heads against other implementations, published counts, formulas and themselves computed plainly."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import torch
import torch.nn.functional as F
from torch import Tensor, nn

from optimus.bench.yardstick import plain_action, plain_loss, plainly
from optimus.data.store import EpisodeStore
from optimus.data.windows import WindowConfig, Windows
from optimus.errors import UnknownNameError
from optimus.learn.agent import PolicyAgent
from optimus.learn.encoder import Encoder, ResNetConfig
from optimus.learn.encoder.small_maps import GatheredConv2d, SmallMapConv2d, TapProducts
from optimus.learn.gradient import LossConfig, batch_loss
from optimus.learn.heads import BeTConfig, FlowConfig, Mixture, MixtureConfig
from optimus.learn.policy import Policy, PolicyInputs
from optimus.learn.presets import PRESETS, preset
from optimus.learn.train import fresh_policy
from optimus.learn.trunk import LSTMConfig, MLPConfig, TransformerConfig
from optimus.learn.trunk.transformer import Block
from synthetic import CAMERAS, make_dataset, make_episode

torch.set_num_threads(1)  # tests run in several processes

PROPRIOCEPTION = {"robot0_eef_pos": 3, "robot0_eef_quat": 4, "robot0_gripper_qpos": 2, "robot0_target_error": 6}
INPUTS = PolicyInputs("square", CAMERAS, PROPRIOCEPTION, 1, keypose=12)


@pytest.fixture(scope="module")
def store(tmp_path_factory: pytest.TempPathFactory) -> EpisodeStore:
    return make_dataset(tmp_path_factory.mktemp("data"), 3)


@pytest.fixture(scope="module")
def large() -> Policy:
    return fresh_policy(preset("optimus-30m").policy, INPUTS, 0).eval()


def test_resnet_has_the_published_number_of_weights() -> None:
    """torchvision documents 11,689,512 for ResNet-18, of which the classes' layer has 513,000."""
    encoder = Encoder(ResNetConfig())
    keypoints = 32 * 512 + 32
    assert sum(p.numel() for p in encoder.trunk.parameters()) - keypoints == 11_689_512 - 513_000
    maps = encoder.trunk(torch.zeros(1, 3, 76, 76))
    assert maps.shape == (1, 32, 3, 3)


@pytest.mark.parametrize(
    ("name", "millions"),
    [
        ("quick", 0.797),
        ("quick-locating", 0.777),
        ("optimus-30m", 27.2),
        ("optimus-30m-locating", 27.2),
        ("optimus-60m", 60.3),
        ("optimus-100m", 100.7),
        ("bc-mlp", 23.7),
        ("bc-rnn", 35.5),
    ],
)
def test_presets_have_the_size_that_their_layers_add_up_to(name: str, millions: float) -> None:
    config = preset(name).policy
    trunk, seen = config.trunk, 64 * 2 + 17
    d, n = trunk.width, config.trunk.layers  # type: ignore[attr-defined]
    match trunk:
        case TransformerConfig():
            inside = config.context * d + 4 * d + n * (12 * d * d + 10 * d)  # qkv has no bias
        case MLPConfig():
            inside = (n - 1) * (d * d + d)
        case _:
            inside = sum(4 * d * (below + d + 2) for below in [trunk.token, *[d] * (n - 1)])
    said = [n for n, used in ((3, config.locates), (12, config.aims)) if used]
    saying = sum(128 * 128 + 128 + n * 128 + n for n in said)
    embedding, head = (seen + sum(said) + 1) * trunk.token, (d + 1) * 5 * 15
    policy = fresh_policy(config, INPUTS, 0)
    encoders = sum(p.numel() for p in policy.encoders.parameters())
    assert policy.parameter_count == encoders + inside + embedding + head + saying
    assert policy.parameter_count / 1e6 == pytest.approx(millions, rel=0.01)


@pytest.mark.parametrize(("side", "stride"), [(1, 1), (2, 1), (3, 1), (5, 2), (6, 2), (4, 1)])
def test_products_of_taps_are_the_convolution(side: int, stride: int) -> None:
    torch.manual_seed(0)
    x = torch.randn(5, 6, side, side, requires_grad=True)
    weight = torch.randn(4, 6, 3, 3, requires_grad=True)
    expected = F.conv2d(x, weight, stride=stride, padding=1)
    found = TapProducts.apply(x, weight, stride)
    torch.testing.assert_close(found, expected, atol=1e-4, rtol=1e-4)
    above = torch.randn_like(expected)
    for have, want in zip(*(torch.autograd.grad(y, (x, weight), above) for y in (found, expected)), strict=True):
        torch.testing.assert_close(have, want, atol=1e-4, rtol=1e-4)


@pytest.mark.parametrize(("size", "stride"), [((1, 1), 1), ((3, 3), 1), ((2, 3), 1), ((5, 5), 2), ((4, 6), 2), ((4, 4), 1)])
def test_what_taps_see_gathered_is_the_convolution_of_an_image(size: tuple[int, int], stride: int) -> None:
    torch.manual_seed(0)
    conv, x = SmallMapConv2d(6, 4, 3, stride, 1, bias=False), torch.randn(1, 6, *size)
    torch.testing.assert_close(GatheredConv2d(conv)(x), F.conv2d(x, conv.weight, stride=stride, padding=1))


def difference(first: list[Tensor], second: list[Tensor]) -> float:
    a, b = (torch.cat([g.flatten() for g in gradient]) for gradient in (first, second))
    return float((a - b).norm() / a.norm())


def test_the_fast_gradient_is_the_plain_one(large: Policy, store: EpisodeStore) -> None:
    """In float32 to rounding; in bfloat16 as near as bfloat16 comes with the library's own convolutions."""
    batch = Windows(store, range(3), WindowConfig()).batch([9, 36])
    loss = LossConfig(runs=2, supervise="last", location_weight=0.0)

    def gradient(policy: Policy, half: bool) -> list[Tensor]:
        value = batch_loss(policy, batch, loss, torch.Generator().manual_seed(0), half)[0]
        return list(torch.autograd.grad(value, list(policy.parameters()), materialize_grads=True))

    plain = plainly(large)
    value = plain_loss(plain, batch, torch.Generator().manual_seed(0))
    expected = list(torch.autograd.grad(value, list(plain.parameters()), materialize_grads=True))
    assert difference(expected, gradient(large, False)) < 1e-3
    of_library, of_taps = difference(expected, gradient(plain, True)), difference(expected, gradient(large, True))
    assert of_taps < max(1.2 * of_library, 0.02)
    assert of_taps < 0.2


def test_only_small_maps_are_taken_apart(monkeypatch: pytest.MonkeyPatch) -> None:
    seen = []
    apply = TapProducts.apply
    monkeypatch.setattr(TapProducts, "apply", lambda x, *rest: (seen.append(x.shape[-1]), apply(x, *rest))[1])
    conv = SmallMapConv2d(2, 2, 3, 1, 1, bias=False)
    for side in (3, 5):
        conv(torch.zeros(20, 2, side, side))
    assert seen == [3]


def test_an_action_of_the_large_policy_is_that_of_its_window(large: Policy) -> None:
    episode, agent = make_episode(5, 10), PolicyAgent(large, "likeliest")
    answers = [agent.act({name: array[t] for name, array in episode.observations.items()}) for t in range(10)]
    images = {c: torch.from_numpy(episode.observations[f"{c}_image"][2:10, 4:80, 4:80])[None] for c in CAMERAS}
    low = {name: torch.from_numpy(episode.observations[name][2:10])[None] for name in PROPRIOCEPTION}
    np.testing.assert_allclose(answers[-1], plain_action(plainly(large), images, low).numpy(), atol=1e-4)


def test_a_block_is_pytorchs_own_pre_norm_layer() -> None:
    torch.manual_seed(0)
    block = Block(TransformerConfig(width=32, heads=4)).eval()
    layer = nn.TransformerEncoderLayer(32, 4, 128, 0.0, F.gelu, batch_first=True, norm_first=True).eval()
    with torch.no_grad():
        layer.self_attn.in_proj_weight.copy_(block.qkv.weight)
        layer.self_attn.in_proj_bias.zero_()
        pairs = ((layer.self_attn.out_proj, block.merge), (layer.linear1, block.expand), (layer.linear2, block.contract))
        for theirs, ours in pairs:
            theirs.load_state_dict(ours.state_dict())
        x = torch.randn(2, 8, 32)
        expected = layer(x, src_mask=nn.Transformer.generate_square_subsequent_mask(8), is_causal=True)
        torch.testing.assert_close(block(x, None), expected, atol=1e-5, rtol=1e-4)


def test_attention_is_dropped_by_the_callers_generator() -> None:
    torch.manual_seed(0)
    config = TransformerConfig(width=32, heads=4, attention_dropout=0.1)
    block, x = Block(config), torch.randn(64, 8, 32)
    first, again, other = (block(x, torch.Generator().manual_seed(s)) for s in (1, 1, 2))
    torch.testing.assert_close(first, again, rtol=0, atol=0)
    assert not torch.equal(first, other)
    # a share that hardly ever drops is plain attention, by another way of computing it
    rare = Block(TransformerConfig(width=32, heads=4, attention_dropout=1e-9))
    rare.load_state_dict(block.state_dict())
    torch.testing.assert_close(rare(x, torch.Generator()), block(x, None), atol=1e-5, rtol=1e-4)


def test_a_perceptron_sees_one_frame_and_a_memory_all_before() -> None:
    torch.manual_seed(0)
    for config, reach in ((MLPConfig(width=32), 1), (LSTMConfig(width=32, token=32), 5)):
        trunk, tokens = config.build(8), torch.randn(2, 8, 32)
        changed = tokens.clone()
        changed[:, 3] = torch.randn(2, 32)
        assert ((trunk(tokens) - trunk(changed)).abs().amax((0, 2)) > 1e-7).tolist() == [3 <= t < 3 + reach for t in range(8)]


@pytest.mark.parametrize("most", [None, 0.1])
def test_the_likelihood_is_that_of_pytorchs_mixture(most: float | None) -> None:
    torch.manual_seed(0)
    head = MixtureConfig(min_deviation=1e-4, max_deviation=most).build(16, 7)
    features, actions = torch.randn(9, 16), torch.rand(9, 7) - 0.5
    made = head(features)
    parts = torch.distributions.Independent(torch.distributions.Normal(made.mean, made.deviation), 1)
    whole = torch.distributions.MixtureSameFamily(torch.distributions.Categorical(logits=made.logits), parts)
    torch.testing.assert_close(-head.loss(features, actions), whole.log_prob(actions))


def test_one_component_of_unit_deviation_is_least_squares() -> None:
    head = preset("quick", "mse").policy.head.build(16, 7)
    features, actions = torch.randn(9, 16), torch.rand(9, 7)
    answer = head(features).likeliest()
    expected = 0.5 * F.mse_loss(answer, actions, reduction="none").sum(-1) + 3.5 * math.log(2 * math.pi)
    torch.testing.assert_close(head.loss(features, actions), expected)


def test_bet_finds_clusters_and_answers_with_centre_and_offset() -> None:
    rng = np.random.default_rng(0)
    centres = rng.uniform(-0.9, 0.9, (4, 7))
    actions = (centres[rng.integers(4, size=400)] + rng.normal(0, 1e-3, (400, 7))).astype(np.float32)
    head = BeTConfig(clusters=4).build(8, 7)
    head.fit(actions)
    nearest = np.abs(head.centres.numpy()[:, None] - centres).max(-1).min(0)
    assert nearest.max() < 1e-3
    head.requires_grad_(False)
    features, label = torch.randn(5, 8), torch.from_numpy(actions[:5])
    made = head(features)
    assert isinstance(made, Mixture)
    for k in range(5):
        right = int(((head.centres - label[k]) ** 2).sum(-1).argmin())
        share = float(torch.softmax(made.logits[k], -1)[right])
        squared = float(((made.mean[k, right] - label[k]) ** 2).mean())
        expected = -((1 - share) ** 2) * math.log(share) + 100 * squared
        assert float(head.loss(features, label)[k]) == pytest.approx(expected, rel=1e-4)


def test_bet_makes_do_with_few_different_actions() -> None:
    head = BeTConfig(clusters=24).build(8, 2)
    head.fit(np.array([[0, 1], [1, 0], [0, 1]], np.float32))
    assert {tuple(row) for row in head.centres.tolist()} == {(0.0, 1.0), (1.0, 0.0)}


def test_a_flow_learns_two_ways() -> None:
    """Half of the labels are one chunk, half its opposite: a mean would be neither."""
    torch.manual_seed(0)
    head = FlowConfig(chunk=2, width=128, steps=8).build(4, 1)
    noise = torch.Generator().manual_seed(0)
    optimiser = torch.optim.Adam(head.parameters(), 3e-3)
    way = torch.tensor([[0.6], [0.3]])
    for _ in range(1000):
        sign = torch.randint(0, 2, (256, 1, 1), generator=noise) * 2 - 1
        loss = head.loss(torch.zeros(256, 4), sign * way, noise).mean()
        optimiser.zero_grad()
        loss.backward()
        optimiser.step()
    with torch.no_grad():
        found = head(torch.zeros(500, 4)).sampled(noise)
    side = found[:, 0, 0].sign()
    assert 0.35 < float((side > 0).float().mean()) < 0.65
    torch.testing.assert_close((side[:, None, None] * found).mean(0), way, atol=0.08, rtol=0)
    assert float((side[:, None, None] * found - way).abs().mean()) < 0.12


def test_a_chunk_is_labelled_with_what_comes_next(store: EpisodeStore) -> None:
    batch = Windows(store, [1], WindowConfig(ahead=3)).batch([0, 10, 18, 19])
    actions = make_episode(1).actions
    for row, end in enumerate((0, 10, 18, 19)):
        following = np.minimum(np.arange(end + 1, end + 4), 19)
        np.testing.assert_array_equal(batch.ahead[row, -1], actions[following])


def test_an_agent_carries_out_a_part_of_each_chunk() -> None:
    policy = fresh_policy(preset("quick", "flow").policy, INPUTS, 0)
    agent, episode, planned = PolicyAgent(policy), make_episode(1, 9), []
    plan = agent._plan
    agent._plan = lambda: (planned.append(len(agent._tokens)), plan())[1]  # type: ignore[method-assign]
    actions = np.stack([agent.act({name: array[t] for name, array in episode.observations.items()}) for t in range(9)])
    assert len(planned) == 3  # at steps 0, 4 and 8
    assert actions.shape == (9, 7) and set(np.abs(actions[:, 6])) == {1.0}


@pytest.mark.parametrize("name", [name for name in PRESETS if name.startswith("quick")])
@pytest.mark.parametrize("head", [None, "gmm", "gaussian", "mse", "flow", "bet"])
def test_every_trunk_goes_with_every_head(name: str, head: str | None, store: EpisodeStore) -> None:
    config = preset(name, head).policy  # type: ignore[arg-type]
    policy = fresh_policy(config, INPUTS, 0)
    cut = Windows(store, [0, 1], config.cut())
    policy.fit_normalisation(cut)
    assert Policy.from_description(Policy.described(policy.description())).config == config
    likelihood, _ = batch_loss(policy, cut.batch([3, 12]), LossConfig(runs=2), torch.Generator().manual_seed(0), False)
    gradient = torch.autograd.grad(likelihood, list(policy.parameters()), materialize_grads=True)
    assert all(bool(g.isfinite().all()) for g in gradient) and difference(list(gradient), [torch.zeros_like(g) for g in gradient])
    action = PolicyAgent(policy).act({name: array[0] for name, array in make_episode(1, 1).observations.items()})
    assert action.shape == (7,) and abs(action[6]) == 1


@pytest.mark.parametrize("name", ["quick", "quick-locating", "optimus-30m", "optimus-30m-locating"])
def test_a_mixture_asked_for_by_name_is_the_presets_own(name: str) -> None:
    assert preset(name, "gmm").policy == preset(name).policy


def test_unknown_names_are_listed() -> None:
    with pytest.raises(UnknownNameError, match="bc-mlp"):
        preset("optimus-31m")
    with pytest.raises(UnknownNameError, match="gaussian"):
        preset("quick", "softmax")  # type: ignore[arg-type]


def test_a_residual_encoder_compiles_to_one_graph() -> None:
    """Block by block, its seven kinds of block would use up PyTorch's limit of graphs with one shape of images."""
    graphs = []

    def count(graph: torch.fx.GraphModule, _: list[torch.Tensor]) -> Any:
        graphs.append(graph)
        return graph.forward

    first, second = (Encoder(ResNetConfig()).get_submodule("trunk") for _ in range(2))
    for trunk in (first, second):
        trunk.compile(backend=count, dynamic=False)
    with torch.no_grad():
        for images in (torch.rand(1, 3, 76, 76), torch.rand(2, 3, 76, 76)):
            for trunk in (first, second):
                expected = torch.nn.Sequential(*trunk.children())(images)
                torch.testing.assert_close(trunk(images), expected)
    assert 2 <= len(graphs) <= 4  # one for each shape, perhaps for each camera as well
    torch._dynamo.reset()
