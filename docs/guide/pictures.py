"""Draws the pictures of the page pictures.md: devices, their forces, maps and runs."""

import argparse
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import passive_haptics as ph
from passive_haptics import plots

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--output", default=".", help="the folder of the pictures")
folder = parser.parse_args().output
os.makedirs(folder, exist_ok=True)
figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.8), layout="constrained")

# A device at a wall
arm = ph.planar_arm([0.12, 0.1, 0.08])
q = [0.9, 0.5, -1.4]
plots.draw_device(arm, q, left)
plots.draw_wall(left, point=arm.position(q), normal=[0, -1])

# What its brakes can make
plots.draw_passive_fmes(arm, q, right, velocity=[0.05, 0.02], normal=[0, -1], desired_force=[0, -10])
figure.savefig(f"{folder}/device.png", dpi=150)

# A map
table = ph.five_bar()
x, y = np.meshgrid(np.linspace(-0.08, 0.08, 81), np.linspace(0.04, 0.14, 51))
q, outcomes = table.inverse(np.column_stack([x.flat, y.flat]))
found = table.displayable(q, velocity=[1, 0], normal=[0, -1])
angle = np.where(outcomes == ph.status.ok, np.degrees(found.angle), np.nan)
figure, axes = plt.subplots(layout="constrained")
colours = axes.pcolormesh(x, y, angle.reshape(x.shape), cmap="cividis", vmin=0, vmax=90)
figure.colorbar(colours, label="approximation angle [deg]", shrink=0.7)
plots.draw_device(table, table.inverse([0.04, 0.1])[0], axes)
figure.savefig(f"{folder}/map.png", dpi=150)

# A design map
figures = table.design_map(q, direction=[1, 0], normal=[0, -1], brakes=table.brakes(), push=2)
figure, panels = plt.subplots(2, 2, figsize=(10, 6.5), layout="constrained")
for axes, (name, highest) in zip(panels.flat, {"drag": 3, "max_force": 40, "sink_slope": 1, "isotropy": 1}.items()):
    values = np.where(outcomes == ph.status.ok, figures[name], np.nan)
    colours = axes.pcolormesh(x, y, values.reshape(x.shape), cmap="cividis", vmin=0, vmax=highest)
    figure.colorbar(colours, label=name, shrink=0.7)
    axes.set(aspect="equal", xlabel="x [m]", ylabel="y [m]")
figure.savefig(f"{folder}/design_map.png", dpi=100)

# Runs along a wall
device, wall = ph.tendon_two_link(), ph.half_space([0, 0.225], [0, -1])
brakes = device.brakes(torque_limit=0.13)  # just strong enough for the hand
figure, (depth, torque) = plt.subplots(2, 1, sharex=True, layout="constrained")
for law, colour in ((ph.no_direct_control(), plots.VERMILION), (ph.saturated_direct_control(), plots.BLUE)):
    simulated = ph.simulated_device(device, brakes, 0.5, device.inverse([0.045, 0.221])[0])
    hand = ph.following_hand([1, 0], simulated.position, push=1.75, normal_stiffness=300, target_depth=0.003)
    control = ph.controller(device, brakes, ph.scene(ph.wall(wall)), law)
    metrics, rows = ph.follow_wall(simulated, control, wall, hand, record=True)
    label = f"{type(law).__name__}: {metrics.separations} separations"
    depth.plot(rows["time"], 1e3 * rows["depth"], color=colour, label=label)
    torque.plot(rows["time"], rows["brake_torque"], color=colour)
depth.set(ylabel="depth [mm]")
depth.legend()
torque.set(xlabel="time [s]", ylabel="torques of the brakes [N m]")
figure.savefig(f"{folder}/runs.png", dpi=100)
