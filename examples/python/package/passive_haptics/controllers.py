"""Controllers, and the states and results of their cycles."""

from __future__ import annotations

import collections.abc
from typing import Any, Literal, Optional

import numpy as np

from passive_haptics import _native
from passive_haptics._native import device_state, step_result
from passive_haptics.arrays import Array
from passive_haptics.catalogue_values import law
from passive_haptics.devices import brakes, mechanism
from passive_haptics.scenes import _any_scene
from passive_haptics.values import expect, value

FIELDS: tuple[str, ...] = _native.BATCH_FIELDS
"""Names of the results of a batch."""


class batch_result:
    """Results of batch(): one array for each requested member of step_result, with a row or a number for each state.

    outcome, power and display are integers: values of status, power_class and display_class.
    """

    def __init__(self, arrays: dict[str, Any]) -> None:
        self.__dict__.update(arrays)

    def __getattr__(self, name: str) -> Array:
        raise AttributeError(
            f"passive_haptics: a batch_result has no {name}: expected one of {', '.join(vars(self))}"
            + (f"; or call batch(..., fields=[{name!r}])" if name in FIELDS else "")
        )

    def __len__(self) -> int:
        """N."""
        return len(self.capacity)

    def __repr__(self) -> str:
        return f"<batch_result of {len(self)} states: {', '.join(vars(self))}>"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, batch_result):
            return NotImplemented
        mine, theirs = vars(self), vars(other)
        return mine.keys() == theirs.keys() and all(
            of.shape == theirs[key].shape and of.tobytes() == theirs[key].tobytes() for key, of in mine.items()
        )


class controller(value):
    """A mechanism, its brakes, a scene and a law. Call it once per cycle, or for a batch of states.

    A pickled controller does not include the memory of its motion.

    Parameters
    ----------
    mechanism, brakes, scene, law
        The parts of the controller.
    max_approximation_angle : float [rad]
        If the angle between desired and nearest force is larger, nothing is displayed; default 89 degrees.
    limits : {keep_direction, clamp_each}
        Scale all torques at a torque limit, or clamp each.
    """

    def __init__(
        self,
        mechanism: mechanism,
        brakes: brakes,
        scene: _any_scene,
        law: law,
        max_approximation_angle: Optional[float] = None,
        limits: Literal["keep_direction", "clamp_each"] = "keep_direction",
    ) -> None:
        expect(mechanism, _mechanism, "mechanism", "a mechanism such as two_link()")
        known = mechanism._brakes(brakes)
        expect(scene, _any_scene, "scene", "a scene: scene(wall(shape, stiffness))")
        expect(law, _law, "law", "a law such as direct_control()")
        if scene.dimension != mechanism.task_dimension:
            raise ValueError(
                f"passive_haptics: scene has dimension {scene.dimension}: expected {mechanism.task_dimension}, the task "
                "dimension of the mechanism"
            )
        given = {"limits": limits, "max_approximation_angle": max_approximation_angle}
        options = _native.named("table", "controller", 0, given)
        self._parameters = {"mechanism": mechanism, "brakes": brakes, "scene": scene, "law": law, **options.parameters()}
        self._held = _native.controller(mechanism._held, known, scene._held, law._held, options)

    def __call__(self, state: device_state) -> step_result:
        """One control cycle."""
        result: step_result = self._held.step(state)
        return result

    def batch(
        self,
        q: Array,
        qd: Array,
        hand_force: Optional[Array] = None,
        time: Optional[Array] = None,
        *,
        fields: Optional[collections.abc.Iterable[str]] = None,
        out: Optional[batch_result] = None,
        workers: int = 1,
    ) -> batch_result:
        """Computes the cycles of N states, each as the first of a motion. Releases the global interpreter lock.

        Parameters
        ----------
        q, qd : N x n
            Joint positions [rad or m] and rates.
        hand_force : N x d [N]
            Base frame; None without a force sensor.
        time : N [s]
        fields : a name, or names
            Results to store in addition to capacity and outcome; None: all, or all of `out`.
        out : batch_result
            An earlier result for the same number of states; its arrays are overwritten.
        workers : int
            Number of threads, at most one for each processor; -1: one for each.
        """
        arrays = {} if out is None else vars(expect(out, batch_result, "out", "what batch() returned for as many states"))
        arrays.update(self._held.batch(q, qd, hand_force, time, self._wanted(fields, out), arrays, workers))
        return batch_result(arrays) if out is None else out

    @staticmethod
    def _wanted(fields: Optional[collections.abc.Iterable[str]], out: Optional[batch_result]) -> list[str]:
        if fields is None:
            return list(FIELDS) if out is None else [name for name in FIELDS if name in vars(out)]
        names = [fields] if isinstance(fields, str) else list(expect(fields, collections.abc.Iterable, "fields", "a list of names"))
        for name in names:
            if name not in FIELDS:
                raise ValueError(f"passive_haptics: fields has {name!r}: expected names among {', '.join(FIELDS)}")
        return [name for name in FIELDS if name in (*names, "capacity", "outcome")]

    def set_brakes(self, brakes: brakes) -> None:
        """Replaces the brakes from the next cycle on, for example if some are off. The law keeps its memory."""
        self._held.set_brakes(self._parameters["mechanism"]._brakes(brakes))
        self._parameters = {**self._parameters, "brakes": brakes}

    def reset(self) -> None:
        """Resets the memory of the law and of the scene."""
        self._held.reset()


_mechanism = mechanism
_law = law


def _show(self: Any) -> str:
    values = {name: getattr(self, name) for name, of in vars(type(self)).items() if isinstance(of, property)}
    lists = {name: of.tolist() if isinstance(of, np.ndarray) else of for name, of in values.items()}
    return f"{type(self).__name__}({', '.join(f'{name}={of!r}' for name, of in lists.items())})"


def _same_bits(self: Any, other: object) -> Any:
    """By repr, which has all digits: NaN equals itself."""
    return repr(self) == repr(other) if type(self) is type(other) else NotImplemented


for _kind in (device_state, step_result):
    for _name, _of in {"__repr__": _show, "__eq__": _same_bits, "__hash__": None}.items():
        setattr(_kind, _name, _of)
setattr(device_state, "__reduce__", lambda self: (device_state, (self.time, self.q, self.qd, self.hand_force)))
