"""OPTIMUS: from the description of a manipulation task to a trained visuomotor policy, with no human demonstrator."""

__version__ = "0.1.0"
