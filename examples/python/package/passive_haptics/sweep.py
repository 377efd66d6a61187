"""Many experiments, each a function of its seed: over the processors of a machine, or over a cluster.

    from passive_haptics.sweep import sweep
    results = sweep(experiment, range(10_000), file="results.sweep")
"""

from __future__ import annotations

import itertools
import operator
import os
import pickle
import queue
import signal
import sys
import threading
import time
import traceback
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor
from contextlib import ExitStack, closing, contextmanager
from typing import Any, NamedTuple, Optional, TypeVar, Union

from passive_haptics.record_file import Path, record_file

PROGRESS_AFTER = 2.0
"""A sweep that takes longer shows its progress [s]."""
PROGRESS_PERIOD = 0.25
"""Between two updates of the progress [s]."""
PARENT_PERIOD = 1.0
"""How often a process of the pool looks for the one that started it [s]."""

Result = TypeVar("Result")


class sweep_error(RuntimeError):
    """Some experiments failed. The others did not, and need not be run again."""

    def __init__(self, message: str, results: dict[int, Any], failures: dict[int, str]) -> None:
        super().__init__(message, results, failures)
        self.results = results
        """Seed to result, of the experiments that did not fail."""
        self.failures = failures
        """Seed to the text of its exception, in the order of the seeds."""

    def __str__(self) -> str:
        return str(self.args[0])


class _outcome(NamedTuple):
    """What became of an experiment: its pickled result, or the text of its exception."""

    seed: int
    result: Optional[bytes]
    failure: str = ""


_Task = Sequence[int]  # the seeds of experiments that one process runs
_Completed = tuple[_Task, Union[list[_outcome], BaseException]]


def sweep(
    function: Callable[[int], Result],
    seeds: Iterable[int],
    executor: Executor | None = None,
    *,
    experiments_per_task: int = 100,
    file: Path | None = None,
    progress: bool | None = None,
) -> list[Result]:
    """The results function(seed) in the order of the seeds, the same bytes for every executor and every split.

    function: takes an integer seed, and must depend on nothing else. It and its results can be pickled. An experiment
    that takes longer than some 10 s deserves a task of its own, one under 1 ms more than 100 a task.
    seeds: distinct integers.
    executor: any of concurrent.futures, for instance dask.distributed.Client(...).get_executor() or
    mpi4py.futures.MPIPoolExecutor(). None: a process for each processor that this one may use.
    file: keeps the results of finished tasks. After an interruption, or with more seeds, a sweep with this file
    runs what is missing. Before that it runs one experiment of the file again, and throws ValueError if that result is
    now another: the function has changed. Reading a file runs what it says (pickle): trust its source.
    progress: None: shown where stderr is a terminal and the sweep takes over 2 s.

    Throws sweep_error once all experiments have run, if some of them failed: it names their seeds and holds the
    results of the others. A process that dies is a failure of the one experiment that ended it, under an executor of
    one's own of all experiments that this executor lost. Throws ValueError or TypeError for seeds that are not as above.
    """
    order = _distinct(seeds)
    if experiments_per_task < 1:
        raise ValueError(f"passive_haptics: experiments_per_task = {experiments_per_task}, expected 1 or more")
    known: dict[int, bytes] = {}
    failures: dict[int, str] = {}
    with ExitStack() as stack:
        store = stack.enter_context(record_file(file)) if file is not None else None
        if store is not None:
            for record in store.records:
                known.update(pickle.loads(record))
            _require_unchanged(function, [seed for seed in order if seed in known][:1], known, executor, file)
        missing = [seed for seed in order if seed not in known]
        tasks = [missing[i : i + experiments_per_task] for i in range(0, len(missing), experiments_per_task)]
        shown = _progress(len(missing), sys.stderr.isatty() if progress is None else progress)
        with closing(_completed(function, tasks, executor, shown)) as completed, closing(shown):
            for outcomes in completed:
                new = {outcome.seed: outcome.result for outcome in outcomes if outcome.result is not None}
                if store is not None and new:
                    store.append(pickle.dumps(new))
                known.update(new)
                failures.update({outcome.seed: outcome.failure for outcome in outcomes if outcome.result is None})
    if failures:
        raise _error_of(order, known, failures)
    return [pickle.loads(known[seed]) for seed in order]


def _distinct(seeds: Iterable[int]) -> list[int]:
    """The seeds as integers of Python; throws TypeError and ValueError."""
    order: list[int] = []
    for seed in seeds:
        try:
            order.append(operator.index(seed))
        except TypeError:
            raise TypeError(f"passive_haptics: seed = {seed!r}, expected an integer") from None
    found: set[int] = set()
    for seed in order:
        if seed in found:
            raise ValueError(f"passive_haptics: seed {seed} is given twice, expected distinct seeds")
        found.add(seed)
    return order


def _require_unchanged(
    function: Callable[[int], object],
    seeds: list[int],
    known: dict[int, bytes],
    executor: Executor | None,
    file: Path | None,
) -> None:
    """Throws ValueError if the function now has other results at these seeds than the file."""
    for outcomes in _completed(function, [seeds] if seeds else [], executor, _progress(len(seeds), False)):
        for seed, result, failure in outcomes:
            if result != known[seed]:
                now = f"fails now:\n{failure}" if failure else "has another result now"
                text = f"passive_haptics: file = {file}: the experiment of seed {seed} {now}"
                raise ValueError(f"{text}. The file is of another function: name a new file, or remove this one.")


def _error_of(order: list[int], known: dict[int, bytes], failures: dict[int, str]) -> sweep_error:
    failed = {seed: failures[seed] for seed in order if seed in failures}
    first = next(iter(failed))
    last_line = failed[first].strip().splitlines()[-1]
    message = (
        f"passive_haptics: {len(failed)} of {len(order)} experiments failed, the first of them with seed {first}: "
        f"{last_line}. See failures of this exception, and results for those of the others."
    )
    return sweep_error(message, {seed: pickle.loads(known[seed]) for seed in order if seed in known}, failed)


def _run_task(function: Callable[[int], object], seeds: _Task) -> list[_outcome]:
    """Runs experiments in this process. Each result is pickled by itself, so that no split shows in its bytes."""
    outcomes = []
    for seed in seeds:
        try:
            outcomes.append(_outcome(seed, pickle.dumps(function(seed), protocol=4)))
        except (Exception, SystemExit):
            outcomes.append(_outcome(seed, None, traceback.format_exc()))
    return outcomes


def _completed(
    function: Callable[[int], object], tasks: list[list[int]], executor: Executor | None, shown: _progress
) -> Generator[list[_outcome], None, None]:
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
                outcomes = [_outcome(seed, None, text) for seed in task]
            shown.add(len(outcomes))
            yield outcomes


def _by_executor(
    executor: Executor,
    function: Callable[[int], object],
    tasks: Iterator[_Task],
    at_once: int | None,
    shown: _progress,
) -> Generator[_Completed, None, None]:
    """Tasks by an executor, this number of them at once, or all. If it breaks, the tasks that have not begun are left."""
    running: dict[Future[list[_outcome]], _Task] = {}
    completed: queue.SimpleQueue[Future[list[_outcome]]] = queue.SimpleQueue()

    def start(count: int | None) -> None:
        for task in itertools.islice(tasks, count):
            try:
                future = executor.submit(_run_task, function, task)
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
    function: Callable[[int], object], tasks: list[list[int]], shown: _progress
) -> Generator[_Completed, None, None]:
    """Tasks by processes of this machine. If one of them dies, a new pool goes on, and the tasks that were lost run by
    themselves."""
    workers = min(len(os.sched_getaffinity(0)), len(tasks))
    left: Iterator[_Task] = iter(tasks)
    lost: list[_Task] = []
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


def _alone(function: Callable[[int], object], task: _Task, shown: _progress) -> Iterator[_Completed]:
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
def _pool(workers: int) -> Iterator[ProcessPoolExecutor]:
    """Processes that end with this one."""
    pool = ProcessPoolExecutor(workers, initializer=_follow, initargs=(os.getpid(),))
    try:
        yield pool
    except BaseException:
        pool.shutdown(wait=False, cancel_futures=True)
        raise
    pool.shutdown()


def _follow(parent: int) -> None:
    """Ends this process without a word at Ctrl-C, and soon after its parent has gone, even if that was killed."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)

    def watch() -> None:
        while os.getppid() == parent:
            time.sleep(PARENT_PERIOD)
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


class _progress:
    """A line on stderr that says how far a sweep is."""

    def __init__(self, total: int, wanted: bool) -> None:
        self._total, self._wanted, self._done = total, wanted, 0
        self._start = time.monotonic()
        self._width = 0

    def add(self, count: int) -> None:
        """So many experiments more are completed."""
        self._done += count
        self.show()

    def show(self) -> None:
        """Prints the line where it is wanted and the sweep takes long enough."""
        passed = time.monotonic() - self._start
        if not self._wanted or passed < PROGRESS_AFTER:
            return
        text = f"{self._done} of {self._total} experiments"
        if self._done:
            text += f", {passed * (self._total - self._done) / self._done:.0f} s left"
        print("\r" + text.ljust(self._width), end="", file=sys.stderr, flush=True)
        self._width = len(text)

    def close(self) -> None:
        """Ends the line."""
        if self._width:
            print(file=sys.stderr)
