"""Many experiments, each a function of its seed, or of another item: over the processors of a machine, or over a cluster.

    from passive_haptics.sweep import sweep
    results = sweep(experiment, range(10_000), file="results.sweep")
"""

from __future__ import annotations

import collections.abc
import functools
import operator
import pickle
from concurrent.futures import Executor
from contextlib import ExitStack, closing
from typing import Any, TypeVar, Union

from passive_haptics.progress import progress_line
from passive_haptics.record_file import Path, record_file
from passive_haptics.tasks import Experiment, completed_outcomes

Result = TypeVar("Result")
Key = Union[int, bytes]
"""An integer, or another item pickled."""


class sweep_error(RuntimeError):
    """Some experiments failed. The others did not, and need not be run again."""

    def __init__(self, message: str, results: dict[Any, Any], failures: dict[Any, str]) -> None:
        super().__init__(message, results, failures)
        self.results = results
        """Seed to result, of the experiments that did not fail; of another item that item, or its number if it has no
        hash."""
        self.failures = failures
        """Seed to the text of its exception, in the order of the seeds."""

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
    """The results function(item) in the order of the items, the same bytes for every executor and every
    split.

    function: takes an item, and must depend on nothing else. It and its results can be pickled. An
    experiment that takes longer than some 10 s deserves a task of its own, one under 1 ms more than 100 a
    task.
    items: distinct integers, such as seeds, or other values that can be pickled, such as tuples of parameters.
    executor: any of concurrent.futures, for instance dask.distributed.Client(...).get_executor() or
    mpi4py.futures.MPIPoolExecutor(). None: a process for each processor that this one may use.
    file: keeps the results of finished tasks. After an interruption, or with more items, a sweep with this
    file runs what is missing. Before that it runs one experiment of the file again, and throws ValueError if
    that result is now another: the function has changed. Reading a file runs what it says (pickle): trust its
    source.
    progress: None: shown where stderr is a terminal and the sweep takes over 2 s.

    Throws sweep_error once all experiments have run, if some of them failed: it names their items and holds
    the results of the others. A process that dies is a failure of the one experiment that ended it, under an
    executor of one's own of all experiments that this executor lost. Throws ValueError or TypeError for items
    that are not as above.
    """
    order = _distinct(items)
    of_key = functools.partial(_run, function)
    if experiments_per_task < 1:
        raise ValueError(f"passive_haptics: experiments_per_task = {experiments_per_task}, expected 1 or more")
    known: dict[Key, bytes] = {}
    failures: dict[Key, str] = {}
    with ExitStack() as stack:
        store = stack.enter_context(record_file(file)) if file is not None else None
        if store is not None:
            for record in store.records:
                known.update(pickle.loads(record))
            _require_unchanged(of_key, [key for key in order if key in known][:1], known, executor, file)
        missing = [key for key in order if key not in known]
        tasks = [missing[i : i + experiments_per_task] for i in range(0, len(missing), experiments_per_task)]
        shown = progress_line(len(missing), "experiments", progress)
        with closing(completed_outcomes(of_key, tasks, executor, shown)) as completed, closing(shown):
            for outcomes in completed:
                new = {outcome.seed: outcome.result for outcome in outcomes if outcome.result is not None}
                if store is not None and new:
                    store.append(pickle.dumps(new))
                known.update(new)
                failures.update({outcome.seed: outcome.failure for outcome in outcomes if outcome.result is None})
    if failures:
        raise _error_of(order, known, failures)
    return [pickle.loads(known[key]) for key in order]


def _distinct(items: collections.abc.Iterable[Any]) -> list[Key]:
    """The keys of the items; throws TypeError and ValueError."""
    order: dict[Key, None] = {}
    for item in items:
        key: Key
        try:
            key = operator.index(item)
        except TypeError:
            try:
                key = pickle.dumps(item, protocol=4)
            except Exception as error:
                raise TypeError(f"passive_haptics: item = {item!r}, expected one that can be pickled: {error}") from None
        if key in order:
            raise ValueError(f"passive_haptics: {_text(key)} is given twice, expected distinct items")
        order[key] = None
    return list(order)


def _item(key: Key) -> Any:
    return pickle.loads(key) if isinstance(key, bytes) else key


def _text(key: Key) -> str:
    return f"item {_item(key)!r}" if isinstance(key, bytes) else f"seed {key}"


def _run(function: collections.abc.Callable[[Any], Any], key: Key) -> Any:
    """The experiment of a key, in the process that runs it."""
    return function(_item(key))


def _require_unchanged(
    function: Experiment,
    keys: list[Key],
    known: dict[Key, bytes],
    executor: Executor | None,
    file: Path | None,
) -> None:
    """Throws ValueError if the function now has other results at these keys than the file."""
    shown = progress_line(len(keys), "experiments", wanted=False)
    for outcomes in completed_outcomes(function, [keys] if keys else [], executor, shown):
        for key, result, failure in outcomes:
            if result != known[key]:
                now = f"fails now:\n{failure}" if failure else "has another result now"
                raise ValueError(
                    f"passive_haptics: file = {file}: the experiment of {_text(key)} {now}. The function has changed, "
                    "or depends on more than its item. Name a new file, or remove this one."
                )


def _error_of(order: list[Key], known: dict[Key, bytes], failures: dict[Key, str]) -> sweep_error:
    def name(key: Key) -> Any:
        item = _item(key)
        try:
            hash(item)
        except TypeError:
            return order.index(key)
        return item

    failed = [key for key in order if key in failures]
    last_line = failures[failed[0]].strip().splitlines()[-1]
    message = (
        f"passive_haptics: {len(failed)} of {len(order)} experiments failed, the first of them with {_text(failed[0])}: "
        f"{last_line}. See failures of this exception, and results for those of the others."
    )
    results = {name(key): pickle.loads(known[key]) for key in order if key in known}
    return sweep_error(message, results, {name(key): failures[key] for key in failed})
