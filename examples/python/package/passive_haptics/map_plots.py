"""Pictures of a design map by matplotlib: what a planar device does at each place of a grid.

    from passive_haptics import map_plots
    found = map_plots.map_over(arm, x, y, direction=[1, 0], normal=[0, -1], brakes=arm.brakes(), push=2)
    map_plots.draw_design_map(x, y, found)
"""

from __future__ import annotations

from typing import Any, cast

import matplotlib.pyplot as plt  # type: ignore[import]
import numpy as np

from passive_haptics import plots
from passive_haptics.arrays import Numbers, Records
from passive_haptics.results import status

PANELS = {
    "drag": ("drag for each newton [1]", (0.0, 3.0)),
    "max_force": ("strongest force [N]", None),
    "sink_slope": ("sink slope [1]", (0.0, 1.0)),
    "isotropy": ("isotropy [1]", (0.0, 1.0)),
}
"""The figures that are drawn, the label of each and the limits of its scale; None: 0 and what 95 % do not exceed."""


def map_over(
    device: Any,
    x: Numbers,
    y: Numbers,
    direction: Numbers,
    normal: Numbers,
    brakes: Any = None,
    push: float = 1.0,
) -> Records:
    """The design_map of a device over a grid of places x, y [m], len(y) x len(x): the handle moves in a direction
    beside a wall with this normal, into which a hand pushes [N].

    The device has an inverse. Where it does not reach, outcome is out_of_reach and all figures are NaN.
    """
    places = np.array([[at_x, at_y] for at_y in y for at_x in x], dtype=float)
    poses = [device.inverse(place) for place in places]
    reached = np.array([outcome == status.ok for _, outcome in poses])
    middle = np.zeros(device.dof)
    q = np.array([pose if outcome == status.ok else middle for pose, outcome in poses])
    found = device.design_map(q, direction, normal, brakes, push)
    for name in found.dtype.names:
        found[name][~reached] = int(status.out_of_reach) if name == "outcome" else 0 if name == "display" else np.nan
    return cast(Records, found.reshape(len(y), len(x)))


def draw_design_map(x: Numbers, y: Numbers, found: Records, figure: plots.Axes | None = None) -> list[plots.Axes]:
    """Drag, strongest force, sink slope and isotropy of a map_over these places x, y [m]. Where the device does not
    reach, or nothing is held, a place is grey. Returns the axes of the four panels."""
    if figure is None:
        figure = plt.figure(figsize=(11, 5.6), layout="constrained")
    panels = list(figure.subplots(2, 2).flat)
    for axes, (name, (label, limits)) in zip(panels, PANELS.items()):
        finite = found[name][np.isfinite(found[name])]
        most = float(np.percentile(finite, 95)) if len(finite) else 1.0
        plots.draw_map(x, y, found[name], axes, label=label, limits=limits or (0.0, most))
    return panels
