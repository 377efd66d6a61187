"""Logs of the library (docs/guide/log.md) as arrays, read and written by the library's own reader and writer."""

from __future__ import annotations

import collections.abc
import os
import shutil
import stat
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from passive_haptics import _native
from passive_haptics.arrays import Array

Path = Union[str, "os.PathLike[str]"]
AXES = ("_x", "_y", "_z")
LINES_AT_ONCE = 1 << 14  # so that Ctrl-C ends a long call
LARGEST_WHOLE = 1 << 53  # all whole numbers up to it are numbers of float64


class motion_log(collections.abc.Mapping[str, NDArray[Any]]):
    """The columns of a log by their names, such as "t", "q1", "Fh_x" and "status", with their units.

    columns: arrays of N numbers, NaN for what is not known, or of N words. An array of N rows under the name "q"
    stands for q1, q2, ..., one under "Fh" for Fh_x, Fh_y and Fh_z. units: of columns whose unit is not the first
    that docs/guide/log.md names, such as "m" of a sliding q1. A column that is not on that page has the unit "1",
    and words have "". Throws TypeError and ValueError.
    """

    def __init__(
        self, columns: collections.abc.Mapping[str, Any], units: collections.abc.Mapping[str, str] = {}
    ) -> None:
        _require_dict("columns", columns, "arrays")
        _require_dict("units", units, "texts")
        self._columns: dict[str, NDArray[Any]] = {}
        for name, values in columns.items():
            if not isinstance(name, str):
                raise _type_error(f"name of a column = {_shown(name)}, expected a str")
            self._add(name, _array_of(name, values))
        self._units = {name: _usual_unit(name, values) for name, values in self._columns.items()}
        for name, unit in units.items():
            self._set_unit(name, unit)
        for name, values in self._columns.items():
            if len(values) != self.line_count:
                first = next(iter(self))
                raise _value_error(f"length of {name} = {len(values)}, expected {self.line_count}, as {first} has")

    @property
    def units(self) -> dict[str, str]:
        """A copy of the units by the names of the columns; "1" of a number without one, "" of words."""
        return dict(self._units)

    @property
    def line_count(self) -> int:
        """N, the lines."""
        return len(next(iter(self._columns.values()), ()))

    def rows(self, name: str) -> Array:
        """The columns q1, q2, ... of the name "q", or Fh_x, Fh_y, ... of "Fh", as rows: N x how many there are.

        They stand in memory column by column, as batch() of a controller reads them in place.
        """
        numbered, axes = [f"{name}{i + 1}" for i in range(len(self))], [name + axis for axis in AXES]
        found = [self[part] for part in (*numbered, *axes) if part in self._columns]
        if not found:
            raise KeyError(f"passive_haptics: no column {name}1 or {name}_x, expected one among {', '.join(self)}")
        return np.asfortranarray(np.column_stack(found), dtype=np.float64)

    def __getitem__(self, name: str) -> NDArray[Any]:
        if name not in self._columns:
            raise KeyError(f"passive_haptics: no column {name!r}, expected one among {', '.join(self)}")
        return self._columns[name]

    def __iter__(self) -> collections.abc.Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __repr__(self) -> str:
        names = ", ".join(f"{name} [{unit}]" if unit else name for name, unit in self._units.items())
        return f"<motion_log of {self.line_count} lines: {names}>"

    def __eq__(self, other: object) -> bool:
        """Whether names, units, order and bits are equal."""
        if not isinstance(other, motion_log):
            return NotImplemented
        return list(self._units.items()) == list(other._units.items()) and all(
            _same_bits(a, b) for a, b in zip(self._columns.values(), other._columns.values())
        )

    __hash__ = None  # type: ignore[assignment]

    def _add(self, name: str, values: NDArray[Any]) -> None:
        columns = [values] if values.ndim == 1 else list(values.T)
        names = [name] if values.ndim == 1 else _parts(name, len(columns))
        if len(names) < len(columns):
            raise _value_error(f"{name} has rows of {len(columns)} numbers, expected 3 at most: _x, _y, _z")
        for one, column in zip(names, columns):
            if one in self._columns:
                raise _value_error(f"column {one} is given twice, expected each once")
            self._columns[one] = column

    def _set_unit(self, name: str, unit: str) -> None:
        if name not in self._columns:
            raise _value_error(f"units has {name!r}, expected names among {', '.join(self)}")
        if not isinstance(unit, str):
            raise _type_error(f"unit of {name} = {_shown(unit)}, expected a str")
        is_words = self._columns[name].dtype.kind == "U"
        if is_words == bool(unit):
            expected = "'' for words" if is_words else "one for numbers; '1' where they have none"
            raise _value_error(f"unit of {name} = {unit!r}, expected {expected}")
        self._units[name] = unit


def read_log(path: Path) -> motion_log:
    """The log in a file, with all its columns, to the last bit as C++ reads it.

    It may be a log of this library or of another program that docs/guide/log.md names. A mistake in the file is a
    ValueError with file, line and column, and what was expected. Throws OSError as open() does. Ctrl-C ends it.
    """
    name = os.fspath(path)
    open(name, "rb").close()
    names, units, columns = _native.read_log(os.fsencode(name), name)
    values = [column if unit else np.array(column, dtype=str) for column, unit in zip(columns, units)]
    return motion_log(dict(zip(names, values)), dict(zip(names, units)))


def write_log(
    path: Path, columns: collections.abc.Mapping[str, Any], units: collections.abc.Mapping[str, str] | None = None
) -> None:
    """Writes a log that every program of this library reads. After an exception the file is what it was before.

    columns, units: a motion_log, or what makes one. The log is read again before it takes the place of the file, so
    that what no log can hold is a ValueError with file, line and column: infinity, a time that goes back, a word of
    two lines. Throws OSError as of the system. Ctrl-C ends it.
    """
    name = os.fspath(path)
    of_log = columns.units if isinstance(columns, motion_log) else {}
    log = motion_log(columns, of_log if units is None else {**of_log, **units})
    target = os.path.realpath(name)
    if os.path.exists(target) and not stat.S_ISREG(os.stat(target).st_mode):
        raise _value_error(f"path = {name!r} is no file, expected one that can be replaced, or a new name")
    part = f"{target}.{os.getpid()}.part"
    try:
        _write(part, log)
        _native.check_log(os.fsencode(part), name, list(log), list(log.units.values()), _lines(log, slice(None)))
        if os.path.exists(target):
            shutil.copymode(target, part)
        os.replace(part, target)
    finally:
        if os.path.exists(part):
            os.remove(part)


def _write(part: str, log: motion_log) -> None:
    names, units = list(log), list(log.units.values())
    with open(part, "wb") as file:
        for first in range(0, max(log.line_count, 1), LINES_AT_ONCE):
            lines = _lines(log, slice(first, first + LINES_AT_ONCE))
            file.write(_native.log_text(names, units, lines, first == 0))
        file.flush()
        os.fsync(file.fileno())


def _lines(log: motion_log, which: slice) -> list[Any]:
    return [column[which].tolist() if column.dtype.kind == "U" else column[which] for column in log.values()]


def _parts(name: str, count: int) -> list[str]:
    """The names of so many columns of one name, of axes at most three."""
    if _native.is_along_axes(name):
        return [name + axis for axis in AXES[:count]]
    return [f"{name}{i + 1}" for i in range(count)]


def _usual_unit(name: str, values: NDArray[Any]) -> str:
    known, is_words = _native.unit_of_column(name), values.dtype.kind == "U"
    if known is not None and is_words == bool(known):
        kinds = ("words", f"numbers [{known}]") if is_words else ("numbers", "words")
        raise _type_error(f"column {name} has {kinds[0]}, expected {kinds[1]}")
    return "" if is_words else known or "1"


def _array_of(name: str, values: Any) -> NDArray[Any]:
    try:
        array = np.array(values)
    except ValueError as error:
        raise _value_error(f"column {name} is no array: {error}") from None
    if array.dtype.kind == "O" and array.size and all(isinstance(word, str) for word in array.flat):
        array = array.astype(str)
    is_words = array.dtype.kind == "U"
    if array.dtype.kind not in "fiubU":
        raise _type_error(f"column {name} has dtype {array.dtype}, expected real numbers or words")
    if array.ndim not in (1, 2) or (is_words and array.ndim == 2):
        raise _value_error(f"column {name} has shape {array.shape}, expected (N,), or (N, parts) of numbers")
    if is_words:
        return array
    if array.dtype.kind in "iu" and array.size and max(abs(int(array.min())), int(array.max())) > LARGEST_WHOLE:
        raise _value_error(f"column {name} has whole numbers over 2^53, expected those that float64 can hold")
    return array.astype(np.float64)


def _same_bits(a: NDArray[Any], b: NDArray[Any]) -> bool:
    if a.dtype.kind != b.dtype.kind or len(a) != len(b):
        return False
    if a.dtype.kind == "U":
        return bool((a == b).all())
    return bool(np.array_equal(a, b, equal_nan=True) and (np.signbit(a) == np.signbit(b))[~np.isnan(a)].all())


def _require_dict(name: str, given: object, of: str) -> None:
    if not isinstance(given, collections.abc.Mapping):
        raise _type_error(f"{name} = {_shown(given)}, expected a dict of {of}")


def _shown(value: object) -> str:
    return f"{value!r:.40} ({type(value).__name__})"


def _type_error(text: str) -> TypeError:
    return TypeError(f"passive_haptics: {text}")


def _value_error(text: str) -> ValueError:
    return ValueError(f"passive_haptics: {text}")
