"""On a GPU: what is recorded, compiled and resident computes what is computed plainly."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch

from optimus.data.store import EpisodeStore
from optimus.data.windows import WindowConfig, Windows
from optimus.learn import metrics
from optimus.learn.agent import PolicyAgent
from optimus.learn.batches import ResidentWindows
from optimus.learn.checkpoint import load
from optimus.learn.encoder import ResNetConfig
from optimus.learn.gradient import GradientWorkers, LossConfig, Runtime
from optimus.learn.heads import BeTConfig, FlowConfig, MixtureConfig
from optimus.learn.policy import PolicyConfig, PolicyInputs
from optimus.learn.train import TrainConfig, fresh_policy, train
from optimus.learn.trunk import LSTMConfig, MLPConfig, TransformerConfig
from synthetic import make_dataset

pytestmark = pytest.mark.skipif(not torch.cuda.is_available(), reason="PyTorch finds no GPU here")

DROPS = TransformerConfig(width=64, layers=2, heads=2, dropout=0.1, attention_dropout=0.1)
NETWORKS = {
    "transformer": PolicyConfig(),
    "not aiming": PolicyConfig(aims=False),
    "dropout": PolicyConfig(trunk=DROPS, locates=False, aims=False),
    "rnn": PolicyConfig(10, trunk=LSTMConfig(width=64, token=32)),
    "mlp": PolicyConfig(1, trunk=MLPConfig(width=64)),
    "bet": PolicyConfig(head=BeTConfig()),
    "flow": PolicyConfig(head=FlowConfig(width=64)),
    "resnet": PolicyConfig(encoder=ResNetConfig(), head=MixtureConfig(min_deviation=1e-4), locates=False, aims=False),
}
GPU = Runtime(1, False, device="cuda")


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return make_dataset(tmp_path_factory.mktemp("data"), 8, 30).path


def gradient_of(dataset: Path, config: PolicyConfig, runtime: Runtime, steps: int = 3) -> tuple[list[float], torch.Tensor]:
    """Losses and gradient of the last of some steps, at the same weights."""
    cut = config.cut(windows=2) if config.context == 8 else config.cut()
    windows = Windows(EpisodeStore.open(dataset), range(8), cut)
    policy = fresh_policy(config, PolicyInputs.of("square", windows), 0)
    policy.fit_normalisation(windows)
    source = ResidentWindows(windows, torch.device(runtime.device)) if runtime.device == "cuda" else windows
    workers = GradientWorkers(policy.to(runtime.device), source, LossConfig(runs=8), runtime, seed=3)
    try:
        losses, gradient = [workers.gradient(step) for step in range(steps)][-1]
        return losses.tolist(), torch.cat([g.flatten() for g in gradient]).cpu()
    finally:
        workers.close()


def apart(a: torch.Tensor, b: torch.Tensor) -> float:
    return float((a - b).norm() / b.norm())


@pytest.mark.parametrize("name", NETWORKS)
def test_a_recorded_gradient_is_the_one_computed_kernel_by_kernel(dataset: Path, name: str) -> None:
    plain, recorded = (gradient_of(dataset, NETWORKS[name], r) for r in (GPU, replace(GPU, recorded=True)))
    assert recorded[0] == pytest.approx(plain[0], rel=1e-4)
    assert apart(recorded[1], plain[1]) < 1e-3


@pytest.mark.parametrize("name", ["transformer", "resnet"])
def test_the_gpus_gradient_is_the_cpus(dataset: Path, name: str) -> None:
    """Up to the rounding of its matrix units: tf32, then bfloat16 and, where that is worth it, compiled."""
    here = gradient_of(dataset, NETWORKS[name], Runtime(1, False), 1)
    there = gradient_of(dataset, NETWORKS[name], replace(GPU, recorded=True), 1)
    assert there[0] == pytest.approx(here[0], rel=1e-2)
    assert apart(there[1], here[1]) < 0.03
    fast = gradient_of(dataset, NETWORKS[name], replace(GPU, recorded=True, compiled=NETWORKS[name].encoder.compiled, half=True), 1)
    assert apart(fast[1], here[1]) < 0.15


def test_portions_of_a_recorded_batch_add_up(dataset: Path) -> None:
    one, three = (gradient_of(dataset, NETWORKS["transformer"], replace(GPU, recorded=r, accumulate=3)) for r in (False, True))
    assert apart(three[1], one[1]) < 1e-3


def test_it_learns_goes_on_and_acts_alike_on_both(tmp_path: Path) -> None:
    dataset = make_dataset(tmp_path / "data", 200, 6).path
    loss = LossConfig(runs=64)
    config = TrainConfig(steps=150, loss=loss, evaluations=2, held_out_runs=60, device="cuda", checkpoint_seconds=0.2)
    network = PolicyConfig(context=2)

    class Stop(Exception):
        pass

    def stop(progress: object) -> None:
        if getattr(progress, "step", 0) == 100:
            raise Stop

    with pytest.raises(Stop):
        train(dataset, tmp_path / "run", config, network, stop)
    train(dataset, tmp_path / "run", config, network)
    last = metrics.read(tmp_path / "run")[-1]
    assert last["step"] == 150 and last["held_out_location_error_mm"] < 20 and last["held_out_action_error_mm"] < 20
    here, there = (PolicyAgent(tmp_path / "run", "likeliest", device=device) for device in ("cpu", "cuda"))
    episode = EpisodeStore.open(dataset).read(0)
    for t in range(len(episode.actions)):
        observation = {name: values[t] for name, values in episode.observations.items()}
        np.testing.assert_allclose(there.act(observation), here.act(observation), atol=0.01)
    assert next(load(tmp_path / "run").parameters()).device.type == "cpu"


def test_a_data_set_too_large_for_the_gpu_stays_on_the_disk(dataset: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from optimus.learn import batches

    windows = Windows(EpisodeStore.open(dataset), range(8), WindowConfig(crop=60))
    assert isinstance(batches.source_on(windows, torch.device("cuda")), ResidentWindows)
    monkeypatch.setattr(torch.cuda, "mem_get_info", lambda device: (1000, 1000))
    assert batches.source_on(windows, torch.device("cuda")) is windows
