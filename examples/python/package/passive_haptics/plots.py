"""Pictures of planar devices by matplotlib: what their brakes can make, where their links are, maps of a
workspace.

    from passive_haptics import plots
    axes = plots.draw_passive_fmes(arm, q, velocity=[0.05, 0.02], normal=[0, -1], desired_force=[0, -3])
    axes.figure.savefig("fmes.png")

Each function draws on the Axes that it is given, or on those of a new figure, and returns them.
"""

from __future__ import annotations

import collections.abc
import math
from typing import Any, Optional

import matplotlib.pyplot as plt  # type: ignore[import]
import numpy as np
from matplotlib import patheffects
from matplotlib.patches import Polygon  # type: ignore[import]

from passive_haptics.arrays import Array, Numbers
from passive_haptics.devices import mechanism
from passive_haptics.planar_geometry import geometry_of
from passive_haptics.producible_forces import (
    nearest_producible,
    passive_fme,
    passive_fmes,
    producible_outline,
    unit_vector,
)
from passive_haptics.progress import progress_line
from passive_haptics.results import status

Axes = Any
"""matplotlib.axes.Axes, which has no types in Debian 12."""

# Colours that the colour-blind can distinguish (Okabe and Ito 2008)
BLUE, SKY, VERMILION, GREEN = "#0072b2", "#56b4e9", "#d55e00", "#009e73"
INK, MUTED, PALE, GROUND = "#222222", "#777777", "#bbbbbb", "#e6e6e6"
# As in the explorer and the pictures of the C++ programs
PRODUCIBLE, DESIRED, DISPLAYED, MOTION, HAND = GREEN, INK, VERMILION, SKY, "#a0457c"

MARGIN = 0.15
"""Around what is drawn, a part of its size [1]."""
LONGEST_ARROW = 0.8
"""A force that is longer than this part of the picture's half is drawn so long [1]."""
LABEL_GAP = 17.0
"""From the outline of an FME to the middle of its name [points]."""
MINUS = "\N{MINUS SIGN}"
HALO = [patheffects.withStroke(linewidth=2.5, foreground="white")]


def draw_passive_fmes(
    device: mechanism,
    q: Numbers,
    axes: Axes | None = None,
    *,
    velocity: Optional[Numbers] = None,
    normal: Optional[Numbers] = None,
    desired_force: Optional[Numbers] = None,
) -> Axes:
    """The forces [N] that the brakes of a planar device can make with 1 N m (1 N on slides) at joint
    positions q.

    Outlines: its passive FMEs, see producible_forces.passive_fmes. With a velocity of the handle, whose
    direction counts [m/s]: filled, what can be made in this motion, and the motion. With the normal of a
    wall: the wall behind the handle. With a desired force [N] and a velocity: that force, and the nearest
    that brakes without limits can make; forces that are too long for the picture are shortened by one factor.
    Labels have the magnitudes.
    """
    regions = passive_fmes(device, q)
    reach = _reach([region.outline for region in regions])
    axes = _prepared(axes, "$F_x$ [N]", "$F_y$ [N]", np.array([[-reach, -reach], [reach, reach]]))
    if normal is not None:
        draw_wall(axes, [0, 0], normal)
    for region in regions:
        axes.plot(*region.outline.T, color=PALE, lw=1.2, zorder=2)
        if _is_quarter(region):
            _name_quarter(axes, region)
    if velocity is not None:
        shown = _region_in_motion(device, q, velocity, regions)
        for outline in shown:
            axes.fill(*outline.T, facecolor=PRODUCIBLE, alpha=0.35, edgecolor="none", zorder=1)
            axes.plot(*outline.T, color=PRODUCIBLE, lw=1.2, zorder=3)
        draw_arrow(axes, 0.5 * reach * unit_vector(velocity, "velocity"), MOTION, "motion")
    if desired_force is not None:
        _draw_forces(axes, device, q, velocity, np.asarray(desired_force, dtype=float), reach)
    axes.plot(0, 0, "o", color=INK, ms=4, zorder=6)
    if velocity is not None or desired_force is not None:
        axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3, frameon=False, fontsize=9)
    return axes


def draw_device(device: mechanism, q: Numbers, axes: Axes | None = None, *, colour: str = INK) -> Axes:
    """A planar device at joint positions q [rad or m], to scale: its links, joints, bases and handle.

    On axes of its own the picture takes in all of the device; on given axes their limits grow to it. Throws
    ValueError for a device in space, one of your own, and a pose that it cannot take.
    """
    found = geometry_of(device, q)
    points = np.concatenate([*found.links, found.joints, found.handle[None]])
    grown = _grown(points)
    if axes is not None and axes.has_data():
        grown = np.concatenate([grown, np.column_stack([axes.get_xlim(), axes.get_ylim()])])
    axes = _prepared(axes, "x [m]", "y [m]", np.array([grown.min(axis=0), grown.max(axis=0)]))
    for link in found.links:
        axes.plot(*link.T, color=colour, lw=4, solid_capstyle="round", solid_joinstyle="round", zorder=3)
    axes.plot(*found.joints.T, "o", color="white", mec=colour, mew=2, ms=8, zorder=4)
    axes.plot(*found.bases.T, "^", color=colour, ms=13, zorder=2)
    axes.plot(*found.handle, "o", color=BLUE, ms=9, zorder=5)
    return axes


def draw_wall(axes: Axes, point: Numbers, normal: Numbers) -> Axes:
    """The wall through a point with a normal out of it, as far as the picture reaches now. Limits stay."""
    n = unit_vector(normal, "normal")
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    corners = np.array([[left, low], [right, low], [right, high], [left, high]])
    behind = _cut(corners, np.asarray(point, dtype=float), n)
    if len(behind):
        axes.add_patch(Polygon(behind, facecolor=GROUND, edgecolor="none", zorder=0))
        surface = behind[np.abs((behind - point) @ n) < 1e-9 * np.ptp(corners)]
        if len(surface) > 1:
            axes.plot(*surface[:2].T, color=MUTED, lw=1.2, zorder=0.5)
    axes.set(xlim=(left, right), ylim=(low, high))
    return axes


def draw_arrow(axes: Axes, vector: Numbers, colour: str, label: str) -> Axes:
    """An arrow from 0 in the units of the picture, and its line of the legend; of a vector 0 the latter alone."""
    tip = np.asarray(vector, dtype=float)
    axes.plot([0, tip[0]], [0, tip[1]], color=colour, lw=2, label=label, zorder=6)
    if np.any(tip):
        style = {"arrowstyle": "-|>", "color": colour, "lw": 2, "shrinkA": 0, "shrinkB": 0}
        axes.annotate("", tip, (0, 0), arrowprops=style, zorder=6)
    return axes


def draw_map(
    x: Numbers,
    y: Numbers,
    values: Array,
    axes: Axes | None = None,
    *,
    label: str,
    limits: Optional[tuple[float, float]] = None,
) -> Axes:
    """Values over a grid of places x, y [m], len(y) x len(x), with a scale that has a label, such as "angle
    [deg]".

    Places whose value is not finite are grey. limits: of the scale, else those of the values.
    Throws ValueError where sizes do not fit.
    """
    columns, rows, shown = np.asarray(x, dtype=float), np.asarray(y, dtype=float), np.asarray(values, dtype=float)
    if shown.shape != (len(rows), len(columns)):
        raise ValueError(
            f"passive_haptics: shape of values = {shown.shape}, expected (len(y), len(x)) = "
            f"({len(rows)}, {len(columns)})"
        )
    half = [np.ptp(each) / max(1, len(each) - 1) / 2 for each in (columns, rows)]
    box = np.array([[columns.min() - half[0], rows.min() - half[1]], [columns.max() + half[0], rows.max() + half[1]]])
    axes = _prepared(axes, "x [m]", "y [m]", box)
    axes.set_facecolor(GROUND)
    lowest, highest = limits if limits is not None else (None, None)
    mesh = axes.pcolormesh(
        columns, rows, shown, cmap="cividis", vmin=lowest, vmax=highest, shading="nearest", zorder=1
    )
    axes.figure.colorbar(mesh, cax=axes.inset_axes([1.03, 0, 0.04, 1]), label=label)
    return axes


def values_over(device: Any, x: Numbers, y: Numbers, function: collections.abc.Callable[[Array], float]) -> Array:
    """function(q) at the joint positions of each place of a grid x, y [m], len(y) x len(x); NaN where the
    device does not reach, or has singular poses in which the function returns NaN. The device has an
    inverse. At a terminal, more than two seconds show their progress."""
    found = np.full((len(y), len(x)), np.nan)
    shown = progress_line(len(y) * len(x), "places")
    for row, at_y in enumerate(y):
        for column, at_x in enumerate(x):
            q, outcome = device.inverse([float(at_x), float(at_y)])
            if outcome == status.ok:
                found[row, column] = function(q)
        shown.add(len(x))
    shown.close()
    return found


def _reach(outlines: list[Array]) -> float:
    """Half of the side of a square about 0 that holds these outlines and a margin."""
    return (1 + MARGIN) * max([float(np.abs(outline).max()) for outline in outlines if len(outline)], default=1.0)


def _grown(points: Array) -> Array:
    """The box of points, two rows, with a margin on each side."""
    low, high = points.min(axis=0), points.max(axis=0)
    margin = MARGIN * max(float((high - low).max()), 1e-3)
    return np.array([low - margin, high + margin])


def _prepared(axes: Axes | None, x_label: str, y_label: str, box: Array) -> Axes:
    """Axes of equal scales with labels and limits, a new figure's if there are none."""
    if axes is None:
        axes = plt.subplots(figsize=(5.2, 4.8), layout="constrained")[1]
    axes.set(xlabel=x_label, ylabel=y_label, xlim=box[:, 0], ylim=box[:, 1])
    axes.set_aspect("equal")
    axes.spines[["top", "right"]].set_visible(False)
    return axes


def _cut(corners: Array, point: Array, n: Array) -> Array:
    """The part of a convex polygon behind the line through a point with normal n, K x 2; none: 0 x 2."""
    kept: list[Array] = []
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        height_a, height_b = float((a - point) @ n), float((b - point) @ n)
        if height_a <= 0:
            kept.append(a)
        if (height_a < 0 < height_b) or (height_b < 0 < height_a):
            kept.append(a + (b - a) * height_a / (height_a - height_b))
    return np.array(kept).reshape(-1, 2)


def _is_quarter(region: passive_fme) -> bool:
    """Whether it is one of the paper's: two brakes, whose signs name it."""
    return region.signs is not None and len(region.signs) == 2


def _name_quarter(axes: Axes, region: passive_fme) -> None:
    """The signs of a quarter beside the middle of its arc."""
    middle = len(region.outline) // 2
    tangent = region.outline[middle + 1] - region.outline[middle - 1]
    outwards = unit_vector([tangent[1], -tangent[0]])
    gap = LABEL_GAP * outwards * (1 if outwards @ region.outline[middle] > 0 else -1)
    name = "(" + ", ".join("+" if sign > 0 else MINUS for sign in region.signs or ()) + ")"
    axes.annotate(
        name, region.outline[middle], xytext=tuple(gap), textcoords="offset points", color=INK, fontsize=9,
        ha="center", va="center", zorder=5, path_effects=HALO,
    )  # fmt: skip


def _region_in_motion(device: Any, q: Numbers, velocity: Numbers, regions: list[passive_fme]) -> list[Array]:
    """What can be made while the handle moves: of the paper's FMEs those whose signs oppose the brakes'
    rates."""
    if not all(_is_quarter(region) for region in regions):
        return [producible_outline(device, q, velocity)]
    rates = device.displayable(q, velocity, [0, 1]).signs
    return [region.outline for region in regions if np.all(np.asarray(region.signs) * rates <= 0)]


def _draw_forces(
    axes: Axes, device: Any, q: Numbers, velocity: Optional[Numbers], desired: Array, reach: float
) -> None:
    """The desired force, and the nearest one where the motion is known."""
    direction, length = unit_vector(desired, "desired_force"), float(np.linalg.norm(desired))
    scale = min(LONGEST_ARROW * reach / length, 1.0)
    draw_arrow(axes, scale * length * direction, DESIRED, f"$F_d$ {length:.3g} N")
    if velocity is None:
        return
    nearest, angle = nearest_producible(device, q, velocity, desired)
    made = float(np.linalg.norm(nearest))
    name = f"nearest {made:.3g} N, {math.degrees(angle):.0f}° off" if made > 0 else "no force is near"
    draw_arrow(axes, scale * nearest, DISPLAYED, name)
