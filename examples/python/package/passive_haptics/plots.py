"""Pictures of planar devices with Matplotlib: producible forces and links.

    from passive_haptics import plots
    axes = plots.draw_passive_fmes(arm, q, velocity=[0.05, 0.02], normal=[0, -1], desired_force=[0, -3])
    axes.figure.savefig("fmes.png")

Each function draws on the given Axes, or on those of a new figure, and returns them.
"""

from __future__ import annotations

import math
from typing import Any, Optional

import matplotlib.pyplot as plt  # type: ignore[import]
import numpy as np
from matplotlib import patheffects
from matplotlib.patches import Polygon  # type: ignore[import]

from passive_haptics.arrays import Array, Numbers
from passive_haptics.devices import mechanism, serial_chain
from passive_haptics.producible_forces import passive_fme, passive_fmes, producible_outline, require_planar, unit_vector

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
    """Draws the forces [N] that the brakes of a planar device can produce with 1 N m (1 N on slides) in a pose q.

    The outlines are the passive FMEs, see producible_forces.passive_fmes. With a velocity of the handle (only
    its direction matters), the forces for this motion are filled. With the normal of a wall, the wall is drawn
    behind the handle. With a desired force [N] and a velocity, that force and the nearest producible force
    without limits are drawn; forces that are too long for the picture are shortened by one factor. Labels show
    the magnitudes.
    """
    regions = passive_fmes(device, q)
    outlines = [region.outline for region in regions if len(region.outline)]
    reach = (1 + MARGIN) * max([float(np.abs(outline).max()) for outline in outlines], default=1.0)
    axes = _prepared(axes, "$F_x$ [N]", "$F_y$ [N]")
    axes.set(xlim=(-reach, reach), ylim=(-reach, reach))
    if normal is not None:
        draw_wall(axes, [0, 0], normal)
    for region in regions:
        axes.plot(*region.outline.T, color=PALE, lw=1.2, zorder=2)
        if region.signs is not None:
            name = "(" + ", ".join("+" if sign > 0 else MINUS for sign in region.signs) + ")"
            middle = region.outline[len(region.outline) // 2]
            style = {"color": INK, "fontsize": 9, "ha": "center", "va": "center", "path_effects": HALO}
            axes.text(*middle, name, zorder=5, **style)
    if velocity is not None:
        for outline in _outlines_in_motion(device, q, velocity, regions):
            axes.fill(*outline.T, facecolor=PRODUCIBLE, alpha=0.35, edgecolor="none", zorder=1)
            axes.plot(*outline.T, color=PRODUCIBLE, lw=1.2, zorder=3)
        draw_arrow(axes, 0.5 * reach * unit_vector(velocity, "velocity"), MOTION, "motion")
    if desired_force is not None:
        _draw_forces(axes, device, q, velocity, np.asarray(desired_force, dtype=float), reach)
    axes.plot(0, 0, "o", color=INK, ms=4, zorder=6)
    if velocity is not None or desired_force is not None:
        axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3, frameon=False, fontsize=9)
    return axes


def links_of(device: mechanism, q: Numbers) -> list[Array]:
    """The links of a planar device in a pose q [rad or m], base frame [m]: lines from each base over the joints to
    the handle, K x 2. A slide of a chain is at the joint before it."""
    require_planar(device, q)
    kind, p, handle = type(device).__name__, device.parameters, device.position(q)
    if kind == "serial_chain":
        points, place = [], [0.0, 0.0]
        for i, joint in enumerate(p["joints"]):  # a joint is the handle of a chain that ends there
            place = joint["point"] if joint["kind"] == "revolute" else place
            points.append(serial_chain(p["joints"], place).position(np.where(np.arange(len(q)) < i, q, 0)))
        return [np.array([*points, handle])]
    if kind == "xy_table":
        return [np.array([[0, 0], [q[0], 0], handle])]
    if kind not in ("two_link", "tendon_two_link", "five_bar", "five_bar_with_four_brakes"):
        raise ValueError(f"passive_haptics: device = {kind}: expected a planar device of the package")
    along = np.array([np.cos(q), np.sin(q)]).T
    if "two_link" in kind:
        return [np.array([[0, 0], p["length_1"] * along[0], handle])]
    bases = np.array([[-0.5, 0.0], [0.5, 0.0]]) * p["base_distance"]
    return [np.array([bases[i], bases[i] + p[f"proximal_{i + 1}"] * along[i], handle]) for i in range(2)]


def draw_device(device: mechanism, q: Numbers, axes: Axes | None = None, *, colour: str = INK) -> Axes:
    """Draws a planar device at joint positions q [rad or m], to scale: links, joints, bases and handle.

    Raises ValueError for spatial and custom devices, and for poses that the device cannot reach.
    """
    lines = links_of(device, q)
    axes = _prepared(axes, "x [m]", "y [m]")
    for line in lines:
        axes.plot(*line.T, color=colour, lw=4, solid_capstyle="round", solid_joinstyle="round", zorder=3)
        axes.plot(*line[:-1].T, "o", color="white", mec=colour, mew=2, ms=8, zorder=4)
        axes.plot(*line[0], "^", color=colour, ms=13, zorder=2)
    axes.plot(*lines[0][-1], "o", color=BLUE, ms=9, zorder=5)
    return axes


def draw_wall(axes: Axes, point: Numbers, normal: Numbers) -> Axes:
    """Draws the wall through a point with an outward normal, up to the limits of the picture."""
    n, at = unit_vector(normal, "normal"), np.asarray(point, dtype=float)
    along = np.array([-n[1], n[0]])
    far = 10 * (np.abs([*axes.get_xlim(), *axes.get_ylim()]).max() + np.abs(at).max())
    corners = at + far * np.array([along, -along, -along - n, along - n])
    axes.add_artist(Polygon(corners, facecolor=GROUND, edgecolor=MUTED, lw=1.2, zorder=0))
    return axes


def draw_arrow(axes: Axes, vector: Numbers, colour: str, label: str) -> Axes:
    """Draws an arrow from 0 in the units of the picture, and its legend entry; for a zero vector only the
    entry."""
    tip = np.asarray(vector, dtype=float)
    axes.plot([0, tip[0]], [0, tip[1]], color=colour, lw=2, label=label, zorder=6)
    if np.any(tip):
        style = {"arrowstyle": "-|>", "color": colour, "lw": 2, "shrinkA": 0, "shrinkB": 0}
        axes.annotate("", tip, (0, 0), arrowprops=style, zorder=6)
    return axes


def _prepared(axes: Axes | None, x_label: str, y_label: str) -> Axes:
    """Axes of equal scales with labels, a new figure's if there are none."""
    if axes is None:
        axes = plt.subplots(figsize=(5.2, 4.8), layout="constrained")[1]
    axes.set(xlabel=x_label, ylabel=y_label)
    axes.margins(MARGIN)
    axes.set_aspect("equal")
    axes.spines[["top", "right"]].set_visible(False)
    return axes


def _outlines_in_motion(
    device: mechanism, q: Numbers, velocity: Numbers, regions: list[passive_fme]
) -> list[Array]:
    """Forces while the handle moves: of the paper's FMEs those with signs that oppose the brakes' rates."""
    if any(region.signs is None for region in regions):
        return [producible_outline(device, q, velocity)]
    rates = device.displayable(q, velocity, [0, 1]).signs
    return [region.outline for region in regions if np.all(np.asarray(region.signs) * rates <= 0)]


def _draw_forces(
    axes: Axes, device: mechanism, q: Numbers, velocity: Optional[Numbers], desired: Array, reach: float
) -> None:
    """The desired force, and the nearest one where the motion is known."""
    direction, length = unit_vector(desired, "desired_force"), float(np.linalg.norm(desired))
    scale = min(LONGEST_ARROW * reach / length, 1.0)
    draw_arrow(axes, scale * length * direction, DESIRED, f"$F_d$ {length:.3g} N")
    if velocity is None:
        return
    found = device.displayable(q, velocity, desired)
    nearest = length * math.cos(found.angle) ** 2 * found.nearest
    made = float(np.linalg.norm(nearest))
    name = f"nearest {made:.3g} N, {math.degrees(found.angle):.0f}° off" if made > 0 else "no force is near"
    draw_arrow(axes, scale * nearest, DISPLAYED, name)
