"""Processes that share out many independent jobs: of this machine, or of a Ray cluster."""

from __future__ import annotations

import math
import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor, as_completed
from functools import partial
from typing import Any, TypeVar

from optimus.errors import OptimusError, UnknownNameError, WorkerError, require_at_least

T = TypeVar("T")

BACKENDS = ("local", "ray")
RAY_RETRIES = 3
"""Times that Ray gives a job to another process when the one at work was killed."""


class _Inline(Executor):
    """Runs each job at once in this process."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as error:  # noqa: BLE001 - handed on through the future, as every executor does
            future.set_exception(error)
        return future


class _Ray(Executor):
    """Hands each job to Ray: to the cluster that `RAY_ADDRESS` names, else to a Ray of this machine that ends with the executor.
    Every job takes one core."""

    def __init__(self, workers: int) -> None:
        try:
            import ray  # pyright: ignore[reportMissingImports] - an optional extra
        except ImportError as error:
            raise WorkerError("the backend ray needs Ray, which is not installed; pip install 'optimus-tamp[cluster]'") from error
        self._ray: Any = ray
        self._own = not ray.is_initialized()
        where: dict[str, Any] = {} if os.environ.get("RAY_ADDRESS") else {"num_cpus": workers, "include_dashboard": False}
        try:
            if self._own:
                ray.init(log_to_driver=False, logging_level="ERROR", **where)
        except (ConnectionError, RuntimeError, ValueError) as error:
            raise WorkerError(f"Ray cannot be started or reached: {error}; see RAY_ADDRESS, or take the backend local") from error
        self._run = ray.remote(num_cpus=1, max_retries=RAY_RETRIES)(_answer)
        self._asked: dict[Future[Any], Any] = {}

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        reference = self._run.remote(partial(fn, *args, **kwargs))
        self._asked[future] = reference
        reference.future().add_done_callback(partial(self._settle, future))
        return future

    def _settle(self, future: Future[Any], from_ray: Future[Any]) -> None:
        self._asked.pop(future, None)
        if from_ray.cancelled() or not future.set_running_or_notify_cancel():
            future.cancel()
            return
        error = from_ray.exception()
        if isinstance(error, (self._ray.exceptions.WorkerCrashedError, self._ray.exceptions.NodeDiedError)):
            future.set_exception(BrokenExecutor(str(error)))
        elif error is not None:
            future.set_exception(error)
        else:
            answer, named = from_ray.result()
            future.set_result(answer) if named is None else future.set_exception(named)

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        if cancel_futures:
            for future, reference in list(self._asked.items()):
                if future.cancel():
                    self._ray.cancel(reference)
        if self._own and self._ray.is_initialized():
            self._ray.shutdown()


def _answer(job: Callable[[], T]) -> tuple[T | None, OptimusError | None]:
    """What `job` gives, or the named error that it ends with: Ray would hand that on as a type of its own."""
    try:
        return job(), None
    except OptimusError as error:
        return None, error


def _begin_worker() -> None:
    """Leave Ctrl-C to the parent, and no orphan behind when that is killed: it cannot say goodbye, so a thread watches for its
    end."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()

    def watch() -> None:
        if parent is not None:
            parent.join()
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


def require_backend(backend: str) -> str:
    """`backend` as it is; `UnknownNameError` if there is none of that name."""
    if backend not in BACKENDS:
        raise UnknownNameError("backend", backend, BACKENDS)
    return backend


def executor(workers: int, backend: str = "local") -> Executor:
    """An executor of that many processes; with one worker, this process does the work itself unless Ray is asked for.

    Processes are spawned, not forked: a GL context and a thread pool do not survive a fork. When one is killed, the futures of its
    jobs end with `BrokenExecutor`, and those of the others may.
    """
    require_at_least(0, workers=workers)
    if require_backend(backend) == "ray":
        return _Ray(workers)
    if workers <= 1:
        return _Inline()
    context = multiprocessing.get_context("spawn")
    return ProcessPoolExecutor(workers, mp_context=context, initializer=_begin_worker)


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
        except BrokenExecutor as error:
            raise WorkerError("a worker process was killed, perhaps for want of memory; try again with fewer --workers") from error
        finally:
            pool.shutdown(wait=True, cancel_futures=True)


def each_apart(jobs: Sequence[Callable[[], T]], workers: int, seconds: float = math.inf) -> Iterator[T | Exception]:
    """The answers of jobs in their order, `workers` at a time (0: one a core), each in a process of its own: where a library
    crashes its process, or takes more than `seconds` of CPU, that job alone ends, with `BrokenExecutor`. An `OptimusError` is given
    back as well, not raised."""
    with ThreadPoolExecutor(min(workers or available_cores(), max(len(jobs), 1))) as threads:
        for future in [threads.submit(_alone, job, seconds) for job in jobs]:
            yield future.result()


def _alone(job: Callable[[], T], seconds: float) -> T | Exception:
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn"), initializer=_begin_worker) as pool:
        try:
            return pool.submit(_limited, job, seconds).result()
        except (OptimusError, BrokenExecutor) as error:
            return error


def _limited(job: Callable[[], T], seconds: float) -> T:
    """`job()`, in a process that ends when it has used so much CPU: native code minds no exception."""
    if math.isfinite(seconds):
        signal.setitimer(signal.ITIMER_PROF, seconds)
    return job()


def available_cores() -> int:
    """Processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
