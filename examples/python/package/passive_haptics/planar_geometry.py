"""Where the links of a planar device are, for pictures."""

from __future__ import annotations

import collections.abc
import typing
from typing import Any

import numpy as np

from passive_haptics.arrays import Array, Numbers
from passive_haptics.devices import mechanism

Parameters = collections.abc.Mapping[str, Any]


class planar_geometry(typing.NamedTuple):
    """A planar device in a pose, base frame [m]."""

    links: list[Array]
    """The links, each a line through K points, K x 2; of a slide what it has slid."""
    joints: Array
    """Where it bends or slides, K x 2, the base first."""
    bases: Array
    """Those that are fixed to the ground, K x 2."""
    handle: Array
    """The end effector, 2."""


def _along(angle: float) -> Array:
    return np.array([np.cos(angle), np.sin(angle)])


def _serial(points: collections.abc.Sequence[Array]) -> planar_geometry:
    """A chain of links from the base to the handle."""
    links = [np.array(pair) for pair in zip(points, points[1:])]
    return planar_geometry(links, np.array(points[:-1]), np.array(points[:1]), points[-1])


def _two_link(p: Parameters, q: Array, handle: Array) -> planar_geometry:
    return _serial([np.zeros(2), p["length_1"] * _along(q[0]), handle])


def _xy_table(p: Parameters, q: Array, handle: Array) -> planar_geometry:
    return _serial([np.zeros(2), np.array([q[0], 0.0]), handle])


def _five_bar(p: Parameters, q: Array, handle: Array) -> planar_geometry:
    half = np.array([p["base_distance"] / 2, 0.0])
    bases = np.array([-half, half])
    elbows = np.array([bases[i] + p[f"proximal_{i + 1}"] * _along(q[i]) for i in range(2)])
    return planar_geometry(
        [np.array([bases[i], elbows[i], handle]) for i in range(2)], np.concatenate([bases, elbows]), bases, handle
    )


def _chain(p: Parameters, q: Array, handle: Array) -> planar_geometry:
    """By the joints of the zero pose. A slide has no place there: it is drawn where the joint before it
    is."""
    turned, moved, place = np.eye(2), np.zeros(2), np.zeros(2)
    points = []
    for joint, angle in zip(p["joints"], q):
        if joint["kind"] == "prismatic":
            points.append(turned @ place + moved)
            moved = moved + angle * (turned @ np.asarray(joint["axis"]) / np.linalg.norm(joint["axis"]))
        else:
            place = np.asarray(joint["point"], dtype=float)
            points.append(turned @ place + moved)
            turned = np.column_stack([_along(angle), _along(angle + np.pi / 2)]) @ turned
            moved = points[-1] - turned @ place
    return _serial([*points, handle])


_geometries: dict[str, collections.abc.Callable[[Parameters, Array, Array], planar_geometry]] = {
    "two_link": _two_link,
    "tendon_two_link": _two_link,
    "xy_table": _xy_table,
    "five_bar": _five_bar,
    "five_bar_with_four_brakes": _five_bar,
    "serial_chain": _chain,
}


def geometry_of(device: mechanism, q: Numbers) -> planar_geometry:
    """Where the parts of a planar device of this package are at joint positions q [rad or m].

    Throws ValueError for another device, and for a pose that the device cannot take.
    """
    kind = type(device).__name__
    if kind not in _geometries:
        raise ValueError(f"passive_haptics: device = {kind}, expected one of {', '.join(_geometries)}")
    positions = np.asarray(q, dtype=float)
    of: Any = device
    handle = of.position(positions)
    if not np.all(np.isfinite(handle)):
        raise ValueError(f"passive_haptics: q = {positions.tolist()}, expected a pose that the device can take")
    return _geometries[kind](of.parameters, positions, handle)
