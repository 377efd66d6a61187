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


def arrow(axes, force, colour):
    """A force from the origin."""
    shape = {"arrowstyle": "-|>", "color": colour, "lw": 2.4, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 16}
    axes.annotate("", force, (0, 0), arrowprops=shape, zorder=6)


def beside(outline):
    """A place for the name of a region: beside its middle, on the outer side of its long axis."""
    distance = 5.5  # [N]
    along = outline[np.argmax(np.linalg.norm(outline, axis=1))]
    along = along / np.linalg.norm(along)
    middle = outline[1:-1].mean(axis=0)
    across = middle - along * (along @ middle)
    return middle + distance * across / np.linalg.norm(across)


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
        right.plot(*outline.T, color=COLOURS["made"] if is_now else "#bbbbbb", lw=1.2, zorder=2 + is_now)
        name = "(" + ", ".join("+" if sign > 0 else "\N{MINUS SIGN}" for sign in signs) + ")"
        right.text(*beside(outline), name, color=INK if is_now else MUTED, ha="center", va="center")
    scale = 13 / np.linalg.norm(result.desired_force)
    arrow(right, scale * result.desired_force, COLOURS["demand"])
    arrow(right, scale * result.control_force, COLOURS["made"])
    right.text(0.03, 0.96, "$F_d$, which the wall demands", color=COLOURS["demand"], transform=right.transAxes)
    right.text(0.03, 0.90, "$F_c$, which is displayed", color=COLOURS["made"], transform=right.transAxes)
    right.text(0.03, 0.84, "both enlarged", color=MUTED, transform=right.transAxes)
    right.set(title="Forces of torques up to 1 N m, by their signs", xlabel="$F_x$ [N]", ylabel="$F_y$ [N]")
    right.set(xlim=(-24, 24))
    for axes in (left, right):
        axes.set_aspect("equal")
        axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(path, dpi=150)
    angle = np.degrees(np.arccos(result.approximation_cosine))
    demanded = np.linalg.norm(result.desired_force)
    print(f"The wall demands {demanded:.2f} N. The display is {result.display.text}, {angle:.0f} deg off.")
    print(f"Brakes may hold {result.capacity.round(3)} N m. The picture: {path}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", default=".", help="the folder of the picture")
    folder = parser.parse_args().output
    os.makedirs(folder, exist_ok=True)
    draw(os.path.join(folder, "passive_fme.png"))
