"""The pieces of code of the page pictures.md: python pictures.py FOLDER."""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import passive_haptics as ph
from passive_haptics import map_plots, plots, run_plots

figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.8), layout="constrained")

# A device at a wall
arm = ph.planar_arm([0.12, 0.1, 0.08])
q = [0.9, 0.5, -1.4]
plots.draw_device(arm, q, left)
plots.draw_wall(left, point=arm.position(q), normal=[0, -1])

# What its brakes can make
plots.draw_passive_fmes(arm, q, right, velocity=[0.05, 0.02], normal=[0, -1], desired_force=[0, -10])
figure.savefig(sys.argv[1] + "/device.png", dpi=150)

# A map
table = ph.five_bar()
x, y = np.linspace(-0.08, 0.08, 81), np.linspace(0.04, 0.14, 51)
angle = lambda q: float(np.degrees(table.displayable(q, velocity=[1, 0], normal=[0, -1]).angle))
axes = plots.draw_map(x, y, plots.values_over(table, x, y, angle), label="approximation angle [deg]", limits=(0, 90))
plots.draw_device(table, table.inverse([0.04, 0.1])[0], axes)
axes.figure.savefig(sys.argv[1] + "/map.png", dpi=150)

# A design map
device = ph.tendon_two_link()
x, y = np.linspace(-0.3, 0.3, 61), np.linspace(0, 0.3, 31)
found = map_plots.map_over(device, x, y, direction=[1, 0], normal=[0, -1], brakes=device.brakes(), push=2)
map_plots.draw_design_map(x, y, found)[0].figure.savefig(sys.argv[1] + "/design_map.png", dpi=100)

# Runs along a wall
wall, runs = ph.half_space([0, 0.225], [0, -1]), {}
brakes = device.brakes(torque_limit=[0.13, 0.13])  # just strong enough for the hand
for law in (ph.no_direct_control(), ph.saturated_direct_control()):
    simulated = ph.simulated_device(device, brakes, 0.5, device.inverse([0.045, 0.221])[0])
    hand = ph.following_hand([1, 0], simulated.position, push=1.75, normal_stiffness=300, target_depth=0.003)
    control = ph.controller(device, brakes, ph.scene(ph.wall(wall)), law)
    figures, rows = ph.follow_wall(simulated, control, wall, hand, record=True)
    runs[f"{type(law).__name__}: {figures.separations} separations"] = rows
run_plots.draw_runs(runs)[0].figure.savefig(sys.argv[1] + "/runs.png", dpi=100)
