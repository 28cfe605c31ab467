"""Fixtures that several tests share."""

from pathlib import Path

import pytest
from hypothesis import settings

from optimus.collect import CollectConfig, collect
from optimus.data.curate import curate
from optimus.learn.train import TrainConfig, train
from optimus.tasks import TASKS

settings.register_profile("shared machine", deadline=None)  # how long a case takes says how busy the machine is
settings.load_profile("shared machine")

SOLVED = list(TASKS)
"""Tasks that the expert is held to; of the shelf tasks a few starts in a hundred have no plan (the README says which)."""


@pytest.fixture(scope="session")
def taught(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """A small dataset of stack, and a policy that has hardly looked at it."""
    folder = tmp_path_factory.mktemp("taught")
    collect(CollectConfig("stack", folder / "data", 4, workers=1))
    curate(folder / "data")
    train(folder / "data", folder / "policy", TrainConfig(steps=3))
    return folder / "data", folder / "policy"
