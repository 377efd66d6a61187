"""The design study: what it counts, that it improves each device, and that its program draws."""

import importlib.util
import math
import os
import subprocess
import sys

import numpy as np
import pytest

pytest.importorskip("scipy", reason="Debian's python3-scipy is not installed")
pytest.importorskip("matplotlib", reason="Debian's python3-matplotlib is not installed")

import passive_haptics as ph  # noqa: E402

PROGRAM = os.path.join(os.path.dirname(__file__), "..", "..", "examples", "python", "design.py")
SPEC = importlib.util.spec_from_file_location("design_study", PROGRAM)
study = importlib.util.module_from_spec(SPEC)
sys.modules["design_study"] = study
SPEC.loader.exec_module(study)
DISC = study.around_a_disc()


@pytest.mark.parametrize("of", study.DESIGNS, ids=lambda of: of.name)
def test_poses_put_the_handle_at_the_places(of):
    x = DISC.x - np.array(of.start[-2:])
    device, q, reached = of.at(of.start, x)
    assert reached.all() and np.allclose(device.position(q), x, rtol=0, atol=1e-12)


@pytest.mark.parametrize("of", study.DESIGNS, ids=lambda of: of.name)
def test_a_few_rounds_improve_each_device(of):
    numbers = study.improved(of, DISC, 3)
    assert numbers == study.improved(of, DISC, 3)
    assert all(low <= number <= high for number, (low, high) in zip(numbers, of.bounds))
    assert study.cost_of(of, numbers, DISC) < study.cost_of(of, of.start, DISC) < study.WORST / 2


def test_costs_are_those_of_drag_and_sinking():
    costs = study.costs_of(np.array([0, 1, 3, math.inf, math.nan]), np.array([0, 0, 1, math.inf, math.nan]))
    assert costs.tolist() == [0, 0.5, 0.75 + 0.5, 2, 2]


def test_a_place_beyond_its_reach_costs_most():
    of = study.DESIGNS[0]
    far_away = study.task("far away", np.array([[0, 0.15], [1, 1]]), np.array([[1.0, 0], [1, 0]]), np.array([[0, -1.0], [0, -1]]))
    costs = study.costs_of(*study.figures_of(of, of.start, far_away))
    assert costs[1] == study.WORST and costs[0] < 1


def test_figures_are_those_of_the_device_where_its_base_is():
    of = study.DESIGNS[0]
    moved = (*of.start[:-2], 0.03, -0.02)
    shifted = DISC._replace(x=DISC.x - [0.03, -0.02])
    ours, theirs = study.figures_of(of, moved, DISC), study.figures_of(of, of.start, shifted)
    assert np.array_equal(ours, theirs, equal_nan=True)


def test_the_program_judges_the_papers_reduction(tmp_path):
    run = subprocess.run(
        [sys.executable, PROGRAM, "--rounds", "2", "--output", tmp_path], capture_output=True, text=True, check=True
    )
    for of in study.DESIGNS:
        assert f"{of.name}: cost " in run.stdout
    assert "the paper's wall: cost 0.74 with k2 = 0.4, 0.46 with k2 = 1.20\n" in run.stdout
    assert "around a disc: cost 0.52 with k2 = 0.4, 0.52 with k2 = 0.57\n" in run.stdout
    assert (tmp_path / "design.png").stat().st_size > 20_000
    assert ph.tendon_two_link().parameters["reduction_2"] == study.PAPERS_K2
