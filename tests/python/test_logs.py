"""Logs are read and written by the library's own reader and writer, to the last bit, whole or not at all."""

import os
import pickle
import re
import signal
import subprocess
import sys

import numpy as np
import pytest

import passive_haptics as ph
from devices import Case

REFERENCE = os.environ.get("PASSIVE_HAPTICS_PYTHON_REFERENCE")
ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
SEED = 20040627

needs_reference = pytest.mark.skipif(REFERENCE is None, reason="tests/run python names the program to compare with")


def bits(array):
    return np.ascontiguousarray(array, dtype=float).view(np.uint64)


def a_log(lines=1000):
    """A motion at the wall that tests/python/logs.cpp has, with gaps before homing, words and a column of its own."""
    random = np.random.default_rng(SEED)
    q = np.array([0.7, 0.8]) + random.uniform(-0.3, 0.3, (lines, 2))
    qd, force = random.uniform(-1, 1, (lines, 2)), random.uniform(-4, 4, (lines, 2))
    q[:5] = qd[:5] = np.nan
    note = np.array(["", "a, b", 'said "x"', " spaces ", "µ", ";"])[random.integers(0, 6, lines)]
    mine = np.where(random.random(lines) < 0.5, np.nan, random.integers(0, 1 << 63, lines).view(float))
    mine[~np.isfinite(mine)] = -0.0
    columns = {"t": np.arange(lines) * 1e-3, "q": q, "qd": qd, "Fh": force, "note": note, "mine": mine}
    return ph.motion_log(columns, {"mine": "V"})


def test_what_is_written_reads_back_to_the_last_bit(tmp_path):
    log, path = a_log(), tmp_path / "a.csv"
    ph.write_log(path, log)
    again = ph.read_log(path)
    assert again == log and list(again) == ["t", "q1", "q2", "qd1", "qd2", "Fh_x", "Fh_y", "note", "mine"]
    assert again.units == {**log.units} and again.units["qd2"] == "rad/s" and again.units["mine"] == "V"
    for name in log:
        if log[name].dtype.kind == "f":
            known = ~np.isnan(log[name])
            assert (bits(again[name])[known] == bits(log[name])[known]).all() and np.isnan(again[name][~known]).all()
    assert again.rows("q").flags.f_contiguous and again.rows("Fh").shape == (1000, 2)
    second = tmp_path / "b.csv"
    ph.write_log(str(second), again)
    assert second.read_bytes() == path.read_bytes()
    assert sorted(os.listdir(tmp_path)) == ["a.csv", "b.csv"]


@needs_reference
def test_the_replay_of_cpp_takes_it_and_decides_what_python_decides(tmp_path):
    """There and back: C++ replays a log of Python, and Python reads the log of that replay."""
    log = a_log()
    ph.write_log(tmp_path / "a.csv", log)
    subprocess.run([REFERENCE, "tendon_two_link", "log", "replay", tmp_path / "a.csv", tmp_path / "b.csv"], check=True)
    replayed = ph.read_log(tmp_path / "b.csv")
    arm = ph.tendon_two_link()
    scene = ph.scene(ph.wall(ph.half_space([0, 0.225], [0, -1]), 1e5))
    control = ph.controller(arm, arm.brakes(), scene, ph.direct_control())
    whole = slice(5, None)
    for name in ("q", "qd", "Fh"):
        assert (bits(replayed.rows(name)[whole]) == bits(log.rows(name)[whole])).all()
    results = [
        control(ph.device_state(*state))
        for state in zip(log["t"][whole], log.rows("q")[whole], log.rows("qd")[whole], log.rows("Fh")[whole])
    ]
    members = {"capacity": "capacity", "torque": "torque", "Fd": "desired_force", "Fc": "control_force"}
    for name, member in members.items():
        assert (bits(replayed.rows(name)[whole]) == bits([getattr(result, member) for result in results])).all()
    assert replayed["status"][whole].tolist() == [result.outcome.text for result in results]
    assert replayed["display"][:5].tolist() == [""] * 5 and np.isnan(replayed["alpha"][:5]).all()
    assert np.mean(replayed.rows("capacity")[whole] > 0) > 0.1


@needs_reference
def test_a_log_of_cpp_reads_equal(tmp_path):
    case = Case("tendon_two_link", 3000, SEED)
    case.write(tmp_path / "states")
    subprocess.run([REFERENCE, case.name, "log", "write", tmp_path / "states", tmp_path / "a.csv"], check=True)
    expected = np.fromfile(f"{tmp_path / 'a.csv'}.numbers").reshape(-1, 7)
    expected[~np.isfinite(expected)] = np.nan  # an empty cell
    log = ph.read_log(tmp_path / "a.csv")
    found = np.column_stack([log["t"], log.rows("q"), log.rows("qd"), log.rows("Fh")])
    assert found.shape == expected.shape == (2999, 7)
    known = ~np.isnan(expected)
    assert (np.isnan(found) == ~known).all() and (bits(found[known]) == bits(expected[known])).all()
    assert log["cycle"].tolist() == list(range(1, 3000)) and log.units["cycle"] == "1"
    assert log["reason"][:3].tolist() == ["", "", 'late, "twice"'] and set(log["status"]) == {"ok", ""}


def test_names_units_and_words_are_those_of_the_page():
    """Each column of the table of docs/guide/log.md is known, with the first of its units."""
    page = open(os.path.join(ROOT, "docs", "guide", "log.md"), encoding="utf-8").read()
    rows = re.findall(r"^\| (`[^|]*) \| ([^|]*?) ?\| ", page, re.M)
    assert len(rows) > 15
    for cells, unit in rows:
        for name in re.findall(r"`([^`]+)`", cells):
            is_words = not unit.strip()
            log = ph.motion_log({"t": [0.0], name: ["x"] if is_words else [1.0]})
            assert log.units[name] == unit.split(",")[0].strip(), name


def test_logs_of_other_programs_are_read(tmp_path):
    path = tmp_path / "a.csv"
    path.write_bytes(b"\xef\xbb\xbft;q1;status;mine;yours\r\n0;1.5;ok;7;\r\n1;;late;;word\r\n")
    log = ph.read_log(path)
    assert log.units == {"t": "s", "q1": "rad", "status": "", "mine": "1", "yours": ""}
    assert np.isnan(log["q1"][1]) and log["mine"][0] == 7 and log["yours"].tolist() == ["", "word"]
    np.savetxt(path, [[0, 1], [1, 2]], delimiter=",", header="t,q1")
    assert ph.read_log(path).rows("q").tolist() == [[1.0], [2.0]]
    path.write_bytes(b"t,note\n0,\xff\n")
    other = tmp_path / "b.csv"
    ph.write_log(other, ph.read_log(path))
    assert b"\n0,\xff\n" in other.read_bytes()
    path.write_bytes(b"t,q1\n")
    assert ph.read_log(path).line_count == 0
    ph.write_log(path, ph.read_log(path))
    assert path.read_bytes() == b"# passive_haptics log 1\n# units: s,rad\nt,q1\n"
    guide = ph.read_log(os.path.join(ROOT, "docs", "guide", "log.csv"))
    assert guide["note"][:2].tolist() == ["before homing", "above the wall"] and guide.units["q2"] == "m"


@pytest.mark.parametrize("text, expected", [
    ("t,q1\n0,x\n", "a.csv, line 2, column 2: 'x', expected a finite number for 'q1'"),
    ("t,q1\n0,1\n0.5\n", "a.csv, line 3, column 2: the line ends, expected a cell for 'q1'"),
    ("t,q1\n1,1\n0,1\n", "a.csv, line 3, column 1: time 0, expected no time before that of the line above"),
    ("# units: s,deg\nt,q1\n0,1\n", "a.csv, line 2, column 2: 'q1' in 'deg', expected it in rad or m"),
    ("# passive_haptics log 9\nt\n0\n", "a.csv, line 1: version 9, expected version 1"),
    ("", "a.csv, line 1: the log is empty, expected a line of names, t,q1,..."),
    ("# units: s,1\nt,mine\n0,inf\n", "a.csv, line 3, column 2: 'inf', expected a finite number for 'mine'"),
    ("t\n0\0\n1\n", "a.csv, line 2: a zero byte or Ctrl-Z, expected text; lines may be lost here: if none is, "
     "remove such bytes"),
])  # fmt: skip
def test_a_mistake_is_named_with_its_place(tmp_path, text, expected):
    path = tmp_path / "a.csv"
    path.write_text(text)
    with pytest.raises(ValueError) as caught:
        ph.read_log(path)
    assert str(caught.value) == f"passive_haptics: {tmp_path}/{expected}"


REFUSED = [
    ({"t": [0, 1], "x": [0, np.inf]}, ValueError, "line 5, column 2: inf for 'x', expected a finite number, or NaN"),
    ({"t": [1, 0]}, ValueError, "line 5, column 1: time 0, expected no time before that of the line above"),
    ({"t": [np.nan], "x": [1]}, ValueError, "line 4, column 1: no time"),
    ({"q": [[1, 2]]}, ValueError, "no column 't', expected one among 'q1,q2'"),
    ({"t": [0, 1], "note": ["a", "b\nc"]}, ValueError, "line 5"),
    ({"t": [0], "note": ["a\0b"]}, ValueError, "a zero byte"),
    ({"t": [0], "x" * 5000: [1]}, ValueError, "more than 4096 characters"),
    ({"t": [0], "a,b": [1]}, ValueError, "expected"),
    ({"t": [0, 1], "x": [1]}, ValueError, "length of x = 1, expected 2, as t has"),
    ({"t": [0], "Fh": [[1, 2, 3, 4]]}, ValueError, "Fh has rows of 4 numbers, expected 3 at most"),
    ({"t": [0], "q": [[1, 2]], "q1": [1]}, ValueError, "column q1 is given twice"),
    ({"t": [0], "status": [0]}, TypeError, "column status has numbers, expected words"),
    ({"t": [0], "alpha": ["x"]}, TypeError, "column alpha has words, expected numbers [1]"),
    ({"t": [0], "x": [1j]}, TypeError, "column x has dtype complex128, expected real numbers or words"),
    ({"t": [0], "x": [None]}, TypeError, "column x has dtype object, expected real numbers or words"),
    ({"t": [0], "x": [[[1]]]}, ValueError, "column x has shape (1, 1, 1)"),
    ({"t": 0}, ValueError, "column t has shape ()"),
    ({"t": [0], "cycle": [2**60]}, ValueError, "whole numbers over 2^53"),
    ({1: [0]}, TypeError, "name of a column = 1 (int), expected a str"),
    ([("t", [0])], TypeError, "(list), expected a dict of arrays"),
]


@pytest.mark.parametrize("columns, error, text", REFUSED, ids=range(len(REFUSED)))
def test_what_no_log_can_hold_leaves_the_file_as_it_was(tmp_path, columns, error, text):
    path = tmp_path / "a.csv"
    path.write_text("before")
    with pytest.raises(error) as caught:
        ph.write_log(path, columns)
    assert str(caught.value).startswith("passive_haptics: ") and text in str(caught.value)
    assert os.listdir(tmp_path) == ["a.csv"] and path.read_text() == "before"


def test_units_that_do_not_fit():
    for units, error, text in (
        ({"q3": "m"}, ValueError, "units has 'q3', expected names among t, q1"),
        ({"q1": ""}, ValueError, "unit of q1 = '', expected one for numbers; '1' where they have none"),
        ({"q1": 1}, TypeError, "unit of q1 = 1 (int), expected a str"),
        ("m", TypeError, "units = 'm' (str), expected a dict of texts"),
    ):
        with pytest.raises(error) as caught:
            ph.motion_log({"t": [0], "q1": [0]}, units)
        assert text in str(caught.value)
    log = ph.motion_log({"t": [0]})
    for call in (lambda: log["q1"], lambda: log.rows("q")):
        with pytest.raises(KeyError, match="expected"):
            call()


def test_files_that_cannot_be_read_or_replaced(tmp_path):
    with pytest.raises(FileNotFoundError):
        ph.read_log(tmp_path / "none.csv")
    with pytest.raises(IsADirectoryError):
        ph.read_log(tmp_path)
    with pytest.raises(ValueError, match="is no file, expected one that can be replaced"):
        ph.write_log("/dev/null", {"t": [0]})
    with pytest.raises(FileNotFoundError):
        ph.write_log(tmp_path / "no_folder" / "a.csv", {"t": [0]})
    target, link = tmp_path / "a.csv", tmp_path / "link.csv"
    target.write_text("before")
    target.chmod(0o640)
    link.symlink_to(target)
    ph.write_log(link, {"t": [0]})
    assert link.is_symlink() and ph.read_log(target).line_count == 1
    assert target.stat().st_mode & 0o777 == 0o640


def test_a_process_that_is_killed_leaves_the_file_as_it_was(tmp_path):
    path = tmp_path / "a.csv"
    ph.write_log(path, a_log(10))
    before = path.read_bytes()
    program = "import sys, numpy as np, passive_haptics as ph\nprint('go', flush=True)\n"
    program += "while True: ph.write_log(sys.argv[1], {'t': np.arange(300_000.0), 'q': np.zeros((300_000, 9))})"
    with subprocess.Popen([sys.executable, "-c", program, path], stdout=subprocess.PIPE) as child:
        child.stdout.readline()
        while len(os.listdir(tmp_path)) == 1 and child.poll() is None:
            pass
        child.send_signal(signal.SIGKILL)
    assert path.read_bytes() == before or ph.read_log(path).line_count == 300_000


def test_a_log_is_a_value():
    log = a_log(20)
    assert pickle.loads(pickle.dumps(log)) == log and log != a_log(21) and log != 1
    assert repr(log).startswith("<motion_log of 20 lines: t [s], q1 [rad]") and "note" in repr(log)
    assert ph.motion_log(log, log.units) == log
    longer = ph.motion_log({**log, "more": np.zeros(20)}, log.units)
    assert longer["more"].tolist() == [0] * 20 and len(longer) == len(log) + 1
    with pytest.raises(TypeError):
        hash(log)
