"""Producible forces of planar devices as outlines: passive FMEs."""

from __future__ import annotations

import itertools
import math
import typing
from typing import Optional

import numpy as np

from passive_haptics.arrays import Array, Numbers
from passive_haptics.devices import brakes, mechanism
from passive_haptics.results import display_class, displayable_force, status

COARSE = 72
"""Directions of motion by which passive FMEs are distinguished."""
ANGLES = np.arange(720) * (2 * math.pi / 720)
"""Directions of forces [rad] at which an outline is computed."""
OUT_OF_LINE = 0.0123
"""The first direction of motion [rad]: no axis of a usual device."""
EDGE = 1e-9
"""Angle [rad] within which a direction is on the edge of a cone."""
HELD = 1e6
"""In a singular pose, the structure itself holds forces over so many times that of 1 N m [1]."""
CUT = 10.0
"""If there is such a force, an outline ends at so many times that at the longest lever [1]."""


class passive_fme(typing.NamedTuple):
    """Forces that the brakes can produce while the handle moves in one direction."""

    signs: Optional[tuple[int, int]]
    """Those of the torques of two brakes on two joints."""
    outline: Array
    """Closed, K x 2, with 0 [N]."""


def unit_vector(of: Numbers, name: str) -> Array:
    """The direction of a vector in the plane; raises ValueError if it has none."""
    vector = np.asarray(of, dtype=float)
    length = float(np.linalg.norm(vector))
    if vector.shape != (2,) or not 0 < length < math.inf:
        raise ValueError(f"passive_haptics: {name} = {vector.tolist()}: expected two finite numbers, not both 0")
    return vector / length


def _along(angle: Array | float) -> Array:
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def require_planar(device: mechanism, q: Numbers) -> None:
    """Raises ValueError unless the device is planar and can take the pose q."""
    if device.task_dimension != 2:
        raise ValueError(f"passive_haptics: device = {type(device).__name__}: expected a planar device")
    if not (np.all(np.isfinite(device.position(q))) and np.all(np.isfinite(device.jacobian(q)))):
        raise ValueError(f"passive_haptics: q = {list(q)}: expected a pose that the device can take")


def _usual_force(device: mechanism, q: Numbers) -> float:
    """The force of 1 N m at the longest lever, or of 1 N on a slide [N]."""
    return float(1 / np.linalg.norm(device.jacobian(q), axis=0).max())


def producible_outline(device: mechanism, q: Numbers, velocity: Numbers) -> Array:
    """The closed outline [N], K x 2, of the forces that brakes of 1 N m (1 N on slides) can produce along each
    direction by force approximation, while the handle moves with a velocity (only its direction matters).

    Each direction from 0 occurs once.
    """
    require_planar(device, q)
    limited = device.brakes(torque_limit=1.0)
    nearest = _displayable(device, q, velocity, ANGLES[::10], limited).nearest
    edges = np.arctan2(nearest[:, 1], nearest[:, 0])[nearest.any(axis=1)]
    angles = np.unique(np.concatenate([ANGLES, edges % (2 * math.pi)]))
    found = _displayable(device, q, velocity, angles, limited)
    radii = np.where(np.asarray(found.angle) < EDGE, found.max_approximated_force, 0.0)  # pi / 2 where there is no force
    usual = _usual_force(device, q)
    if np.any(radii > HELD * usual):
        radii = np.minimum(radii, CUT * usual)
    is_kept = (radii > 0) | (np.roll(radii, 1) > 0) | (np.roll(radii, -1) > 0)
    outline = (radii[:, None] * _along(angles))[is_kept]
    return np.concatenate([outline, outline[:1]])


def _displayable(
    device: mechanism, q: Numbers, velocity: Numbers, angles: Array, limited: Optional[brakes] = None
) -> displayable_force:
    """Along each of these directions [rad]."""
    return device.displayable(np.tile(q, (len(angles), 1)), velocity, _along(angles), limited)


def passive_fmes(device: mechanism, q: Numbers) -> list[passive_fme]:
    """The passive FMEs of a planar device at joint positions q [rad or m].

    For two brakes on two joints, those of the paper: forces of torques with a norm of 1 N m, four quarters of
    an ellipse. For other devices and nearly singular poses: forces of brakes of at most 1 N m each, as force
    approximation divides them, one region for each set of brake signs. A region that spans less than 5 degrees
    may be missed.
    """
    require_planar(device, q)
    if device.dof == device.brake_count == 2:
        forces, outcome = device.reference_forces(q)
        if outcome == status.ok and np.linalg.norm(forces, axis=0).max() < HELD * _usual_force(device, q):
            return [passive_fme(signs, outline) for signs, outline in device.passive_fme(q)]
    motions = [_along(OUT_OF_LINE + 2 * math.pi * k / COARSE) for k in range(COARSE)]
    sets = [list(alike) for _, alike in itertools.groupby(motions, lambda v: _shown_in_motion(device, q, v))]
    if len(sets) > 1 and _shown_in_motion(device, q, motions[0]) == _shown_in_motion(device, q, motions[-1]):
        sets[0] = sets.pop() + sets[0]
    return [passive_fme(None, producible_outline(device, q, alike[len(alike) // 2])) for alike in sets]


def _shown_in_motion(device: mechanism, q: Numbers, velocity: Array) -> bytes:
    """The signs of the brakes in each direction in which a force can be displayed."""
    found = _displayable(device, q, velocity, ANGLES[::10])
    return np.where(np.asarray(found.display == display_class.exact)[:, None], found.signs, 0).tobytes()
