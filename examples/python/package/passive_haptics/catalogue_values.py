"""The base classes of the entries of the library's catalogue (laws, shapes, effects, brake models) and of
tables of parameters."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from passive_haptics import _native
from passive_haptics.arrays import Array, Numbers
from passive_haptics.values import value

LISTS: dict[str, Any] = _native.lists()
"""Names of the catalogue by their lists."""


class catalogue_value(value):
    """An entry of the catalogue, and its parameters. Its classes are in passive_haptics.catalogue."""

    _list: ClassVar[str]
    _name: ClassVar[str]
    _named: Any

    def __init__(self, given: dict[str, Any], dimension: int = 0) -> None:
        if not hasattr(type(self), "_name"):
            raise TypeError(f"passive_haptics: {type(self).__name__} is a base class: expected one that derives from it")
        parameters = {key: of for key, of in given.items() if of is not None and key not in ("self", "__class__")}
        self._named = _native.named(self._list, self._name, dimension, parameters)
        self._parameters = self._named.parameters()
        self._held = self._made()

    def _made(self) -> Any:
        return self._named


class law(catalogue_value):
    """A control law."""

    _list = "law"


class brake_model(catalogue_value):
    """The response of one brake of a simulated device to a command."""

    _list = "brake_model"


class _in_a_dimension(catalogue_value):
    """A value with vectors of 2 numbers (planar) or 3 (spatial); the first vector decides."""

    _dimensions: ClassVar[tuple[int, ...]]

    def __init__(self, given: dict[str, Any]) -> None:
        super().__init__(given, self._dimension_of(given))

    def _dimension_of(self, given: dict[str, Any]) -> int:
        if len(self._dimensions) < 2:
            return self._dimensions[0] if self._dimensions else 0
        for key, of in given.items():
            if key not in ("self", "__class__") and hasattr(of, "__len__") and not isinstance(of, str):
                if len(of) and isinstance(of[0], dict):
                    return self._dimension_of(of[0])
                if len(of) not in self._dimensions:
                    raise ValueError(f"passive_haptics: length of {key} of {self._name} = {len(of)}: expected 2 or 3")
                return len(of)
        names = ", ".join(key for key in given if key not in ("self", "__class__"))
        raise TypeError(f"passive_haptics: {self._name} needs a vector of 2 or 3 numbers among {names}")


class shape(_in_a_dimension):
    """A shape of a wall, as a signed distance."""

    _list = "shape"

    def _made(self) -> Any:
        return _native.shape(self._named)

    @property
    def dimension(self) -> int:
        """2 in the plane, 3 in space."""
        return int(self._held.dimension())

    def distance(self, x: Numbers) -> float:
        """The signed distance [m] at x [m], positive in free space."""
        return float(self._held.distance(x))

    def gradient(self, x: Numbers) -> Array:
        """The outward unit normal at x [m]."""
        of: Array = self._held.gradient(x)
        return of


class shape_of_shape(shape):
    """A shape that modifies another one."""

    _dimensions = (2, 3)

    def __init__(self, of: Any, given: dict[str, Any]) -> None:
        self._of = of
        given = {key: each for key, each in given.items() if key not in ("self", "__class__", "shape")}
        if not isinstance(of, shape):
            raise TypeError(f"passive_haptics: shape = {of!r} ({type(of).__name__}): expected a shape such as half_space(...)")
        catalogue_value.__init__(self, given, of.dimension)
        self._parameters = {"shape": of, **self._parameters}

    def _made(self) -> Any:
        return _native.shape(self._named, self._of._held)


class effect(_in_a_dimension):
    """A force in addition to that of the walls, which resists motion."""

    _list = "effect"

    def _made(self) -> Any:
        return _native.effect(self._named)


class parameter_table(catalogue_value):
    """A group of parameters."""

    _list = "table"


class hand(parameter_table):
    """A hand that moves along a wall in a direction of any length > 0, at start [m] at time 0: d numbers
    each."""

    def __init__(self, direction: Numbers, start: Numbers, given: dict[str, Any]) -> None:
        super().__init__({key: of for key, of in given.items() if key not in ("direction", "start")})
        way, first = np.array(direction, dtype=float), np.array(start, dtype=float)
        if first.shape != way.shape or way.shape not in ((2,), (3,)):
            text = f"length of start = {first.size}: expected {way.size}, as direction has, 2 or 3"
            raise ValueError(f"passive_haptics: {text}")
        if not 0 < np.linalg.norm(way) < np.inf:
            text = f"direction of a {self._name} = {way.tolist()}: expected a direction of finite length > 0"
            raise ValueError(f"passive_haptics: {text}")
        self._parameters = {"direction": way.tolist(), "start": first.tolist(), **self._parameters}

    def force(self, time: float, position: Numbers, velocity: Numbers, normal: Numbers, depth: float) -> Array:
        """Force of the muscles [N] at a time [s], with the handle at a position [m] with a velocity [m/s],
        and at a depth [m] in a wall of this normal."""
        p = self._parameters
        of: Array = _native.hand_force(
            self._held, p["direction"], p["start"], time, position, velocity, normal, depth
        )
        return of

    @property
    def mass(self) -> float:
        """The mass that moves with the handle [kg]."""
        return float(self._parameters["mass"])
