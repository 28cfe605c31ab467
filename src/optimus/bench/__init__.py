"""Measurements anyone can repeat: CPU time, medians and percentiles."""

from optimus.bench.config import BenchConfig
from optimus.bench.expert import bench_expert
from optimus.bench.stages import bench_action, bench_collect, bench_render, bench_step

BENCHES = {
    "expert": bench_expert,
    "collect": bench_collect,
    "step": bench_step,
    "action": bench_action,
    "render": bench_render,
}

__all__ = ["BENCHES", "BenchConfig"]
