"""Sweeps: results are those of a loop, whatever the executor and the split, and whoever dies."""

import contextlib
import glob
import os
import pickle
import random
import shlex
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest

import experiments
from experiments import BAD, DIES, EXITS, UNPICKLABLE, counted, digest, experiment
from passive_haptics.sweep import _results_in, sweep, sweep_error

HERE = os.path.dirname(os.path.abspath(__file__))
GUIDE = os.path.join(HERE, "..", "..", "docs", "guide")
PATIENCE = 120  # seconds until a test gives up on another process
TWO_TASKS = 200_000  # bytes of a file with their results
SEEDS = random.Random(1).sample(range(10_000), 300)


@pytest.fixture(scope="module")
def serial():
    return [experiment(seed) for seed in range(300)]


def environment(**more):
    path = os.pathsep.join([HERE, *filter(None, [os.environ.get("PYTHONPATH")])])
    return {**os.environ, "PYTHONPATH": path, **{key: str(value) for key, value in more.items()}}


def seeds_in(log):
    return [int(line.split()[1]) for line in log.read_text().splitlines()] if log.exists() else []


def known_in(file):
    """The items with results in a file."""
    with _results_in(file) as results:
        return {pickle.loads(item) for (item,) in results.execute("SELECT item FROM results")}


def until(condition):
    deadline = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < deadline, "another process did not do its part"
        time.sleep(0.02)


def is_running(process):
    try:
        with open(f"/proc/{process}/stat", encoding="utf-8") as file:
            return file.read().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


@pytest.mark.parametrize("size", [1, 7, 100, 299, 300, 1000])
def test_results_are_those_of_a_loop_for_every_split(size):
    expected = [experiment(seed) for seed in SEEDS]
    assert digest(sweep(experiment, SEEDS, experiments_per_task=size)) == digest(expected)
    with ThreadPoolExecutor(3) as executor:
        assert digest(sweep(experiment, iter(SEEDS), executor, experiments_per_task=size)) == digest(expected)


def test_an_executor_of_ones_own_and_seeds_of_numpy(serial):
    with ProcessPoolExecutor(2) as executor:
        assert digest(sweep(experiment, np.arange(300), executor)) == digest(serial)
        assert executor.submit(int, "1").result() == 1  # not shut down
    assert sweep(experiment, []) == []


@pytest.mark.parametrize("method", ["fork", "spawn", "forkserver"])
def test_processes_however_they_are_started(method, serial):
    program = f"""
import multiprocessing
multiprocessing.set_start_method("{method}")
import experiments
from passive_haptics.sweep import sweep
experiments.print_digest(sweep(experiments.experiment, range(300)))
"""
    run = subprocess.run([sys.executable, "-c", program], env=environment(), capture_output=True, text=True)
    assert f"digest 300 {digest(serial)}" in run.stdout, run.stderr


def test_results_of_one_object_are_as_if_each_had_its_own():
    shared = ["a list"]
    with ThreadPoolExecutor(1) as executor:
        first, second = sweep(lambda seed: shared, [1, 2], executor)
    assert first == second == shared and first is not second


def test_seeds_and_sizes_that_are_not_valid():
    with pytest.raises(TypeError, match="item = <function .*: expected one that can be pickled"):
        sweep(experiment, [1, lambda: 2])
    with pytest.raises(ValueError, match="item 3 is given twice"):
        sweep(experiment, [3, 1, 3])
    with pytest.raises(TypeError, match=r"executor = 4 \(int\): expected an Executor of concurrent.futures"):
        sweep(experiment, [3], 4)
    with pytest.raises(ValueError, match="experiments_per_task = 0: expected 1 or more"):
        sweep(experiment, [3], experiments_per_task=0)


def test_items_that_are_no_seeds(tmp_path):
    items = [(0.5, "a"), {"length": 0.1}, 0.25, None, 7]
    for _ in range(2):
        assert sweep(experiments.shown, items, file=tmp_path / "items") == [repr(item) for item in items]
    assert sweep(sum, np.array([[1, 2], [3, 4]])) == [3, 7]
    with pytest.raises(ValueError, match="item 0.25 is given twice"):
        sweep(experiments.shown, [0.25, 0.25])
    with pytest.raises(sweep_error, match="the first of them with item 'no number': ValueError") as caught:
        sweep(float, ["0.5", "no number", [1]])
    assert caught.value.results == {"0.5": 0.5} and list(caught.value.failures) == ["no number", 2]


def test_failures_name_their_seeds_and_lose_no_others_results(serial):
    with pytest.raises(sweep_error) as caught:
        sweep(experiments.troubled, range(300))
    error = caught.value
    assert list(error.failures) == [BAD, UNPICKLABLE, EXITS, DIES]
    for seed, text in zip(error.failures, ["no such device", "pickle", "SystemExit: 3", "terminated abruptly"]):
        assert text in error.failures[seed]
    assert "4 of 300 experiments failed, the first of them with item 17: ValueError: no such device" in str(error)
    good = [seed for seed in range(300) if seed not in error.failures]
    assert list(error.results) == good
    assert digest(error.results.values()) == digest([serial[seed] for seed in good])
    again = pickle.loads(pickle.dumps(error))
    assert str(again) == str(error) and again.failures == error.failures


def test_an_executor_that_breaks_loses_only_what_it_had_not_finished(tmp_path, serial, monkeypatch):
    monkeypatch.setenv("SWEEP_KILLED", str(tmp_path / "killed"))
    file = tmp_path / "results"
    with ProcessPoolExecutor(1) as executor, pytest.raises(sweep_error) as caught:
        sweep(experiments.dies_once, range(300), executor, experiments_per_task=50, file=file)
    error = caught.value
    assert set(error.failures) | set(error.results) == set(range(300)) and DIES in error.failures
    assert set(error.results) >= set(range(250))  # one process runs them in their order
    assert all(digest([serial[seed]]) == digest([result]) for seed, result in error.results.items())
    assert digest(sweep(experiments.dies_once, range(300), file=file)) == digest(serial)


def test_a_file_that_is_whole_saves_all_but_one_experiment(tmp_path, serial, monkeypatch):
    log, file = tmp_path / "log", tmp_path / "results"
    monkeypatch.setenv("SWEEP_LOG", str(log))
    assert digest(sweep(counted, range(200), file=file)) == digest(serial[:200])
    log.unlink()
    assert digest(sweep(counted, range(200), file=file)) == digest(serial[:200])
    assert seeds_in(log) == [0]
    log.unlink()
    mixed = [*range(199, 0, -2), *range(200, 300)]
    assert digest(sweep(counted, mixed, file=file, experiments_per_task=9)) == digest([serial[i] for i in mixed])
    assert sorted(seeds_in(log)) == [199, *range(200, 300)]


def test_a_sweep_that_was_killed_goes_on(tmp_path, serial, monkeypatch):
    log, file = tmp_path / "log", tmp_path / "results"
    program = "import experiments, sys; from passive_haptics.sweep import sweep\n"
    program += "sweep(experiments.stuck_from_200, range(300), file=sys.argv[1])"
    child = subprocess.Popen([sys.executable, "-c", program, file], env=environment(SWEEP_LOG=log))
    until(lambda: 200 in seeds_in(log) and os.path.getsize(file) > TWO_TASKS)
    child.kill()
    child.wait()
    workers = {int(line.split()[0]) for line in log.read_text().splitlines()}
    until(lambda: not any(map(is_running, workers)))  # they end soon after the sweep that was killed
    known = known_in(file)
    assert known and known <= set(range(200))
    log.unlink()
    monkeypatch.setenv("SWEEP_LOG", str(log))
    assert digest(sweep(counted, range(300), file=file)) == digest(serial)
    assert sorted(seeds_in(log)) == sorted([min(known)] + [seed for seed in range(300) if seed not in known])


def test_ctrl_c_ends_a_sweep_and_keeps_what_was_finished(tmp_path, serial):
    log, file = tmp_path / "log", tmp_path / "results"
    program = "import experiments, signal, sys; from passive_haptics.sweep import sweep\n"
    program += "signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's job in the background has none\n"
    program += "sweep(experiments.stuck_from_200, range(300), file=sys.argv[1])"
    child = subprocess.Popen(
        [sys.executable, "-c", program, file],
        env=environment(SWEEP_LOG=log), start_new_session=True, stderr=subprocess.PIPE, text=True,
    )  # fmt: skip
    until(lambda: 200 in seeds_in(log) and os.path.getsize(file) > TWO_TASKS)
    os.killpg(child.pid, signal.SIGINT)
    error = child.communicate(timeout=PATIENCE)[1]
    assert "KeyboardInterrupt" in error and error.count("Traceback") == 1  # no word of the other processes
    assert digest(sweep(experiment, range(300), file=file)) == digest(serial)


def test_a_file_of_another_function_or_kind_is_refused(tmp_path):
    file = tmp_path / "results"
    sweep(experiment, range(10), file=file)
    before = file.read_bytes()
    with pytest.raises(ValueError, match="results: the experiment of item 4 has another result now"):
        sweep(abs, [4, 5], file=file)
    with pytest.raises(ValueError, match="the experiment of item 4 fails now:(.|\n)*ZeroDivisionError"):
        sweep(zero_divided, [4, 5], file=file)
    assert file.read_bytes() == before
    other = tmp_path / "letter.txt"
    other.write_text("Dear reader")
    with pytest.raises(ValueError, match="letter.txt: file is not a database: expected a new file or one of a sweep"):
        sweep(experiment, [1], file=other)
    assert other.read_text() == "Dear reader"


def zero_divided(seed):
    return seed / 0


def test_a_file_is_used_once_at_a_time(tmp_path):
    program = "import experiments, sys; from passive_haptics.sweep import sweep; sweep(abs, [1], file=sys.argv[1])"
    path = tmp_path / "results"
    with _results_in(path):
        with pytest.raises(BlockingIOError, match="results is in use: expected one that no other sweep writes"):
            sweep(abs, [1], file=path)
        other = subprocess.run([sys.executable, "-c", program, path], env=environment(), capture_output=True, text=True)
        assert "results is in use" in other.stderr
    assert sweep(abs, [-1], file=path) == [1]
    with pytest.raises(sqlite3.OperationalError, match="unable to open database file"):
        sweep(abs, [1], file=tmp_path / "no folder" / "results")


class Terminal:
    def __init__(self, isatty):
        self.text, self.isatty = "", lambda: isatty

    def write(self, text):
        self.text += text

    def flush(self):
        pass


@pytest.mark.parametrize("isatty", [False, True])
@pytest.mark.parametrize("progress", [None, False, True])
@pytest.mark.parametrize("after", [0.0, 1e9])
def test_progress_is_shown_at_a_terminal_when_it_takes_long(isatty, progress, after, monkeypatch):
    terminal = Terminal(isatty)
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setattr(sys.modules["passive_haptics.sweep"], "AFTER", after)
    with ThreadPoolExecutor(1) as executor:
        sweep(abs, range(250), executor, progress=progress)
    if after == 0 and (isatty if progress is None else progress):
        assert terminal.text.startswith("\r100 of 250 experiments, ")
        assert terminal.text.endswith("\r250 of 250 experiments, 0 s left\n")
    else:
        assert terminal.text == ""


def test_300_experiments_by_two_workers_of_dask_one_of_which_is_killed(tmp_path, serial):
    pytest.importorskip("distributed", reason="Debian's python3-distributed is not installed")
    run = subprocess.run(
        [sys.executable, os.path.join(HERE, "sweep_by_dask.py"), "300"],
        env=environment(SWEEP_KILLED=tmp_path / "killed", DASK_TEMPORARY_DIRECTORY=tmp_path),
        cwd=tmp_path, capture_output=True, text=True, timeout=PATIENCE,
    )  # fmt: skip
    assert run.returncode == 0, run.stderr
    assert f"digest 300 {digest(serial)}" in run.stdout


MPIRUN = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", "2"]


def on_ranks(**more):
    return environment(OMPI_MCA_btl_vader_single_copy_mechanism="none", OMPI_MCA_btl="self,vader", **more)


def by_mpi(*command, folder, **variables):
    """A program on two ranks."""
    command = [*MPIRUN, sys.executable, "-m", "mpi4py.futures", *command]
    return subprocess.run(
        command, env=on_ranks(**variables), cwd=folder, capture_output=True, text=True, timeout=PATIENCE
    )  # fmt: skip


@pytest.mark.skipif(not shutil.which("mpirun"), reason="no mpirun: Debian's openmpi-bin is not installed")
def test_300_experiments_by_two_ranks_of_mpi_one_of_which_is_killed(tmp_path, serial):
    pytest.importorskip("mpi4py", reason="Debian's python3-mpi4py is not installed")
    file = tmp_path / "results"
    command = [os.path.join(HERE, "sweep_by_mpi.py"), "300", file]
    killed = by_mpi(*command, folder=tmp_path, SWEEP_KILLED=tmp_path / "killed")
    assert killed.returncode != 0 and (tmp_path / "killed").exists(), killed.stdout + killed.stderr
    assert len(known_in(file)) in (100, 200)
    again = by_mpi(*command, folder=tmp_path, SWEEP_KILLED=tmp_path / "killed")
    assert again.returncode == 0, again.stderr
    assert f"digest 300 {digest(serial)}" in again.stdout


def stand_in(path, script):
    """A program that is this script of a shell."""
    path.write_text(f"#!/bin/sh\n{script}\n")
    path.chmod(0o700)


def by_shell(command, folder):
    """What a command of the guide prints, as a job of SLURM on two ranks; what it started ends with it."""
    for file in glob.glob(os.path.join(GUIDE, "sweeps*")):
        shutil.copy(file, folder)
    stand_in(folder / "python", f'exec {shlex.quote(sys.executable)} "$@"')
    stand_in(folder / "srun", f'[ "$1" != --mpi=pmix ] || shift\nexec {shlex.join(MPIRUN)} "$@"')
    variables = on_ranks(
        PATH=f"{folder}:{os.environ['PATH']}", SLURMD_NODENAME="127.0.0.1", SLURM_JOB_ID=os.getpid(),
        DASK_TEMPORARY_DIRECTORY=folder,
    )  # fmt: skip
    with open(folder / "out", "w") as out, open(folder / "err", "w") as err:
        job = subprocess.Popen(
            ["sh", "-c", command], env=variables, cwd=folder, stdout=out, stderr=err, start_new_session=True
        )  # fmt: skip
    try:
        job.wait(timeout=PATIENCE)
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(job.pid, signal.SIGTERM)
    assert job.returncode == 0, (folder / "err").read_text()
    return (folder / "out").read_text()


def test_guide_runs(tmp_path):
    printed = by_shell("python sweeps.py", tmp_path)
    assert printed.startswith("0.650 +- 0.001 of the states\n")
    assert "299 others have results; ZeroDivisionError: float division by zero" in printed


@pytest.mark.skipif(not shutil.which("mpirun"), reason="no mpirun: Debian's openmpi-bin is not installed")
@pytest.mark.parametrize("command", ["python sweeps_dask.py", "sh sweeps_dask.sh", "sh sweeps_mpi.sh"])
def test_guide_runs_on_workers_and_in_jobs(command, tmp_path):
    pytest.importorskip("distributed", reason="Debian's python3-distributed is not installed")
    pytest.importorskip("mpi4py", reason="Debian's python3-mpi4py is not installed")
    assert by_shell(command, tmp_path) == "0.650\n"
