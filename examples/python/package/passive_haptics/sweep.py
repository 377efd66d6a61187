"""Sweeps: an experiment for many items, on processes of this machine or any executor of
concurrent.futures."""

from __future__ import annotations

import collections.abc
import errno
import numbers
import operator
import os
import pickle
import sqlite3
import sys
import time
from concurrent.futures import Executor
from contextlib import closing, contextmanager
from typing import Any, TypeVar

from passive_haptics.arrays import Path
from passive_haptics.tasks import Experiment, completed_outcomes, run_task
from passive_haptics.values import expect

Result = TypeVar("Result")
AFTER = 2.0
"""A call that takes longer shows its progress [s]."""
BETWEEN = 0.2
"""Between two updates [s]."""


class sweep_error(RuntimeError):
    """Some experiments failed. The others succeeded and need not run again."""

    def __init__(self, message: str, results: dict[Any, Any], failures: dict[Any, str]) -> None:
        super().__init__(message, results, failures)
        self.results = results
        """Item to result, of the experiments that did not fail; of an item without a hash its number."""
        self.failures = failures
        """Item to the text of its exception, in the order of the items."""

    def __str__(self) -> str:
        return str(self.args[0])


def sweep(
    function: collections.abc.Callable[[Any], Result],
    items: collections.abc.Iterable[Any],
    executor: Executor | None = None,
    *,
    experiments_per_task: int = 100,
    file: Path | None = None,
    progress: bool | None = None,
) -> list[Result]:
    """Returns the results function(item) in the order of the items, byte for byte equal for every executor and split.

    Parameters
    ----------
    function
        A function of an item only. It and its results can be pickled.
    items
        Distinct integers, such as seeds, or other values that can be pickled, such as tuples of parameters.
    executor : concurrent.futures.Executor
        Such as dask.distributed.Client(...).get_executor() or mpi4py.futures.MPIPoolExecutor(); None: a
        process for each processor that this one may use.
    experiments_per_task : int
        Use 1 for experiments that take over 10 s, more than 100 for those under 1 ms.
    file
        A database of SQLite with the results of finished tasks. A sweep with this file, after an interruption
        or with more items, runs one experiment of the file again, and then what is missing. Reading it can
        run code (pickle): trust its source.
    progress : bool
        None: shown if stderr is a terminal and the sweep takes over 2 s.

    Raises
    ------
    sweep_error
        Once all experiments have run, if some failed. A process that dies is a failure of the one experiment
        that ended it; under an executor of your own, of all experiments that this executor lost.
    ValueError
        If items are not distinct, the function now returns another result than in the file, or the file is of
        another kind.
    BlockingIOError
        If another sweep uses the file.
    """
    order = _distinct(items)
    expect(executor, (Executor, type(None)), "executor", "an Executor of concurrent.futures")
    if experiments_per_task < 1:
        raise ValueError(f"passive_haptics: experiments_per_task = {experiments_per_task}: expected 1 or more")
    failures: dict[bytes, str] = {}
    with _results_in(file) as stored:
        known = dict(stored.execute("SELECT item, result FROM results"))
        _require_unchanged(function, next((item for item in order if item in known), None), known, file)
        before = len(known)
        missing = [item for item in order if item not in known]
        starts = range(0, len(missing), experiments_per_task)
        tasks = [tuple(missing[i : i + experiments_per_task]) for i in starts]
        completed = completed_outcomes(function, tasks, executor)
        with closing(completed), _progress_line(len(missing), progress) as shown:
            for outcomes in completed:
                new = {of.item: of.result for of in outcomes if of.result is not None}
                with stored:
                    stored.executemany("INSERT INTO results VALUES (?, ?)", new.items())
                known.update(new)
                failures.update({of.item: of.failure for of in outcomes if of.result is None})
                shown(len(known) + len(failures) - before)
    if failures:
        raise _error_of(order, known, failures)
    return [pickle.loads(known[item]) for item in order]


def _distinct(items: collections.abc.Iterable[Any]) -> list[bytes]:
    """The items, pickled; integers of all types alike."""
    order: dict[bytes, None] = {}
    for item in items:
        try:
            pickled = pickle.dumps(operator.index(item) if isinstance(item, numbers.Integral) else item, protocol=4)
        except Exception as error:
            raise TypeError(f"passive_haptics: item = {item!r}: expected one that can be pickled: {error}") from None
        if pickled in order:
            raise ValueError(f"passive_haptics: item {item!r} is given twice: expected distinct items")
        order[pickled] = None
    return list(order)


@contextmanager
def _results_in(file: Path | None) -> collections.abc.Iterator[sqlite3.Connection]:
    """The table of results in a file, or in memory: locked for all others until the end."""
    name = ":memory:" if file is None else os.fspath(file)
    with closing(sqlite3.connect(name, timeout=0)) as results:
        try:
            results.execute("PRAGMA locking_mode = EXCLUSIVE")
            results.execute("BEGIN EXCLUSIVE")
            results.execute("CREATE TABLE IF NOT EXISTS results (item BLOB PRIMARY KEY, result BLOB)")
            results.commit()
        except sqlite3.OperationalError as error:
            if "locked" not in str(error):
                raise
            text = f"passive_haptics: file = {name} is in use: expected one that no other sweep writes"
            raise BlockingIOError(errno.EAGAIN, text) from None
        except sqlite3.DatabaseError as error:
            raise ValueError(f"passive_haptics: file = {name}: {error}: expected a new file or one of a sweep") from None
        yield results


@contextmanager
def _progress_line(total: int, wanted: bool | None) -> collections.abc.Iterator[collections.abc.Callable[[int], None]]:
    """A function that shows the number of finished experiments on stderr, with the time that the others will take."""
    is_wanted = sys.stderr.isatty() if wanted is None else wanted
    start, latest, width = time.monotonic(), 0.0, 0

    def reach(done: int) -> None:
        nonlocal latest, width
        now = time.monotonic()
        if not is_wanted or now - start < AFTER or (now - latest < BETWEEN and done < total):
            return
        text = f"{done} of {total} experiments"
        if done:
            text += f", {(now - start) * (total - done) / done:.0f} s left"
        print("\r" + text.ljust(width), end="", file=sys.stderr, flush=True)
        latest, width = now, len(text)

    try:
        yield reach
    finally:
        if width:
            print(file=sys.stderr)


def _require_unchanged(
    function: Experiment, item: bytes | None, known: dict[bytes, bytes], file: Path | None
) -> None:
    """Throws ValueError if the function now has another result of this item than the file."""
    if item is None:
        return
    ((_, result, failure),) = run_task(function, (item,))
    if result != known[item]:
        now = f"fails now:\n{failure}" if failure else "has another result now"
        raise ValueError(
            f"passive_haptics: file = {file}: the experiment of item {pickle.loads(item)!r} {now}. The function "
            "has changed, or depends on more than its item. Name a new file, or remove this one."
        )


def _error_of(order: list[bytes], known: dict[bytes, bytes], failures: dict[bytes, str]) -> sweep_error:
    def name(number: int) -> Any:
        item = pickle.loads(order[number])
        try:
            hash(item)
        except TypeError:
            return number
        return item

    failed = [number for number, item in enumerate(order) if item in failures]
    last_line = failures[order[failed[0]]].strip().splitlines()[-1]
    message = (
        f"passive_haptics: {len(failed)} of {len(order)} experiments failed, the first of them with item "
        f"{pickle.loads(order[failed[0]])!r}: {last_line}. See failures of this exception, and results for "
        "those of the others."
    )
    results = {name(number): pickle.loads(known[item]) for number, item in enumerate(order) if item in known}
    return sweep_error(message, results, {name(number): failures[order[number]] for number in failed})
