"""The devices of these tests and their states; reference.cpp and chains.hpp have the same numbers."""

import numpy as np

import passive_haptics as ph

LAWS = ["direct_control", "saturated_direct_control", "recommended"]
OTHER_LAWS = ["no_direct_control", "on_off_control"]  # of the paper's device


def geometry(n, d):
    joints = []
    for i in range(n):
        axis = [0, 0] if d == 2 else [0, 0, 1] if i % 2 == 0 else [0, -1, 0]
        joints.append({"kind": "revolute", "axis": axis, "point": [0.1 * i] + [0] * (d - 1)})
    return {"joints": joints, "handle": [0.1 * n] + [0] * (d - 1)}


def inertia(n, d):
    about = [0.0002] if d == 2 else 0.0002 * np.eye(3)
    link = lambda i: {"mass": 0.2, "centre": [0.1 * i + 0.05] + [0] * (d - 1), "about_centre": about}
    return {"links": [link(i) for i in range(n)]}


def chain(n, d):
    return ph.serial_chain(**geometry(n, d))


def heavy_chain(n, d):
    return ph.serial_chain(**geometry(n, d), **inertia(n, d))


DEVICES = {
    "tendon_two_link": ph.tendon_two_link,
    "two_link": ph.two_link,
    "xy_table": ph.xy_table,
    "five_bar": ph.five_bar,
    "five_bar_with_four_brakes": ph.five_bar_with_four_brakes,
    "delta": ph.delta,
    "planar_chain_3": lambda: chain(3, 2),
    "planar_chain_4": lambda: chain(4, 2),
    "spatial_chain_3": lambda: chain(3, 3),
    "spatial_chain_6": lambda: chain(6, 3),
    "spatial_chain_7": lambda: chain(7, 3),
    "planar_chain_3_with_inertia": lambda: heavy_chain(3, 2),
    "planar_chain_4_with_inertia": lambda: heavy_chain(4, 2),
    "spatial_chain_3_with_inertia": lambda: heavy_chain(3, 3),
}

# Joint positions about which the states lie, where the loops of closed chains close
MIDDLE = {
    "xy_table": [0.1, 0.2],
    "five_bar": [2.0, 1.1],
    "five_bar_with_four_brakes": [2.0, 1.1],
    "delta": [0.5, 0.5, 0.5],
}


def middle(name, dof):
    return np.array(MIDDLE.get(name, [0.4 + 0.3 * (i % 2) for i in range(dof)]), dtype=float)


class Case:
    """A device, a wall, brakes and N states about that wall: random ones, and in front the edge cases."""

    def __init__(self, name, count, seed):
        self.name = name
        self.device = DEVICES[name]()
        n, d, m = self.device.dof, self.device.task_dimension, self.device.brake_count
        random = np.random.default_rng(seed)
        q0 = middle(name, n)
        reach = 0.02 if name == "xy_table" else 0.2
        self.q = q0 + reach * random.uniform(-1, 1, (count, n))
        self.qd = random.uniform(-1, 1, (count, n)) * np.where(random.random((count, 1)) < 0.2, 0.01, 1)
        self.hand_force = random.uniform(-4, 4, (count, d))
        self.time = np.arange(count) * 1e-3
        self.point = self.device.position(q0)
        self.normal = np.array([0.6, -0.8] if d == 2 else [0.48, -0.6, 0.64])
        self.stiffness = 1e5
        self.torque_limit = np.linspace(0.5, 1.5, m)
        self.edges()

    def edges(self):
        q, qd, force, time = self.q, self.qd, self.hand_force, self.time
        qd[0:20] = 0
        force[10:30] = 0
        qd[30, 0], qd[31, -1], force[32, 0], q[33, 0], time[34] = np.nan, np.inf, -np.inf, np.nan, np.nan
        qd[35:40] = 5e-324
        force[40:45] = 5e-324
        qd[45:50] = -0.0
        q[50:60] = 0.0
        q[60, :], qd[61, :], force[62, :] = 1e300, 1e300, 1e300

    def scene(self):
        return ph.scene(ph.wall(ph.half_space(self.point, self.normal), self.stiffness))

    def brakes(self):
        return self.device.brakes(torque_limit=self.torque_limit)

    def law(self, name):
        return self.device.recommended_law(self.brakes()) if name == "recommended" else getattr(ph, name)()

    def controller(self, law):
        return ph.controller(self.device, self.brakes(), self.scene(), self.law(law))

    def write(self, path):
        rows = np.column_stack([self.time, self.q, self.qd, self.hand_force])
        head = [*self.point, *self.normal, self.stiffness, *self.torque_limit]
        with open(path, "wb") as file:
            file.write(np.array(head, dtype=float).tobytes())
            file.write(np.ascontiguousarray(rows).tobytes())


def pairs():
    """The compared pairs of a device and a law; tests/unit/runtime compares the controllers of all."""
    compared = ("tendon_two_link", "delta", "planar_chain_3")
    return [(device, law) for device in compared for law in LAWS] + [("tendon_two_link", law) for law in OTHER_LAWS]
