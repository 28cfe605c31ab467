"""Everything that the next training step depends on, and its file.

`train_state/<step>.safetensors` holds weights, running average and optimiser moments, with step and plan in its header: one
file, renamed into place, so that a run killed at any moment has a whole one.
"""

from __future__ import annotations

import copy
import json
import re
from dataclasses import asdict
from pathlib import Path

import torch
from safetensors import safe_open
from safetensors.torch import save as serialise
from torch import Tensor

from optimus.data.atomic import make_folder, remove_leftovers, write_whole
from optimus.errors import CheckpointError, TrainingError
from optimus.learn.checkpoint import contiguous, load_weights, read_tensors
from optimus.learn.policy import Policy
from optimus.learn.schedule import StepPlan

_NAME = re.compile(r"(\d{8,})\.safetensors")
_FORMAT = "optimus-train-state"
