"""Logs are read by the library's own reader, to the last bit."""

import os
import re
import subprocess

import numpy as np
import pytest

import passive_haptics as ph
from devices import Case

REFERENCE = os.environ.get("PASSIVE_HAPTICS_PYTHON_REFERENCE")
ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
SEED = 20040627
NAMES = ["t", "q1", "q2", "qd1", "qd2", "Fh_x", "Fh_y"]

needs_reference = pytest.mark.skipif(REFERENCE is None, reason="tests/run python names the program to compare with")


def rows(columns, *names):
    return np.column_stack([columns[name] for name in names])


@needs_reference
def test_the_replay_of_cpp_decides_what_python_decides(tmp_path):
    """There and back: C++ replays a log that NumPy wrote, and Python reads the log of that replay."""
    random = np.random.default_rng(SEED)
    q = np.array([0.7, 0.8]) + random.uniform(-0.3, 0.3, (1000, 2))
    qd, force = random.uniform(-1, 1, (1000, 2)), random.uniform(-4, 4, (1000, 2))
    times = np.arange(1000) * 1e-3
    written = np.column_stack([times, q, qd, force])
    np.savetxt(tmp_path / "a.csv", written, fmt="%.17g", delimiter=",", header=",".join(NAMES), comments="")
    subprocess.run([REFERENCE, "tendon_two_link", "log", "replay", tmp_path / "a.csv", tmp_path / "b.csv"], check=True)
    log, units = ph.read_log(tmp_path / "b.csv")
    assert rows(log, *NAMES).tobytes() == written.tobytes() and units["qd2"] == "rad/s"
    arm = ph.tendon_two_link()
    scene = ph.scene(ph.wall(ph.half_space([0, 0.225], [0, -1]), 1e5))
    control = ph.controller(arm, arm.brakes(), scene, ph.direct_control())
    results = [control(ph.device_state(*state)) for state in zip(times, q, qd, force)]
    for name, member in (("capacity", "capacity"), ("torque", "torque"), ("Fd", "desired_force"), ("Fc", "control_force")):
        parts = [f"{name}_{axis}" for axis in "xy"] if name[0] == "F" else [f"{name}{i}" for i in (1, 2)]
        assert rows(log, *parts).tobytes() == np.array([getattr(result, member) for result in results]).tobytes()
    assert log["status"].tolist() == [result.outcome.text for result in results]
    assert np.mean(log["capacity1"] > 0) > 0.1


@needs_reference
def test_a_log_of_cpp_reads_equal(tmp_path):
    case = Case("tendon_two_link", 3000, SEED)
    case.write(tmp_path / "states")
    subprocess.run([REFERENCE, case.name, "log", "write", tmp_path / "states", tmp_path / "a.csv"], check=True)
    expected = np.fromfile(f"{tmp_path / 'a.csv'}.numbers").reshape(-1, 7)
    expected[~np.isfinite(expected)] = np.nan  # an empty cell
    log, units = ph.read_log(tmp_path / "a.csv")
    found = rows(log, *NAMES)
    assert found.shape == expected.shape == (2999, 7)
    known = ~np.isnan(expected)
    assert (np.isnan(found) == ~known).all() and found[known].tobytes() == expected[known].tobytes()
    assert log["cycle"].tolist() == list(range(1, 3000)) and units["cycle"] == "1"
    assert log["reason"][:3].tolist() == ["", "", 'late, "twice"'] and set(log["status"]) == {"ok", ""}


def test_names_and_units_are_those_of_the_page(tmp_path):
    """Each column of the table of docs/guide/log.md is known, with the first of its units."""
    page = open(os.path.join(ROOT, "docs", "guide", "log.md"), encoding="utf-8").read()
    table = re.findall(r"^\| (`[^|]*) \| ([^|]*?) ?\| ", page, re.M)
    assert len(table) > 15
    for cells, unit in table:
        for name in set(re.findall(r"`([^`]+)`", cells)) - {"t"}:
            (tmp_path / "a.csv").write_text(f"t,{name}\n0,1\n")
            assert ph.read_log(tmp_path / "a.csv")[1][name] == unit.split(",")[0].strip(), name


def test_logs_of_other_programs_are_read(tmp_path):
    path = tmp_path / "a.csv"
    path.write_bytes(b"\xef\xbb\xbft;q1;status;mine;yours\r\n0;1.5;ok;7;\r\n1;;late;;word\r\n")
    log, units = ph.read_log(path)
    assert units == {"t": "s", "q1": "rad", "status": "", "mine": "1", "yours": ""}
    assert np.isnan(log["q1"][1]) and log["mine"][0] == 7 and log["yours"].tolist() == ["", "word"]
    path.write_bytes(b"t,note\n0,\xff\n")
    assert ph.read_log(path)[0]["note"].tolist() == ["\udcff"]
    path.write_bytes(b"t,q1\n")
    assert ph.read_log(path)[0]["q1"].shape == (0,)
    log, units = ph.read_log(os.path.join(ROOT, "docs", "guide", "log.csv"))
    assert log["note"][:2].tolist() == ["before homing", "above the wall"] and units["q2"] == "m"


@pytest.mark.parametrize("text, expected", [
    ("t,q1\n0,x\n", "a.csv, line 2, column 2: 'x': expected a finite number for 'q1'"),
    ("t,q1\n0,1\n0.5\n", "a.csv, line 3, column 2: the line ends: expected a cell for 'q1'"),
    ("t,q1\n1,1\n0,1\n", "a.csv, line 3, column 1: time 0: expected no time before that of the line above"),
    ("# units: s,deg\nt,q1\n0,1\n", "a.csv, line 2, column 2: 'q1' in 'deg': expected it in rad or m"),
    ("# passive_haptics log 9\nt\n0\n", "a.csv, line 1: version 9: expected version 1"),
    ("", "a.csv, line 1: the log is empty: expected a line of names, t,q1,..."),
    ("# units: s,1\nt,mine\n0,inf\n", "a.csv, line 3, column 2: 'inf': expected a finite number for 'mine'"),
    ("t\n0\0\n1\n", "a.csv, line 2: a zero byte or Ctrl-Z: expected text; lines may be lost here: if none is, "
     "remove such bytes"),
])  # fmt: skip
def test_a_mistake_is_named_with_its_place(tmp_path, text, expected):
    path = tmp_path / "a.csv"
    path.write_text(text)
    with pytest.raises(ValueError) as caught:
        ph.read_log(path)
    assert str(caught.value) == f"passive_haptics: {tmp_path}/{expected}"


def test_files_that_cannot_be_read(tmp_path):
    with pytest.raises(FileNotFoundError):
        ph.read_log(tmp_path / "none.csv")
    with pytest.raises(IsADirectoryError):
        ph.read_log(tmp_path)
