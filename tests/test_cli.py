"""The command line as a contract: JSON last on standard output, one-line errors with exit status 2."""

import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pytest
from PIL import Image
from safetensors.numpy import load_file

from optimus.control import CONTROLS
from optimus.tasks import TASKS
from program import optimus, refused, result_of
from synthetic import make_dataset


def test_tasks_and_help() -> None:
    assert {t["name"] for t in result_of("tasks")["tasks"]} == set(TASKS)
    for verb in ("show", "collect", "dataset", "export", "import", "train", "evaluate", "export-policy", "run", "bench"):
        done = optimus(verb, "--help")
        assert done.returncode == 0 and "optimus " + verb in done.stdout and "Try:" in done.stdout


def test_it_says_which_version_it_is() -> None:
    assert optimus("--version").stdout == f"optimus {version('optimus-tamp')}\n"


def test_help_names_the_ways_of_control() -> None:
    assert "{" + ",".join(CONTROLS) + "}" in optimus("collect", "--help").stdout


def test_help_loads_no_simulator_and_no_learner() -> None:
    code = "import sys, optimus.cli; print(*(m for m in ('mujoco', 'torch', 'ompl') if m in sys.modules))"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split() == []


def test_it_is_a_module_that_can_be_run() -> None:
    done = subprocess.run([sys.executable, "-m", "optimus.cli", "show", "stackk"], capture_output=True, text=True, check=False)
    assert done.returncode == 2 and done.stderr.startswith("optimus: unknown task 'stackk'") and done.stderr.count("\n") == 1


def test_a_reader_that_has_seen_enough_is_no_error() -> None:
    command = (sys.executable, "-m", "optimus.cli", "tasks")
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as asked:
        assert asked.stdout is not None and asked.stderr is not None
        asked.stdout.close()
        assert asked.stderr.read() == b"" and asked.wait() == 141


def test_unknown_names_list_the_valid_ones(tmp_path: Path) -> None:
    assert ", ".join(sorted(TASKS)) in refused("show", "stackk")
    assert "pick-place-two, shelf" in refused("collect", "stackk", "--out", str(tmp_path / "d"))
    assert "collect" in refused("colect", "stack")
    assert not (tmp_path / "d").exists()


def test_numbers_that_make_no_sense_are_refused_before_anything_is_written(tmp_path: Path) -> None:
    data = ("--out", str(tmp_path / "d"))
    for option in ("--workers", "--seed", "--episodes", "--stall", "--speed"):
        assert f"{option[2:]}: -1" in refused("collect", "stack", option, "-1", *data)
    assert "speed: nan" in refused("collect", "stack", "--speed", "nan", *data)
    assert "episodes: 0 is not 1 or more" in refused("bench", "expert", "stack", "--episodes", "0")
    assert "seed: -1" in refused("show", "stack", "--seed", "-1", "--out", str(tmp_path / "p.png"))
    assert list(tmp_path.iterdir()) == []


def test_missing_or_foreign_folders_are_named(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("not a dataset")
    assert "file" in refused("curate", str(tmp_path / "file"))
    assert str(tmp_path) in refused("train", str(tmp_path), "--out", str(tmp_path / "run"))
    assert str(tmp_path) in refused("evaluate", str(tmp_path), "--states", "random")
    assert "file" in refused("collect", "stack", "--out", str(tmp_path / "file" / "data"))


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_a_full_disk_is_one_line(tmp_path: Path) -> None:
    """A file system of 300 kB, made in a mount namespace where that is allowed."""
    script = f"mount -t tmpfs -o size=300k none {tmp_path} && exec {sys.executable} -m optimus.cli collect stack"
    script += f" --episodes 1 --workers 1 --out {tmp_path}/data"
    done = subprocess.run(["unshare", "-rm", "sh", "-c", script], capture_output=True, text=True, check=False)
    if "unshare" in done.stderr or "mount" in done.stderr:
        pytest.skip("mount namespaces are not allowed here")
    assert done.returncode == 2
    assert "No space left" in done.stderr.strip().splitlines()[-1]


def test_bench_expert_has_its_keys() -> None:
    result = result_of("bench", "expert", "stack", "--episodes", "3", "--seed", "77")
    keys = "task control episodes successes interval paper_rule_successes plan_seconds episode_steps tracking_error_mm"
    assert {*keys.split(), "branches", "retries", "retried_seeds", "failures", "failed_seeds"} <= set(result)
    assert "planning_shares" not in result
    assert "invalid_plans" not in result
    assert result["successes"] == 3 and set(result["plan_seconds"]) == {"median", "p95", "max"}


def test_the_time_for_planning_is_kept_to_and_asked_for_only_where_there_is_planning() -> None:
    spent = result_of("bench", "expert", "stack", "--episodes", "1", "--planning-seconds", "0")
    assert spent["successes"] == 0 and "planning time spent" in next(iter(spent["failures"]))
    assert result_of("bench", "expert", "stack", "--episodes", "1", "--planning-seconds", "60")["successes"] == 1
    assert "expert" in refused("bench", "collect", "stack", "--planning-seconds", "5")
    assert "--plan" in refused("show", "stack", "--planning-seconds", "5")
    assert "-1.0 is not 0 or more" in refused("show", "stack", "--plan", "--planning-seconds", "-1")


def test_plans_are_checked_on_demand(tmp_path: Path) -> None:
    assert result_of("bench", "expert", "stack", "--episodes", "2", "--check")["invalid_plans"] == 0
    assert result_of("show", "stack", "--plan", "--check", "--out", str(tmp_path / "plan.png"))["picture"]
    assert result_of("collect", "stack", "--episodes", "1", "--workers", "1", "--check", "--out", str(tmp_path / "d"))["new"] == 1
    assert "--plan" in refused("show", "stack", "--check")
    assert "expert" in refused("bench", "step", "stack", "--check")
    assert "expert" in refused("bench", "step", "stack", "--where")


def test_bench_collect_render_step_and_action() -> None:
    collected = result_of("bench", "collect", "stack", "--episodes", "2", "--workers", "2")
    assert collected["demonstrations"] == 2
    assert {"planning", "physics", "rendering", "writing"} <= set(collected["cpu_seconds_per_demonstration"])
    assert result_of("bench", "render", "stack", "--episodes", "3")["frame_ms"]["agentview"]["median"] > 0
    assert result_of("bench", "step", "stack", "--episodes", "1")["step_ms"]["median"] > 0
    assert result_of("bench", "action", "stack")["action_ms"]["median"] > 0


def test_bench_of_a_preset_needs_no_task_and_no_data() -> None:
    step = result_of("bench", "step", "--preset", "quick", "--rounds", "1")
    assert {"speedup_independent", "speedup_chunked", "gradient_seconds", "update_seconds"} <= set(step)
    assert step["gradient_difference"] < 0.2
    action = result_of("bench", "action", "--preset", "quick", "--rounds", "1", "--no-compile")
    assert action["speedup"] > 1 and action["difference"] < 1e-4
    assert "leave out stack" in refused("bench", "step", "stack", "--preset", "quick")
    assert "optimus-30m" in refused("bench", "step", "--preset", "optimus-3m")
    assert "TASK" in refused("bench", "step")
    assert "bench action" in refused("bench", "render", "--preset", "quick")


def test_a_preset_with_another_head_is_trained_and_exported(tmp_path: Path) -> None:
    data, run = tmp_path / "data", tmp_path / "run"
    make_dataset(data, 4, 12)
    chosen = ("--preset", "quick-mlp", "--head", "gaussian", "--observe", "state", "--board", "none")
    result = result_of("train", str(data), "--out", str(run), "--steps", "2", *chosen)
    count = sum(array.size for array in load_file(run / "model.safetensors").values())
    assert 0 < count - result["parameters"] < 200  # besides the weights there is only the normalisation
    assert "quick-rnn" in refused("train", str(data), "--out", str(run), "--preset", "quick-lstm")
    assert "1, 2, 3, 6" in refused("train", str(data), "--out", str(run), "--batch", "6", "--consecutive", "4")
    both = refused("train", str(data), "--out", str(run), "--minutes", "1", "--epochs", "2")
    assert "--minutes and --epochs each say how long" in both
    pytest.importorskip("onnxscript", reason="needs the extra `onnx`")
    onnx = tmp_path / "new" / "policy.onnx"
    assert result_of("export-policy", str(run), "--onnx", str(onnx))["bytes"] > 4 * result["parameters"]
    for there in (onnx, run / "model.safetensors"):
        before = there.read_bytes()
        assert "exists" in refused("export-policy", str(run), "--onnx", str(there)) and there.read_bytes() == before


def test_show_writes_pictures(tmp_path: Path) -> None:
    for extra in ([], ["--plan"]):
        out = tmp_path / f"{len(extra)}.png"
        assert result_of("show", "stack", "--seed", "3", "--out", str(out), *extra)["picture"] == str(out)
        with Image.open(out) as picture:
            assert picture.size[0] > 1000


def test_the_stages_one_by_one(taught: tuple[Path, Path], tmp_path: Path) -> None:
    data, run = taught[0], tmp_path / "run"
    assert result_of("curate", str(data))["train"] >= 2
    result_of("train", str(data), "--out", str(run), "--steps", "3")
    films = tmp_path / "films"
    args = ("evaluate", str(run), "--dataset", str(data), "--episodes", "2", "--workers", "1", "--horizon", "30")
    found = result_of(*args, "--videos", str(films))
    assert found["episodes"] == 2 and len(found["interval"]) == 2
    assert len(list(films.glob("*.mp4"))) == 2
    assert "pick-place" in refused(*args, "--task", "pick-place")


def test_data_sets_come_and_go(taught: tuple[Path, Path], tmp_path: Path) -> None:
    data, file = str(taught[0]), str(tmp_path / "d.hdf5")
    assert result_of("export", "robomimic", data, "--out", file, "--no-next-obs")["states"] is True
    assert "--overwrite" in refused("export", "robomimic", data, "--out", file)
    assert "robomimic" in refused("export", "lerobot", data, "--out", str(tmp_path / "l"), "--compress")
    assert result_of("import", "robomimic", file, "--out", str(tmp_path / "back"))["task"] == "stack"
    assert result_of("export", "lerobot", str(tmp_path / "back"), "--out", str(tmp_path / "l"))["instructions"] == 1
    about = result_of("dataset", str(tmp_path / "back"), "--html", str(tmp_path / "page.html"))
    assert about["episodes"] == 4 and list(about["instructions"]) == ["put the red block on the green block"]
    assert (tmp_path / "page.html").read_text().startswith("<!DOCTYPE html>")
    assert result_of("dataset", data, "--play", "0", "--out", str(tmp_path / "0.mp4"))["frames"] > 50
    assert "it holds" in refused("dataset", data, "--play", "77")
    assert "not a dataset" in refused("dataset", str(tmp_path))
