"""Pictures of design maps and of runs along a wall: what was drawn, and that it is right."""

import numpy as np
import pytest

matplotlib = pytest.importorskip("matplotlib", reason="Debian's python3-matplotlib is not installed")
matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402

import passive_haptics as ph  # noqa: E402
from passive_haptics import map_plots, run_plots  # noqa: E402

ARM = ph.tendon_two_link()
WALL = ph.half_space([0, 0.225], [0, -1])
X, Y = np.linspace(-0.4, 0.4, 9), np.linspace(0.05, 0.35, 7)


@pytest.fixture(autouse=True)
def no_figure_is_left():
    yield
    plt.close("all")


def run(law, longest=0.3):
    device = ph.simulated_device(ARM, ARM.brakes(), 0.5, ARM.inverse([0.045, 0.221])[0])
    hand = ph.following_hand([1, 0], device.position)
    control = ph.controller(ARM, ARM.brakes(), ph.scene(ph.wall(WALL)), law)
    parameters = ph.wall_following_parameters(max_duration=longest)
    return ph.follow_wall(device, control, WALL, hand, parameters, record=True)[1]


@pytest.fixture(scope="module")
def runs():
    return {"none": run(ph.no_direct_control()), "direct": run(ph.direct_control())}


def test_a_map_has_the_figures_of_each_place():
    found = map_plots.map_over(ARM, X, Y, [1, 0], [0, -1], ARM.brakes(), push=2)
    assert found.shape == (7, 9)
    reached = 0
    for row, y in enumerate(Y):
        for column, x in enumerate(X):
            q, outcome = ARM.inverse([x, y])
            at = found[row, column]
            assert at["outcome"] == outcome
            if outcome != ph.status.ok:
                assert all(np.isnan(at[name]) for name in map_plots.PANELS)
                continue
            reached += 1
            alone = ARM.design_map(np.array([q]), [1, 0], [0, -1], ARM.brakes(), 2)[0]
            for name in map_plots.PANELS:
                assert at[name] == pytest.approx(alone[name], rel=1e-9, nan_ok=True)
    assert 20 < reached < 50


def test_a_map_is_drawn_in_four_panels():
    found = map_plots.map_over(ARM, X, Y, [1, 0], [0, -1], ARM.brakes(), push=2)
    panels = map_plots.draw_design_map(X, Y, found)
    assert len(panels) == 4
    for axes, name in zip(panels, map_plots.PANELS):
        shown = np.ma.filled(axes.collections[0].get_array(), np.nan).reshape(found.shape)
        finite = np.isfinite(found[name])
        assert np.array_equal(shown[finite], found[name][finite])
    with pytest.raises(ValueError, match=r"shape of values = \(7, 9\), expected \(len\(y\), len\(x\)\) = \(9, 7\)"):
        map_plots.draw_design_map(Y, X, found)


def test_runs_are_drawn_one_above_the_other(runs):
    panels = run_plots.draw_runs(runs)
    assert [axes.get_ylabel() for axes in panels] == ["depth [mm]", "mean alpha [1]", "brake 1 [N m]", "brake 2 [N m]", "hand [N]"]
    for line, (name, rows) in zip(panels[0].lines, runs.items()):
        assert line.get_label() == name
        assert np.array_equal(line.get_xdata(), rows["time"][:: run_plots.EVERY])
        assert np.array_equal(line.get_ydata(), 1e3 * rows["depth"][:: run_plots.EVERY])
    torque = panels[3].lines[1].get_ydata()
    assert np.array_equal(torque, np.abs(runs["direct"]["brake_torque"][:: run_plots.EVERY, 1])) and torque.max() > 0
    assert panels[2].get_ylim() == panels[3].get_ylim()
    figure = plt.figure()
    assert all(axes.figure is figure for axes in run_plots.draw_runs(runs, figure))


def test_means_are_those_of_the_latest_values():
    values = np.random.default_rng(1).uniform(size=50)
    expected = [values[max(0, k - 6) : k + 1].mean() for k in range(50)]
    assert run_plots.recent_means(values, 7) == pytest.approx(expected, abs=1e-15)
    assert run_plots.recent_means(values, 100)[-1] == pytest.approx(values.mean(), abs=1e-15)


def test_runs_without_rows_are_refused(runs):
    with pytest.raises(ValueError, match="runs = {}, expected one run or more"):
        run_plots.draw_runs({})
    with pytest.raises(ValueError, match=r"run 'none' has 0 rows, expected some; call follow_wall\(..., record=True\)"):
        run_plots.draw_runs({"none": runs["none"][:0]})
