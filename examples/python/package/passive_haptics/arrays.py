"""Types of arrays, for annotations."""

import collections.abc
import os
from typing import Any, Union

import numpy
from numpy.typing import NDArray

Array = NDArray[numpy.float64]
"""Numbers that are returned, and those of a batch."""
Integers = NDArray[numpy.int32]
"""Enumerations and wall numbers of a batch."""
Numbers = Union[collections.abc.Sequence[float], NDArray[Any]]
"""A vector that is passed: a list, a tuple or a one-dimensional array of real numbers."""
Rows = Union[collections.abc.Sequence[collections.abc.Sequence[float]], collections.abc.Sequence[NDArray[Any]], NDArray[Any]]
"""Vectors that are passed."""
Poses = Union[Numbers, Rows]
"""One vector, or N of them as rows."""
Records = NDArray[numpy.void]
"""A row for each place or time step, with named fields."""
Path = Union[str, "os.PathLike[str]"]
"""The name of a file."""
