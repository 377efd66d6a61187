"""Draws the passive FMEs of the paper's device, a wall, the desired force and the displayed force."""

import argparse
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import passive_haptics as ph
from passive_haptics import plots

POINT, NORMAL = [0, 0.225], [0, -1]  # of the wall [m]
VELOCITY = [0.05, 0.02]  # of the handle, along the wall and into it [m/s]


def draw(path):
    """One picture: the device at the wall on the left, its forces on the right."""
    arm = ph.tendon_two_link()
    q, outcome = arm.inverse([0.14, 0.226])  # 1 mm behind the wall [m]
    assert outcome == ph.status.ok
    wall = ph.wall(ph.half_space(POINT, NORMAL), stiffness=15_000)
    control = ph.controller(arm, arm.brakes(torque_limit=[1, 1]), ph.scene(wall), ph.direct_control())
    qd = np.linalg.solve(arm.jacobian(q), VELOCITY)
    result = control(ph.device_state(time=0, q=q, qd=qd, hand_force=[1, 2]))

    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.8), layout="constrained")
    plots.draw_device(arm, q, left)
    plots.draw_wall(left, POINT, NORMAL)
    left.set_title("The device at the wall")
    plots.draw_passive_fmes(arm, q, right, velocity=VELOCITY, normal=NORMAL, desired_force=result.desired_force)
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
