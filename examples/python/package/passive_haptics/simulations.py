"""Simulated devices and hands, and the wall-following experiment."""

from __future__ import annotations

import collections.abc
from typing import Any, Optional, Union, cast

import numpy as np

from passive_haptics import _native
from passive_haptics.arrays import Array, Numbers, Records
from passive_haptics.catalogue import coulomb_brake, following_hand, wall_following_parameters
from passive_haptics.catalogue_values import brake_model, shape
from passive_haptics.controllers import controller
from passive_haptics.devices import brakes, mechanism
from passive_haptics.results import contact_metrics
from passive_haptics.values import expect, value


class simulated_device(value):
    """A simulated device, at rest at joint positions q: a mechanism with inertia, real brakes and the mass of a hand on
    its handle. Pickling, and `parameters`, give the initial state.

    Parameters
    ----------
    mechanism : mechanism
    brakes : brakes, or a list of brake models
        `brakes` are exactly what the controller assumes; models may differ.
    hand_mass : float [kg]
    q : n numbers [rad or m]
    """

    def __init__(
        self,
        mechanism: mechanism,
        brakes: Union[brakes, collections.abc.Sequence[brake_model]],
        hand_mass: float,
        q: Numbers,
    ) -> None:
        expect(mechanism, _mechanism, "mechanism", "a mechanism such as two_link()")
        models = _models(mechanism, brakes)
        mass = _native.number(hand_mass, "hand_mass")
        self._held = _native.plant(mechanism._held, [each._held for each in models], mass, q)
        self._parameters = {"mechanism": mechanism, "brakes": brakes, "hand_mass": mass, "q": self._held.q().tolist()}

    def advance(self, dt: float, capacity: Numbers, muscle_force: Numbers) -> None:
        """Advances by a time step dt [s], with commanded capacities [N m] and the force of the hand's muscles [N].

        Does nothing unless dt is a finite number > 0. If dt is more than twice the time constants of the hand's spring and
        damper, the motion diverges.
        """
        self._held.advance(_native.number(dt, "dt"), capacity, muscle_force)

    def set_motion(self, q: Numbers, qd: Numbers) -> None:
        """Sets joint positions [rad or m] and rates, and resets the energy balance."""
        self._held.set_motion(q, qd)

    @property
    def q(self) -> Array:
        """Joint positions now [rad or m]."""
        return cast(Array, self._held.q())

    @property
    def qd(self) -> Array:
        """Joint rates now [rad/s or m/s]."""
        return cast(Array, self._held.qd())

    @property
    def position(self) -> Array:
        """The handle now [m]."""
        return cast(Array, self._held.position())

    @property
    def velocity(self) -> Array:
        """The handle's velocity [m/s]."""
        return cast(Array, self._held.velocity())

    @property
    def sensed_force(self) -> Array:
        """Force of the hand on the handle in the last step [N]."""
        return cast(Array, self._held.sensed_force())

    @property
    def brake_torque(self) -> Array:
        """Mean torque of the brakes in the last step [N m]."""
        return cast(Array, self._held.brake_torque())


_mechanism = mechanism


def _models(device: mechanism, given: Any) -> list[Any]:
    """One model for each brake."""
    if isinstance(given, brakes):
        device._brakes(given)
        p = given.parameters
        if np.isfinite(p["torque_lower"]).any() or np.isfinite(p["torque_upper"]).any():
            raise ValueError("passive_haptics: brakes of a simulated_device: expected brakes that work both ways, or brake models")
        return [coulomb_brake(torque_limit=t, time_constant=lag) for t, lag in zip(p["torque_limit"], p["time_constant"])]
    expect(given, (list, tuple), "brakes", "what brakes() of the mechanism returns, or a list of brake models")
    if len(given) != device.brake_count:
        raise ValueError(f"passive_haptics: number of brakes = {len(given)}: expected {device.brake_count} models")
    return [expect(each, brake_model, f"brakes[{i}]", "a brake model such as coulomb_brake()") for i, each in enumerate(given)]


def follow_wall(
    device: simulated_device,
    controller: controller,
    shape: shape,
    hand: following_hand,
    parameters: Optional[wall_following_parameters] = None,
    *,
    record: bool = False,
) -> tuple[contact_metrics, Records]:
    """The wall-following experiment: a hand moves the device along a shape, the measured wall, under a
    controller. Ctrl-C stops it.

    The device and the controller continue from their present state. Time begins at 0: reset() a controller that has run.

    Returns
    -------
    metrics, samples
        Figures of the run. If record is true, samples has a row for each time step: time [s], depth [m], position [m],
        velocity [m/s], rates of the brakes, brake_torque [N m], brake_power [W], hand_force [N], brake_force [N], and of the
        latest control cycle capacity [N m], alpha, outcome, power, display, saturated and wall_number.
    """
    expect(device, simulated_device, "device", "a simulated_device")
    expect(controller, _controller, "controller", "a controller(mechanism, brakes, scene, law)")
    expect(shape, _shape, "shape", "a shape such as half_space(...)")
    expect(hand, following_hand, "hand", "a following_hand(direction, start)")
    parameters = wall_following_parameters() if parameters is None else parameters
    expect(parameters, wall_following_parameters, "parameters", "wall_following_parameters(...)")
    of = device._parameters["mechanism"]
    n, d, m = of._held.sizes()
    if controller._parameters["mechanism"]._held.sizes() != (n, d, m):
        raise ValueError("passive_haptics: controller is of another mechanism: expected one of the device's sizes")
    metrics, numbers = _native.follow_wall(
        of._held, device._held, controller._held, shape._held, hand._held, parameters._held, record
    )
    widths = {"time": (), "depth": (), "position": d, "velocity": d, "rates": m, "brake_torque": m, "brake_power": m}
    widths |= {"hand_force": d, "brake_force": d, "capacity": m, "alpha": ()}
    whole = [(name, "i8") for name in ("outcome", "power", "display", "saturated", "wall_number")]
    return metrics, numbers.view([*((name, "f8", width) for name, width in widths.items()), *whole])


_controller = controller
_shape = shape
