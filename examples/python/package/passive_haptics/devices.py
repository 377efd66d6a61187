"""Mechanisms and their brakes."""

from __future__ import annotations

import collections.abc
from typing import Any, Literal, Optional, Union, cast

import numpy as np

from passive_haptics import _native
from passive_haptics.arrays import Array, Integers, Numbers, Poses, Records, Rows
from passive_haptics.catalogue_values import LISTS, catalogue_value, law
from passive_haptics.results import display_class, displayable_force, of_one, status
from passive_haptics.values import expect

Limits = Union[float, Numbers]
"""One number for all brakes, or one for each."""


class brakes(catalogue_value):
    """The brakes of a device. mechanism.brakes() returns brakes of the right number.

    torque_lower = torque_upper = 0: the brake is off. If one of them is 0, the brake works in one direction.

    Parameters
    ----------
    torque_limit, torque_lower, torque_upper : one number for all, or one for each [N m]
        The limit, and bounds of the signed torque, which default to none.
    rate_dead_band [rad/s], torque_dead_band [N m] : likewise
        Below rate_dead_band a brake is at rest; below torque_dead_band the torque of the hand has no sign.
    time_constant : likewise [s]
        Lag of the torque behind its command.
    count : int
        The number of brakes, if all other parameters are scalars.
    """

    _list = "brakes"
    _name = "brakes"

    def __init__(
        self,
        torque_limit: Optional[Limits] = None,
        torque_lower: Optional[Limits] = None,
        torque_upper: Optional[Limits] = None,
        rate_dead_band: Optional[Limits] = None,
        torque_dead_band: Optional[Limits] = None,
        time_constant: Optional[Limits] = None,
        *,
        count: Optional[int] = None,
    ) -> None:
        given = {key: of for key, of in locals().items() if key not in ("self", "__class__", "count")}
        sizes = [len(of) for of in given.values() if hasattr(of, "__len__") and not isinstance(of, str)]
        if count is None and not sizes:
            raise TypeError("passive_haptics: brakes need a number for each brake, [1, 1], or count=2")
        super().__init__(given, sizes[0] if count is None else _native.whole_number(count, "count"))
        self._parameters = {key: np.atleast_1d(of).tolist() for key, of in self._parameters.items()}

    @property
    def count(self) -> int:
        """The number of brakes, m."""
        return len(self._parameters["torque_limit"])


Brakes = brakes
"""The class, within the class with a method of this name."""


class mechanism(catalogue_value):
    """A mechanism: joint positions in, end effector out.

    Functions of joint positions q accept one pose (n numbers) or N poses (rows), and return one result
    or N. q is in [rad], of sliding joints in [m].
    """

    _list = "mechanism"
    _make = _native.mechanism

    @property
    def dof(self) -> int:
        """n, the number of joints."""
        return int(self._held.sizes()[0])

    @property
    def task_dimension(self) -> int:
        """d, the size of a position."""
        return int(self._held.sizes()[1])

    @property
    def brake_count(self) -> int:
        """m, the number of brakes."""
        return int(self._held.sizes()[2])

    def brakes(self, torque_limit: Optional[Limits] = None, **others: Optional[Limits]) -> Brakes:
        """The brakes of this device, with the parameters of the class brakes."""
        return Brakes(torque_limit, **others, count=self.brake_count)

    def _brakes(self, given: Any) -> Any:
        """The given brakes, which must fit this device."""
        expected = "what brakes() of the mechanism returns, for its number of brakes"
        if expect(given, Brakes, "brakes", expected).count != self.brake_count:
            raise TypeError(f"passive_haptics: brakes = {given.count} of them: expected {expected}, {self.brake_count}")
        return given._held

    def position(self, q: Poses) -> Array:
        """The end effector [m], base frame: d numbers, or N rows of them."""
        return cast(Array, self._held.position(q))

    def jacobian(self, q: Poses) -> Array:
        """J in v = J qd [m/rad or 1]: d x n, or N x d x n."""
        return cast(Array, self._held.jacobian(q))

    def brake_rates(self, q: Poses, qd: Poses) -> Array:
        """The rates of the brakes, w = T qd [rad/s or m/s]: m numbers, or N rows of them."""
        return cast(Array, self._held.brake_rates(q, qd))

    def inverse(self, x: Poses, branch: Literal["left", "right"] = "left") -> tuple[Array, Union[status, Integers]]:
        """Joint positions that put the end effector at x [m], and the status, which must be status.ok.

        Parameters
        ----------
        x : d numbers [m], or N rows
            Places.
        branch : {left, right}
            For two-link arms: the side of the elbow, seen from the base.

        Returns
        -------
        q, outcome
            One pose and its status, or N rows and N integers. If x is out of reach, q does not belong to x.

        Raises
        ------
        TypeError
            If the mechanism has no inverse: use nearest_pose.
        """
        if branch not in ("left", "right"):
            raise ValueError(f"passive_haptics: branch = {branch!r}: expected 'left' or 'right'")
        found = self._held.inverse(x, branch == "right")
        if found is None:
            kind = type(self).__name__
            raise TypeError(f"passive_haptics: a {kind} has no inverse: expected nearest_pose(mechanism, x, start)")
        return found[0], of_one(status, found[1])

    def brake_signs(
        self, q: Numbers, qd: Numbers, hand_force: Optional[Numbers] = None, brakes: Optional[Brakes] = None
    ) -> Array:
        """The signs of the brake rates; at rest, the signs of the hand's torques."""
        return cast(Array, self._held.brake_signs(q, qd, hand_force, self._brakes(brakes or self.brakes())))

    def recommended_law(self, brakes: Optional[Brakes] = None) -> law:
        """The recommended law for a device with a force sensor."""
        from passive_haptics import catalogue

        known = self._brakes(brakes or self.brakes())
        if self._held.has_inertia():
            return catalogue.velocity_direct_control()
        return catalogue.on_off_control(lead=float(np.max(known.parameters()["time_constant"])))

    def _require_square(self, function: str) -> None:
        if len({*self._held.sizes()}) != 1:
            raise TypeError(
                f"passive_haptics: {function} needs as many brakes and joints as task dimensions, but the mechanism has "
                f"{self.dof} joints, {self.brake_count} brakes and {self.task_dimension} task dimensions"
            )

    def reference_forces(self, q: Numbers) -> tuple[Array, status]:
        """The forces of unit torques, one column for each brake [N per N m], equation (6); NaN unless the status is ok.

        Raises TypeError unless there are as many brakes and joints as task dimensions.
        """
        self._require_square("reference_forces")
        return cast("tuple[Array, status]", self._held.reference_forces(q))

    def nearest_force(self, q: Numbers, signs: Numbers, desired_force: Numbers) -> Array:
        """The force [N] nearest to the desired one that brakes with these signs can produce.

        Raises TypeError unless there are as many brakes and joints as task dimensions.
        """
        self._require_square("nearest_force")
        return cast(Array, self._held.nearest_force(q, signs, desired_force))

    def passive_fme(self, q: Numbers, segments: int = 32) -> list[tuple[tuple[int, int], Array]]:
        """The four passive FMEs: the signs of the torques, and the closed outline [N] as K rows of 2 numbers.

        NaN at a singular pose. Raises TypeError unless there are two brakes on two joints in the plane.
        """
        if self._held.sizes() != (2, 2, 2):
            raise TypeError("passive_haptics: passive_fme needs two brakes on two joints in the plane; take another mechanism")
        return cast("list[tuple[tuple[int, int], Array]]", self._held.passive_fme(q, segments))

    def displayable(self, q: Poses, velocity: Poses, normal: Poses, brakes: Optional[Brakes] = None) -> displayable_force:
        """The force that the brakes can display along the normal of a wall.

        Parameters
        ----------
        q : n numbers, or N rows
            Joint positions.
        velocity, normal : d numbers, or N rows
            Velocity of the handle (only its direction matters), and outward normal of the wall.
        brakes : brakes
            Default: brakes without limits.
        """
        found, *vectors = self._held.displayable(q, velocity, normal, brakes and self._brakes(brakes))
        kinds = {"outcome": status, "display": display_class, "angle": float, "max_force": float, "max_approximated_force": float}
        return displayable_force(*(of_one(kind, found[name]) for name, kind in kinds.items()), *vectors)

    def sink_depth(
        self, q: Rows, direction: Poses, normal: Poses, brakes: Optional[Brakes] = None, push: float = 1.0
    ) -> float:
        """The minimum depth [m] to which a hand with this push [N] sinks along a path.

        q: joint positions at the middles of N >= 2 equal parts of the path, N rows; direction and normal of the wall
        there: N rows, or one vector for all.
        """
        return float(self._held.sink_depth(q, direction, normal, brakes and self._brakes(brakes), push))

    def design_map(
        self, q: Poses, direction: Poses, normal: Poses, brakes: Optional[Brakes] = None, push: float = 1.0
    ) -> Records:
        """The figures of the device at points of a task, as an array with named fields. Ctrl-C stops it.

        Returns
        -------
        Records
            outcome (status), display (display_class), cosine of gamma [1], drag per displayed newton [1],
            max_force along the normal [N], sink_slope [1] and isotropy of E [1].
        """
        return cast(Records, self._held.design_map(q, direction, normal, brakes and self._brakes(brakes), push))


class serial_chain(mechanism):
    """A serial chain of joints, a brake on each.

    Controllers exist for 2, 3 and 4 joints in the plane, and for 3, 6 and 7 in space. With `links` the chain has
    inertia.

    Parameters
    ----------
    joints : list of dicts of kind ("revolute" or "prismatic"), axis [1] and point [m]
        In the zero pose, base frame. In the plane a revolute joint needs no axis.
    handle : d numbers [m]
        The end effector in the zero pose; 2 numbers in the plane, 3 in space.
    links : list of dicts of mass [kg], centre [m] and about_centre [kg m^2]
        Link i moves with joint i.
    rotor_inertia : one number for all joints or one for each [kg m^2, or kg]
    handle_mass : float [kg]
    gravity : d numbers [m/s^2]
    """

    def __init__(
        self,
        joints: collections.abc.Sequence[collections.abc.Mapping[str, Any]],
        handle: Numbers,
        links: Optional[collections.abc.Sequence[collections.abc.Mapping[str, Any]]] = None,
        rotor_inertia: Optional[Numbers] = None,
        handle_mass: Optional[float] = None,
        gravity: Optional[Numbers] = None,
    ) -> None:
        given = {key: of for key, of in locals().items() if key not in ("self", "__class__")}
        if not hasattr(joints, "__len__") or not hasattr(handle, "__len__"):
            raise TypeError("passive_haptics: joints and handle of a serial_chain: expected a list of dicts, and a vector [m]")
        name = ("planar" if len(handle) == 2 else "spatial") + f"_chain_{len(joints)}"
        if any(of is not None for of in (links, rotor_inertia, handle_mass, gravity)):
            name += "_with_inertia"
        if name not in LISTS["mechanism"] or len(handle) not in (2, 3):
            raise ValueError(
                f"passive_haptics: {len(joints)} joints and a handle of {len(handle)} numbers: expected 2, 3 or 4 joints in the "
                "plane, or 3, 6 or 7 in space"
            )
        self._name = name  # type: ignore[misc]
        super().__init__(given)


serial_chain._name = "serial_chain"
