"""A mechanism of Python functions does what the same mechanism of C++ does, and lets out what goes wrong in them."""

import functools
import pickle
import threading

import numpy as np
import pytest

import passive_haptics as ph
from devices import DEVICES, Case

LINK = 0.15  # [m]
CHAINS = ["planar_chain_3", "planar_chain_4", "spatial_chain_3", "spatial_chain_6", "spatial_chain_7"]
HEAVY = ["two_link", "planar_chain_3_with_inertia"]


def position(q):
    return [LINK * (np.cos(q[0]) + np.cos(q[0] + q[1])), LINK * (np.sin(q[0]) + np.sin(q[0] + q[1]))]


def jacobian(q):
    x, y = position(q)
    return [[-y, -LINK * np.sin(q[0] + q[1])], [x, LINK * np.cos(q[0] + q[1])]]


def arm(**functions):
    return ph.python_mechanism(**{"dof": 2, "task_dimension": 2, "position": position, "jacobian": jacobian, **functions})


def of_device(device, **functions):
    """A mechanism whose functions are those of a compiled one."""
    return ph.python_mechanism(device.dof, device.task_dimension, device.position, device.jacobian, **functions)


def states_of(case, count=200):
    return [ph.device_state(*row) for row in zip(case.time[:count], case.q, case.qd, case.hand_force)]


def controllers_of(case, mine, law):
    return [ph.controller(device, case.brakes(), case.scene(), law) for device in (case.device, mine)]


@pytest.mark.parametrize("name", CHAINS)
def test_cycles_and_batches_have_the_bits_of_cpp(name):
    case, law = Case(name, 300, 3), ph.on_off_control() if name == "planar_chain_4" else ph.direct_control()
    mine = of_device(case.device)
    compiled, written = controllers_of(case, mine, law)
    assert [written(state) for state in states_of(case)] == [compiled(state) for state in states_of(case)]
    columns = case.q, case.qd, case.hand_force, case.time
    assert written.batch(*columns) == compiled.batch(*columns)
    assert mine.recommended_law() == case.device.recommended_law()
    assert mine.brakes(torque_limit=case.torque_limit) == case.brakes()


def test_what_it_displays_is_what_cpp_displays():
    """Of two joints J^-T is found from J, so that bits may differ."""
    compiled, mine = ph.two_link(), arm()
    random = np.random.default_rng(4)
    for q in random.uniform([-1, 0.3], [1, 2], (20, 2)):
        assert np.allclose(mine.position(q), compiled.position(q), rtol=0, atol=1e-15)
        assert np.allclose(arm(jacobian=None).jacobian(q), compiled.jacobian(q), rtol=0, atol=1e-9)
        forces, outcome = mine.reference_forces(q)
        assert outcome == ph.status.ok and np.allclose(forces, compiled.reference_forces(q)[0], rtol=1e-12)
        found = mine.displayable(q, [0.1, 0.02], [0, -1])
        assert np.isclose(found.angle, compiled.displayable(q, [0.1, 0.02], [0, -1]).angle)
        slopes = [of.design_map([q], [1, 0], [0, -1])["sink_slope"] for of in (mine, compiled)]
        assert np.isclose(*slopes)
    places = random.uniform([-1, 0.3], [1, 2], (50, 2))
    ours, theirs = (device.design_map(places, [1.0, 0.0], [0.0, -1.0]) for device in (mine, compiled))
    assert (ours["display"] == theirs["display"]).all() and np.isfinite(ours["drag"]).mean() > 0.5
    assert np.allclose(ours["drag"], theirs["drag"], rtol=1e-9, equal_nan=True)
    assert mine.reference_forces([0.3, 0])[1] == compiled.reference_forces([0.3, 0])[1] == ph.status.singular_jacobian
    assert len(mine.passive_fme([0.3, 1])) == 4


@pytest.mark.parametrize("name", HEAVY)
def test_simulations_with_inertia(name):
    """The dynamics by finite differences of a mechanism that knows none: one link's mass at the handle."""
    case = Case(name, 300, 5)
    device, mass = case.device, 0.4

    def mass_matrix(q):
        J = device.jacobian(q)
        return mass * J.T @ J + 1e-3 * np.eye(device.dof)

    def bias_acceleration(q, qd):
        step = 1e-6
        return (device.jacobian(q + step * qd) - device.jacobian(q - step * qd)) @ qd / (2 * step)

    def bias_torque(q, qd):
        return mass * device.jacobian(q).T @ bias_acceleration(q, qd)

    mine = of_device(device, mass_matrix=mass_matrix, bias_torque=bias_torque, bias_acceleration=bias_acceleration)
    assert mine.recommended_law() == ph.velocity_direct_control()
    simulated = ph.simulated_device(mine, mine.brakes(), 0.3, case.q[100])
    for _ in range(500):
        simulated.advance(1e-4, [0.02] * mine.brake_count, [0.5, -1])
    assert np.isfinite(simulated.position).all()
    control = ph.controller(mine, case.brakes(), case.scene(), mine.recommended_law())
    hand = ph.following_hand([case.normal[1], -case.normal[0]], mine.position(case.q[100]))
    simulated = ph.simulated_device(mine, case.brakes(), 0.5, case.q[100])
    shape = ph.half_space(case.point, case.normal)
    metrics, rows = ph.follow_wall(simulated, control, shape, hand, ph.wall_following_parameters(max_duration=0.05), record=True)
    assert metrics.end == ph.run_end.time_over and len(rows) == 500 and np.isfinite(rows["position"]).all()


class surprise(Exception):
    pass


def failing(after):
    """A function that fails at its call after so many others."""
    calls = iter(range(10**9))

    def f(q):
        if next(calls) >= after:
            raise surprise("here")
        return position(q)

    return f


def test_exceptions_come_out_as_they_are():
    case = Case("two_link", 2000, 6)
    for after in (0, 1):
        mine = arm(position=failing(after))
        control = ph.controller(mine, case.brakes(), case.scene(), ph.direct_control())
        with pytest.raises(surprise, match="here"):
            for state in states_of(case):
                control(state)
    control = ph.controller(arm(position=failing(1000)), case.brakes(), case.scene(), ph.direct_control())
    with pytest.raises(surprise, match="here"):
        control.batch(case.q, case.qd, case.hand_force)
    for call in (
        lambda m: m.position([0, 1]), lambda m: m.design_map(case.q, [1.0, 0.0], [0.0, -1.0]),
        lambda m: m.displayable([0, 1], [1, 0], [0, 1]), lambda m: m.reference_forces([0, 1]),
    ):  # fmt: skip
        with pytest.raises(surprise, match="here"):
            call(arm(position=failing(0), jacobian=failing(0)))
    ours = arm(position=failing(10), check=False)
    assert [ours.position([0, 1]).shape for _ in range(10)] == [(2,)] * 10


def test_nan_ends_a_cycle_with_a_status():
    case = Case("two_link", 300, 7)
    state = states_of(case)[100]
    for bad in (np.nan, np.inf, -np.inf):
        control = ph.controller(arm(position=lambda q: [bad, 0.0]), case.brakes(), case.scene(), ph.direct_control())
        result = control(state)
        assert result.outcome != ph.status.ok and result.capacity.tolist() == [0, 0]
        deep = ph.scene(ph.wall(ph.half_space(case.point + 0.5 * case.normal, case.normal)))
        control = ph.controller(arm(jacobian=lambda q: np.full((2, 2), bad)), case.brakes(), deep, ph.direct_control())
        result = control(state)
        assert result.outcome != ph.status.ok and result.capacity.tolist() == [0, 0]


def test_a_jacobian_that_is_no_derivative_is_an_error_wherever_it_is_first_used():
    case = Case("two_link", 300, 12)
    free = ph.scene(ph.wall(ph.half_space(case.point - 9 * case.normal, case.normal)))
    state = states_of(case)[150]

    def control(device, scene):
        return ph.controller(device, case.brakes(), scene, ph.direct_control())

    for call in (
        lambda m: control(m, free)(state), lambda m: control(m, free).batch(case.q, case.qd, case.hand_force),
        lambda m: m.jacobian(state.q), lambda m: m.displayable(state.q, [1, 0], [0, 1]),
    ):  # fmt: skip
        wrong = {"jacobian": lambda q: np.transpose(jacobian(q))}
        mine = arm(**wrong)
        for _ in range(2):
            with pytest.raises(ValueError, match=r"jacobian\(q\)\[1\]\[0\] = .*, the slope of position\(q\)\[1\] over q\[0\]"):
                call(mine)
        call(arm(**wrong, check=False))
    slightly = [[1, 1], [1, 1 + 9e-5]]
    control(arm(jacobian=lambda q: np.multiply(jacobian(q), slightly)), free)(state)


def test_threads_share_one():
    case = Case("two_link", 500, 8)
    control = ph.controller(arm(), case.brakes(), case.scene(), ph.direct_control())
    expected = control.batch(case.q, case.qd, case.hand_force)
    results = []
    threads = [
        threading.Thread(target=lambda: results.append(control.batch(case.q, case.qd, case.hand_force))) for _ in range(3)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 3 and all(result == expected for result in results)


def test_a_function_cannot_call_its_controller():
    case = Case("two_link", 300, 10)
    state, calls = states_of(case)[150], []

    def again(q):
        calls.append(q)
        control.reset() if len(calls) == 1 else control(state)
        return position(q)

    mine = arm(position=again)
    control = ph.controller(mine, case.brakes(), case.scene(), ph.direct_control())
    for _ in range(2):
        with pytest.raises(ValueError, match="called while a function of its mechanism runs: expected one call"):
            control(state)
    assert len(calls) == 2


def test_a_function_cannot_resize_arrays_of_its_batch():
    case = Case("two_link", 300, 11)
    q, rest = np.full((1000, 2), 0.7), np.zeros((1000, 2))

    def resizing(x):
        q.resize((0, 2), refcheck=False)
        return position(x)

    control = ph.controller(arm(position=resizing), case.brakes(), case.scene(), ph.direct_control())
    with pytest.raises(ValueError, match="cannot resize an array that references or is referenced"):
        control.batch(q, rest, rest)


def test_it_pickles_if_its_functions_do():
    mine = arm()
    assert pickle.loads(pickle.dumps(mine)) == mine and mine != arm(jacobian=None)
    assert pickle.loads(pickle.dumps(arm(position=functools.partial(position)))).position([0, 1]).shape == (2,)
    case = Case("two_link", 300, 9)
    control = ph.controller(mine, case.brakes(), case.scene(), ph.direct_control())
    state = states_of(case)[150]
    assert pickle.loads(pickle.dumps(control))(state) == control(state)


def heavy(**functions):
    """Two slides of 1 kg."""
    inertia = {"mass_matrix": np.eye(2), "bias_torque": [0, 0], "bias_acceleration": [0, 0], **functions}
    constants = {name: lambda *q, value=value: value for name, value in inertia.items()}
    return ph.python_mechanism(2, 2, lambda q: q, **constants)


def still(mechanism):
    return ph.simulated_device(mechanism, mechanism.brakes(), 0.5, [0, 1])


INERTIA = {"mass_matrix": position, "bias_torque": position, "bias_acceleration": position}
case = Case("two_link", 100, 1)
MISUSES = [
    (lambda: arm(position=3), TypeError, "position = 3 (int): expected a function of q"),
    (lambda: arm(bias_torque=[1]), TypeError, "bias_torque = [1] (list): expected a function of q and qd"),
    (lambda: arm(dof=2.0), TypeError, "dof = 2.0 (float): expected a whole number"),
    (lambda: arm(dof=5), ValueError, "dof = 5 and task_dimension = 2: expected 2 and 2, 3 and 2, 4 and 2, 3 and 3"),
    (lambda: arm(inverse=position), TypeError, "has no parameter 'inverse': expected dof, task_dimension, position"),
    (lambda: arm(mass_matrix=position), TypeError, "mass_matrix, bias_torque, bias_acceleration: expected all three or none"),
    (lambda: arm(position=lambda q: [1, 2, 3]).position([0, 1]), ValueError, "length of position(q) = 3: expected 2"),
    (lambda: arm(position=lambda q: None).position([0, 1]), TypeError, "position(q) = None (NoneType): expected"),
    (lambda: arm(jacobian=lambda q: np.zeros((2, 3))).jacobian([0, 1]), ValueError,
     "shape of jacobian(q) = (2, 3): expected (2, 2)"),
    (lambda: arm(jacobian=lambda q: [["a", 1]] * 2).jacobian([0, 1]), TypeError, "jacobian(q) has dtype <U"),
    (lambda: arm(**{**INERTIA, "mass_matrix": lambda q: np.eye(3)}), None, ""),
    (lambda: ph.controller(arm(), case.brakes(), case.scene(), ph.velocity_direct_control()), TypeError, "law = velocity_direct_control: expected another law: it needs the mechan"),
    (lambda: ph.simulated_device(arm(), case.brakes(), 0.5, [0, 1]), TypeError, "simulated_device needs a mechanism with inertia"),
    (lambda: ph.simulated_device(arm(**{**INERTIA, "mass_matrix": lambda q: np.eye(3)}), case.brakes(), 0.5, [0, 1]),
     ValueError, "shape of mass_matrix(q) = (3, 3): expected (2, 2)"),
    (lambda: still(heavy(mass_matrix=-np.eye(2))), ValueError, "(numpy.ndarray): expected a symmetric matrix, positive definite"),
    (lambda: still(heavy(mass_matrix=[[1, 0.5], [0, 1]])), ValueError,
     "mass_matrix(q) = [[1, 0.5], [0, 1]] (list): expected a symmetric matrix, positive definite"),
    (lambda: heavy().jacobian([0, 1]), None, ""),
    (lambda: ph.simulated_device(heavy(bias_torque=[0]), heavy().brakes(), 0.5, [0, 1]).advance(1e-3, [0, 0], [0, 0]),
     ValueError, "length of bias_torque(q, qd) = 1: expected 2"),
    (lambda: arm().brakes(torque_limit=[1, 1, 1]), ValueError, "length of torque_limit = 3: expected 2"),
    (lambda: ph.controller(arm(position=lambda q: [1]), case.brakes(), case.scene(), ph.direct_control())(states_of(case)[80]),
     ValueError, "length of position(q) = 1: expected 2"),
]  # fmt: skip


@pytest.mark.parametrize("call, error, text", MISUSES, ids=range(len(MISUSES)))
def test_misuses(call, error, text):
    if error is None:
        call()
        return
    with pytest.raises(error) as caught:
        call()
    assert text in str(caught.value)
