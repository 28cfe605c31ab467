"""A run as one self-contained HTML page: no script, no link, readable from a mail attachment."""

from optimus.report.comparison import render_comparison, write_comparison
from optimus.report.data import (
    DatasetStats,
    EvaluationStats,
    ExpertStats,
    Film,
    Interval,
    ReportData,
    Starts,
)
from optimus.report.page import render, write_report

__all__ = [
    "DatasetStats",
    "EvaluationStats",
    "ExpertStats",
    "Film",
    "Interval",
    "ReportData",
    "Starts",
    "render",
    "render_comparison",
    "write_comparison",
    "write_report",
]
