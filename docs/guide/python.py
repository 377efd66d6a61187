"""The pieces of code of the page python.md."""

# The imports
import os
import pickle
import tempfile

import numpy as np

import passive_haptics as ph
from passive_haptics.arrays import Array

os.chdir(os.path.dirname(os.path.abspath(__file__)))

# The loop
arm = ph.tendon_two_link()  # the paper's device: two links of 0.15 m, both brakes at the base
brakes = arm.brakes()
plane = ph.half_space([0, 0.225], [0, -1])  # a point of the surface [m], the outward normal
control = ph.controller(arm, brakes, ph.scene(ph.wall(plane)), arm.recommended_law(brakes))

start = np.array([0.05, 0.224])  # 1 mm before the wall [m]
hand = ph.following_hand([1, 0], start)  # moves with 5 cm/s and presses with 2 N
plant = ph.simulated_device(arm, brakes, hand.mass, arm.inverse(start)[0])

for k in range(2001):  # a control loop of 1 kHz
    state = ph.device_state(1e-3 * k, plant.q, plant.qd, plant.sensed_force)
    result = control(state)  # what the brakes may hold: result.capacity
    depth = -plane.distance(plant.position)
    push = hand.force(state.time, plant.position, plant.velocity, [0, -1], depth)
    plant.advance(1e-3, result.capacity, push)
    if k % 400 == 0:
        x = 1e3 * (plant.position - start)[0]
        print(f"{state.time:.1f} s: {x:2.0f} mm along the wall, {1e3 * depth:5.2f} mm deep, feels {state.hand_force[1]:.2f} N")

# One cycle
arm = ph.tendon_two_link(reduction_2=0.4)
brakes = arm.brakes(torque_limit=1)
wall = ph.wall(ph.half_space([0, 0.225], [0, -1]), stiffness=1e5)
control = ph.controller(arm, brakes, ph.scene(wall), ph.direct_control())

q, outcome = arm.inverse([0.1, 0.226])  # 1 mm behind the wall
result = control(ph.device_state(time=0, q=q, qd=[0.5, -0.2], hand_force=[0.5, 2]))
print(result.capacity, result.display.text)

# A device file
device_of_file = ph.load("../../examples/catalogue/devices/paper.toml")
control_of_file = device_of_file.controller()
plant = device_of_file.plant(q=[1.8, -1.2])
print(device_of_file.mechanism, device_of_file.law)

# Many states
random = np.random.default_rng(1)
positions = q + random.uniform(-0.1, 0.1, (100_000, 2))
rates = random.uniform(-1, 1, (100_000, 2))
pushes = random.uniform(-4, 4, (100_000, 2))
results = control.batch(positions, rates, pushes, fields=["display", "alpha"])
results = control.batch(positions, rates, -pushes, out=results, workers=-1)  # into the same arrays, on all processors
share = np.mean(results.display == ph.display_class.approximate)
print(f"{share:.0%} of the states are displayed approximately")

# What a device can display
forces, outcome = arm.reference_forces(q)
signs = arm.brake_signs(q, [0.5, -0.2])
nearest = arm.nearest_force(q, signs, [0, -5])
found = arm.displayable(q, velocity=[0.05, 0], normal=[0, -1], brakes=brakes)
print(f"{found.max_force:.1f} N at most, {np.degrees(found.angle):.0f} degrees off")

# Before there is a device
x, y = np.meshgrid(np.linspace(0.05, 0.15, 21), np.linspace(0.15, 0.25, 21))
places, outcomes = arm.inverse(np.column_stack([x.flat, y.flat]))
print(f"{np.mean(outcomes == ph.status.ok):.0%} of the places are in reach")
figures = arm.design_map(places, direction=[1.0, 0.0], normal=[0.0, -1.0], brakes=brakes, push=2)
print(f"sink slope: {np.median(figures['sink_slope']):.2f} m for each metre along the wall")
depth = arm.sink_depth(places[:21], [1.0, 0.0], [0.0, -1.0], brakes, push=2)

# Along a wall
device = ph.simulated_device(arm, brakes, hand_mass=0.5, q=arm.inverse([0.0, 0.22])[0])
hand = ph.following_hand(direction=[1, 0], start=device.position, push=2)
plane = ph.half_space([0, 0.225], [0, -1])
gentle = ph.controller(arm, brakes, ph.scene(ph.wall(plane, 1e4)), arm.recommended_law(brakes))
metrics, samples = ph.follow_wall(device, gentle, plane, hand, ph.wall_following_parameters(max_duration=2), record=True)
print(f"{metrics.separations} separations, {1e3 * metrics.depth_mean:.1f} mm deep; {metrics.end.text}")
deepest = samples["time"][np.argmax(samples["depth"])]

# Meshes
mesh, remarks = ph.read_stl("mesh_file.stl", metres_per_unit=1e-3)  # also read_obj and read_ply
print(remarks, mesh.plausibility(reach=0.4))  # nothing, if all is well
roof = ph.mesh(
    np.array([[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.1, 0.1, 0.05]]),  # vertices [m]
    np.array([[0, 1, 2], [1, 3, 2]]),  # triangles, counterclockwise from the free side
)
room = ph.world([
    ph.wall(ph.mesh_solid(mesh), 1e5),
    ph.wall(ph.mesh_surface(roof), 1e5),
    *(ph.wall(ph.ball([0.02 * i, 0.02 * j, -0.1], 0.005), 1e5) for i in range(10) for j in range(10)),
])
robot = ph.delta()
in_room = ph.controller(robot, robot.brakes(), room, ph.direct_control())

# A slow virtual environment
seen = ph.held_scene(ph.scene(ph.wall(plane, 1e4)), period=0.05)  # 20 Hz
slow = ph.controller(arm, brakes, seen, arm.recommended_law(brakes))

# Effects
handle = ph.with_effects(
    ph.scene(ph.wall(plane, 1e4)),
    ph.rough_walls(coefficient=0.3),  # friction on the wall
    ph.detents(origin=[0, 0.2], direction=[1, 0], spacing=0.02, strength=1),
    ph.end_stops(lower=[-1, 0.2], upper=[2, 2.5], stiffness=[5, 5]),
)
felt = ph.controller(arm, brakes, handle, ph.direct_control())

# Logs
folder = tempfile.TemporaryDirectory()
path = os.path.join(folder.name, "motion.csv")
columns = np.column_stack([1e-3 * np.arange(len(positions)), positions, rates, pushes])
np.savetxt(path, columns, fmt="%.17g", delimiter=",", header="t,q1,q2,qd1,qd2,Fh_x,Fh_y", comments="")
log, units = ph.read_log(path)
print(", ".join(f"{name} [{unit}]" for name, unit in units.items()))
q, qd, Fh = (np.column_stack([log[a], log[b]]) for a, b in (("q1", "q2"), ("qd1", "qd2"), ("Fh_x", "Fh_y")))
again = control.batch(q, qd, Fh, log["t"])

# Brakes that are off
control.set_brakes(arm.brakes(torque_limit=1, torque_lower=[0, -np.inf], torque_upper=[0, np.inf]))

# A mechanism in Python
def boom(q: Array) -> Array:
    """The end of a boom that turns by q[0] [rad] and slides by q[1] [m]."""
    return np.array([q[1] * np.cos(q[0]), q[1] * np.sin(q[0])])


def boom_jacobian(q: Array) -> Array:
    """J, 2 x 2: the turn [m/rad] and the slide [1]."""
    x, y = np.cos(q[0]), np.sin(q[0])
    return np.array([[-q[1] * y, x], [q[1] * x, y]])


crane = ph.python_mechanism(dof=2, task_dimension=2, position=boom, jacobian=boom_jacobian)
relay = ph.controller(crane, crane.brakes(), ph.scene(wall), crane.recommended_law())
result = relay(ph.device_state(time=0, q=[1.2, 0.25], qd=[0.1, 0.1], hand_force=[0.5, 2]))

# Values
assert pickle.loads(pickle.dumps(control)) == control
try:
    ph.tendon_two_link(length_1=-1)
except ValueError as error:
    print(error)
