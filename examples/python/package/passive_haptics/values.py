"""The base of all values of the package: keywords, repr, equality, pickling, copies."""

from __future__ import annotations

import difflib
import functools
import inspect
import os
import sys
import warnings
from typing import Any

import numpy as np

from passive_haptics.arrays import Path


class value:
    """An immutable value with parameters; equal to another of its class with equal parameters."""

    _parameters: dict[str, Any]
    _held: Any

    def __init_subclass__(cls) -> None:
        init = vars(cls).get("__init__")
        if init is not None and ("_name" in vars(cls) or init.__module__.startswith("passive_haptics.")):  # of no user
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
        if type(self) is not type(other):
            return NotImplemented
        return bool(self._parameters == other._parameters)  # type: ignore[attr-defined]

    def __reduce__(self) -> tuple[Any, ...]:
        return functools.partial(type(self), **self._parameters), ()


def with_suggestions(init: Any) -> Any:
    """An __init__ with errors about unknown keywords that list the parameters and suggest the nearest."""
    kinds = inspect.signature(init).parameters.values()
    names = [of.name for of in kinds if of.kind in (of.POSITIONAL_OR_KEYWORD, of.KEYWORD_ONLY)][1:]

    @functools.wraps(init)
    def call(self: Any, *args: Any, **kwargs: Any) -> None:
        for key in kwargs:
            if key not in names:
                near = difflib.get_close_matches(key, names, 1)
                raise TypeError(
                    f"passive_haptics: {type(self).__name__} has no parameter {key!r}: expected {', '.join(names) or 'none'}"
                    + (f"; did you mean {near[0]}?" if near else "")
                )
        init(self, *args, **kwargs)

    return call


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


def readable(path: Path) -> bytes:
    """The name of a file for C++. Raises OSError as open() does if it cannot be read."""
    name = os.fsencode(path)
    open(name, "rb").close()
    return name


def expect(thing: Any, kind: type[Any] | tuple[type[Any], ...], name: str, expected: str) -> Any:
    """The thing, if it is an initialised object of this class; else TypeError."""
    if not isinstance(thing, kind):
        shown = repr(thing)
        shown = shown if len(shown) <= 40 else shown[:40] + "..."
        raise TypeError(f"passive_haptics: {name} = {shown} ({type(thing).__name__}): expected {expected}")
    if isinstance(thing, value):
        thing._held
    return thing
