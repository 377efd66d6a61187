"""Positions of the links of a planar device, for pictures."""

from __future__ import annotations

import collections.abc
from typing import Any

import numpy as np

from passive_haptics.arrays import Array, Numbers
from passive_haptics.devices import mechanism

Parameters = collections.abc.Mapping[str, Any]


def _along(angle: float) -> Array:
    return np.array([np.cos(angle), np.sin(angle)])


def _two_link(p: Parameters, q: Array, handle: Array) -> list[Array]:
    return [np.array([np.zeros(2), p["length_1"] * _along(q[0]), handle])]


def _xy_table(p: Parameters, q: Array, handle: Array) -> list[Array]:
    return [np.array([np.zeros(2), [q[0], 0.0], handle])]


def _five_bar(p: Parameters, q: Array, handle: Array) -> list[Array]:
    bases = np.array([[-0.5, 0.0], [0.5, 0.0]]) * p["base_distance"]
    elbows = [bases[i] + p[f"proximal_{i + 1}"] * _along(q[i]) for i in range(2)]
    return [np.array([bases[i], elbows[i], handle]) for i in range(2)]


def _chain(p: Parameters, q: Array, handle: Array) -> list[Array]:
    """Links by the joints of the zero pose. A slide has no position there and is drawn at the joint before it."""
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
    return [np.array([*points, handle])]


_links: dict[str, collections.abc.Callable[[Parameters, Array, Array], list[Array]]] = {
    "two_link": _two_link,
    "tendon_two_link": _two_link,
    "xy_table": _xy_table,
    "five_bar": _five_bar,
    "five_bar_with_four_brakes": _five_bar,
    "serial_chain": _chain,
}


def links_of(device: mechanism, q: Numbers) -> list[Array]:
    """The links of a planar device of this package in a pose q [rad or m], base frame [m]: lines from each
    base over the joints to the handle, K x 2.

    Raises ValueError for other devices, and for poses that the device cannot reach.
    """
    kind = type(device).__name__
    if kind not in _links or device.task_dimension != 2:
        raise ValueError(f"passive_haptics: device = {kind}: expected a planar one of {', '.join(_links)}")
    positions = np.asarray(q, dtype=float)
    handle = device.position(positions)
    if not np.all(np.isfinite(handle)):
        text = f"passive_haptics: q = {positions.tolist()}: expected a pose that the device can take"
        raise ValueError(text)
    return _links[kind](device.parameters, positions, handle)
