"""The main job, small: every stage really runs, and a second call finds everything done."""

import json
import time
from pathlib import Path

import pytest

from optimus.errors import DatasetError
from optimus.run import RunConfig, run


def test_from_the_task_to_a_report(tmp_path: Path) -> None:
    stages: list[str] = []
    config = RunConfig("pick-place", tmp_path / "out", minutes=0.8, demonstrations=12, episodes=2, corrections=True)
    first = run(config, lambda stage, done, total, notes: stages.append(stage))
    assert list(dict.fromkeys(stages)) == ["collect", "first policy", "correct", "train", "evaluate"]
    assert first["evaluation"]["episodes"] == 2 and len(first["evaluation"]["interval"]) == 2
    page = Path(first["report"]).read_text()
    assert "<html" in page and "data:video/mp4" in page and "https://" not in page
    began = time.perf_counter()
    second = run(config)
    assert second["evaluation"] == first["evaluation"]
    assert time.perf_counter() - began < first["seconds"]["train"] + 20
    with pytest.raises(DatasetError, match="minutes"):
        run(RunConfig("pick-place", tmp_path / "out", minutes=5))
    assert json.loads((tmp_path / "out" / "run.json").read_text())["config"]["minutes"] == 0.8
