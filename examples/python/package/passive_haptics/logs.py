"""Logs (docs/guide/log.md) as arrays, read by the library's own reader."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from passive_haptics import _native
from passive_haptics.arrays import Path
from passive_haptics.values import readable


def read_log(path: Path) -> tuple[dict[str, NDArray[Any]], dict[str, str]]:
    """The columns of a log and their units, by name, for example "t", "q1" and "status". Ctrl-C stops it.

    docs/guide/log.md lists the supported programs. Numbers are read exactly; an empty cell is NaN. Words have
    the unit "", numbers without a unit "1". Raises ValueError with file, line and column, and OSError as
    open() does.
    """
    columns, units = _native.read_log(readable(path))
    return {key: np.asarray(of) if units[key] else np.array(of, dtype=str) for key, of in columns.items()}, units
