"""The base of all values of the package: keywords, repr, equality, pickling, copies."""

from __future__ import annotations

import difflib
import functools
import inspect
import os
import sys
import warnings
from typing import TYPE_CHECKING, Any, ClassVar, cast

from passive_haptics.arrays import Path


class value:
    """An immutable value with parameters; equal to another of its class with equal parameters."""

    _parameters: dict[str, Any]
    _held: Any
    _base: ClassVar[type[Any]]
    """The class of the package, whose __init__ takes the parameters."""

    def __init_subclass__(cls) -> None:
        init = vars(cls).get("__init__")
        if init is not None and ("_name" in vars(cls) or init.__module__.startswith("passive_haptics.")):  # of no user
            cls._base = cls
            setattr(cls, "__init__", with_suggestions(init))

    if not TYPE_CHECKING:  # a checker of types reports unknown members

        def __getattr__(self, name: str) -> Any:
            kind = type(self).__name__
            if name in ("_held", "_parameters"):
                raise TypeError(f"passive_haptics: a {kind} without parameters: expected a call of super().__init__(...)")
            hint = f": expected parameters[{name!r}]" if name in self._parameters else ""
            raise AttributeError(f"passive_haptics: a {kind} has no {name}{hint}")

        def __setattr__(self, name: str, of: Any) -> None:
            if name in vars(self).get("_parameters", ()):
                kind = type(self).__name__
                raise AttributeError(f"passive_haptics: a {kind} does not change: expected a new one, {kind}(..., {name}={of!r})")
            super().__setattr__(name, of)

    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
        return cast(dict[str, Any], _copied(self._parameters))

    def _arguments(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        """Arguments of an equal value: by their order, and by their names."""
        return (), self._parameters

    def __repr__(self) -> str:
        ordered, named = self._arguments()
        return f"{type(self).__name__}({', '.join([*map(repr, ordered), *(f'{key}={of!r}' for key, of in named.items())])})"

    def __eq__(self, other: object) -> bool:
        if type(self) is not type(other):
            return NotImplemented
        return bool(self._parameters == other._parameters)  # type: ignore[attr-defined]

    def __reduce__(self) -> tuple[Any, ...]:
        members = {name: of for name, of in vars(self).items() if not name.startswith("_")}  # of a derived class
        return _restored, (type(self), *self._arguments()), members


def _restored(kind: type[Any], ordered: tuple[Any, ...], named: dict[str, Any]) -> Any:
    made = object.__new__(kind)
    kind._base.__init__(made, *ordered, **named)
    return made


def _copied(x: Any) -> Any:
    """A copy of lists and dicts in each other."""
    if isinstance(x, dict):
        return {key: _copied(of) for key, of in x.items()}
    return [_copied(of) for of in x] if isinstance(x, list) else x


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
    """A warning at the line of the user, if there is a text."""
    frame, level = sys._getframe(1), 2
    while frame.f_back is not None and frame.f_globals.get("__name__", "").startswith("passive_haptics."):
        frame, level = frame.f_back, level + 1
    if text:
        warnings.warn("passive_haptics: " + text.rstrip("\n"), stacklevel=level)


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
