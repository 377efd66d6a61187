"""Devices of device files."""

from __future__ import annotations

import dataclasses
import os
from typing import Any, Optional, Union

import numpy as np

from passive_haptics import _native, catalogue, scenes
from passive_haptics.arrays import Numbers, Path
from passive_haptics.catalogue_values import brake_model, law
from passive_haptics.controllers import controller
from passive_haptics.devices import brakes, mechanism, serial_chain
from passive_haptics.simulations import simulated_device


@dataclasses.dataclass(frozen=True)
class device_description:
    """A device of a device file: its parts, and what is made of them."""

    mechanism: mechanism
    brakes: brakes
    """As the controller assumes them."""
    law: law
    scene: Optional[scenes._any_scene]
    """None without walls."""
    brake_models: tuple[brake_model, ...]
    """Of a simulation, one for each brake, or none."""
    has_force_sensor: bool
    """Else states have no hand_force."""
    options: dict[str, Any]
    """max_approximation_angle [rad] and limits of the controller."""
    remarks: str
    """A line for each value that is allowed but unusual."""

    def controller(self) -> controller:
        """The controller of this device, with a memory of its own."""
        if self.scene is None:
            raise ValueError("passive_haptics: walls = [], expected a wall: a controller needs a scene")
        return controller(self.mechanism, self.brakes, self.scene, self.law, **self.options)

    def plant(self, q: Numbers, hand_mass: float = 0.5) -> simulated_device:
        """A simulation of this device, at rest at q [rad or m] with a hand's mass [kg] on its handle."""
        of: Union[brakes, tuple[brake_model, ...]] = self.brake_models or self.brakes
        return simulated_device(self.mechanism, of, hand_mass, q)


def load(path: Path) -> device_description:
    """The device of a device file (docs/guide/device.md). Raises ValueError with file, line and key.

    It reads the sections of the device; those of brake_driver, such as [port], are passed over.
    """
    found = _native.read_device(os.fspath(path))
    name, parameters = found["mechanism"]
    kind = serial_chain if "_chain_" in name else getattr(catalogue, name)
    walls = [scenes.wall(_shape(shapes), stiffness) for shapes, stiffness in found["walls"]]
    effects = [getattr(catalogue, of)(**values) for of, values in found["effects"]]
    if effects and not walls:
        raise ValueError("passive_haptics: walls = [], expected a wall with [[effects]]: effects without a wall are in C++ only")
    scene: Optional[scenes._any_scene] = scenes.world(walls) if walls else None
    if scene is not None and found["period"] > 0:
        scene = scenes.held_scene(scene, found["period"])
    if scene is not None and effects:
        scene = scenes.with_effects(scene, *effects)
    of_law, values = found["law"]
    return device_description(
        kind(**parameters),
        brakes(**found["brakes"]),
        getattr(catalogue, of_law)(**values),
        scene,
        tuple(getattr(catalogue, f"{of}_brake")(**each) for of, each in found["brake_models"]),
        found["has_force_sensor"],
        found["options"],
        found["remarks"],
    )


def _shape(shapes: list[Any]) -> Any:
    """The shape of names and parameters, the outer one first."""
    (name, parameters), *inner = shapes
    if name == "height_field":
        raise ValueError("passive_haptics: walls.type = height_field, expected another shape: this one is in C++ only")
    if "file" in parameters:
        read = getattr(scenes, "read_" + os.path.splitext(parameters["file"])[1][1:].lower())
        mesh, _ = read(parameters["file"], parameters["metres_per_unit"])
        moved = scenes.mesh(mesh.vertices + np.array(parameters["position"]), mesh.facets)
        return getattr(scenes, name)(moved)
    if inner:
        return getattr(catalogue, name)(_shape(inner), **parameters)
    return getattr(catalogue, name)(**parameters)
