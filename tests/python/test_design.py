"""Figures of a device before it is built, and runs along a wall with its simulation, are those of C++, bit for bit."""

import os
import pickle
import subprocess
import sys

import numpy as np
import pytest

import passive_haptics as ph
from devices import DEVICES, Case

REFERENCE = os.environ.get("PASSIVE_HAPTICS_PYTHON_REFERENCE")
SEED = 46
PUSH = 0.4
FIRST, SAMPLES, START = 70, 20, 100
NAMES = ["tendon_two_link", "delta", "planar_chain_3_with_inertia"]

needs_reference = pytest.mark.skipif(REFERENCE is None, reason="tests/run python names the program to compare with")


def of_cpp(case, mode, folder):
    states, results = folder / "states", folder / "results"
    case.write(states)
    subprocess.run([REFERENCE, case.name, "design", mode, states, results], check=True)
    return np.fromfile(results)


def same_bits(ours, theirs):
    ours = np.ascontiguousarray(ours, dtype=float)
    assert ours.shape == theirs.shape
    different = np.flatnonzero(ours.view(np.uint64) != theirs.view(np.uint64))
    both_nan = np.isnan(ours[different]) & np.isnan(theirs[different])
    assert both_nan.all(), f"{len(different)} of {len(ours)} numbers differ, first {different[:3]}, seed {SEED}"


@needs_reference
@pytest.mark.parametrize("name", NAMES)
def test_figures(name, tmp_path):
    case = Case(name, 3000, SEED)
    brakes = case.brakes()
    found = case.device.design_map(case.q, case.hand_force, case.normal, brakes, PUSH)
    columns = [found[field] for field in found.dtype.names]
    same_bits(np.column_stack([np.asarray(c, dtype=float) for c in columns]).ravel(), of_cpp(case, "figures", tmp_path))
    assert 0.3 < np.mean(found["outcome"] == ph.status.ok) < 1
    assert np.isfinite(found["sink_slope"]).mean() > 0.05


@needs_reference
@pytest.mark.parametrize("name", NAMES)
def test_depth(name, tmp_path):
    case = Case(name, 3000, SEED)
    path = slice(FIRST, FIRST + SAMPLES)
    # Without reversals: what is held at no slope would make all infinite
    found = case.device.sink_depth(case.q[path], case.hand_force[path], case.normal, case.brakes(), PUSH)
    same_bits([found], of_cpp(case, "depth", tmp_path))


def run_of(case, brakes):
    device = ph.simulated_device(case.device, brakes, 0.5, case.q[START])
    along = np.zeros(case.device.task_dimension)
    along[:2] = case.normal[1], -case.normal[0]
    hand = ph.following_hand(along, device.position)
    parameters = ph.wall_following_parameters(max_duration=0.5, path_end=10)
    shape = ph.half_space(case.point, case.normal)
    return ph.follow_wall(device, case.controller("direct_control"), shape, hand, parameters, record=True)


def numbers_of(metrics, rows):
    fields = ("time", "depth", "position", "brake_torque", "hand_force", "capacity", "alpha")
    samples = np.column_stack([rows[field] for field in fields])
    figures = [metrics.depth_mean, metrics.depth_std, metrics.max_depth, metrics.stick_share, metrics.hand_force_std]
    figures += [metrics.retarding_force, metrics.brake_energy, metrics.max_brake_power, metrics.duration]
    return np.concatenate([samples.ravel(), figures])


@needs_reference
@pytest.mark.parametrize("name", NAMES)
def test_runs(name, tmp_path):
    case = Case(name, 200, SEED)
    ideal = run_of(case, case.brakes())
    sticking = run_of(case, [ph.stribeck_brake(static_ratio=1.3)] * case.device.brake_count)
    same_bits(np.concatenate([numbers_of(*ideal), numbers_of(*sticking)]), of_cpp(case, "runs", tmp_path))
    metrics, rows = ideal
    assert metrics.end == ph.run_end.time_over and metrics.end.text == "time over"
    assert len(rows) == 5000
    assert set(rows["display"]) <= set(ph.display_class)


def test_runs_without_a_record_are_the_same_runs():
    case = Case("tendon_two_link", 200, SEED)
    metrics, rows = run_of(case, case.brakes())
    device = ph.simulated_device(case.device, case.brakes(), 0.5, case.q[START])
    hand = ph.following_hand([case.normal[1], -case.normal[0]], device.position)
    parameters = ph.wall_following_parameters(max_duration=0.5, path_end=10)
    shape = ph.half_space(case.point, case.normal)
    again, none = ph.follow_wall(device, case.controller("direct_control"), shape, hand, parameters)
    assert again == metrics and len(none) == 0
    assert pickle.loads(pickle.dumps(metrics)) == metrics
    assert pickle.loads(pickle.dumps(rows)).tobytes() == rows.tobytes()
    assert device.position.tolist() == rows["position"][-1].tolist()


def test_a_motion_that_is_set():
    arm = ph.two_link()
    device = ph.simulated_device(arm, arm.brakes(), 0.3, [0.4, 0.9])
    device.advance(1e-3, [0.02, 0.05], [0.5, -1])
    assert device.q.tolist() != [0.4, 0.9]
    device.set_motion([0.4, 0.9], [0, 0])
    assert device.q.tolist() == [0.4, 0.9] and device.qd.tolist() == [0, 0]
    assert device == ph.simulated_device(arm, arm.brakes(), 0.3, [0.4, 0.9])  # what it was made of


def test_maps_take_one_vector_for_all():
    for make in DEVICES.values():
        device = make()
        q = np.full((3, device.dof), 0.5)
        q[1] = 1e300
        q[2] = np.nan
        n = np.eye(device.task_dimension)[1]
        t = np.eye(device.task_dimension)[0]
        found = device.design_map(q, t, n)
        assert found.tobytes() == device.design_map(q, np.tile(t, (3, 1)), np.tile(n, (3, 1))).tobytes()
        assert found["outcome"].tolist()[1:] == [ph.status.pose_undefined, ph.status.state_not_finite]
        assert device.design_map(q[0], t, n).tobytes() == found[0].tobytes()
        assert len(device.design_map(q[:0], t, n)) == 0


@pytest.mark.parametrize("call", ["ph.follow_wall(device, control, plane, hand, parameters)",
                                  "arm.design_map(np.tile(case.q, (1000, 1)), [1.0, 0.0], [0.0, -1.0])"])  # fmt: skip
def test_long_calls_can_be_interrupted(call):
    program = f"""
import os, signal, threading
import numpy as np
import passive_haptics as ph
from devices import Case
case = Case("two_link", 10_000, 1)
arm, plane, control = case.device, ph.half_space([0, 0.2], [0, -1]), case.controller("direct_control")
device = ph.simulated_device(arm, case.brakes(), 0.5, case.q[100])
hand = ph.following_hand([1, 0], device.position)
parameters = ph.wall_following_parameters(max_duration=1e5, path_end=1e5, max_depth=1e9)
signal.signal(signal.SIGINT, signal.default_int_handler)
threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    {call}
    print("ran to its end")
except KeyboardInterrupt:
    print("interrupted")
"""
    done = subprocess.run([sys.executable, "-c", program], cwd=os.path.dirname(__file__), text=True,
                          capture_output=True, timeout=300)  # fmt: skip
    assert done.stdout.strip() == "interrupted", done.stderr

