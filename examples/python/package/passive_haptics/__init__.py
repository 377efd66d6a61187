"""Haptic devices with brakes instead of motors: the C++ library passive_haptics in Python.

A controller combines a mechanism, its brakes, a scene and a law. Call it once per cycle, or for a batch of states:

    arm = passive_haptics.tendon_two_link()
    wall = passive_haptics.wall(passive_haptics.half_space([0, 0.225], [0, -1]))
    control = passive_haptics.controller(
        arm, arm.brakes(), passive_haptics.scene(wall), passive_haptics.direct_control()
    )
    result = control(passive_haptics.device_state(time=0, q=[0.7, 0.8], qd=[0.1, 0], hand_force=[0, 2]))
"""

from __future__ import annotations

import importlib
import os
from typing import TYPE_CHECKING

from passive_haptics import catalogue as _catalogue
from passive_haptics._native import __version__ as __version__
from passive_haptics._native import device_state, step_result
from passive_haptics.catalogue import *
from passive_haptics.catalogue_values import brake_model, effect, law, shape
from passive_haptics.chains import chain_from_urdf, nearest_pose, planar_arm
from passive_haptics.controllers import batch_result, controller
from passive_haptics.device_file import device_description, load
from passive_haptics.devices import brakes, mechanism, serial_chain
from passive_haptics.logs import read_log
from passive_haptics.python_mechanism import python_mechanism
from passive_haptics.results import (
    contact_metrics,
    contact_report,
    display_class,
    displayable_force,
    power_class,
    run_end,
    status,
)
from passive_haptics.scenes import (
    held_scene,
    mesh,
    mesh_solid,
    mesh_surface,
    read_obj,
    read_ply,
    read_stl,
    scene,
    scene_of_device,
    wall,
    with_effects,
    world,
)
from passive_haptics.simulations import follow_wall, simulated_device

__all__ = [
    *_catalogue.__all__, "batch_result", "brake_model", "brakes", "chain_from_urdf", "contact_metrics",
    "contact_report", "controller", "device_description", "device_state", "display_class", "displayable_force",
    "effect", "follow_wall", "held_scene", "include_folders", "law", "load", "mechanism", "mesh", "mesh_solid",
    "mesh_surface", "nearest_pose", "planar_arm", "power_class", "python_mechanism", "read_log", "read_obj",
    "read_ply", "read_stl", "run_end", "scene", "scene_of_device", "serial_chain", "shape", "simulated_device",
    "status", "step_result", "wall", "with_effects", "world",
]  # fmt: skip


def include_folders() -> list[str]:
    """The include directories for a custom mechanism in C++: those of this library and of Eigen."""
    return [os.path.join(os.path.dirname(__file__), "include"), "/usr/include/eigen3"]


if TYPE_CHECKING:
    from passive_haptics import plots, producible_forces, sweep
else:

    def __getattr__(name):
        """Imports the modules of pictures and sweeps at their first use."""
        if name in ("plots", "producible_forces", "sweep"):
            return importlib.import_module(f"passive_haptics.{name}")
        raise AttributeError(f"module 'passive_haptics' has no attribute {name!r}")
