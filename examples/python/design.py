"""Improves three planar devices for a task: their links, their base, and the reduction k2 of the paper's
device.

The cost is known before a device is built: the depth to which a hand sinks where the brakes do not hold it,
and the drag of the brakes where they do. It needs neither a law nor a simulation. docs/guide/design.md shows
the results.
"""

from __future__ import annotations

import argparse
import math
import os
import typing
from collections.abc import Callable, Sequence

import matplotlib  # type: ignore[import]

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # type: ignore[import]
import numpy as np
from scipy.optimize import differential_evolution  # type: ignore[import]

import passive_haptics as ph
from passive_haptics import plots
from passive_haptics.arrays import Array

PUSH = 2.0  # of the hand, into the wall [N]
TORQUE_LIMIT = 1.0  # of each brake [N m]
SEED = 20040627
WORST = 2.0  # the cost of a place that the device does not reach, or where its brakes hold nothing
PAPERS_K2 = 0.4


class task(typing.NamedTuple):
    """Places where a hand goes along a wall and back, a row of two numbers each."""

    name: str
    x: Array  # [m]
    direction: Array  # of the motion
    normal: Array  # of the wall, outward


def around_a_disc(count: int = 32) -> task:
    """Around a disc of 40 mm, 0.15 m before the base: walls in all directions."""
    angle = np.linspace(0, 2 * math.pi, count, endpoint=False)
    normal, along = (np.column_stack([np.cos(a), np.sin(a)]) for a in (angle, angle + math.pi / 2))
    return task("around a disc", [0, 0.15] + 0.04 * normal, along, normal)


def papers_wall(count: int = 32) -> task:
    """Along the wall of section 5.2 of the paper, y = 0.225 m, from which the hand comes below."""
    x = np.column_stack([np.linspace(0.06, 0.17, count), np.full(count, 0.225)])
    return task("the paper's wall", x, np.tile([1.0, 0.0], (count, 1)), np.tile([0.0, -1.0], (count, 1)))


Posed = tuple[typing.Any, Array, Array]
"""A device, its joint positions at places, and true where it reaches them."""


def by_inverse(device: typing.Any, x: Array) -> Posed:
    """A device that has an inverse, at places [m] in its base frame."""
    q, outcomes = device.inverse(x)
    return device, q, outcomes == ph.status.ok


def arm_with_a_direction(v: Sequence[float], x: Array) -> Posed:
    """Three links, of which the last one keeps its direction."""
    wrist = x - v[2] * np.array([math.cos(v[3]), math.sin(v[3])])
    _, q, reached = by_inverse(ph.two_link(length_1=v[0], length_2=v[1]), wrist)
    return ph.planar_arm(v[:3]), np.column_stack([q, v[3] - q.sum(axis=1)]), reached


class design(typing.NamedTuple):
    """A device with numbers that an optimiser may change. The last two are the place of its base [m]."""

    name: str
    variables: tuple[str, ...]
    start: tuple[float, ...]
    bounds: tuple[tuple[float, float], ...]
    at: Callable[[Sequence[float], Array], Posed]
    """With these numbers, at places [m] in the base frame."""


BASE = ("base x [m]", "base y [m]")
AROUND_BASE = ((-0.1, 0.1), (-0.1, 0.04))  # 70 mm from the disc at least
LINK = (0.05, 0.2)  # [m]
DESIGNS = (
    design(
        "the paper's device", ("link 1 [m]", "link 2 [m]", "k2 [1]", *BASE), (0.15, 0.15, PAPERS_K2, 0, 0),
        (LINK, LINK, (0.1, 2.5), *AROUND_BASE),
        lambda v, x: by_inverse(ph.tendon_two_link(length_1=v[0], length_2=v[1], reduction_2=v[2]), x),
    ),
    design(
        "five-bar", ("upper links [m]", "lower links [m]", "base distance [m]", *BASE), (0.1, 0.13, 0.05, 0, 0),
        (LINK, LINK, (0.0, 0.15), *AROUND_BASE),
        lambda v, x: by_inverse(ph.five_bar(v[2], v[0], v[0], v[1], v[1]), x),
    ),
    design(
        "arm of 3 joints", ("link 1 [m]", "link 2 [m]", "link 3 [m]", "direction of link 3 [rad]", *BASE),
        (0.12, 0.1, 0.08, 1.5, 0, 0), (LINK, LINK, (0.03, 0.15), (-math.pi, math.pi), *AROUND_BASE),
        arm_with_a_direction,
    ),
)  # fmt: skip


def figures_of(of: design, numbers: Sequence[float], what: task) -> tuple[Array, Array]:
    """The drag for each newton out of the wall [1] and the sink slope [1] at each place, one way and back; NaN out of reach."""
    device, q, reached = of.at(numbers, what.x - np.asarray(numbers[-2:]))
    brakes = device.brakes(torque_limit=TORQUE_LIMIT)
    ways = [device.design_map(q, way * what.direction, what.normal, brakes, PUSH) for way in (1, -1)]
    both = {name: np.concatenate([np.where(reached, of_way[name], np.nan) for of_way in ways]) for name in ("drag", "sink_slope")}
    return both["drag"], both["sink_slope"]


def costs_of(drag: Array, sink_slope: Array) -> Array:
    """The cost of each place, 0 (held, no drag) to 2: both figures between 0 and 1, as some are infinite."""
    return sum(1 - 1 / (1 + np.nan_to_num(part, nan=np.inf)) for part in (drag, sink_slope))  # type: ignore


def cost_of(of: design, numbers: Sequence[float], what: task) -> float:
    """The mean over the places of a task."""
    return float(np.mean(costs_of(*figures_of(of, numbers, what))))


def improved(of: design, what: task, rounds: int) -> tuple[float, ...]:
    """The numbers of the minimum cost that the optimiser finds; never worse than those at the start."""
    found = differential_evolution(
        lambda numbers: cost_of(of, numbers, what), of.bounds, x0=np.array(of.start), maxiter=rounds, popsize=6,
        tol=1e-3, seed=SEED, polish=False,
    )  # fmt: skip
    return tuple(float(number) for number in found.x)


def draw_design(axes: plots.Axes, of: design, numbers: Sequence[float], what: task, title: str) -> None:
    """The device at one place of the task, and the cost of each place: dots side by side, one for each
    way."""
    x, (drag, sink_slope) = what.x - np.asarray(numbers[-2:]), figures_of(of, numbers, what)
    device, q, reached = of.at(numbers, x)
    plots.draw_device(device, q[np.argmax(reached)], axes)
    dots = np.concatenate([x + 0.004 * what.normal, x + 0.010 * what.normal])  # on the free side of the wall [m]
    costs = costs_of(drag, sink_slope)
    axes.scatter(*dots.T, c=costs, cmap="cividis_r", vmin=0, vmax=WORST, s=14, zorder=8)
    axes.set(xlim=(-0.22, 0.22), ylim=(-0.12, 0.32))
    axes.set_title(f"{title}: cost {np.mean(costs):.2f}, {np.mean(sink_slope == 0):.0%} held", fontsize=10)


def main() -> None:
    """The whole study."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", default=".", help="the folder of the picture")
    parser.add_argument("--rounds", type=int, default=60, help="of the optimiser; 60 take a minute or two")
    given = parser.parse_args()
    os.makedirs(given.output, exist_ok=True)
    what = around_a_disc()
    figure, rows = plt.subplots(len(DESIGNS), 2, figsize=(9, 4.1 * len(DESIGNS)), layout="constrained")
    for of, (left, right) in zip(DESIGNS, rows):
        after = improved(of, what, given.rounds)
        print(f"{of.name}: cost {cost_of(of, of.start, what):.2f} -> {cost_of(of, after, what):.2f}")
        for name, old, new in zip(of.variables, of.start, after):
            print(f"    {name:26s} {old:6.3f} -> {new:6.3f}")
        draw_design(left, of, of.start, what, f"{of.name}, before")
        draw_design(right, of, after, what, "after")
    figure.savefig(os.path.join(given.output, "design.png"), dpi=120)
    for of_k2 in (papers_wall(), what):
        costs = {k2: cost_of(DESIGNS[0], (0.15, 0.15, k2, 0, 0), of_k2) for k2 in (PAPERS_K2, *np.geomspace(0.1, 2.5, 49))}
        best = min(costs, key=costs.__getitem__)
        print(f"{of_k2.name}: cost {costs[PAPERS_K2]:.2f} with k2 = {PAPERS_K2}, {costs[best]:.2f} with k2 = {best:.2f}")
    print(f"The picture: {given.output}/design.png")


if __name__ == "__main__":
    main()
