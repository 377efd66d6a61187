"""Experiments in tasks: by an executor, or by processes of this machine."""

from __future__ import annotations

import collections.abc
import ctypes
import os
import pickle
import signal
import traceback
import typing
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor, as_completed
from typing import Any, Optional

PR_SET_PDEATHSIG = 1
"""Of the system's prctl(): the signal at the end of the process that started this one."""


class outcome(typing.NamedTuple):
    """The outcome of an experiment: its pickled result, or the text of its exception."""

    item: bytes
    result: Optional[bytes]
    failure: str = ""


Experiment = collections.abc.Callable[[Any], object]
"""A function of an item."""
Task = tuple[bytes, ...]
"""Pickled items of experiments that one process runs."""


def run_task(function: Experiment, task: Task) -> list[outcome]:
    """Runs experiments in this process. Each result is pickled separately, so the bytes do not depend on the split."""
    outcomes = []
    for item in task:
        try:
            outcomes.append(outcome(item, pickle.dumps(function(pickle.loads(item)), protocol=4)))
        except (Exception, SystemExit):
            outcomes.append(outcome(item, None, traceback.format_exc()))
    return outcomes


def completed_outcomes(
    function: Experiment, tasks: list[Task], executor: Executor | None
) -> collections.abc.Generator[list[outcome], None, None]:
    """The outcomes of tasks, in order of completion; by processes of this machine if there is no executor. If one of
    these dies, the tasks that may have been its own run by themselves, and a new pool goes on."""
    if executor is not None:
        yield from (_outcomes_of(task, future) for task, future in _by_executor(executor, function, tasks))
        return
    left = dict.fromkeys(tasks)
    while left:
        workers = min(len(os.sched_getaffinity(0)), len(left))
        with ProcessPoolExecutor(workers, initializer=_end_with_parent) as pool:
            for task, future in _by_executor(pool, function, list(left)):
                if not isinstance(future.exception(), BrokenExecutor):
                    del left[task]
                    yield _outcomes_of(task, future)
        for task in list(left)[: 2 * workers]:
            del left[task]
            yield from _alone(function, task)


def _by_executor(
    executor: Executor, function: Experiment, tasks: collections.abc.Iterable[Task]
) -> collections.abc.Generator[tuple[Task, Future[list[outcome]]], None, None]:
    left = {_submitted(executor, function, task): task for task in tasks}
    try:
        for future in as_completed(left):
            yield left.pop(future), future
    finally:
        for future in left:
            future.cancel()


def _submitted(executor: Executor, function: Experiment, task: Task) -> Future[list[outcome]]:
    try:
        return executor.submit(run_task, function, task)
    except Exception as error:  # it has broken
        failed: Future[list[outcome]] = Future()
        failed.set_exception(error)
        return failed


def _outcomes_of(task: Task, future: Future[list[outcome]]) -> list[outcome]:
    try:
        return future.result()
    except Exception:
        return [outcome(item, None, traceback.format_exc()) for item in task]


def _alone(function: Experiment, task: Task) -> collections.abc.Iterator[list[outcome]]:
    """A task in a process of its own. If that dies, each half has one, down to the experiment that ended
    it."""
    with ProcessPoolExecutor(1, initializer=_end_with_parent) as pool:
        ((_, future),) = _by_executor(pool, function, [task])
    if len(task) == 1 or not isinstance(future.exception(), BrokenExecutor):
        yield _outcomes_of(task, future)
    else:
        half = len(task) // 2
        yield from _alone(function, task[:half])
        yield from _alone(function, task[half:])


def _end_with_parent() -> None:
    """Ends this process at Ctrl-C without a traceback, and at the end of the process that started it."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
