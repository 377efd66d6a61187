"""Experiments in tasks: by an executor, or by processes of this machine."""

from __future__ import annotations

import collections.abc
import itertools
import multiprocessing
import os
import pickle
import queue
import signal
import threading
import time
import traceback
import typing
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor
from contextlib import closing, contextmanager
from typing import Any, Optional, Union

from passive_haptics.progress import progress_line

PROGRESS_PERIOD = 0.25
"""Between two updates of the progress [s]."""
PARENT_PERIOD = 1.0
"""How often a process of the pool looks for the one that started it [s]."""


class outcome(typing.NamedTuple):
    """What became of an experiment: its pickled result, or the text of its exception."""

    seed: Union[int, bytes]
    result: Optional[bytes]
    failure: str = ""


Experiment = collections.abc.Callable[[Any], object]
"""A function of a seed."""
Task = collections.abc.Sequence[Union[int, bytes]]
"""The seeds of experiments that one process runs."""
_Completed = tuple[Task, Union[list[outcome], BaseException]]


def run_task(function: Experiment, seeds: Task) -> list[outcome]:
    """Runs experiments in this process. Each result is pickled by itself, so that no split shows in its
    bytes."""
    outcomes = []
    for seed in seeds:
        try:
            outcomes.append(outcome(seed, pickle.dumps(function(seed), protocol=4)))
        except (Exception, SystemExit):
            outcomes.append(outcome(seed, None, traceback.format_exc()))
    return outcomes


def completed_outcomes(
    function: Experiment, tasks: list[list[Union[int, bytes]]], executor: Executor | None, shown: progress_line
) -> collections.abc.Generator[list[outcome], None, None]:
    """The outcomes of tasks, as they are completed."""
    completed = (
        _by_processes(function, tasks, shown)
        if executor is None
        else _by_executor(executor, function, iter(tasks), None, shown)
    )
    with closing(completed):
        for task, outcomes in completed:
            if isinstance(outcomes, BaseException):
                text = "".join(traceback.format_exception(type(outcomes), outcomes, outcomes.__traceback__))
                outcomes = [outcome(seed, None, text) for seed in task]
            shown.add(len(outcomes))
            yield outcomes


def _by_executor(
    executor: Executor,
    function: Experiment,
    tasks: collections.abc.Iterator[Task],
    at_once: int | None,
    shown: progress_line,
) -> collections.abc.Generator[_Completed, None, None]:
    """Tasks by an executor, this number of them at once, or all. If it breaks, the tasks that have not begun
    are left."""
    running: dict[Future[list[outcome]], Task] = {}
    completed: queue.SimpleQueue[Future[list[outcome]]] = queue.SimpleQueue()

    def start(count: int | None) -> None:
        for task in itertools.islice(tasks, count):
            try:
                future = executor.submit(run_task, function, task)
            except Exception as error:
                future = Future()
                future.set_exception(error)
            running[future] = task
            future.add_done_callback(completed.put)

    try:
        start(at_once)
        broken = False
        while running:
            try:
                future = completed.get(timeout=PROGRESS_PERIOD)
            except queue.Empty:
                shown.show()
                continue
            task = running.pop(future)
            error = RuntimeError("the task was cancelled") if future.cancelled() else future.exception()
            broken = broken or isinstance(error, BrokenExecutor)
            yield task, future.result() if error is None else error
            if at_once is not None and not broken:
                start(1)
    finally:
        for future in running:
            future.cancel()


def _by_processes(
    function: Experiment, tasks: list[list[Union[int, bytes]]], shown: progress_line
) -> collections.abc.Generator[_Completed, None, None]:
    """Tasks by processes of this machine. If one of them dies, a new pool goes on, and the tasks that were
    lost run by themselves."""
    workers = min(len(os.sched_getaffinity(0)), len(tasks))
    left: collections.abc.Iterator[Task] = iter(tasks)
    lost: list[Task] = []
    while workers > 0:
        with _pool(workers) as pool:
            for task, outcomes in _by_executor(pool, function, left, 2 * workers, shown):
                if isinstance(outcomes, BrokenExecutor):
                    lost.append(task)
                else:
                    yield task, outcomes
        if not lost:
            return
        while lost:
            yield from _alone(function, lost.pop(), shown)


def _alone(function: Experiment, task: Task, shown: progress_line) -> collections.abc.Iterator[_Completed]:
    """A task in a process of its own. If that dies, each half has one, down to the experiment that ends it."""
    with _pool(1) as pool:
        for _, outcomes in _by_executor(pool, function, iter([task]), 1, shown):
            if not isinstance(outcomes, BrokenExecutor) or len(task) == 1:
                yield task, outcomes
                return
    half = len(task) // 2
    yield from _alone(function, task[:half], shown)
    yield from _alone(function, task[half:], shown)


@contextmanager
def _pool(workers: int) -> collections.abc.Iterator[ProcessPoolExecutor]:
    """Processes that end with this one."""
    pool = ProcessPoolExecutor(workers, initializer=_follow)
    try:
        yield pool
    except BaseException:
        pool.shutdown(wait=False, cancel_futures=True)
        raise
    pool.shutdown()


def _follow() -> None:
    """Ends this process without a word at Ctrl-C, and soon after its parent has gone, even if that was
    killed."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    starter, parent = os.getppid(), multiprocessing.parent_process()

    def watch() -> None:
        while os.getppid() == starter and (parent is None or parent.is_alive()):
            time.sleep(PARENT_PERIOD)
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()
