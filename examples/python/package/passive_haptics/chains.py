"""Serial chains by their usual shapes, and their inverse kinematics."""

import collections.abc

import numpy as np

from passive_haptics import _native
from passive_haptics.arrays import Array, Numbers, Path
from passive_haptics.devices import mechanism, serial_chain
from passive_haptics.results import status
from passive_haptics.values import readable


def planar_arm(lengths: collections.abc.Sequence[float]) -> serial_chain:
    """A planar arm of two to four revolute joints, all its links [m] along x in the zero pose."""
    *joints, handle = np.cumsum([0.0, *_native.vector(lengths, "lengths", -1)]).tolist()
    return serial_chain(joints=[{"point": [x, 0.0]} for x in joints], handle=[handle, 0.0])


def chain_from_urdf(path: Path, base: str, tip: str, tool: Numbers = (0.0, 0.0, 0.0), balanced: bool = False) -> serial_chain:
    """The chain of a URDF from the link `base` to the link `tip`, with inertia (docs/guide/urdf.md).

    `tool` is the handle in the frame of the tip [m]; `balanced` accepts an inertia that no rigid body has, changed as little
    as necessary. A chain of 2 to 4 joints that moves in one plane is planar. Warns about parts of the file that are left out.
    Raises ValueError with the file and its element, RuntimeError if the package is built without urdfdom.
    """
    return serial_chain(**_native.chain_from_urdf(readable(path), base, tip, tool, balanced))


def nearest_pose(mechanism: mechanism, x: Numbers, start: Numbers) -> tuple[Array, status]:
    """Joint positions that put the end effector at x [m], near `start`, and the status.

    For mechanisms without inverse(), such as chains. Uses damped least-squares steps (Levenberg,
    Marquardt) of minimum norm, about 10 us each. Out of reach, the result is the nearest point that
    the steps found (status.out_of_reach).
    """
    MOST_STEPS, LEAST_DAMPING, MOST_DAMPING, damping = 200, 1e-15, 1e6, 1e-3
    target, q = _native.vector(x, "x", mechanism.task_dimension), np.array(_native.vector(start, "start", mechanism.dof))
    error = target - mechanism.position(q)
    if not np.isfinite(error).all():
        return q, status.state_not_finite
    for _ in range(MOST_STEPS):
        J = mechanism.jacobian(q)
        square = J @ J.T
        damped = square + damping * max(float(np.trace(square)), 1e-12) * np.eye(len(target))
        further = q + J.T @ np.linalg.solve(damped, error)
        left = target - mechanism.position(further)
        if np.linalg.norm(left) < np.linalg.norm(error):
            q, error, damping = further, left, max(damping / 10, LEAST_DAMPING)
        elif damping < MOST_DAMPING:
            damping *= 10
        else:
            break
    reached = np.linalg.norm(error) <= 1e-9 * max(1e-3, float(np.linalg.norm(target)))
    return q, status.ok if reached else status.out_of_reach
