"""Processes that share out many independent episodes."""

from __future__ import annotations

import multiprocessing
import os
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, Future, ProcessPoolExecutor, as_completed
from typing import Any, TypeVar

T = TypeVar("T")


class _Inline(Executor):
    """Runs each job at once in this process."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as error:  # noqa: BLE001 - handed on through the future, as every executor does
            future.set_exception(error)
        return future


def _end_with_parent() -> None:
    """Leave no orphan behind when the parent is killed: it cannot say goodbye, so a thread watches for its end."""
    parent = multiprocessing.parent_process()

    def watch() -> None:
        if parent is not None:
            parent.join()
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


def executor(workers: int) -> Executor:
    """An executor of that many processes; with one worker, this process does the work itself.

    Processes are spawned, not forked: a GL context and a thread pool do not survive a fork.
    """
    if workers <= 1:
        return _Inline()
    context = multiprocessing.get_context("spawn")
    return ProcessPoolExecutor(workers, mp_context=context, initializer=_end_with_parent)


def finished(jobs: Sequence[Callable[[], T]], workers: int) -> Iterator[tuple[int, T]]:
    """Run every job, and give its number and its answer as soon as it has ended. `workers` processes (0: one a core) share them
    out, never more than there are jobs."""
    with executor(min(workers or available_cores(), len(jobs))) as pool:
        if isinstance(pool, _Inline):
            yield from ((i, job()) for i, job in enumerate(jobs))
            return
        numbers = {pool.submit(job): i for i, job in enumerate(jobs)}
        try:
            for future in as_completed(numbers):
                yield numbers[future], future.result()
        finally:
            pool.shutdown(wait=True, cancel_futures=True)


def available_cores() -> int:
    """Processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
