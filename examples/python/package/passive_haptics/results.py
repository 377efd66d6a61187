"""Enumerations and tuples of results; batches return the numbers of these enumerations."""

from __future__ import annotations

import enum
import typing
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from passive_haptics import _native
from passive_haptics.arrays import Array, Integers


class _in_words(enum.IntEnum):
    @property
    def text(self) -> str:
        """The value in words."""
        return _native.text_of(type(self).__name__, self.value)

    def __str__(self) -> str:
        return self.text

    __format__ = enum.Enum.__format__  # of this text


def of_one(kind: type[Any], numbers: NDArray[Any]) -> Any:
    """The number of a single pose as this type; the array of several as it is."""
    return kind(numbers.item()) if numbers.ndim == 0 else numbers


class status(_in_words):
    """The outcome of a calculation."""

    ok = 0
    state_not_finite = 1
    contact_invalid = 2
    parameters_invalid = 3
    pose_undefined = 4
    scale_out_of_range = 5
    result_not_finite = 6
    singular_jacobian = 7
    out_of_reach = 8
    too_many_contacts = 9
    scene_stale = 10
    time_not_rising = 11


class power_class(_in_words):
    """The power class of the desired force (section 2 of the paper)."""

    none = 0
    active = 1
    passive_1 = 2
    passive_2 = 3


class display_class(_in_words):
    """The quality with which the desired force is displayed."""

    none = 0
    approximate = 1
    exact = 2


class contact_report(typing.NamedTuple):
    """One touched wall and its displayed normal force."""

    wall_number: int
    """Wall of the scene."""
    wanted: float
    """Normal force that the law requires [N]; of a law of torques the one that these make before the limits."""
    displayed: float
    """Normal force that is commanded [N]."""
    has_priority: bool
    """The hand is leaving this wall, and the law gives way: met before others."""


class displayable_force(typing.NamedTuple):
    """The force that brakes can display along the normal of a wall, for one pose or, in arrays, for N."""

    outcome: Union[status, Integers]
    """ok, or why nothing is known."""
    display: Union[display_class, Integers]
    """How a force along the normal is displayed."""
    angle: Union[float, Array]
    """gamma [rad] between the normal and the nearest force."""
    max_force: Union[float, Array]
    """The maximum along the normal [N] of all forces."""
    max_approximated_force: Union[float, Array]
    """The maximum along the normal [N] of the nearest force."""
    nearest: Array
    """The nearest force with 1 N along the normal [N], d or N x d; 0 if nothing is displayed."""
    signs: Array
    """s of the brakes in this motion, m or N x m."""

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, displayable_force):
            return NotImplemented
        return all(np.array_equal(a, b, equal_nan=True) for a, b in zip(self, other))


class run_end(_in_words):
    """The end of a run along a wall."""

    time_over = 0
    arrived = 1
    too_deep = 2
    not_finite = 3


class contact_metrics(typing.NamedTuple):
    """Figures of one run along a wall, counted from the first contact."""

    separations: int
    """Contact followed by a depth under -10 um."""
    recontacts: int
    """Separation followed by a depth over +10 um."""
    depth_mean: float
    """Mean depth after the first 10 % of the path [m]."""
    depth_std: float
    """Standard deviation of the depth there [m]."""
    depth_range: float
    """Largest less smallest depth there [m]."""
    depth_drift: float
    """Last less first depth there [m]; < 0 moves out of the wall."""
    max_depth: float
    """Largest depth on the whole path [m]."""
    stick_share: float
    """Share of time that the watched brake is slower than 1e-3 rad/s [1]."""
    hand_force_std: float
    """Standard deviation of the hand's force into the wall [N]."""
    retarding_force: float
    """Mean force of the brakes against the motion along the wall [N]."""
    brake_energy: float
    """Dissipated by the friction of all brakes [J]."""
    max_brake_power: float
    """Largest that one brake gave to the device in a step [W]; 0 if none."""
    duration: float
    """From the first contact to the end [s]."""
    arrived: bool
    """The end of the path was reached."""
    touched: bool
    """The wall was touched at all."""
    end: run_end
    """How the run ended."""
