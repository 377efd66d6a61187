"""Pictures of planar devices: what was drawn, and that it is right."""

import math
import os
import subprocess
import sys
import warnings

import numpy as np
import pytest

matplotlib = pytest.importorskip("matplotlib", reason="Debian's python3-matplotlib is not installed")
matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.colors import to_hex  # noqa: E402

import passive_haptics as ph  # noqa: E402
from devices import DEVICES, middle  # noqa: E402
from passive_haptics import plots  # noqa: E402
from passive_haptics.plots import links_of  # noqa: E402
from passive_haptics.producible_forces import passive_fmes, producible_outline  # noqa: E402

PLANAR = [name for name in DEVICES if name not in ("delta",) and not name.startswith("spatial")]
OF_TWO_BRAKES = ["tendon_two_link", "two_link", "xy_table", "five_bar"]
V = np.array([0.5, 0.2])


@pytest.fixture(autouse=True)
def no_figure_is_left():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield
    plt.close("all")


def pose(name, seed=0):
    device = DEVICES[name]()
    reach = 0.02 if name == "xy_table" else 0.2
    return device, middle(name, device.dof) + np.random.default_rng(seed).uniform(-reach, reach, device.dof)


def unit(angle):
    return np.array([math.cos(angle), math.sin(angle)])


def patches_of(axes, colour):
    return [patch for patch in axes.patches if to_hex(patch.get_facecolor()) == colour]


def area(polygon):
    x, y = np.asarray(polygon).T
    return 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))


@pytest.mark.parametrize("name", PLANAR)
@pytest.mark.parametrize("seed", range(3))
def test_producible_forces_take_energy(name, seed):
    """F . v <= 0, and a motion back has what is opposite."""
    device, q = pose(name, seed)
    for v in (V, unit(2), unit(4.5)):
        there, back = producible_outline(device, q, v), producible_outline(device, q, -v)
        size = np.abs(there).max()
        assert size > 0 and np.all(there @ v <= 1e-9 * size)
        assert np.array_equal(there[0], there[-1])
        assert area(there) == pytest.approx(area(back), rel=1e-9)


@pytest.mark.parametrize("name", OF_TWO_BRAKES)
@pytest.mark.parametrize("seed", range(3))
def test_two_brakes_make_a_parallelogram(name, seed):
    device, q = pose(name, seed)
    forces, outcome = device.reference_forces(q)
    assert outcome == ph.status.ok
    signs = device.brake_signs(q, np.linalg.solve(device.jacobian(q), V))
    torques = -np.linalg.solve(forces, producible_outline(device, q, V).T).T * signs
    assert np.all(torques >= -1e-9)
    largest = torques.max(axis=1)
    assert np.allclose(largest[largest > 1e-9], 1)  # a brake at its limit, at each point but 0
    for fme in passive_fmes(device, q):
        torques = np.linalg.solve(forces, fme.outline[1:-1].T).T
        assert np.all(torques * fme.signs >= -1e-12) and np.allclose(np.linalg.norm(torques, axis=1), 1)


@pytest.mark.parametrize("seed", range(3))
def test_redundant_brakes_make_what_their_torques_can(seed):
    """Of four brakes: each point of an outline by torques in their box, found by brute force over edges of that box."""
    device, q = pose("five_bar_with_four_brakes", seed)
    qd = np.linalg.solve(device.jacobian(q), V)
    signs = np.sign(device.brake_rates(q, qd))
    T = np.array([[1, 0], [0, 1], [1, -1], [1, 1]])
    G = np.linalg.solve(device.jacobian(q).T, T.T) * -signs  # F = G t, t in [0, 1]^4
    outline = producible_outline(device, q, V)
    corners = np.array([[i >> b & 1 for b in range(4)] for i in range(16)]) @ G.T
    for angle in np.linspace(0, 2 * math.pi, 50):  # the box's support bounds the outline's
        assert (outline @ unit(angle)).max() <= (corners @ unit(angle)).max() + 1e-9
    assert area(outline) > 0.5 * area_of_hull(corners)


def area_of_hull(points):
    """By its support in many directions."""
    angles = np.linspace(0, 2 * math.pi, 2001)[:-1]
    far = [points[np.argmax(points @ unit(angle))] for angle in angles]
    return area(far)


def nearest_force(device, q, desired):
    found = device.displayable(q, V, desired)
    return np.linalg.norm(desired) * math.cos(found.angle) ** 2 * found.nearest, found.angle


@pytest.mark.parametrize("name", OF_TWO_BRAKES)
def test_nearest_forces(name):
    device, q = pose(name)
    signs = device.brake_signs(q, np.linalg.solve(device.jacobian(q), V))
    for Fd in (np.array([0.0, -3.0]), 20 * unit(1), 0.01 * unit(3.3)):
        force, off = nearest_force(device, q, Fd)
        assert np.allclose(force, device.nearest_force(q, signs, Fd), atol=1e-9)
        assert np.linalg.norm(force) == pytest.approx(np.linalg.norm(Fd) * math.cos(off), abs=1e-9)


@pytest.mark.parametrize("name", PLANAR)
def test_passive_fmes_are_drawn(name):
    device, q = pose(name)
    fmes = passive_fmes(device, q)
    axes = plots.draw_passive_fmes(device, q)
    assert [to_hex(line.get_color()) for line in axes.lines].count(plots.PALE) == len(fmes)
    assert axes.get_xlabel() == "$F_x$ [N]" and axes.get_ylabel() == "$F_y$ [N]" and axes.get_aspect() == 1
    reach = max(np.abs(fme.outline).max() for fme in fmes)
    assert np.allclose([*axes.get_xlim(), *axes.get_ylim()], 1.15 * reach * np.array([-1, 1, -1, 1]))
    names = {text.get_text() for text in axes.texts}
    quarters = {"(+, +)", f"(+, {plots.MINUS})", f"({plots.MINUS}, +)", f"({plots.MINUS}, {plots.MINUS})"}
    assert names == (quarters if name in OF_TWO_BRAKES else set())
    assert axes.get_legend() is None and not axes.patches


@pytest.mark.parametrize("name", PLANAR)
def test_a_wall_and_forces_are_drawn(name, tmp_path):
    device, q = pose(name)
    own = plt.subplots()[1]
    axes = plots.draw_passive_fmes(device, q, own, velocity=V, normal=[0, -2], desired_force=[0, -300])
    assert axes is own
    (wall,) = patches_of(axes, plots.GROUND)
    reach = axes.get_xlim()[1]
    assert wall.get_xy()[:, 1].min() == pytest.approx(0, abs=1e-9)
    (made,) = patches_of(axes, plots.PRODUCIBLE)
    assert np.all(made.get_xy() @ V <= 1e-9 * reach)
    labels = [text.get_text() for text in axes.get_legend().get_texts()]
    assert labels[:2] == ["motion", "$F_d$ 300 N"]
    nearest, off = nearest_force(device, q, [0, -300])
    assert labels[2] == f"nearest {np.linalg.norm(nearest):.3g} N, {math.degrees(off):.0f}° off"
    arrows = [line for line in axes.lines if line.get_label() in labels]
    motion, desired, displayed = (np.array(arrow.get_xydata()[1]) for arrow in arrows)
    assert np.allclose(motion / np.linalg.norm(motion), V / np.linalg.norm(V))
    assert np.allclose(desired, [0, -plots.LONGEST_ARROW * reach])
    assert np.allclose(displayed, nearest * np.linalg.norm(desired) / 300)
    axes.figure.savefig(tmp_path / "picture.png")
    assert (tmp_path / "picture.png").stat().st_size > 10_000


def test_a_force_that_cannot_be_made_is_named():
    table = ph.xy_table()
    axes = plots.draw_passive_fmes(table, [0, 0], velocity=[1, 1], desired_force=[1, 1])
    assert [text.get_text() for text in axes.get_legend().get_texts()][2] == "no force is near"
    axes = plots.draw_passive_fmes(table, [0, 0], velocity=[1, 0])  # brake 2 rests: it holds either way
    assert len(patches_of(axes, plots.PRODUCIBLE)) == 2


@pytest.mark.parametrize("q", [[0.3, 0], [0.3, 1e-9], [0.3, math.pi], [0, 0]])
def test_singular_poses_are_drawn(q):
    axes = plots.draw_passive_fmes(ph.tendon_two_link(), q, velocity=V, normal=[0, -1], desired_force=[0, -3])
    assert 1 < axes.get_xlim()[1] < 1e3
    axes.figure.canvas.draw()


@pytest.mark.parametrize("name", PLANAR)
@pytest.mark.parametrize("seed", range(5))
def test_links_end_where_the_device_says(name, seed):
    device, q = pose(name, seed)
    lines = links_of(device, q)
    assert np.allclose([line[-1] for line in lines], device.position(q))
    lengths = [float(np.linalg.norm(d)) for line in lines for d in np.diff(line, axis=0)]
    expected = {
        "xy_table": np.abs(q),
        "five_bar": [0.063, 0.075] * 2,
        "five_bar_with_four_brakes": [0.063, 0.075] * 2,
    }.get(name, [0.15, 0.15] if "link" in name else [0.1] * device.dof)
    assert np.allclose(lengths, expected)


@pytest.mark.parametrize("seed", range(5))
def test_chains_with_slides_end_at_their_handle(seed):
    random = np.random.default_rng(seed)
    joints = [
        {"kind": "revolute", "point": random.uniform(-1, 1, 2)},
        {"kind": "prismatic", "axis": random.uniform(-1, 1, 2)},
        {"kind": "revolute", "point": random.uniform(-1, 1, 2)},
        {"kind": "revolute", "point": random.uniform(-1, 1, 2)},
    ]
    chain = ph.serial_chain(joints=joints, handle=random.uniform(-1, 1, 2))
    q = random.uniform(-2, 2, 4)
    (line,) = links_of(chain, q)
    assert np.allclose(line[0], joints[0]["point"])
    # A joint's place is the handle of a chain that ends there
    shorter = ph.serial_chain(joints=joints, handle=joints[3]["point"])
    assert np.allclose(line[3], shorter.position(q))
    assert np.allclose(np.linalg.norm(line[3] - line[2]),
                       np.linalg.norm(joints[3]["point"] - joints[2]["point"]))  # fmt: skip


@pytest.mark.parametrize("name", PLANAR)
def test_devices_are_drawn_to_scale(name):
    device, q = pose(name)
    lines = links_of(device, q)
    axes = plots.draw_device(device, q)
    assert len(axes.lines) == 3 * len(lines) + 1
    assert axes.get_aspect() == 1 and axes.get_xlabel() == "x [m]" and axes.get_ylabel() == "y [m]"
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    points = np.concatenate(lines)
    assert np.all((left, low) < points.min(axis=0)) and np.all(points.max(axis=0) < (right, high))
    again = plots.draw_device(device, q + (0.01 if name == "xy_table" else 0.3), axes, colour=plots.MUTED)
    assert again is axes and axes.get_xlim()[0] <= left and axes.get_ylim()[1] >= high


def test_a_wall_fills_the_picture_behind_its_surface():
    axes = plots.draw_device(*pose("two_link"))
    axes.set(xlim=(-1, 1), ylim=(-1, 1))
    for point, normal in [([0, 0], [0, -1]), ([0, 0.5], [0, -3]), ([0.5, 0.5], [-1, -1]), ([9, 0], [1, 0])]:
        assert plots.draw_wall(axes, point, normal) is axes
        wall = axes.patches[-1]
        places = np.random.default_rng(1).uniform(-1, 1, (100, 2))
        inside = wall.get_path().contains_points(places, wall.get_patch_transform())
        assert np.array_equal(inside, (places - point) @ np.array(normal) < 0)
        assert axes.get_xlim() == (-1, 1) and axes.get_ylim() == (-1, 1)


def test_guide_draws_its_pictures(tmp_path):
    program = os.path.join(os.path.dirname(__file__), "..", "..", "docs", "guide", "pictures.py")
    run = subprocess.run([sys.executable, program, "--output", tmp_path], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert all((tmp_path / name).stat().st_size > 20_000 for name in ("device.png", "map.png", "design_map.png", "runs.png"))


def test_what_cannot_be_drawn_is_refused():
    arm = ph.two_link()
    for draw in (plots.draw_passive_fmes, plots.draw_device):
        with pytest.raises(ValueError, match="device = delta: "):
            draw(ph.delta(), [0.5, 0.5, 0.5])
    with pytest.raises(ValueError, match=r"velocity = \[0.0, 0.0\]: expected two finite numbers, not both 0"):
        plots.draw_passive_fmes(arm, [0.7, 0.8], velocity=[0, 0])
    with pytest.raises(ValueError, match="normal = .*nan"):
        plots.draw_passive_fmes(arm, [0.7, 0.8], normal=[0, math.nan])
    with pytest.raises(ValueError, match="expected a pose that the device can take"):
        plots.draw_device(arm, [math.nan, 0])
    for force in ([math.inf, 0], [0, 0], [1, 2, 3]):
        with pytest.raises(ValueError, match="desired_force = "):
            plots.draw_passive_fmes(arm, [0.7, 0.8], velocity=V, desired_force=force)
    for draw in (plots.draw_passive_fmes, plots.draw_device):
        with pytest.raises(ValueError, match="expected a pose that the device can take"):
            draw(ph.five_bar(), [math.pi, 0.0])
