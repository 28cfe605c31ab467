"""A run as one self-contained HTML page: no script, no link, readable from a mail attachment."""

from optimus.report.data import (
    DatasetStats,
    EvaluationStats,
    ExpertStats,
    Film,
    Interval,
    ReportData,
)
from optimus.report.page import render, write_report

__all__ = [
    "DatasetStats",
    "EvaluationStats",
    "ExpertStats",
    "Film",
    "Interval",
    "ReportData",
    "render",
    "write_report",
]
