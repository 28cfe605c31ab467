"""Run in an environment with LeRobot: its loader reads a folder, and every frame and statistic is what it should be.

Arguments: the folder; a file of expected arrays (`run.write_expected`); the PSNR [dB] that every frame has to reach, inf for exact.
"""

# pyright: reportMissingImports=false
import json
import sys
from pathlib import Path

import numpy as np
from vision import import_torchvision

import_torchvision()

import torch  # noqa: E402
from lerobot.datasets.compute_stats import aggregate_stats, get_feature_stats  # noqa: E402
from lerobot.datasets.lerobot_dataset import LeRobotDataset  # noqa: E402
from lerobot.datasets.utils import load_nested_dataset  # noqa: E402

QUANTILES = {"01": 0.01, "10": 0.1, "50": 0.5, "90": 0.9, "99": 0.99}
KEYS = {"state": "observation.state", "action": "action"}


def main() -> None:
    """Compare; an assertion names what differs."""
    root, expected, floor = Path(sys.argv[1]), dict(np.load(sys.argv[2])), float(sys.argv[3])
    dataset = LeRobotDataset("local/export", root=root, video_backend="pyav")
    cameras = [k for k in expected if k.startswith("images.")]
    total = int(expected["lengths"].sum())
    assert (len(dataset), dataset.meta.total_episodes) == (total, len(expected["lengths"]))
    starts = np.repeat(np.cumsum(expected["lengths"]) - expected["lengths"], expected["lengths"])
    worst = np.inf
    for i in range(total):
        frame = dataset[i]
        for name, key in KEYS.items():
            assert np.array_equal(frame[key].numpy(), expected[name][i]), (key, i)
        assert abs(float(frame["timestamp"]) - (i - starts[i]) / dataset.fps) < 1e-4 and frame["task"]
        for camera in cameras:
            seen = np.rint(frame[f"observation.{camera}"].permute(1, 2, 0).numpy() * 255)
            error = float(np.mean((seen - expected[camera][i]) ** 2))
            worst = min(worst, np.inf if error == 0 else 10 * np.log10(255**2 / error))
    assert worst >= floor - 0.5, (worst, floor)
    windows = LeRobotDataset("local/export", root=root, video_backend="pyav", delta_timestamps={"action": [0.0, 1 / dataset.fps]})
    assert torch.equal(windows[5]["action"], torch.from_numpy(expected["action"][5:7]))
    check_statistics(dataset, root, expected, cameras)
    sys.stdout.write(f"LeRobot read {total} frames of {len(expected['lengths'])} episodes; worst frame {worst:.1f} dB\n")


def check_statistics(dataset: LeRobotDataset, root: Path, expected: dict[str, np.ndarray], cameras: list[str]) -> None:
    """Ours, of each episode and of all, against those by LeRobot's own functions of the same arrays."""
    rows = load_nested_dataset(root / "meta/episodes")
    ends = np.cumsum(expected["lengths"])
    theirs = []
    for row, end, length in zip(rows, ends, expected["lengths"], strict=True):
        part = slice(end - length, end)
        # of float64: LeRobot subtracts squares in what it is given, and squares uint8 within uint8
        values = {key: expected[name][part].astype(np.float64) for name, key in KEYS.items()}
        found = {key: get_feature_stats(array, axis=0, keepdims=False) for key, array in values.items()}
        for camera in cameras:
            array, key = expected[camera][part].transpose(0, 3, 1, 2).astype(np.float64), f"observation.{camera}"
            stats = get_feature_stats(array, axis=(0, 2, 3), keepdims=True)
            found[key] = {k: v if k == "count" else np.squeeze(v / 255.0, axis=0) for k, v in stats.items()}
            values[key] = array.transpose(0, 2, 3, 1).reshape(-1, 3) / 255.0
        for key, stats in found.items():
            own = {name: row[f"stats/{key}/{name}"] for name in stats}
            compare(key, {k: v for k, v in stats.items() if k[1:] not in QUANTILES}, own)
            check_quantiles(key, values[key], stats, own)
        theirs.append(found)
    ours = json.loads((root / "meta/stats.json").read_text())
    for key, stats in aggregate_stats(theirs).items():
        compare(key, {k: v for k, v in stats.items() if k[1:] not in QUANTILES}, ours[key])
        assert np.allclose(dataset.meta.stats[key]["mean"], np.array(ours[key]["mean"]))


def compare(key: str, theirs: dict[str, np.ndarray], ours: dict[str, list]) -> None:
    """Equal to rounding."""
    for name, value in theirs.items():
        assert np.shape(value) == np.shape(ours[name]), (key, name, np.shape(value), np.shape(ours[name]))
        assert np.allclose(value, np.asarray(ours[name]), rtol=0, atol=1e-5), (key, name, value, ours[name])


def check_quantiles(key: str, values: np.ndarray, theirs: dict[str, np.ndarray], ours: dict[str, list]) -> None:
    """Both lie where a quantile may: LeRobot estimates it from a histogram, or takes the value below where it is between two."""
    slack = 0.01 * np.ptp(values, axis=0) + 1e-6
    for digits, share in QUANTILES.items():
        low, high = (np.quantile(values, np.clip(share + d / len(values), 0, 1), axis=0) for d in (-1.5, 1.5))
        for found in (theirs[f"q{digits}"], ours[f"q{digits}"]):
            value = np.asarray(found).ravel()
            assert np.all((low - slack <= value) & (value <= high + slack)), (key, digits, low, value, high)


if __name__ == "__main__":
    main()
