"""Devices of device files."""

from __future__ import annotations

import dataclasses
from typing import Any

from passive_haptics import _native, catalogue
from passive_haptics.arrays import Numbers, Path
from passive_haptics.catalogue_values import brake_model, law
from passive_haptics.controllers import controller
from passive_haptics.devices import brakes, mechanism, serial_chain
from passive_haptics.scenes import scene_of_device
from passive_haptics.simulations import simulated_device
from passive_haptics.values import readable


@dataclasses.dataclass(frozen=True)
class device_description:
    """A device from a device file: its parts, a controller and a simulation."""

    mechanism: mechanism
    brakes: brakes
    """As the controller assumes them."""
    law: law
    scene: scene_of_device
    """The walls, which may move, and the effects; perhaps none."""
    brake_models: tuple[brake_model, ...]
    """Of a simulation, one for each brake, or none."""
    has_force_sensor: bool
    """Else states have no hand_force."""
    options: dict[str, Any]
    """max_approximation_angle [rad] and limits of the controller."""
    remarks: str
    """A line for each value that is allowed but unusual."""

    def controller(self) -> controller:
        """Returns a new controller of this device."""
        return controller(self.mechanism, self.brakes, self.scene, self.law, **self.options)

    def plant(self, q: Numbers, hand_mass: float = 0.5) -> simulated_device:
        """Returns a simulation of this device, at rest at q [rad or m] with the mass of a hand [kg] on its handle."""
        return simulated_device(self.mechanism, self.brake_models or self.brakes, hand_mass, q)


def load(path: Path) -> device_description:
    """Reads a device file (docs/guide/device.md). Raises ValueError with file, line and key; warns of
    unusual values.

    Sections of brake_driver, such as [port], are ignored.
    """
    (name, parameters), of_brakes, (of_law, values), of_models, text, *others = _native.read_device(readable(path))
    kind = serial_chain if "_chain_" in name else getattr(catalogue, name)
    models = tuple(getattr(catalogue, f"{of}_brake")(**each) for of, each in of_models)
    law = getattr(catalogue, of_law)(**values)
    return device_description(kind(**parameters), brakes(**of_brakes), law, scene_of_device(text), models, *others)
