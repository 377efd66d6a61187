"""Improves three planar devices for a task: their links, their base, and the reduction k2 of the paper's device.

What counts is known before a device is built: how deep a hand sinks that a brake cannot hold, and how hard the brakes
drag where they hold it. No law and no simulation is part of it. docs/guide/design.md shows what comes out.
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
    """Places where a hand goes along a wall, a row of two numbers each."""

    name: str
    x: Array  # [m]
    direction: Array  # of the motion
    normal: Array  # of the wall, out of it


def both_ways(name: str, x: Array, along: Array, normal: Array) -> task:
    """A task in which the hand goes along the wall and back."""
    return task(name, np.vstack([x, x]), np.vstack([along, -along]), np.vstack([normal, normal]))


def around_a_disc(count: int = 32) -> task:
    """Around a disc of 40 mm, 0.15 m before the base: walls in all directions."""
    angle = np.linspace(0, 2 * math.pi, count, endpoint=False)
    normal = np.column_stack([np.cos(angle), np.sin(angle)])
    along = np.column_stack([-np.sin(angle), np.cos(angle)])
    return both_ways("around a disc", [0, 0.15] + 0.04 * normal, along, normal)


def papers_wall(count: int = 32) -> task:
    """Along the wall of section 5.2 of the paper, y = 0.225 m, from which the hand comes below."""
    x = np.column_stack([np.linspace(0.06, 0.17, count), np.full(count, 0.225)])
    return both_ways("the paper's wall", x, np.tile([1.0, 0.0], (count, 1)), np.tile([0.0, -1.0], (count, 1)))


class design(typing.NamedTuple):
    """A device whose numbers an optimiser may change. The last two are where its base stands [m]."""

    name: str
    variables: tuple[str, ...]
    start: tuple[float, ...]
    bounds: tuple[tuple[float, float], ...]
    made: Callable[[Sequence[float]], typing.Any]
    pose: Callable[[typing.Any, Sequence[float], Array], typing.Optional[Array]]
    """At x in the base frame; None: out of reach."""


def pose_by_inverse(device: typing.Any, numbers: Sequence[float], x: Array) -> typing.Optional[Array]:
    """The pose of a device that has an inverse."""
    q, outcome = device.inverse(x)
    return q if outcome == ph.status.ok else None


def pose_of_arm(device: typing.Any, numbers: Sequence[float], x: Array) -> typing.Optional[Array]:
    """The pose of three links whose last one keeps its direction."""
    first, second, third, direction = numbers[:4]
    wrist = x - third * np.array([math.cos(direction), math.sin(direction)])
    q = pose_by_inverse(ph.two_link(length_1=first, length_2=second), numbers, wrist)
    return None if q is None else np.array([q[0], q[1], direction - q[0] - q[1]])


BASE = ("base x [m]", "base y [m]")
AROUND_BASE = ((-0.1, 0.1), (-0.1, 0.04))  # 70 mm from the disc at least
LINK = (0.05, 0.2)  # [m]
DESIGNS = (
    design(
        "the paper's device", ("link 1 [m]", "link 2 [m]", "k2 [1]", *BASE), (0.15, 0.15, PAPERS_K2, 0, 0),
        (LINK, LINK, (0.1, 2.5), *AROUND_BASE),
        lambda v: ph.tendon_two_link(length_1=v[0], length_2=v[1], reduction_2=v[2]), pose_by_inverse,
    ),
    design(
        "five-bar", ("upper links [m]", "lower links [m]", "base distance [m]", *BASE), (0.1, 0.13, 0.05, 0, 0),
        (LINK, LINK, (0.0, 0.15), *AROUND_BASE),
        lambda v: ph.five_bar(proximal_1=v[0], proximal_2=v[0], distal_1=v[1], distal_2=v[1], base_distance=v[2]),
        pose_by_inverse,
    ),
    design(
        "arm of 3 joints", ("link 1 [m]", "link 2 [m]", "link 3 [m]", "direction of link 3 [rad]", *BASE),
        (0.12, 0.1, 0.08, 1.5, 0, 0), (LINK, LINK, (0.03, 0.15), (-math.pi, math.pi), *AROUND_BASE),
        lambda v: ph.planar_arm(v[:3]), pose_of_arm,
    ),
)  # fmt: skip


class figures(typing.NamedTuple):
    """What a device does at the places of a task; NaN where it does not get."""

    drag: Array  # for each newton out of the wall [1]
    sink_slope: Array  # metres into the wall for each metre along it [1]

    @property
    def costs(self) -> Array:
        """Of each place, 0 (held, no drag) to 2: both figures between 0 and 1, as some are infinite."""
        drag, sink = (1 - 1 / (1 + np.nan_to_num(part, nan=np.inf)) for part in self)
        return typing.cast(Array, drag + sink)

    @property
    def cost(self) -> float:
        """Of the task."""
        return float(np.mean(self.costs))

    @property
    def held(self) -> float:
        """The share of places at which a push does not sink."""
        return float(np.mean(self.sink_slope == 0))


def figures_of(of: design, numbers: Sequence[float], what: task) -> figures:
    """Of a design over a task."""
    device = of.made(numbers)
    poses = [of.pose(device, numbers, x - np.asarray(numbers[-2:])) for x in what.x]
    reached = np.array([q is not None for q in poses])
    drag, sink_slope = np.full(len(poses), np.nan), np.full(len(poses), np.nan)
    if reached.any():
        found = device.design_map(
            np.array([q for q in poses if q is not None]), what.direction[reached], what.normal[reached],
            device.brakes(torque_limit=[TORQUE_LIMIT] * device.brake_count), PUSH,
        )  # fmt: skip
        drag[reached], sink_slope[reached] = found["drag"], found["sink_slope"]
    return figures(drag, sink_slope)


def improved(of: design, what: task, rounds: int) -> tuple[float, ...]:
    """The numbers of the least cost that the optimiser finds; never worse than those at the start."""
    cost = lambda numbers: figures_of(of, numbers, what).cost
    found = differential_evolution(
        cost, of.bounds, x0=np.array(of.start), maxiter=rounds, popsize=6, tol=1e-3, seed=SEED, polish=False
    )
    return tuple(float(number) for number in found.x)


def draw_design(axes: plots.Axes, of: design, numbers: Sequence[float], what: task, title: str) -> typing.Any:
    """The device at one place of the task, and the cost of each place: dots outside of each other, a way each."""
    device, base, found = of.made(numbers), np.asarray(numbers[-2:]), figures_of(of, numbers, what)
    q = next((q for x in what.x if (q := of.pose(device, numbers, x - base)) is not None), None)
    if q is not None:
        plots.draw_device(device, q, axes)
    side = np.repeat([0.004, 0.010], len(what.x) // 2)[:, None]  # beside the wall, on its free side [m]
    places = what.x - base + side * what.normal
    dots = axes.scatter(*places.T, c=found.costs, cmap="cividis_r", vmin=0, vmax=WORST, s=14, zorder=8)
    axes.set(xlabel="x [m]", ylabel="y [m]", aspect="equal", xlim=(-0.22, 0.22), ylim=(-0.12, 0.32))
    drag = np.nanmedian(found.drag[np.isfinite(found.drag)]) if np.isfinite(found.drag).any() else math.nan
    axes.set_title(f"{title}: cost {found.cost:.2f}, {found.held:.0%} held, drag {drag:.2f}", fontsize=10)
    return dots


def draw_study(path: str, what: task, after: dict[str, tuple[float, ...]]) -> None:
    """Before and after, side by side."""
    figure, rows = plt.subplots(len(DESIGNS), 2, figsize=(9, 4.1 * len(DESIGNS)), layout="constrained")
    for (left, right), of in zip(rows, DESIGNS):
        draw_design(left, of, of.start, what, f"{of.name}, before")
        dots = draw_design(right, of, after[of.name], what, "after")
    figure.colorbar(dots, ax=rows, shrink=0.4, label="cost of a place: 0 held without drag, 2 nothing is held")
    figure.savefig(path, dpi=120)


def draw_reductions(path: str, tasks: Sequence[task]) -> dict[str, float]:
    """The cost of the paper's device over its reduction k2, for each task; returns the best k2 of each."""
    values, best = np.geomspace(0.1, 2.5, 49), {}
    axes = plt.subplots(figsize=(6, 4), layout="constrained")[1]
    for what, colour in zip(tasks, (plots.BLUE, plots.VERMILION)):
        costs = [figures_of(DESIGNS[0], (0.15, 0.15, k2, 0, 0), what).cost for k2 in values]
        best[what.name] = float(values[int(np.argmin(costs))])
        axes.plot(values, costs, color=colour, lw=2, label=f"{what.name}: best at {best[what.name]:.2f}")
    axes.axvline(PAPERS_K2, color=plots.MUTED, lw=1, ls="--", label="the paper's 0.4")
    axes.set(xscale="log", xlabel="k2 [1]", ylabel="cost [1]", ylim=(0, None))
    axes.set_title("The reduction of the paper's device")
    axes.set_xticks([0.1, 0.2, 0.4, 1, 2], ["0.1", "0.2", "0.4", "1", "2"], minor=False)
    axes.legend(frameon=False)
    axes.spines[["top", "right"]].set_visible(False)
    axes.figure.savefig(path, dpi=150)
    return best


def main() -> None:
    """The whole study."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", default=".", help="the folder of the pictures")
    parser.add_argument("--rounds", type=int, default=60, help="of the optimiser; 60 take a minute or two")
    given = parser.parse_args()
    os.makedirs(given.output, exist_ok=True)
    what, after = around_a_disc(), dict[str, tuple[float, ...]]()
    for of in DESIGNS:
        after[of.name] = improved(of, what, given.rounds)
        before, now = figures_of(of, of.start, what), figures_of(of, after[of.name], what)
        print(f"{of.name}: cost {before.cost:.2f} -> {now.cost:.2f}, held {before.held:.0%} -> {now.held:.0%}")
        for name, old, new in zip(of.variables, of.start, after[of.name]):
            print(f"    {name:26s} {old:6.3f} -> {new:6.3f}")
    draw_study(os.path.join(given.output, "design.png"), what, after)
    best = draw_reductions(os.path.join(given.output, "design_reductions.png"), [papers_wall(), what])
    print("best k2: " + ", ".join(f"{k2:.2f} {name}" for name, k2 in best.items()))
    print(f"Pictures: {given.output}/design.png, {given.output}/design_reductions.png")


if __name__ == "__main__":
    main()
