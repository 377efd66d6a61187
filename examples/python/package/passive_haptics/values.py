"""The base of all values of the package: keywords, repr, equality, pickling, copies."""

from __future__ import annotations

import difflib
import functools
import inspect
import math
import sys
import warnings
from collections.abc import Callable
from typing import Any, ClassVar, TypeVar, cast

import numpy as np


def same(a: Any, b: Any) -> bool:
    """True if two parameters are equal; NaN equals itself."""
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(same(value, b[key]) for key, value in a.items())
    if isinstance(a, (list, tuple)) and isinstance(b, (list, tuple)):
        return len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, float) and isinstance(b, float) and math.isnan(a):
        return math.isnan(b)
    return bool(a == b)


def restored(kind: type[Any], base: type[Any], parameters: dict[str, Any]) -> Any:
    """A value of a class, of which `base` takes the parameters."""
    made = object.__new__(kind)
    base.__init__(made, **parameters)
    return made


class value:
    """An immutable value with parameters; equal to another of its class with equal parameters."""

    _base: ClassVar[type[Any]]
    _parameters: dict[str, Any]
    _held: Any

    def __init_subclass__(cls) -> None:
        init = vars(cls).get("__init__")
        if init is not None and ("_name" in vars(cls) or init.__module__.startswith("passive_haptics.")):  # of no user
            cls._base = cls
            setattr(cls, "__init__", with_suggestions(init))

    def __getattr__(self, name: str) -> Any:
        kind = type(self).__name__
        if name in ("_held", "_parameters"):
            raise TypeError(f"passive_haptics: a {kind} without parameters: expected a call of super().__init__(...)")
        raise AttributeError(f"passive_haptics: a {kind} has no {name}")

    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
        return dict(self._parameters)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{key}={of!r}' for key, of in self._parameters.items())})"

    def __eq__(self, other: object) -> bool:
        mine = self._parameters
        if type(self) is not type(other):
            return NotImplemented
        return same(mine, other._parameters)  # type: ignore[attr-defined]

    def __reduce__(self) -> tuple[Any, ...]:
        return restored, (type(self), self._base, self._parameters)


F = TypeVar("F", bound=Callable[..., Any])


def with_suggestions(function: F) -> F:
    """A method with errors about unknown keywords that list the parameters and suggest the nearest."""
    kinds = inspect.signature(function).parameters.values()
    names = [of.name for of in kinds if of.kind in (of.POSITIONAL_OR_KEYWORD, of.KEYWORD_ONLY)][1:]

    @functools.wraps(function)
    def call(self: Any, *args: Any, **kwargs: Any) -> Any:
        for key in kwargs:
            if key not in names:
                owner = type(self).__name__ if function.__name__ == "__init__" else function.__name__
                near = difflib.get_close_matches(key, names, 1)
                raise TypeError(
                    f"passive_haptics: {owner} has no parameter {key!r}: expected {', '.join(names) or 'none'}"
                    + (f"; did you mean {near[0]}?" if near else "")
                )
        return function(self, *args, **kwargs)

    return cast(F, call)


def warn(text: str) -> None:
    """A warning at the line of the user."""
    frame, level = sys._getframe(1), 2
    while frame.f_back is not None and frame.f_globals.get("__name__", "").startswith("passive_haptics."):
        frame, level = frame.f_back, level + 1
    warnings.warn(text, stacklevel=level)


def number(x: Any, name: str) -> float:
    """x as float64; TypeError if it is not a number."""
    if isinstance(x, bool) or not isinstance(x, (int, float, np.floating, np.integer)):
        raise TypeError(f"passive_haptics: {name} = {x!r} ({type(x).__name__}): expected a number")
    return float(x)


def expect(thing: Any, kind: type[Any], name: str, expected: str) -> Any:
    """The thing, if it is an initialised object of this class; else TypeError."""
    if not isinstance(thing, kind):
        shown = repr(thing)
        shown = shown if len(shown) <= 40 else shown[:40] + "..."
        raise TypeError(f"passive_haptics: {name} = {shown} ({type(thing).__name__}): expected {expected}")
    if isinstance(thing, value):
        thing._held
    return thing
