"""Simulated devices and hands, and the wall-following experiment."""

from __future__ import annotations

import collections.abc
from typing import Any, Optional, Union

import numpy as np

from passive_haptics import _native
from passive_haptics.arrays import Array, Numbers, Records
from passive_haptics.catalogue import braked_wall, coulomb_brake, wall_following_parameters
from passive_haptics.catalogue_values import brake_model, shape
from passive_haptics.controllers import controller
from passive_haptics.devices import brakes, mechanism
from passive_haptics.progress import progress_line
from passive_haptics.results import contact_metrics, wall_limits
from passive_haptics.values import expect, number, value


class simulated_device(value):
    """A device without hardware, at rest at joint positions q: a mechanism with inertia, real brakes and a hand's mass on
    its handle. A pickled one, and parameters, are those of the start.

    Parameters
    ----------
    mechanism : mechanism
    brakes : brakes, or a list of brake models
        What brakes() of the mechanism returns are brakes that are what their controller assumes.
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
        self._parameters = {"mechanism": mechanism, "brakes": brakes, "hand_mass": number(hand_mass, "hand_mass")}
        self._parameters["q"] = np.array(q, dtype=float).tolist()
        self._held = _native.plant(mechanism._held, [each._held for each in models], hand_mass, q)

    def advance(self, dt: float, capacity: Numbers, muscle_force: Numbers) -> None:
        """One time step dt [s] under commanded capacities [N m] and the force that the hand's muscles exert [N].

        No time passes unless dt is a finite number > 0. A dt over twice the time constants of the hand's spring and damper
        makes the motion grow until it is NaN.
        """
        self._held.advance(number(dt, "dt"), capacity, muscle_force)

    def set_motion(self, q: Numbers, qd: Numbers) -> None:
        """Sets joint positions [rad or m] and rates, and begins the energy balance again."""
        self._held.set_motion(q, qd)

    @property
    def q(self) -> Array:
        """Joint positions now [rad or m]."""
        return self._now("q")

    @property
    def qd(self) -> Array:
        """Joint rates now [rad/s or m/s]."""
        return self._now("qd")

    @property
    def position(self) -> Array:
        """The handle now [m]."""
        return self._now("position")

    @property
    def velocity(self) -> Array:
        """The handle's velocity [m/s]."""
        return self._now("velocity")

    @property
    def rates(self) -> Array:
        """Rates of the brakes [rad/s or m/s]."""
        return self._now("rates")

    @property
    def sensed_force(self) -> Array:
        """Force of the hand on the handle in the last step [N]."""
        return self._now("sensed_force")

    @property
    def brake_torque(self) -> Array:
        """Mean torque of the brakes in the last step [N m]."""
        return self._now("brake_torque")

    @property
    def brake_force(self) -> Array:
        """The force at the handle that does what these torques do [N]."""
        return self._now("brake_force")

    @property
    def energy(self) -> dict[str, float]:
        """Where the energy came from and went since the motion was set [J], and the maximum power of a brake [W]."""
        found: dict[str, float] = self._held.energy()
        return found

    def _now(self, name: str) -> Array:
        of: Array = getattr(self._held, name)()
        return of


_mechanism = mechanism


def _models(device: mechanism, given: Any) -> list[Any]:
    """A model for each brake."""
    if isinstance(given, brakes):
        device._brakes(given)
        p = given.parameters
        if np.isfinite(p["torque_lower"]).any() or np.isfinite(p["torque_upper"]).any():
            raise ValueError(
                "passive_haptics: brakes of a simulated_device have a torque_lower or torque_upper, expected brakes that work "
                "both ways, or a list of brake models; a controller commands those that are off nothing"
            )
        return [coulomb_brake(torque_limit=limit, time_constant=lag) for limit, lag in zip(p["torque_limit"], p["time_constant"])]
    if not isinstance(given, (list, tuple)):
        expect(given, brakes, "brakes", "what brakes() of the mechanism returns, or a list of brake models")
    if len(given) != device.brake_count:
        raise ValueError(
            f"passive_haptics: number of brakes = {len(given)}, expected {device.brake_count}, a model for each brake of the "
            "mechanism"
        )
    return [expect(each, brake_model, f"brakes[{i}]", "a brake model such as coulomb_brake()") for i, each in enumerate(given)]


class following_hand(value):
    """A hand that moves along a wall in a direction and presses on it.

    Parameters
    ----------
    direction : d numbers
        Along the wall, of any length > 0.
    start : d numbers [m]
        At time 0.
    speed [m/s], stiffness [N/m], damping [N s/m] : float
        Intended motion along the wall.
    push [N], normal_stiffness [N/m], target_depth [m], normal_damping [N s/m] : float
        Force into the wall at target_depth, and how it falls with the depth and its rate.
    mass : float [kg]
        What moves with the handle.
    """

    def __init__(
        self,
        direction: Numbers,
        start: Numbers,
        speed: float = 0.05,
        stiffness: float = 200.0,
        damping: float = 20.0,
        push: float = 2.0,
        normal_stiffness: float = 0.0,
        target_depth: float = 0.0,
        normal_damping: float = 20.0,
        mass: float = 0.5,
    ) -> None:
        given = {key: of for key, of in locals().items() if key not in ("self", "direction", "start", "__class__")}
        self._held = _native.named("table", "following_hand", 0, given)
        way, first = np.array(direction, dtype=float), np.array(start, dtype=float)
        if first.shape != way.shape or way.shape not in ((2,), (3,)):
            raise ValueError(f"passive_haptics: length of start = {first.size}, expected {way.size}, as direction has, 2 or 3")
        if not 0 < np.linalg.norm(way) < np.inf:
            raise ValueError(
                f"passive_haptics: direction of a following_hand = {way.tolist()}, expected a direction of finite length > 0"
            )
        self._parameters = {"direction": way.tolist(), "start": first.tolist(), **self._held.parameters()}

    def force(self, time: float, position: Numbers, velocity: Numbers, normal: Numbers, depth: float) -> Array:
        """Force of the muscles [N] at a time [s], with the handle at a position [m] with a velocity [m/s], and at a depth
        [m] in a wall of this normal."""
        p = self._parameters
        of: Array = _native.hand_force(self._held, p["direction"], p["start"], time, position, velocity, normal, depth)
        return of

    @property
    def mass(self) -> float:
        """What moves with the handle [kg]."""
        return float(self._parameters["mass"])


def follow_wall(
    device: simulated_device,
    controller: controller,
    shape: shape,
    hand: following_hand,
    parameters: Optional[wall_following_parameters] = None,
    *,
    record: bool = False,
) -> tuple[contact_metrics, Records]:
    """The wall-following experiment: a hand moves the device along a shape, the wall whose depth is measured, under a
    controller. Ctrl-C ends it.

    The device and the controller go on from where they are; time begins at 0, so reset() a controller that has run before.

    Returns
    -------
    metrics, samples
        Figures of the run. If record is true, a row for each time step: time [s], depth [m], position [m], velocity [m/s],
        rates of the brakes, brake_torque [N m], brake_power [W], hand_force [N], brake_force [N], and of the latest control
        cycle capacity [N m], alpha, outcome, power, display, saturated and wall_number.
    """
    expect(device, simulated_device, "device", "a simulated_device")
    expect(controller, _controller, "controller", "a controller(mechanism, brakes, scene, law)")
    expect(shape, _shape, "shape", "a shape such as half_space(...)")
    expect(hand, following_hand, "hand", "a following_hand(direction, start)")
    parameters = wall_following_parameters() if parameters is None else parameters
    expect(parameters, wall_following_parameters, "parameters", "wall_following_parameters(...)")
    of = device.parameters["mechanism"]
    n, d, m = of._held.sizes()
    if controller._held.sizes() != (n, d, m):
        raise ValueError("passive_haptics: controller is of another mechanism, expected one of the device's sizes")
    if shape.dimension != d:
        raise ValueError(
            f"passive_haptics: shape has dimension {shape.dimension}, expected {d}, the task dimension of the device"
        )
    p = hand.parameters
    with progress_line(round(1e3 * parameters.parameters["max_duration"]), "ms at most") as shown:
        metrics, numbers = _native.follow_wall(
            of._held, device._held, controller._held, shape._held, hand._held, p["direction"], p["start"], parameters._held,
            record, lambda time: shown.reach(round(1e3 * time)),
        )  # fmt: skip
    widths = {"position": d, "velocity": d, "rates": m, "brake_torque": m, "brake_power": m, "hand_force": d}
    widths |= {"brake_force": d, "capacity": m}
    row: list[Any] = [("time", "f8"), ("depth", "f8"), *((name, "f8", (width,)) for name, width in widths.items())]
    row += [("alpha", "f8")]
    row += [(name, "i8") for name in ("outcome", "power", "display", "saturated", "wall_number")]
    return metrics, numbers.view(np.dtype(row))


_controller = controller
_shape = shape


def limits_of(wall: braked_wall) -> wall_limits:
    """What a wall made of brakes can be, as mechanism.braked_wall_at() returns it."""
    expect(wall, braked_wall, "wall", "a braked_wall, as braked_wall_at() returns")
    return wall_limits(*_native.limits_of(wall._held))
