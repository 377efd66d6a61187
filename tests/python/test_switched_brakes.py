"""Brakes that are off or work one way: the cycles are those of C++, bit for bit."""

import os
import pickle
import subprocess
import threading

import numpy as np
import pytest

import passive_haptics as ph
from devices import DEVICES, Case
from test_equal_to_cpp import assert_same_bits, numbers_of, rows_of

REFERENCE = os.environ.get("PASSIVE_HAPTICS_PYTHON_REFERENCE")
SEED = 47
inf = float("inf")


def states_of(case):
    return [ph.device_state(*row) for row in zip(case.time.tolist(), case.q, case.qd, case.hand_force)]


@pytest.mark.skipif(REFERENCE is None, reason="tests/run python names the program to compare with")
def test_cycles(tmp_path):
    case = Case("tendon_two_link", 20_000, SEED)
    case.write(tmp_path / "states")
    command = [REFERENCE, case.name, "switched", "cycle", tmp_path / "states", tmp_path / "results"]
    subprocess.run(command, check=True)
    theirs = np.fromfile(tmp_path / "results").reshape(len(case.q), -1)
    one_way = case.device.brakes(torque_limit=case.torque_limit, torque_upper=[0, inf])
    one_off = case.device.brakes(torque_limit=case.torque_limit, torque_lower=[-inf, 0], torque_upper=[0, 0])
    control = ph.controller(case.device, one_way, case.scene(), ph.direct_control())
    ours = bytearray()
    for i, state in enumerate(states_of(case)):
        if i == len(case.q) // 2:
            control.set_brakes(one_off)
        ours += numbers_of(control(state))
    assert_same_bits(np.frombuffer(bytes(ours)).reshape(theirs.shape), theirs, "switched brakes")
    assert control.parameters["brakes"] == one_off and pickle.loads(pickle.dumps(control)) == control


@pytest.mark.parametrize("name", ["tendon_two_link", "two_link", "xy_table", "delta"])
def test_batches_are_the_cycles(name):
    """Also where the batch of that wall was compiled for brakes that work both ways."""
    case = Case(name, 500, SEED)
    off = np.zeros(case.device.brake_count)
    lower = np.where(np.arange(len(off)) == 0, 0, -inf)
    one_way = case.device.brakes(torque_limit=case.torque_limit, torque_lower=lower)
    for brakes in (one_way, case.device.brakes(torque_lower=off, torque_upper=off)):
        control = ph.controller(case.device, case.brakes(), case.scene(), ph.direct_control())
        before = control.batch(case.q, case.qd, case.hand_force, case.time)
        control.set_brakes(brakes)
        made = ph.controller(case.device, brakes, case.scene(), ph.direct_control())
        found = made.batch(case.q, case.qd, case.hand_force, case.time)
        assert control.batch(case.q, case.qd, case.hand_force, case.time) == found != before
        singly = []
        for state in states_of(case):
            made.reset()
            singly.append(np.frombuffer(numbers_of(made(state))))
        assert_same_bits(rows_of(found), np.array(singly), f"batch of {name}")
    assert not found.capacity.any() and before.capacity.any()


def test_a_brake_that_is_off_displays_nothing():
    arm = ph.tendon_two_link()
    q, motion, normal = [0.7, 0.8], [0.05, 0.02], [0, -1]
    off = arm.brakes(torque_lower=[0, 0], torque_upper=[0, 0])
    assert arm.displayable(q, motion, normal, arm.brakes()).max_force > 0
    assert arm.displayable(q, motion, normal, off).max_force == 0
    assert arm.design_map([q], [1, 0], normal, off)["sink_slope"] == inf


def test_a_batch_keeps_the_brakes_with_which_it_began():
    case = Case("two_link", 200_000, SEED)
    control = ph.controller(case.device, case.brakes(), case.scene(), ph.direct_control())
    first, done = control.batch(case.q, case.qd, case.hand_force), threading.Event()

    def switch():
        while not done.is_set():
            control.set_brakes(case.device.brakes(torque_limit=0))
            control.set_brakes(case.brakes())

    thread = threading.Thread(target=switch)
    thread.start()
    limits = {control.batch(case.q, case.qd, case.hand_force).capacity.max() for _ in range(5)}
    done.set()
    thread.join()
    assert limits <= {0.0, first.capacity.max()}


def test_misuses():
    arm = ph.tendon_two_link()
    chain, scene = ph.planar_arm([0.1, 0.1, 0.1]), ph.scene(ph.wall(ph.half_space([0, 0.2], [0, -1])))
    control = ph.controller(arm, arm.brakes(), scene, ph.direct_control())
    for call, error, text in (
        (lambda: arm.brakes(torque_lower=[0.1, 0]), ValueError, "torque_lower[0] [N m] = 0.1: expected a number <= 0"),
        (lambda: arm.brakes(torque_upper=[0, -1]), ValueError, "torque_upper[1] [N m] = -1: expected a number >= 0"),
        (lambda: arm.brakes(torque_upper=[0]), ValueError, "length of torque_upper = 1: expected 2"),
        (lambda: ph.controller(chain, chain.brakes(torque_upper=[0, 0, 0]), scene, ph.direct_control()), ValueError,
         "a controller of a mechanism with more joints than task dimensions supports such brakes only in C++"),
        (lambda: control.set_brakes(3), TypeError, "brakes = 3 (int): expected what brakes() of the mechanism returns"),
        (lambda: control.set_brakes(DEVICES["delta"]().brakes()), TypeError, "for its number of brakes"),
        (lambda: ph.simulated_device(arm, arm.brakes(torque_upper=[0, 0]), 0.5, [0.7, 0.8]), ValueError,
         "expected brakes that work both ways"),
    ):  # fmt: skip
        with pytest.raises(error) as caught:
            call()
        assert text in str(caught.value), str(caught.value)
