"""A device of a device file is what its parts are."""

import os

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
    assert device.scene == ph.held_scene(ph.world([wall]), 0.05) and device.has_force_sensor


def test_an_error_names_file_and_line(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text('[mechanism]\ntype = "five_bra"\n')
    with pytest.raises(ValueError, match='mine.toml:2: mechanism.type = .five_bra.*did you mean "five_bar"'):
        ph.load(path)


def test_a_wall_that_moves_is_in_cpp_only(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text('[[walls]]\ntype = "half_space"\n[walls.motion]\nbelt_velocity = [0.1, 0]\n')
    with pytest.raises(ValueError, match="mine.toml: a wall has a motion, expected walls that stay"):
        ph.load(path)


def test_chains_and_shapes_of_shapes(tmp_path):
    path = tmp_path / "chain.toml"
    joints = "".join(f"[[mechanism.joints]]\npoint = [{sum([0.1] * i)}, 0]\n" for i in range(3))
    path.write_text(
        f'[mechanism]\ntype = "planar_chain_3"\nhandle = [0.30000000000000004, 0]\n{joints}[[walls]]\ntype = "offset"\ngrowth = 0.01\n'
        '[walls.of]\ntype = "ball"\ncentre = [0, 0.3]\nradius = 0.1\n'
    )
    device = ph.load(path)
    assert device.mechanism == ph.planar_arm([0.1, 0.1, 0.1])
    assert device.scene == ph.world([ph.wall(ph.offset(ph.ball([0, 0.3], 0.1), 0.01), 1e7)])
    assert device.law == device.mechanism.recommended_law(device.brakes)
