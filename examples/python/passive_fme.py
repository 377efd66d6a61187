"""Draws the passive FMEs of the paper's device, a wall, the force that it demands and what the brakes make of it."""

import argparse
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import passive_haptics as ph

INK, MUTED = "#222222", "#777777"
COLOURS = {"display": "#dbe9f6", "demand": "#c0392b", "made": "#1f5fa8", "wall": "#e4e0d8"}


def arrow(axes, start, vector, colour, label, side):
    """A force from a point, with its name at the tip."""
    tip = start + vector
    axes.annotate("", tip, start, arrowprops={"arrowstyle": "-|>", "color": colour, "lw": 2.2, "shrinkA": 0})
    axes.annotate(label, tip, xytext=side, textcoords="offset points", color=colour, fontsize=11, ha="center")


def draw(path):
    """One picture: the device at the wall on the left, its forces on the right."""
    arm = ph.tendon_two_link()
    x = np.array([0.14, 0.226])  # 1 mm behind the wall [m]
    q, outcome = arm.inverse(x)
    assert outcome == ph.status.ok
    plane = ph.half_space([0, 0.225], [0, -1])
    brakes = arm.brakes(torque_limit=[1, 1])
    control = ph.controller(arm, brakes, ph.scene(ph.wall(plane, 500)), ph.direct_control())

    qd = np.linalg.solve(arm.jacobian(q), [0.05, 0.02])  # along the wall and into it [m/s]
    result = control(ph.device_state(0, q, qd, [1, 2]))
    producible = tuple(-int(sign) for sign in result.signs)

    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.6), layout="constrained")
    elbow = 0.15 * np.array([np.cos(q[0]), np.sin(q[0])])
    left.axhspan(0.225, 0.30, color=COLOURS["wall"], zorder=0)
    left.text(-0.085, 0.262, "wall", color=MUTED, fontsize=11)
    left.plot(*np.array([[0, 0], elbow, x]).T, "-o", color=INK, lw=4, ms=9, solid_capstyle="round")
    left.annotate("base, with both brakes", (0, 0), xytext=(14, -3), textcoords="offset points", color=MUTED)
    left.annotate("", x + [0.07, 0.028], x, arrowprops={"arrowstyle": "->", "color": MUTED, "lw": 1.6})
    left.annotate("v", x + [0.073, 0.03], color=MUTED, fontsize=11)
    left.set(title="The device at the wall", xlabel="x [m]", ylabel="y [m]", xlim=(-0.1, 0.26), ylim=(-0.03, 0.3))

    for signs, outline in arm.passive_fme(q):
        is_now = signs == producible
        right.fill(*outline.T, color=COLOURS["display"] if is_now else "white", zorder=1)
        right.plot(*outline.T, color=COLOURS["made"] if is_now else "#bbbbbb", lw=1.2, zorder=2)
        name = "(" + ", ".join("+" if sign > 0 else "\N{MINUS SIGN}" for sign in signs) + ")"
        middle = outline[1:-1].mean(axis=0)
        right.text(*middle, name, color=INK if is_now else MUTED, ha="center", va="center", zorder=5)
    scale = 4 / np.linalg.norm(result.desired_force)
    arrow(right, np.zeros(2), scale * result.desired_force, COLOURS["demand"], "$F_d$: the wall demands", (-62, -12))
    arrow(right, np.zeros(2), scale * result.control_force, COLOURS["made"], "$F_c$: displayed", (-20, -16))
    right.set(title="Forces of 1 N m, by the signs of the torques", xlabel="$F_x$ [N]", ylabel="$F_y$ [N]")
    for axes in (left, right):
        axes.set_aspect("equal")
        axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(path, dpi=150)
    angle = np.degrees(np.arccos(result.approximation_cosine))
    print(f"The wall demands {np.linalg.norm(result.desired_force):.2f} N. {result.display.text}, {angle:.0f} deg off.")
    print(f"Brakes may hold {result.capacity.round(3)} N m. The picture: {path}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", default=".", help="the folder of the picture")
    folder = parser.parse_args().output
    os.makedirs(folder, exist_ok=True)
    draw(os.path.join(folder, "passive_fme.png"))
