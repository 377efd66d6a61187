"""The base classes of the entries of the library's catalogue (laws, shapes, effects, brake models) and of
tables of parameters."""

from __future__ import annotations

from typing import Any, ClassVar, Optional, cast

import numpy as np

from passive_haptics import _native
from passive_haptics.arrays import Array, Numbers
from passive_haptics.values import expect, value

LISTS: dict[str, Any] = _native.lists()
"""Names of the catalogue by their lists."""


class dimensional(value):
    """A value in the plane or in space."""

    @property
    def dimension(self) -> int:
        """2 in the plane, 3 in space."""
        return int(self._held.dimension())


class catalogue_value(value):
    """An entry of the catalogue, and its parameters. Its classes are in passive_haptics.catalogue."""

    _list: ClassVar[str]
    _name: ClassVar[str]
    _dimensions: ClassVar[tuple[int, ...]] = ()
    """Numbers of its vectors, 2 (planar) or 3 (spatial); of several, the first vector decides."""

    def __init__(self, given: dict[str, Any], dimension: Optional[int] = None) -> None:
        if not hasattr(type(self), "_name"):
            raise TypeError(f"passive_haptics: {type(self).__name__} is a base class: expected one that derives from it")
        dimension = self._dimension_of(given) if dimension is None else dimension
        named = _native.named(self._list, self._name, dimension, given)
        self._parameters = named.parameters()
        self._held = self._make(named)

    def _make(self, named: Any) -> Any:
        return named

    def _dimension_of(self, given: dict[str, Any]) -> int:
        if len(self._dimensions) < 2:
            return self._dimensions[0] if self._dimensions else 0
        for key, of in given.items():
            if hasattr(of, "__len__") and not isinstance(of, str):
                if len(of) and isinstance(of[0], dict):
                    return self._dimension_of(of[0])
                if len(of) not in self._dimensions:
                    raise ValueError(f"passive_haptics: length of {key} of {self._name} = {len(of)}: expected 2 or 3")
                return len(of)
        raise TypeError(f"passive_haptics: {self._name} needs a vector of 2 or 3 numbers among {', '.join(given)}")


class law(catalogue_value):
    """A control law."""

    _list = "law"


class brake_model(catalogue_value):
    """The response of one brake of a simulated device to a command."""

    _list = "brake_model"


class shape(catalogue_value, dimensional):
    """A shape of a wall, as a signed distance."""

    _list = "shape"
    _make = _native.shape

    def distance(self, x: Numbers) -> float:
        """The signed distance [m] at x [m], positive in free space."""
        return float(self._held.distance(x))

    def gradient(self, x: Numbers) -> Array:
        """The outward unit normal at x [m]."""
        return cast(Array, self._held.gradient(x))


class shape_of_shape(shape):
    """A shape that modifies another one."""

    def __init__(self, of: Any, given: dict[str, Any]) -> None:
        self._of = expect(of, shape, "shape", "a shape such as half_space(...)")
        super().__init__(given, of.dimension)
        self._parameters = {"shape": of, **self._parameters}

    def _make(self, named: Any) -> Any:
        return _native.shape(named, self._of._held)


class effect(catalogue_value):
    """A force in addition to that of the walls, which resists motion."""

    _list = "effect"
    _make = _native.effect


class parameter_table(catalogue_value):
    """A group of parameters."""

    _list = "table"


class hand(parameter_table):
    """A hand that moves along a wall in a direction of any length > 0, at start [m] at time 0: d numbers
    each."""

    def __init__(self, direction: Numbers, start: Numbers, given: dict[str, Any]) -> None:
        super().__init__(given)
        self._held = _native.hand(self._held, direction, start)
        way, first = (np.array(of, dtype=float).tolist() for of in (direction, start))
        self._parameters = {"direction": way, "start": first, **self._parameters}

    def force(self, time: float, position: Numbers, velocity: Numbers, normal: Numbers, depth: float) -> Array:
        """Force of the muscles [N] at a time [s], with the handle at a position [m] with a velocity [m/s],
        and at a depth [m] in a wall of this normal."""
        return cast(Array, self._held.force(time, position, velocity, normal, depth))

    @property
    def mass(self) -> float:
        """The mass that moves with the handle [kg]."""
        return float(self._parameters["mass"])
