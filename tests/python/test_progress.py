"""Long calls say how far they are where stderr is a terminal, and nowhere else."""

import io
import re
import sys
import time

import numpy as np
import pytest

import passive_haptics as ph
from passive_haptics import progress

device = ph.two_link()


class screen(io.StringIO):
    def isatty(self):
        return True


def slow_position(q):
    time.sleep(2e-4)
    return device.position(q)


def slow_map():
    """Some 0.5 s."""
    slow = ph.python_mechanism(2, 2, slow_position, device.jacobian)
    return slow.design_map(np.tile([0.5, 1.0], (2000, 1)), [1.0, 0.0], [0.0, -1.0])


def slow_run():
    """Some seconds of the hand's time, at least 0.2 ms for each of their cycles."""
    simulated = ph.simulated_device(device, device.brakes(), 0.5, [0.5, 1.0])
    far = ph.half_space([0, 5], [0, -1])
    slow = ph.python_mechanism(2, 2, slow_position, device.jacobian)
    control = ph.controller(slow, slow.brakes(), ph.scene(ph.wall(far)), ph.direct_control())
    hand = ph.following_hand([1, 0], simulated.position, push=0)
    return ph.follow_wall(simulated, control, far, hand, ph.wall_following_parameters(max_duration=5, path_end=1e3))


@pytest.mark.parametrize("call, of, total", [(slow_map, "places", 2000), (slow_run, "ms at most", 5_000)])
def test_a_line_on_a_terminal(monkeypatch, call, of, total):
    shown = screen()
    monkeypatch.setattr(sys, "stderr", shown)
    monkeypatch.setattr(progress, "AFTER", 0.0)
    call()
    lines = re.findall(rf"\r(\d+) of (\d+) {of}(?:, (\d+) s left)? *", shown.getvalue())
    counts = [int(done) for done, _, _ in lines]
    assert counts and counts == sorted(counts) and 0 < counts[-1] < total
    assert {int(all_of_them) for _, all_of_them, _ in lines} == {total}
    assert shown.getvalue().endswith("\n")


def test_nothing_elsewhere_or_of_short_calls(monkeypatch):
    file, shown = io.StringIO(), screen()
    monkeypatch.setattr(sys, "stderr", file)
    slow_map()
    monkeypatch.setattr(sys, "stderr", shown)
    device.design_map(np.tile([0.5, 1.0], (2000, 1)), [1.0, 0.0], [0.0, -1.0])  # takes milliseconds
    assert file.getvalue() == shown.getvalue() == ""
