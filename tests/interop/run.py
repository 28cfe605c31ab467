"""Whether the programs that the exports are for can read them: each in an environment of its own, made here, a gigabyte or two.

    python tests/interop/run.py robomimic DATASET [--environments FOLDER]
    python tests/interop/run.py lerobot DATASET

Exports the data set and has the reader's own code train an epoch (robomimic's BC-Transformer) or load every frame (LeRobot). Fails
with the reader's own message if it does not like what it reads. Needs a package index; no part of the test suite.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from optimus.data.curate import load_curation
from optimus.data.store import EpisodeStore
from optimus.exchange.lerobot import LerobotConfig, export_lerobot
from optimus.exchange.robomimic import RobomimicConfig, export_robomimic

HERE = Path(__file__).parent
# a build of torch without CUDA; torchvision without what it requires, which would bring CUDA
TORCH = (("torch==2.13.0+cpu", "--extra-index-url", "https://download.pytorch.org/whl/cpu", "--retries", "1"),)
INSTALL: dict[str, tuple[tuple[str, ...], ...]] = {
    "robomimic": (
        *TORCH,
        ("--no-deps", "torchvision==0.22.1", "robomimic==0.3.0"),
        ("h5py", "psutil", "tqdm", "termcolor", "tensorboard", "tensorboardX", "imageio", "imageio-ffmpeg", "matplotlib", "six"),
        ("numpy<2", "pillow<12"),
    ),
    "lerobot": (
        *TORCH,
        ("--no-deps", "torchvision==0.22.1", "lerobot==0.4.4"),
        ("datasets>=4,<5", "huggingface-hub<0.36", "av>=15,<16", "jsonlines", "einops", "draccus==0.10.0", "gymnasium<2"),
        ("deepdiff", "imageio", "imageio-ffmpeg", "termcolor", "pyserial", "accelerate", "opencv-python-headless", "numpy<2.3"),
    ),
}


def environment(name: str, folder: Path) -> Path:
    """The Python of the reader's environment, made unless it is there."""
    python = folder / name / "bin" / "python"
    done = folder / name / "installed"
    if not done.exists():
        subprocess.run([sys.executable, "-m", "venv", str(folder / name)], check=True)
        for packages in INSTALL[name]:
            subprocess.run([str(python), "-m", "pip", "install", "-q", *packages], check=True)
        done.touch()
    return python


def read_by(python: Path, script: str, *args: str) -> None:
    """Run a reader's script, without a network and without GPU."""
    quiet = {"HF_HUB_OFFLINE": "1", "HF_DATASETS_OFFLINE": "1", "CUDA_VISIBLE_DEVICES": "", "PYTHONWARNINGS": "ignore"}
    subprocess.run([str(python), str(HERE / script), *args], check=True, env={**os.environ, **quiet, "PYTHONPATH": ""})


def robomimic(python: Path, dataset: Path, folder: Path) -> None:
    """One epoch of robomimic's own BC-Transformer."""
    file = folder / "demos.hdf5"
    sys.stdout.write(f"{export_robomimic(dataset, file, RobomimicConfig())}\n")
    read_by(python, "robomimic_trains.py", str(file), str(folder / "trained"))


def lerobot(python: Path, dataset: Path, folder: Path) -> None:
    """Every frame and statistic by LeRobot's own loader, with videos and with images."""
    expected = folder / "expected.npz"
    write_expected(dataset, expected)
    for images in (False, True):
        out = folder / ("images" if images else "videos")
        result = export_lerobot(dataset, out, LerobotConfig(images=images))
        sys.stdout.write(f"{result}\n")
        floor = min((q["worst_frame_db"] for q in result["videos"].values()), default=float("inf"))
        read_by(python, "lerobot_reads.py", str(out), str(expected), str(floor))


def write_expected(dataset: Path, file: Path) -> None:
    """What the reader has to find, from the data set itself: arrays over all frames, training episodes first."""
    store, curation = EpisodeStore.open(dataset), load_curation(dataset)
    episodes = [store.read(seed) for seed in (*curation.train, *curation.validation)]
    images = {f"images.{c}": np.concatenate([e.observations[f"{c}_image"] for e in episodes]) for c in store.cameras}
    low = [[a for k, a in e.observations.items() if not k.endswith("_image")] for e in episodes]
    arrays = {
        "state": np.concatenate([np.concatenate(parts, axis=1) for parts in low]),
        "action": np.concatenate([e.actions for e in episodes]),
        "lengths": np.array([len(e) for e in episodes]),
    }
    np.savez(file, allow_pickle=False, **arrays, **images)


def main() -> None:
    """The command."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("reader", choices=INSTALL)
    parser.add_argument("dataset", type=Path, help="a curated data set")
    parser.add_argument("--environments", type=Path, default=Path(tempfile.gettempdir()) / "optimus-interop")
    asked = parser.parse_args()
    python = environment(asked.reader, asked.environments)
    with tempfile.TemporaryDirectory() as folder:
        {"robomimic": robomimic, "lerobot": lerobot}[asked.reader](python, asked.dataset, Path(folder))


if __name__ == "__main__":
    main()
