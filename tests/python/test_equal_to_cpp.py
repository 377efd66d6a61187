"""Single cycles and batches of every pair of a device and a law are those of C++, bit for bit."""

import os
import subprocess

import numpy as np
import pytest

import passive_haptics as ph
from devices import Case, pairs

STATES = int(os.environ.get("PASSIVE_HAPTICS_PYTHON_STATES", "100000"))
SEED = 45
REFERENCE = os.environ.get("PASSIVE_HAPTICS_PYTHON_REFERENCE")


def numbers_of(result):
    """The numbers of a result in the order in which reference.cpp writes them."""
    whole = np.array(
        [result.outcome, result.power, result.display, result.saturated, result.wall_number], dtype=float
    )
    return b"".join(
        part.tobytes()
        for part in (
            result.capacity,
            result.torque,
            whole,
            np.array([result.alpha, result.approximation_cosine]),
            result.desired_force,
            result.control_force,
            result.cone_coefficients,
            result.signs,
        )
    )


def rows_of(result):
    """The rows of a batch in the same order."""
    columns = [result.capacity, result.torque]
    columns += [result.outcome, result.power, result.display, result.saturated, result.wall_number]
    columns += [result.alpha, result.approximation_cosine, result.desired_force, result.control_force]
    columns += [result.cone_coefficients, result.signs]
    return np.column_stack([np.asarray(column, dtype=float) for column in columns])


def expected(case, law, mode, folder):
    """What C++ decides, a row for each state."""
    states, results = folder / "states", folder / "results"
    case.write(states)
    subprocess.run([REFERENCE, case.name, law, mode, states, results], check=True)
    return np.fromfile(results).reshape(len(case.q), -1)


def assert_same_bits(ours, theirs, what):
    different = np.any(ours.view(np.uint64) != theirs.view(np.uint64), axis=1)
    first = np.argmax(different)
    assert not different.any(), (
        f"{what}, seed {SEED}: {different.sum()} of {len(ours)} states differ, the first is {first}: "
        f"{ours[first]} but C++ has {theirs[first]}"
    )


@pytest.mark.skipif(REFERENCE is None, reason="tests/run python names the program to compare with")
@pytest.mark.parametrize("device,law", pairs())
def test_single_cycles(device, law, tmp_path):
    case = Case(device, STATES, SEED)
    theirs = expected(case, law, "cycle", tmp_path)
    control = case.controller(law)
    ours = bytearray()
    for time, q, qd, force in zip(case.time.tolist(), case.q, case.qd, case.hand_force):
        ours += numbers_of(control(ph.device_state(time, q, qd, force)))
    ours = np.frombuffer(bytes(ours)).reshape(theirs.shape)
    assert_same_bits(ours, theirs, f"single cycles of {device} under {law}")
    touched = theirs[:, -1 - case.device.brake_count :] != 0
    assert touched.any(axis=1).mean() > 0.1  # the wall is there


@pytest.mark.skipif(REFERENCE is None, reason="tests/run python names the program to compare with")
@pytest.mark.parametrize("device,law", pairs())
def test_batches(device, law, tmp_path):
    case = Case(device, STATES + 3, SEED + 1)
    theirs = expected(case, law, "batch", tmp_path)
    control = case.controller(law)
    by_rows = control.batch(case.q, case.qd, case.hand_force, case.time)
    assert_same_bits(rows_of(by_rows), theirs, f"batch of {device} under {law}")
    columns = [np.asfortranarray(x) for x in (case.q, case.qd, case.hand_force)]
    by_columns = control.batch(*columns, case.time)
    assert by_columns == by_rows
    every_other = [np.repeat(x, 2, axis=0)[::2] for x in (case.q, case.qd, case.hand_force)]
    assert control.batch(*every_other, case.time, workers=-1) == by_rows
    again = control.batch(*columns, case.time, out=by_columns)
    assert again.capacity is by_columns.capacity
    assert again == by_rows
    fewer = control.batch(*columns, case.time, fields="alpha")
    with pytest.raises(AttributeError, match="no torque: expected one of capacity, outcome, alpha; or call batch"):
        fewer.torque
    assert fewer.capacity.tobytes() == by_rows.capacity.tobytes()
    assert control.batch(*columns, case.time, fields=["signs"], out=fewer).signs.tobytes() == by_rows.signs.tobytes()
    assert fewer.alpha.tobytes() == by_rows.alpha.tobytes()
