"""A device of a device file is what its parts are."""

import os
import pickle

import numpy as np
import pytest

import passive_haptics as ph

DEVICES = os.path.join(os.path.dirname(__file__), "..", "..", "examples", "catalogue", "devices")
MIDDLE = {"paper.toml": [1.8, -1.2], "five_bar.toml": [2.0, 1.1], "delta.toml": [0.5, 0.5, 0.5]}


@pytest.mark.parametrize("name", MIDDLE)
def test_the_files_of_the_library(name):
    device = ph.load(os.path.join(DEVICES, name))
    control, q = device.controller(), np.array(MIDDLE[name])
    made = ph.controller(device.mechanism, device.brakes, device.scene, device.law, **device.options)
    random = np.random.default_rng(1)
    states = q + random.uniform(-0.4, 0.4, (300, len(q)))
    rates, forces = random.uniform(-1, 1, (300, len(q))), random.uniform(-3, 3, (300, len(q)))
    assert control.batch(states, rates, forces) == made.batch(states, rates, forces)
    plant = device.plant(q)
    plant.advance(1e-4, np.zeros(device.mechanism.brake_count), np.ones(device.mechanism.task_dimension))
    assert np.isfinite(plant.position).all()
    assert len(device.brake_models) in (0, device.mechanism.brake_count)


def test_the_paper_s_device():
    device = ph.load(os.path.join(DEVICES, "paper.toml"))
    assert device.mechanism == ph.tendon_two_link() and device.law == ph.direct_control()
    assert device.brakes == device.mechanism.brakes(torque_limit=1, time_constant=0.02)
    wall = ph.wall(ph.half_space([0, 0.225], [0, -1]), 1e7)
    held = ph.controller(device.mechanism, device.brakes, ph.held_scene(ph.world([wall]), 0.05), device.law)
    q, rates = [1.8, -1.2] + np.random.default_rng(1).uniform(-0.4, 0.4, (2, 300, 2))
    assert device.controller().batch(q, rates, 3 * rates) == held.batch(q, rates, 3 * rates)
    assert device.has_force_sensor


@pytest.mark.parametrize("text, expected", [
    ('[mechanism]\ntype = "five_bra"\n', 'mine.toml:2: mechanism.type = .five_bra.*did you mean "five_bar"'),
    ("[mechanism]\nlenght_1 = 0.2\n", "mine.toml:2: unknown key 'mechanism.lenght_1': expected .*did you mean \"length_1\""),
    ("[laww]\n", "mine.toml:1: unknown key 'laww': expected .*did you mean \"law\""),
])  # fmt: skip
def test_an_error_names_file_and_line(tmp_path, text, expected):
    path = tmp_path / "mine.toml"
    path.write_text(text)
    with pytest.raises(ValueError, match=expected):
        ph.load(path)


@pytest.mark.parametrize("name", ["comedi", "serial", "simulated", "xy_table"])
def test_keys_of_the_driver_are_ignored(name):
    assert ph.load(os.path.join(DEVICES, "..", "..", "brake_driver", f"{name}.toml")).mechanism.dof == 2


PLANE = '[[walls]]\ntype = "half_space"\nsurface_point = [0, 0.225]\nnormal = [0, -1]\nstiffness = 1e4\n'
FIELD = '[mechanism]\ntype = "delta"\n[[walls]]\ntype = "height_field"\nfile = "heights.txt"\nspacing_x = 1\nspacing_y = 1\n'


def capacities(device, q):
    """At a pose under a push of 2 N along the last axis, after a quarter and three quarters of a second."""
    d = device.mechanism.task_dimension
    control, rates = device.controller(), np.full(len(q), 0.05)
    return [control(ph.device_state(time, q, rates, [0.0] * (d - 1) + [2.0])).capacity.tolist() for time in (0.25, 0.75)]


def test_a_wall_that_moves(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text(PLANE + "[walls.motion]\namplitude = [0, 0.05]\nfrequency = 1\n")
    device = ph.load(path)
    q = device.mechanism.inverse([0.1, 0.23])[0]
    while_it_is_away, when_it_is_back = capacities(device, q)
    assert while_it_is_away == [0, 0] and max(when_it_is_back) > 0


def test_a_height_field(tmp_path):
    path = tmp_path / "mine.toml"
    (tmp_path / "heights.txt").write_text("0 0\n0 0\n")
    path.write_text(FIELD + "origin = [-0.5, -0.5, -0.1]\n")
    device = ph.load(path)
    control, arm = device.controller(), device.mechanism
    over, under = (arm.inverse([0.01, 0.02, z])[0] for z in (-0.099, -0.101))
    assert control(ph.device_state(0, over, [0.1] * 3, [0, 0, -2])).capacity.tolist() == [0, 0, 0]
    assert control(ph.device_state(1e-3, under, [0.1] * 3, [0, 0, -2])).wall_number == 0


def test_effects_without_a_wall(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text('walls = []\n[[effects]]\ntype = "viscous_field"\nviscosity = [[10, 0], [0, 20]]\n')
    device = ph.load(path)
    assert min(capacities(device, [0.7, 0.8])[0]) > 0
    again = pickle.loads(pickle.dumps(device))
    assert again == device and capacities(again, [0.7, 0.8]) == capacities(device, [0.7, 0.8])
    with pytest.raises(TypeError, match="scene has effects: expected one without"):
        ph.held_scene(device.scene, 0.1)


def test_chains_and_shapes_of_shapes(tmp_path):
    path = tmp_path / "chain.toml"
    joints = "".join(f"[[mechanism.joints]]\npoint = [{sum([0.1] * i)}, 0]\n" for i in range(3))
    path.write_text(
        f'[mechanism]\ntype = "planar_chain_3"\nhandle = [0.30000000000000004, 0]\n{joints}[[walls]]\ntype = "offset"\ngrowth = 0.01\n'
        '[walls.of]\ntype = "ball"\ncentre = [0, 0.3]\nradius = 0.1\n'
    )
    device = ph.load(path)
    assert device.mechanism == ph.planar_arm([0.1, 0.1, 0.1])
    scene = ph.world([ph.wall(ph.offset(ph.ball([0, 0.3], 0.1), 0.01), 1e7)])
    made = ph.controller(device.mechanism, device.brakes, scene, device.law)
    q, rates = np.random.default_rng(1).uniform(-1, 1, (2, 300, 3)) + [[[1.0, 1.0, 0.5]], [[0.0, 0.0, 0.0]]]
    assert device.controller().batch(q, rates, rates[:, :2]) == made.batch(q, rates, rates[:, :2])
    assert device.law == device.mechanism.recommended_law(device.brakes)


def test_a_chain_of_a_urdf():
    urdf = os.path.join(os.path.dirname(__file__), "..", "..", "docs", "guide", "seven_joint_arm.urdf")
    try:
        arm = ph.chain_from_urdf(urdf, "base", "handle", tool=[0, 0, 0.1])
    except RuntimeError as error:
        assert "liburdfdom-dev" in str(error)  # of a package that is built without it
        return
    assert [link["mass"] for link in arm.parameters["links"]] == [0.6, 0.5, 0.4, 0.4, 0.3, 0.2, 0.1]
    assert arm.position(np.zeros(7)) == pytest.approx([0.03, 0, 0.76], abs=1e-15)
    with pytest.raises(ValueError, match="seven_joint_arm.urdf: tip_link = 'handel': expected one of its links: 'base', 'handle'"):
        ph.chain_from_urdf(urdf, "base", "handel")
