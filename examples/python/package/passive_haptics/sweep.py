"""Many experiments, each a function of its seed: over the processors of a machine, or over a cluster.

    from passive_haptics.sweep import sweep
    results = sweep(experiment, range(10_000), file="results.sweep")
"""

from __future__ import annotations

import collections.abc
import operator
import pickle
from concurrent.futures import Executor
from contextlib import ExitStack, closing
from typing import Any, TypeVar

from passive_haptics.progress import progress_line
from passive_haptics.record_file import Path, record_file
from passive_haptics.tasks import Experiment, completed_outcomes

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


def sweep(
    function: collections.abc.Callable[[int], Result],
    seeds: collections.abc.Iterable[int],
    executor: Executor | None = None,
    *,
    experiments_per_task: int = 100,
    file: Path | None = None,
    progress: bool | None = None,
) -> list[Result]:
    """The results function(seed) in the order of the seeds, the same bytes for every executor and every
    split.

    function: takes an integer seed, and must depend on nothing else. It and its results can be pickled. An
    experiment that takes longer than some 10 s deserves a task of its own, one under 1 ms more than 100 a
    task.
    seeds: distinct integers.
    executor: any of concurrent.futures, for instance dask.distributed.Client(...).get_executor() or
    mpi4py.futures.MPIPoolExecutor(). None: a process for each processor that this one may use.
    file: keeps the results of finished tasks. After an interruption, or with more seeds, a sweep with this
    file runs what is missing. Before that it runs one experiment of the file again, and throws ValueError if
    that result is now another: the function has changed. Reading a file runs what it says (pickle): trust its
    source.
    progress: None: shown where stderr is a terminal and the sweep takes over 2 s.

    Throws sweep_error once all experiments have run, if some of them failed: it names their seeds and holds
    the results of the others. A process that dies is a failure of the one experiment that ended it, under an
    executor of one's own of all experiments that this executor lost. Throws ValueError or TypeError for seeds
    that are not as above.
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
        shown = progress_line(len(missing), "experiments", progress)
        with closing(completed_outcomes(function, tasks, executor, shown)) as completed, closing(shown):
            for outcomes in completed:
                new = {outcome.seed: outcome.result for outcome in outcomes if outcome.result is not None}
                if store is not None and new:
                    store.append(pickle.dumps(new))
                known.update(new)
                failures.update({outcome.seed: outcome.failure for outcome in outcomes if outcome.result is None})
    if failures:
        raise _error_of(order, known, failures)
    return [pickle.loads(known[seed]) for seed in order]


def _distinct(seeds: collections.abc.Iterable[int]) -> list[int]:
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
    function: Experiment,
    seeds: list[int],
    known: dict[int, bytes],
    executor: Executor | None,
    file: Path | None,
) -> None:
    """Throws ValueError if the function now has other results at these seeds than the file."""
    shown = progress_line(len(seeds), "experiments", wanted=False)
    for outcomes in completed_outcomes(function, [seeds] if seeds else [], executor, shown):
        for seed, result, failure in outcomes:
            if result != known[seed]:
                now = f"fails now:\n{failure}" if failure else "has another result now"
                raise ValueError(
                    f"passive_haptics: file = {file}: the experiment of seed {seed} {now}. The function has changed, or "
                    "depends on more than its seed. Name a new file, or remove this one."
                )


def _error_of(order: list[int], known: dict[int, bytes], failures: dict[int, str]) -> sweep_error:
    failed = {seed: failures[seed] for seed in order if seed in failures}
    first = next(iter(failed))
    last_line = failed[first].strip().splitlines()[-1]
    message = (
        f"passive_haptics: {len(failed)} of {len(order)} experiments failed, the first of them with seed {first}: "
        f"{last_line}. See failures of this exception, and results for those of the others."
    )
    return sweep_error(message, {seed: pickle.loads(known[seed]) for seed in order if seed in known}, failed)
