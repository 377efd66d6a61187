"""Walls, scenes of walls, and meshes."""

from __future__ import annotations

import collections.abc
from typing import Any, Union, cast

import numpy as np

from passive_haptics import _native
from passive_haptics.arrays import Array, Integers, Path, Rows
from passive_haptics.catalogue_values import dimensional, effect, shape
from passive_haptics.values import expect, readable

LARGEST_SHOWN = 20
"""Vertices or facets of a mesh, with a repr of all of them."""


class mesh(dimensional):
    """A constant surface of triangles (spatial) or segments (planar).

    Parameters
    ----------
    vertices : N x d [m]
        Rows of 2 numbers (planar) or 3 (spatial).
    facets : M x d whole numbers
        Indices of vertices. The corners of a triangle run counterclockwise seen from the free side; of a
        segment the free side is on its right.

    Raises
    ------
    ValueError
        States the first invalid facet.
    """

    def __init__(self, vertices: Rows, facets: Rows) -> None:
        self._held = _native.mesh(vertices, facets)
        self._parameters = {"vertices": np.array(vertices, dtype=float), "facets": np.array(facets, dtype=np.int32)}
        for of in self._parameters.values():
            of.flags.writeable = False

    @property
    def vertices(self) -> Array:
        """The vertices, N x d [m], read-only."""
        return cast(Array, self._parameters["vertices"])

    @property
    def facets(self) -> Integers:
        """The indices of vertices, M x d, read-only."""
        return cast(Integers, self._parameters["facets"])

    def plausibility(self, reach: float) -> str:
        """A line for each implausible property, for a device of this reach [m]; "" if there is none."""
        return str(self._held.plausibility(_native.number(reach, "reach")))

    def __len__(self) -> int:
        """The number of facets."""
        return len(self.facets)

    def __repr__(self) -> str:
        if max(len(self.vertices), len(self.facets)) > LARGEST_SHOWN:
            return f"mesh(<{len(self.vertices)} vertices>, <{len(self.facets)} facets>)"
        return f"mesh({self.vertices.tolist()}, {self.facets.tolist()})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, mesh):
            return NotImplemented
        return np.array_equal(self.vertices, other.vertices) and np.array_equal(self.facets, other.facets)


def _read(form: str, path: Path, metres_per_unit: float) -> tuple[mesh, str]:
    vertices, facets, remarks = _native.read_mesh(form, readable(path), _native.number(metres_per_unit, "metres_per_unit"))
    return mesh(vertices, facets), remarks


def read_stl(path: Path, metres_per_unit: float = 1.0) -> tuple[mesh, str]:
    """Returns the mesh of an STL file, in text or binary, and remarks on skipped parts of the file; "" if there
    are none.

    metres_per_unit is the unit of the file: 1e-3 for millimetres. Raises ValueError with file and line.
    """
    return _read("stl", path, metres_per_unit)


def read_obj(path: Path, metres_per_unit: float = 1.0) -> tuple[mesh, str]:
    """Returns the mesh of an OBJ file, with all objects and groups as one; see read_stl."""
    return _read("obj", path, metres_per_unit)


def read_ply(path: Path, metres_per_unit: float = 1.0) -> tuple[mesh, str]:
    """Returns the mesh of a PLY file, in text or binary; see read_stl."""
    return _read("ply", path, metres_per_unit)


class mesh_solid(shape):
    """The solid inside a closed mesh with outward normals.

    It has one contact in a scene of one wall. A handle that is pushed more than half-way through a thin wall
    comes out on the other side.
    """

    _name = "mesh_solid"

    def __init__(self, surface: mesh) -> None:
        self._parameters = {"surface": expect(surface, mesh, "surface", "a mesh: mesh(vertices, facets)")}
        self._held = _native.mesh_solid(surface._held)


class mesh_surface(dimensional):
    """A closed or open mesh that stops the handle from its front side, at any depth. A scene with one is a
    world.

    Parameters
    ----------
    surface : mesh
    skin : float [m]
        The distance from the surface to the proxy point of the handle.
    crease_angle : float [rad]
        Facets with normals that differ by less belong to one smooth surface.
    """

    def __init__(self, surface: mesh, skin: float = 1e-7, crease_angle: float = 0.5235987755982988) -> None:
        expect(surface, mesh, "surface", "a mesh: mesh(vertices, facets)")
        numbers = {"skin": _native.number(skin, "skin"), "crease_angle": _native.number(crease_angle, "crease_angle")}
        self._parameters = {"surface": surface, **numbers}
        self._held = _native.mesh_surface(surface._held, skin, crease_angle)


class wall(dimensional):
    """A shape that resists with stiffness [N/m] times depth."""

    def __init__(self, shape: Union[shape, mesh_surface], stiffness: float = 1e7) -> None:
        if not isinstance(shape, mesh_surface):
            expect(shape, _shape, "shape", "a shape such as half_space(...): a wall is made of (shape, stiffness)")
        self._parameters = {"shape": shape, "stiffness": _native.number(stiffness, "stiffness")}
        self._held = _native.wall(shape._held, stiffness)


_shape = shape


class _any_scene(dimensional):
    """The members of all scenes."""

    def _arguments(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        """All by their order, those of *walls or *effects one by one."""
        return tuple(each for of in self._parameters.values() for each in (of if isinstance(of, tuple) else (of,))), {}


def _scene_of(kind: str, walls: collections.abc.Sequence[Any], is_world: bool) -> Any:
    if not walls:
        raise TypeError(f"passive_haptics: a {kind} needs a wall, wall(shape, stiffness)")
    for i, each in enumerate(walls):
        expect(each, wall, f"wall {i} of a {kind}", "a wall: put each shape into one, wall(shape)")
        if each.dimension != walls[0].dimension:
            raise ValueError(
                f"passive_haptics: wall {i} of a {kind} has dimension {each.dimension}: expected "
                f"{walls[0].dimension}, as wall 0 has"
            )
    return _native.scene([each._held for each in walls], is_world)


class scene(_any_scene):
    """Walls, numbered from 0. Several walls, or a mesh_surface, become a world."""

    def __init__(self, *walls: wall) -> None:
        self._held = _scene_of("scene", walls, False)
        self._parameters = {"walls": walls}


class world(_any_scene):
    """Many walls. A cycle examines only those that the handle can have reached since the last one.

    It reports at most d + 1 contacts, those with the largest forces. With a mesh among them, all walls form one
    surface.
    """

    def __init__(self, walls: collections.abc.Sequence[wall]) -> None:
        self._parameters = {"walls": list(walls)}
        self._held = _scene_of("world", self._parameters["walls"], True)


class held_scene(_any_scene):
    """A scene that is sampled once per period [s] and held in between: a virtual environment that is slower than
    the control loop. 0 samples in each cycle."""

    def __init__(self, scene: _any_scene, period: float) -> None:
        expect(scene, _any_scene, "scene", "a scene: held_scene(scene(wall(shape, stiffness)), period)")
        self._parameters = {"scene": scene, "period": _native.number(period, "period")}
        self._held = _native.held_scene(scene._held, period)


class with_effects(_any_scene):
    """A scene with effects in addition to its walls.

    Walls have priority: except for the drag along them, their forces do not depend on the effects. Effects use
    the remaining force. They need direct_control, and a mechanism with as many joints and brakes as task
    dimensions.
    """

    def __init__(self, scene: _any_scene, *effects: effect) -> None:
        expect(scene, _any_scene, "scene", "a scene: with_effects(scene(wall(shape, stiffness)), effect, ...)")
        if not effects:
            raise TypeError("passive_haptics: with_effects needs an effect: with_effects(scene, effect, ...)")
        for i, each in enumerate(effects):
            expect(each, effect, f"effect {i} of a scene", "an effect such as viscous_field(viscosity)")
        self._held = _native.with_effects(scene._held, [each._held for each in effects])
        self._parameters = {"scene": scene, "effects": effects}


class scene_of_device(_any_scene):
    """Walls and effects from the text of a device file (docs/guide/device.md), including moving walls and height
    fields."""

    def __init__(self, text: str) -> None:
        self._held = _native.scene_of_device(text)
        self._parameters = {"text": text}
