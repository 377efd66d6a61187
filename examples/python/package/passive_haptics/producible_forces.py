"""The forces that the brakes of any planar device can make, as outlines: passive FMEs."""

from __future__ import annotations

import itertools
import math
import typing
from typing import Any, Optional

import numpy as np

from passive_haptics.arrays import Array, Numbers
from passive_haptics.devices import mechanism
from passive_haptics.results import display_class, status

COARSE = 72
"""Directions of motion, and of forces, by which passive FMEs are distinguished."""
FINE = 720
"""Directions of forces at which an outline is computed."""
OUT_OF_LINE = 0.0123
"""The first direction of motion [rad]: no axis of a usual device."""
EDGE = 1e-9
"""Angle [rad] within which a direction is on the edge of a cone."""
HELD = 1e6
"""A force so many times that of 1 N m at the longest lever [1] is held by the structure itself, in a singular
pose."""
CUT = 10.0
"""If there is such a force, an outline ends at so many times that at the longest lever [1]."""


class passive_fme(typing.NamedTuple):
    """Forces that the brakes can make while the handle moves one way."""

    signs: Optional[tuple[int, ...]]
    """Those of the torques; None where they are not the same for all of the forces."""
    outline: Array
    """Closed, K x 2, with 0 [N]."""


class force_towards(typing.NamedTuple):
    """What the brakes can make of a force."""

    force: Array
    """The nearest force [N], 0 where there is none."""
    angle: float
    """Between the two [rad]."""


def unit_vector(of: Numbers, name: str = "direction") -> Array:
    """The direction of a vector in the plane; throws ValueError if it has none."""
    vector = np.asarray(of, dtype=float)
    length = float(np.linalg.norm(vector))
    if vector.shape != (2,) or not 0 < length < math.inf:
        raise ValueError(f"passive_haptics: {name} = {vector.tolist()}, expected two finite numbers, not both 0")
    return vector / length


def _unit(angle: float) -> Array:
    return np.array([math.cos(angle), math.sin(angle)])


def _require_planar(device: Any, q: Numbers) -> None:
    if device.task_dimension != 2:
        raise ValueError(
            f"passive_haptics: device = {type(device).__name__}, whose task has {device.task_dimension} dimensions, "
            "expected a planar device"
        )
    if not (np.all(np.isfinite(device.position(q))) and np.all(np.isfinite(device.jacobian(q)))):
        raise ValueError(f"passive_haptics: q = {list(q)}, expected a pose that the device can take")


def _brakes_of_1(device: Any) -> Any:
    return device.brakes(torque_limit=np.ones(device.brake_count))


def _usual_force(device: Any, q: Numbers) -> float:
    """What 1 N m makes at the longest lever, or 1 N on a slide [N]."""
    return float(1 / np.linalg.norm(device.jacobian(q), axis=0).max())


def _direction_nearest(device: Any, q: Numbers, velocity: Numbers, angle: float, brakes: Any) -> Optional[float]:
    """The direction [rad] of the force nearest to that in a direction; None where there is none."""
    found = device.displayable(q, velocity, _unit(angle), brakes)
    if found.display == display_class.exact:
        return angle
    if found.display != display_class.approximate:
        return None
    sides = [angle + float(found.angle), angle - float(found.angle)]
    return min(sides, key=lambda side: float(device.displayable(q, velocity, _unit(side), brakes).angle))


def nearest_producible(
    device: mechanism, q: Numbers, velocity: Numbers, desired_force: Numbers
) -> force_towards:
    """The force nearest to the desired one [N] that brakes without limits can make while the handle moves
    with a velocity, whose direction counts [m/s]; (0, pi / 2) where there is none. Throws ValueError for a
    force 0, a device in space and a pose that it cannot take."""
    _require_planar(device, q)
    Fd = np.asarray(desired_force, dtype=float)
    n = unit_vector(Fd, "desired_force")
    angle = math.atan2(n[1], n[0])
    nearest = _direction_nearest(device, q, velocity, angle, None)
    if nearest is None:
        return force_towards(np.zeros(2), math.pi / 2)
    if nearest == angle:
        return force_towards(Fd, 0.0)
    return force_towards(float(Fd @ _unit(nearest)) * _unit(nearest), abs(nearest - angle))


def producible_outline(device: mechanism, q: Numbers, velocity: Numbers) -> Array:
    """Closed outline [N], K x 2, of the forces that brakes of 1 N m (of 1 N on slides) can make along each
    direction by force approximation, while the handle moves with a velocity, whose direction counts [m/s].
    Seen from 0, each direction is met once. Cost: some thousand calls of displayable."""
    _require_planar(device, q)
    of: Any = device
    brakes = _brakes_of_1(of)
    edges: list[float] = []
    for k in range(COARSE):
        edge = _direction_nearest(of, q, velocity, 2 * math.pi * k / COARSE, brakes)
        if edge is not None:
            edges.append(edge % (2 * math.pi))
    angles = np.unique(np.concatenate([np.arange(FINE) * (2 * math.pi / FINE), edges]))
    radii = np.zeros(len(angles))
    for k, angle in enumerate(angles):
        found = of.displayable(q, velocity, _unit(angle), brakes)
        if found.angle < EDGE:  # pi / 2 where there is no force
            radii[k] = found.max_approximated_force
    usual = _usual_force(of, q)
    if np.any(radii > HELD * usual):
        radii = np.minimum(radii, CUT * usual)
    points = radii[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
    kept = [k for k in range(len(points)) if radii[k] > 0 or radii[k - 1] > 0 or radii[(k + 1) % len(radii)] > 0]
    outline = points[kept]
    return np.concatenate([outline, outline[:1]])


def passive_fmes(device: mechanism, q: Numbers) -> list[passive_fme]:
    """The passive FMEs of a planar device at joint positions q [rad or m].

    Two brakes on two joints: those of the paper, forces of torques whose norm is 1 N m, four quarters of an
    ellipse. Any other device, and poses that are singular or all but singular: forces of brakes of at most 1
    N m each, as force approximation divides them, for each set of directions of motion that differ in what
    can be made. A set that spans less than 5 degrees may be missed. Throws ValueError for a device in space
    and a pose that it cannot take.
    """
    _require_planar(device, q)
    of: Any = device
    if device.dof == device.brake_count == 2:
        regions = [passive_fme(tuple(signs), outline) for signs, outline in of.passive_fme(q)]
        forces, outcome = of.reference_forces(q)
        if outcome == status.ok and np.linalg.norm(forces, axis=0).max() < HELD * _usual_force(of, q):
            return regions
    brakes = _brakes_of_1(of)
    directions = [OUT_OF_LINE + 2 * math.pi * k / COARSE for k in range(COARSE)]
    sets = [
        (shown, list(ways))
        for shown, ways in itertools.groupby(directions, lambda way: _shown_in_motion(of, q, _unit(way), brakes))
    ]
    if len(sets) > 1 and sets[0][0] == sets[-1][0]:
        sets[-1][1].extend(direction + 2 * math.pi for direction in sets.pop(0)[1])
    return [
        passive_fme(_only_signs(shown), producible_outline(device, q, _unit(ways[len(ways) // 2])))
        for shown, ways in sets
    ]


def _shown_in_motion(device: Any, q: Numbers, velocity: Numbers, brakes: Any) -> list[Optional[tuple[int, ...]]]:
    """Of each direction in which a force can be displayed, the signs of the torques that do it; None of the others."""
    found = [device.displayable(q, velocity, _unit(2 * math.pi * k / COARSE), brakes) for k in range(COARSE)]
    return [tuple(-int(s) for s in each.signs) if each.display == display_class.exact else None for each in found]


def _only_signs(shown: list[Optional[tuple[int, ...]]]) -> Optional[tuple[int, ...]]:
    """The signs that all forces have, none of them 0; else None."""
    signs = {each for each in shown if each is not None}
    only = signs.pop() if len(signs) == 1 else (0,)
    return only if all(only) else None
