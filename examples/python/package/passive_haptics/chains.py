"""Serial chains by their usual shapes."""

import collections.abc
from typing import Union

from passive_haptics import _native

PlanarArm = Union[_native.planar_chain_3, _native.planar_chain_4]


def planar_arm(lengths: collections.abc.Sequence[float]) -> PlanarArm:
    """A planar arm of three or four revolute joints, all its links [m] along x in the zero pose."""
    kinds: dict[int, type[PlanarArm]] = {3: _native.planar_chain_3, 4: _native.planar_chain_4}
    if len(lengths) not in kinds:
        raise ValueError(f"passive_haptics: length of lengths = {len(lengths)}, expected 3 or 4")
    joints, reached = [], 0.0
    for length in lengths:
        joints.append({"point": [reached, 0.0]})
        reached += length
    return kinds[len(lengths)](joints=joints, handle=[reached, 0.0])
