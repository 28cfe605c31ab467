"""The evaluation protocol: a list of initial states, one episode each, k of n with an honest interval."""

from optimus.evaluate.actors import environment, policy_folder, require_same_problems, task_of, trained_robot
from optimus.evaluate.outcome import EvalReport, Outcome, how_said, states_label
from optimus.evaluate.start import RANDOM_SEEDS_FROM, Start, random_starts, validation_starts
from optimus.evaluate.trials import evaluate, play

__all__ = [
    "RANDOM_SEEDS_FROM",
    "EvalReport",
    "Outcome",
    "Start",
    "environment",
    "evaluate",
    "how_said",
    "play",
    "policy_folder",
    "random_starts",
    "require_same_problems",
    "states_label",
    "task_of",
    "trained_robot",
    "validation_starts",
]
