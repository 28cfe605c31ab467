"""One batch, however it is shared out: over portions, over processes, or cut on the device, the step is the same."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch
from safetensors.numpy import load_file

from optimus.data.store import EpisodeStore
from optimus.data.windows import WindowConfig, Windows
from optimus.errors import CheckpointError
from optimus.learn import metrics
from optimus.learn.batches import ResidentWindows, on_device
from optimus.learn.gradient import BatchError, GradientWorkers, LossConfig, Runtime
from optimus.learn.policy import PolicyInputs
from optimus.learn.ranks import DeviceError, Ranks, device_kind
from optimus.learn.train import TrainingError, fresh_policy, train
from synthetic import make_dataset
from test_train import QUICK, SMALL, files_of

torch.set_num_threads(1)

CHILD = """
import os, sys; sys.path.insert(0, {tests!r})
import torch; torch.set_num_threads(1)
from dataclasses import replace
from pathlib import Path
from safetensors.torch import save_file
from test_train import QUICK, SMALL, train
from optimus.learn.gradient import Runtime
from optimus.learn.checkpoint import contiguous
config = replace(QUICK, steps={steps}, runtime=Runtime(1, False, 1, 2))
rank = os.environ["RANK"]
def slow(p):  # whichever is slower decides nothing
    if rank == "1" and p.step == {kill}: os.kill(os.getpid(), 9)
policy = train({dataset!r}, {run!r}, config, SMALL, slow)
save_file(contiguous(policy.state_dict()), {run!r} + "-rank" + rank + ".safetensors")
"""


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return make_dataset(tmp_path_factory.mktemp("data"), 4, 12).path


def two_processes(dataset: Path, run: Path, steps: int = 8, kill: int = 0) -> int:
    """Train in two processes over gloo, as `torchrun` starts them; the exit status. Rank 1 is killed after step `kill`."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    script = CHILD.format(tests=str(Path(__file__).parent), dataset=str(dataset), run=str(run), steps=steps, kill=kill)
    children = []
    for rank in "01":
        told = {"RANK": rank, "LOCAL_RANK": rank, "WORLD_SIZE": "2", "LOCAL_WORLD_SIZE": "2"}
        env = {**os.environ, **told, "MASTER_ADDR": "127.0.0.1", "MASTER_PORT": str(port), "OMP_NUM_THREADS": "1"}
        children.append(subprocess.Popen([sys.executable, "-c", script], env=env, stderr=subprocess.PIPE))
    if kill:
        children[1].wait()
        children[0].wait(60)  # its partner is gone: it ends with an error of its own
    out = [child.communicate()[1].decode() for child in children]
    if not kill:
        assert [child.returncode for child in children] == [0, 0], out
    return max(abs(child.returncode) for child in children)


@pytest.fixture(scope="module")
def together(dataset: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    run = tmp_path_factory.mktemp("two") / "together"
    two_processes(dataset, run)
    return run


def test_two_processes_are_one_with_the_joint_batch(dataset: Path, together: Path, tmp_path: Path) -> None:
    alone = tmp_path / "alone"
    train(dataset, alone, replace(QUICK, steps=8, runtime=Runtime(1, False, 2)), SMALL)
    mine, theirs = files_of(alone), files_of(together)
    for file, tensors in mine.items():
        for name, value in tensors.items():
            np.testing.assert_allclose(value, theirs[file][name], rtol=1e-4, atol=1e-6, err_msg=f"{file} {name}")
    said = [[line["loss"] for line in metrics.read(run)] for run in (alone, together)]
    assert len(said[0]) == 8  # step for step
    np.testing.assert_allclose(said[0], said[1], rtol=1e-4)
    first, second = (load_file(f"{together}-rank{rank}.safetensors") for rank in "01")
    for name, value in first.items():
        assert value.tobytes() == second[name].tobytes(), name


def test_two_processes_of_which_one_was_killed_end_with_the_same_bits(dataset: Path, together: Path, tmp_path: Path) -> None:
    assert two_processes(dataset, tmp_path / "killed", kill=5) != 0
    assert metrics.read(tmp_path / "killed")[-1]["step"] < 8
    two_processes(dataset, tmp_path / "killed")
    for file, tensors in files_of(together).items():
        for name, value in tensors.items():
            assert value.tobytes() == files_of(tmp_path / "killed")[file][name].tobytes(), (file, name)
    with pytest.raises(CheckpointError, match=r"started with processes = 2, not 1"):
        train(dataset, together, replace(QUICK, steps=8, runtime=Runtime(1, False, 1, 2)), SMALL)


def test_portions_add_up_to_the_mean_gradient_of_their_windows(dataset: Path) -> None:
    windows = Windows(EpisodeStore.open(dataset), range(4), WindowConfig(crop=60))
    policy = fresh_policy(SMALL, PolicyInputs.of("square", windows), 0)
    gradients = []
    for runtime in (Runtime(4, False), Runtime(1, False, 4), Runtime(2, False, 2)):
        workers = GradientWorkers(policy, windows, LossConfig(runs=8), runtime, seed=5)
        gradients.append(workers.gradient(3))
        workers.close()
    for loss, gradient in gradients[1:]:
        torch.testing.assert_close(loss, gradients[0][0], rtol=1e-6, atol=1e-9)
        for a, b in zip(gradient, gradients[0][1], strict=True):
            torch.testing.assert_close(a, b, rtol=1e-4, atol=1e-6)
    with pytest.raises(BatchError, match="8 cannot be split into 12 parts"):
        GradientWorkers(policy, windows, LossConfig(runs=8), Runtime(2, False, 6), seed=5)


def test_what_is_cut_on_the_device_is_what_is_cut_from_the_files(dataset: Path) -> None:
    windows = Windows(EpisodeStore.open(dataset), range(4), WindowConfig(crop=60, windows=2))
    resident = ResidentWindows(windows, torch.device("cpu"))
    for seed in range(5):
        here = resident.sample(np.random.default_rng(seed), 16)
        there = on_device(windows.sample(np.random.default_rng(seed), 16), torch.device("cpu"))
        for name in ("images", "shifts", "proprioception"):
            for key, value in getattr(there, name).items():
                assert torch.equal(value, getattr(here, name)[key]), (name, key)
        for name in ("actions", "weight", "objects"):
            assert torch.equal(getattr(there, name), getattr(here, name)), name


def test_a_step_from_the_resident_data_is_the_same_step(dataset: Path) -> None:
    windows = Windows(EpisodeStore.open(dataset), range(4), WindowConfig(crop=60))
    policy = fresh_policy(SMALL, PolicyInputs.of("square", windows), 0)
    answers = []
    for source in (windows, ResidentWindows(windows, torch.device("cpu"))):
        workers = GradientWorkers(policy, source, LossConfig(runs=4), Runtime(2, False), seed=1)
        answers.append(workers.gradient(0)[1])
        workers.close()
    assert all(torch.equal(a, b) for a, b in zip(*answers, strict=True))


def test_several_processes_need_a_number_of_steps(dataset: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from contextlib import nullcontext

    monkeypatch.setattr("optimus.learn.train.joined", lambda device: nullcontext(Ranks(0, 2, 2)))
    with pytest.raises(TrainingError, match="--steps"):
        train(dataset, tmp_path, replace(QUICK, steps=None), SMALL)


def test_processes_that_find_other_episodes_do_not_train_together(
    dataset: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As where one of them opened a dataset before another one had curated it."""
    monkeypatch.setattr(Ranks, "agree", lambda self, value: "another split" if isinstance(value, str) else value)
    with pytest.raises(TrainingError, match="process 0 found other episodes than the first one"):
        train(dataset, tmp_path / "run", QUICK, SMALL)


@pytest.mark.skipif(torch.cuda.is_available(), reason="there is a GPU here")
def test_a_device_that_is_not_there_is_an_error(dataset: Path, tmp_path: Path) -> None:
    assert device_kind("auto") == device_kind("cpu") == "cpu"
    with pytest.raises(DeviceError, match="--device cpu"):
        train(dataset, tmp_path, replace(QUICK, device="cuda"), SMALL)
    with pytest.raises(DeviceError, match="valid: auto, cpu, cuda"):
        device_kind("tpu")
