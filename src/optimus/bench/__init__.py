"""Measurements anyone can repeat: CPU time, medians and percentiles."""

from optimus.bench.config import BenchConfig
from optimus.bench.expert import bench_expert
from optimus.bench.read import bench_read
from optimus.bench.stages import bench_action, bench_collect, bench_render, bench_step

BENCHES = {
    "expert": bench_expert,
    "collect": bench_collect,
    "read": bench_read,
    "step": bench_step,
    "action": bench_action,
    "render": bench_render,
}

__all__ = ["BENCHES", "BenchConfig"]
