"""Pictures of runs along a wall by matplotlib, from what follow_wall records.

    from passive_haptics import run_plots
    figures, rows = passive_haptics.follow_wall(device, control, shape, hand, record=True)
    run_plots.draw_runs({f"direct control: {figures.separations} separations": rows})
"""

from __future__ import annotations

import collections.abc

import matplotlib.pyplot as plt  # type: ignore[import]
import numpy as np

from passive_haptics import plots
from passive_haptics.arrays import Array, Records

COLOURS = (plots.VERMILION, plots.BLUE, plots.GREEN, plots.SKY)
EVERY = 10
"""Of so many time steps one is drawn: 1 ms of the usual 0.1 ms."""
MEAN_OF = 400
"""Alpha is drawn as its mean over so many time steps: 40 ms, two time constants of the usual brakes."""


def draw_runs(runs: collections.abc.Mapping[str, Records], figure: plots.Axes | None = None) -> list[plots.Axes]:
    """Runs over time, a colour for each: the depth in the wall, the mean of alpha, the torque of each brake, the
    hand's force.

    runs: the name of each run for the legend, and the rows that follow_wall records. figure: a new one where none
    is given. Returns the axes of its panels, one above the other. Throws ValueError where no run is given, or one
    has no rows.
    """
    if not runs:
        raise ValueError("passive_haptics: runs = {}, expected one run or more")
    for name, rows in runs.items():
        if len(rows) == 0:
            raise ValueError(f"passive_haptics: run {name!r} has 0 rows, expected some; call follow_wall(..., record=True)")
    brakes = next(iter(runs.values()))["brake_torque"].shape[1]
    labels = ["depth [mm]", "mean alpha [1]", *(f"brake {i + 1} [N m]" for i in range(brakes)), "hand [N]"]
    if figure is None:
        figure = plt.figure(figsize=(8, 1.5 * len(labels) + 0.8), layout="constrained")
    panels = list(figure.subplots(len(labels), 1, sharex=True))
    for number, (name, rows) in enumerate(runs.items()):
        shown, colour = rows[::EVERY], COLOURS[number % len(COLOURS)]
        torques = np.abs(shown["brake_torque"]).T
        hand = np.linalg.norm(shown["hand_force"], axis=1)
        alpha = recent_means(rows["alpha"], MEAN_OF)[::EVERY]
        for axes, values in zip(panels, [1e3 * shown["depth"], alpha, *torques, hand]):
            axes.plot(shown["time"], values, color=colour, lw=1, label=name)
    for axes, label in zip(panels, labels):
        axes.set_ylabel(label)
        axes.margins(x=0)
        axes.spines[["top", "right"]].set_visible(False)
    highest = max(axes.get_ylim()[1] for axes in panels[2:-1])
    for axes in panels[2:-1]:  # one scale for all brakes
        axes.set_ylim(0, highest)
    panels[1].set_ylim(-0.05, 1.05)
    panels[0].axhline(0, color=plots.INK, lw=0.8)  # the wall's surface
    panels[0].legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2, frameon=False)
    panels[-1].set_xlabel("time [s]")
    return panels


def recent_means(values: Array, count: int) -> Array:
    """The mean of the latest `count` values, at each; at the beginning of those that there are."""
    sums = np.concatenate([[0.0], np.cumsum(values)])
    last = np.arange(1, len(values) + 1)
    first = np.maximum(last - count, 0)
    return np.asarray((sums[last] - sums[first]) / (last - first), dtype=float)
