"""What holds of each class: pickling, copies, equality, repr, parameters."""

import copy
import inspect
import pickle

import numpy as np
import pytest

import passive_haptics as ph
from devices import DEVICES, LAWS, OTHER_LAWS, Case
from passive_haptics import _native

SHAPES = [
    ph.half_space([0, 0.2], [0, -1]),
    ph.half_space([0, 0.2, 0.1], [0, -1, 0]),
    ph.ball([0.1, 0.2], 0.05),
    ph.ball(centre=[0, 0.1, 0.2], radius=0.1, inside="hollow"),
    ph.box([0, 0], [0.1, 0.2]),
    ph.box([0, 0, 0], [0.1, 0.2, 0.3], axes=[[0, -1, 0], [1, 0, 0], [0, 0, 1]]),
    ph.capsule([0, 0], [0.1, 0], 0.02),
    ph.capsule([0, 0, 0], [0.1, 0, 0], 0.02),
    ph.convex_polygon([[0, 0], [1, 0], [0, 1]]),
    ph.convex_polygon(np.array([[0, 0], [1, 0], [1, 1], [0.5, 1.5], [0, 1]])),
    ph.convex_polytope([{"surface_point": [0, 0], "normal": [0, -1]}, {"surface_point": [0, 0], "normal": [1, 0]}]),
    ph.offset(ph.box([0, 0], [0.1, 0.2]), 0.01),
    ph.complement(ph.capsule([0, 0, 0], [0.1, 0, 0], 0.02)),
    ph.mesh_solid(ph.mesh([[0, 0], [0.1, 0], [0, 0.1]], [[0, 1], [1, 2], [2, 0]])),
    ph.mesh_solid(ph.mesh(np.vstack([np.zeros(3), np.eye(3)]), [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])),
]

BRAKES = [
    ph.coulomb_brake(),
    ph.coulomb_brake(torque_limit=0.5, strength=0.01),
    ph.stribeck_brake(torque_limit=0.7, static_ratio=1.2),
    ph.eddy_current_brake(),
    ph.magnetorheological_brake(),
    ph.presliding_brake(presliding=1e-3),
]


def boom(q):
    return q[1] * np.array([np.cos(q[0]), np.sin(q[0])])


def values():
    """One value at least of each class that can be made or is returned."""
    yield from SHAPES
    for make in DEVICES.values():
        device = make()
        yield device
        yield device.brakes()
        yield device.brakes(torque_limit=np.linspace(0.1, 0.7, device.brake_count))
        yield device.recommended_law()
    for law in [law for law in LAWS if law != "recommended"] + OTHER_LAWS:
        yield getattr(ph, law)()
    yield ph.direct_control(velocity_dead_band=0.01)
    yield ph.velocity_direct_control(force_share=0.1)
    yield ph.scene_of_device('walls = []\n[mechanism]\ntype = "two_link"\n')
    yield ph.wall(SHAPES[0])
    yield ph.wall(SHAPES[0], 500)
    yield ph.scene(ph.wall(SHAPES[0]), ph.wall(SHAPES[2], 1e3))
    yield ph.mesh([[0, 0.5], [1, 0]], [[0, 1]])
    yield ph.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    yield ph.mesh_surface(ph.mesh([[0, 0.5], [1, 0]], [[0, 1]]))
    yield ph.mesh_surface(ph.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]), skin=1e-6, crease_angle=0.1)
    yield ph.wall(ph.mesh_surface(ph.mesh([[0, 0.5], [1, 0]], [[0, 1]])), 1e4)
    yield ph.world([ph.wall(SHAPES[0]), ph.wall(SHAPES[2], 1e3)])
    yield ph.held_scene(ph.scene(ph.wall(SHAPES[0])), 0.05)
    yield ph.held_scene(ph.world([ph.wall(SHAPES[0])]), 0.05)
    effects = [
        ph.viscous_field([[1, 0], [0, 2]]),
        ph.viscous_field(viscosity=np.eye(3)),
        ph.guide("plane", [0, 0, 0], [0, 0, 1], stiffness=10),
        ph.guide(point=[0, 0]),
        ph.detents([0, 0], [1, 0], 0.01),
        ph.end_stops(lower=[0, 0, 0]),
        ph.rough_walls(),
        ph.rough_walls(0.3),
    ]
    yield from effects
    yield ph.with_effects(ph.scene(ph.wall(SHAPES[0])), effects[0], effects[-1])
    case = Case("planar_chain_3_with_inertia", 100, 1)
    control = case.controller("direct_control")
    yield control
    yield ph.controller(case.device, case.brakes(), case.scene(), case.law("recommended"), limits="clamp_each")
    state = ph.device_state(0.5, case.q[70], case.qd[70], case.hand_force[70])
    yield state
    yield ph.device_state(0, [1, 2], [3, 4])
    yield ph.device_state(float("nan"), [0.0], [-0.0], [float("nan")])
    yield control(state)
    yield control.batch(case.q, case.qd, case.hand_force, case.time)
    yield control.batch(case.q, case.qd, case.hand_force, fields=[])
    yield case.device.displayable(case.q[70], [1, 0], [0, -1])
    for brake in BRAKES:
        yield brake
    yield ph.simulated_device(case.device, case.brakes(), 0.5, case.q[70])
    yield ph.simulated_device(ph.two_link(), [BRAKES[0], BRAKES[1]], 0, [0.5, 0.5])
    yield ph.following_hand([1, 0], [0.1, 0.2])
    yield ph.following_hand([0, 0, 1], [0.1, 0.2, 0.3], push=3)
    yield ph.wall_following_parameters(max_duration=2, noise_seed=7)
    yield ph.python_mechanism(2, 2, boom)
    yield ph.python_mechanism(dof=2, task_dimension=2, position=boom, jacobian=boom)


ALL = list(values())
NAMES = [f"{i}_{type(value).__name__}" for i, value in enumerate(ALL)]


@pytest.mark.parametrize("value", ALL, ids=NAMES)
def test_pickles_and_copies_are_equal(value):
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        again = pickle.loads(pickle.dumps(value, protocol))
        assert type(again) is type(value)
        assert again == value
        assert repr(again) == repr(value)
    assert copy.copy(value) == value
    assert copy.deepcopy(value) == value


class painted_arm(ph.tendon_two_link):
    def __init__(self, colour):
        super().__init__(length_1=0.2)
        self.colour = colour


def test_a_derived_class_keeps_its_members():
    arm = pickle.loads(pickle.dumps(painted_arm("red")))
    assert arm == painted_arm("red") and arm.colour == "red" and arm.parameters["length_1"] == 0.2


def test_different_values_are_not_equal():
    for i, a in enumerate(ALL):
        for j, b in enumerate(ALL):
            if a == b:
                assert repr(a) == repr(b)
                assert type(a) is type(b)
        assert a != i
        assert not a == "text"


@pytest.mark.parametrize("value", ALL, ids=NAMES)
def test_repr_makes_an_equal_value(value):
    text = repr(value)
    if isinstance(value, (ph.step_result, ph.batch_result, ph.displayable_force)):
        assert type(value).__name__ in text
        return
    names = {**vars(ph), "nan": float("nan"), "inf": float("inf"), "boom": boom}
    assert eval(text, names) == value


def test_every_class_is_among_them():
    bases = {ph.shape, ph.effect, ph.law, ph.mechanism, ph.brake_model}
    bases |= {ph.status, ph.power_class, ph.display_class, ph.run_end}
    others = {ph.device_description, ph.contact_metrics, ph.contact_report}
    classes = {thing for thing in vars(ph).values() if inspect.isclass(thing) and thing.__name__ in ph.__all__}
    assert classes - bases - others == {type(value) for value in ALL}


def test_parameters_are_those_of_the_tables():
    arm = ph.tendon_two_link(length_2=0.2)
    assert arm.parameters["length_2"] == 0.2
    assert arm.parameters["length_1"] == 0.15
    assert arm.parameters["reduction_2"] == 0.4
    assert repr(arm).startswith("tendon_two_link(length_1=0.15, length_2=0.2, ")
    assert "reduction_2 : float [1], default 0.4\n        A finite number > 0." in ph.tendon_two_link.__doc__
    assert inspect.signature(ph.tendon_two_link).parameters["reduction_2"].default == 0.4
    assert ph.tendon_two_link(**arm.parameters) == arm
    with pytest.raises(TypeError):
        hash(arm)
    chain = ph.planar_arm([0.1, 0.1])
    chain.parameters["joints"][1]["point"][0] = 9  # of a copy
    assert chain == ph.planar_arm([0.1, 0.1])


def test_branches_of_an_inverse():
    arm, q = ph.two_link(), [0.3, 0.9]
    back, outcome = arm.inverse(arm.position(q), "right")
    assert outcome == ph.status.ok and np.allclose(back, q, atol=1e-12)
    assert arm.inverse(arm.position(q))[0][1] < 0


def test_enumerations_have_the_texts_of_the_library():
    for kind in (ph.status, ph.power_class, ph.display_class):
        assert [member.value for member in kind] == list(range(len(kind)))
        assert "unknown" in _native.text_of(kind.__name__, len(kind))
        assert len({member.text for member in kind}) == len(kind)
        assert all(f"{member:<20}".rstrip() == str(member) == member.text for member in kind)
        assert not any("unknown" in member.text for member in kind)


def test_several_walls_are_felt_at_once():
    table = ph.xy_table()
    corner = ph.scene(ph.wall(ph.half_space([0, 0], [1, 0]), 1e3), ph.wall(ph.half_space([0, 0], [0, 1]), 1e3))
    control = ph.controller(table, table.brakes(torque_limit=[50, 50]), corner, ph.direct_control())
    result = control(ph.device_state(0, [-1e-3, -2e-3], [-0.1, -0.1], [-1, -1]))
    assert [report.wall_number for report in result.contacts] == [0, 1]
    assert np.allclose([report.wanted for report in result.contacts], [1, 2])
    assert np.allclose(result.capacity, [1, 2])
    batch = control.batch(np.array([[-1e-3, -2e-3]]), np.array([[-0.1, -0.1]]), np.array([[-1.0, -1.0]]))
    assert np.allclose(batch.capacity, [[1, 2]])


def test_a_controller_remembers_until_it_is_reset():
    case = Case("two_link", 2000, 3)
    control, fresh = (case.controller("recommended") for _ in range(2))
    states = [ph.device_state(*row) for row in zip(case.time, case.q, case.qd, case.hand_force)]
    first = [control(state) for state in states]
    control.reset()
    assert [control(state) for state in states] == first
    assert [fresh(state) for state in states] == first


def test_planar_arm():
    assert ph.planar_arm([0.1, 0.2, 0.3]).position([0, 0, 0]).tolist() == pytest.approx([0.6, 0])
    assert ph.planar_arm([0.1, 0.1, 0.1, 0.1]).dof == 4
    with pytest.raises(ValueError, match="expected 2, 3 or 4"):
        ph.planar_arm([0.1])


@pytest.mark.parametrize("name", [name for name in DEVICES if "chain" in name] + ["two_link"])
def test_nearest_pose_leads_to_the_place(name):
    device = DEVICES[name]()
    random = np.random.default_rng(8)
    for _ in range(50):
        q = random.uniform(0.2, 1.2, device.dof)
        x = device.position(q)
        found, outcome = ph.nearest_pose(device, x, q + random.uniform(-0.3, 0.3, device.dof))
        assert outcome == ph.status.ok
        assert np.allclose(device.position(found), x, atol=1e-9)
    beyond = np.full(device.task_dimension, 10.0)
    found, outcome = ph.nearest_pose(device, beyond, q)
    assert outcome == ph.status.out_of_reach and np.isfinite(found).all()
    assert ph.nearest_pose(device, beyond * np.nan, q)[1] == ph.status.state_not_finite
    with pytest.raises(ValueError, match="length of x = 1: expected"):
        ph.nearest_pose(device, [1.0], q)


@pytest.mark.parametrize("name", [name for name in DEVICES if "inertia" not in name])
def test_functions_of_many_poses_are_those_of_each(name):
    case = Case(name, 100, 9)
    device, q, qd = case.device, case.q[70:], case.qd[70:]
    velocity = case.hand_force[70:]
    found = device.displayable(q, velocity, case.normal, case.brakes())
    singly = [device.displayable(*row, case.normal, case.brakes()) for row in zip(q, velocity)]
    for field, values in zip(found._fields, zip(*singly)):
        assert np.array_equal(getattr(found, field), np.array(values), equal_nan=True)
    assert device.position(q).tolist() == [device.position(row).tolist() for row in q]
    assert device.jacobian(q).tolist() == [device.jacobian(row).tolist() for row in q]
    assert device.brake_rates(q, qd).tolist() == [device.brake_rates(*row).tolist() for row in zip(q, qd)]
    if "chain" in name:
        with pytest.raises(TypeError, match="a serial_chain has no inverse: expected nearest_pose"):
            device.inverse(device.position(q[0]))
        return
    x = np.vstack([device.position(q), np.full(device.task_dimension, 9.0)])
    back, outcomes = device.inverse(x)
    assert back.tolist() == [device.inverse(row)[0].tolist() for row in x]
    assert outcomes.tolist() == [device.inverse(row)[1] for row in x]
    assert (outcomes[-1] == ph.status.out_of_reach) == (name != "xy_table")


def test_what_no_device_has_is_a_warning():
    arm = ph.tendon_two_link()
    for call, text in (
        (lambda: ph.tendon_two_link(length_1=150), r"length_1 \[m\] = 150: expected at most"),
        (lambda: ph.device_state(0, [119.7, -82.5], [0, 0]), "q has 119.7, usually within two turns: degrees"),
        (lambda: arm.displayable([[1, 2], [119.7, -82.5]], [1, 0], [0, 1]), "q has 119.7"),
        (lambda: ph.simulated_device(arm, arm.brakes(), 0.5, [119.7, -82.5]), "q has 119.7"),
        (lambda: arm.brakes(time_constant=20), r"time_constant\[0\] \[s\] = 20"),
    ):
        with pytest.warns(UserWarning, match=text):
            call()
