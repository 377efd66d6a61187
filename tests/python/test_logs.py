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


def test_a_mistake_is_named_with_its_place(tmp_path):
    text, expected = "t,q1\n0,x\n", "a.csv, line 2, column 2: 'x': expected a finite number for 'q1'"
    path = tmp_path / "a.csv"
    path.write_text(text)
    with pytest.raises(ValueError) as caught:
        ph.read_log(path)
    assert str(caught.value) == f"passive_haptics: {tmp_path}/{expected}"
