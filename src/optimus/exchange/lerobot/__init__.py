"""A data set as a LeRobotDataset v3.0."""

from optimus.exchange.lerobot.write import LerobotConfig, export_lerobot

__all__ = ["LerobotConfig", "export_lerobot"]
