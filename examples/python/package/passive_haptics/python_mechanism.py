"""A mechanism with functions written in Python."""

from __future__ import annotations

import collections.abc
from typing import Any, Optional

from passive_haptics import _native
from passive_haptics.arrays import Array, Numbers, Rows
from passive_haptics.devices import mechanism

Function = collections.abc.Callable[[Array], Any]


class python_mechanism(mechanism):
    """A mechanism with functions written in Python, a brake on each of its joints.

    It has all functions of a compiled mechanism, but each call of a Python function takes microseconds. Exceptions of
    these functions are passed on. NaN ends a cycle with a status.

    Parameters
    ----------
    dof, task_dimension : int
        2 and 2, 3 and 2, 4 and 2, 3 and 3, 6 and 3, or 7 and 3.
    position : function of q
        The end effector [m], base frame, of joint positions q [rad or m], an array of dof numbers.
    jacobian : function of q
        J in v = J qd, task_dimension x dof [m/rad or 1]; without it J is found by central differences, to about ten digits.
    mass_matrix, bias_torque, bias_acceleration : functions of q, of q and qd, of q and qd
        The inertia, all three or none: M, dof x dof [kg m^2, kg m or kg], c in M qdd + c [N m or N] and Jd qd [m/s^2].
    check : bool
        Compare jacobian with the derivative of position at the first q; a difference above 1e-4 is a ValueError.
    """

    _name = "python_mechanism"

    def __init__(
        self,
        dof: int,
        task_dimension: int,
        position: collections.abc.Callable[[Array], Numbers],
        jacobian: Optional[collections.abc.Callable[[Array], Rows]] = None,
        mass_matrix: Optional[collections.abc.Callable[[Array], Rows]] = None,
        bias_torque: Optional[collections.abc.Callable[[Array, Array], Numbers]] = None,
        bias_acceleration: Optional[collections.abc.Callable[[Array, Array], Numbers]] = None,
        check: bool = True,
    ) -> None:
        given = {key: of for key, of in locals().items() if key not in ("self", "__class__") and of is not None}
        for key, of in given.items():
            if key not in ("dof", "task_dimension", "check") and not callable(of):
                what = "q and qd" if key.startswith("bias") else "q"
                raise TypeError(f"passive_haptics: {key} = {of!r} ({type(of).__name__}): expected a function of {what}")
        inertia = (mass_matrix, bias_torque, bias_acceleration)
        if None in inertia and inertia != (None, None, None):
            raise TypeError("passive_haptics: mass_matrix, bias_torque, bias_acceleration: expected all three or none of them")
        self._parameters = given if not check else {key: of for key, of in given.items() if key != "check"}
        self._held = _native.python_mechanism(
            dof, task_dimension, position, jacobian, mass_matrix, bias_torque, bias_acceleration, not check
        )

    def __repr__(self) -> str:
        shown = (f"{key}={getattr(of, '__qualname__', repr(of))}" for key, of in self._parameters.items())
        return f"python_mechanism({', '.join(shown)})"
