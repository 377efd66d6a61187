"""Walls, scenes of walls, and meshes."""

from __future__ import annotations

import collections.abc
import os
from typing import Any, Optional, Union

import numpy as np

from passive_haptics import _native
from passive_haptics.arrays import Array, Integers, Path, Rows
from passive_haptics.catalogue_values import effect, shape
from passive_haptics.values import expect, number, value

LARGEST_SHOWN = 20
"""Vertices or facets of a mesh whose repr has them all."""


class mesh(value):
    """A surface that never changes: triangles in space, or segments in the plane.

    Parameters
    ----------
    vertices : N x d [m]
        2 numbers in a row in the plane, 3 in space.
    facets : M x d whole numbers
        Indices of vertices. The corners of a triangle run counterclockwise seen from the free side; of a segment the
        free side is on its right.

    Raises
    ------
    ValueError
        Names the first facet that is wrong.
    """

    def __init__(self, vertices: Rows, facets: Rows) -> None:
        points = _table(vertices, "vertices", "N rows of 2 numbers (in the plane) or 3 (in space)")
        corners = _table(facets, "facets", "M rows of indices of vertices")
        if points.dtype.kind not in "fiu":
            raise TypeError(
                f"passive_haptics: vertices has dtype {points.dtype}, expected real numbers [m]: vertices.astype(float)"
            )
        if corners.dtype.kind not in "iu":
            raise TypeError(f"passive_haptics: facets has dtype {corners.dtype}, expected whole numbers: facets.astype(int)")
        if points.shape[1] not in (2, 3):
            raise ValueError(f"passive_haptics: shape of vertices = {points.shape}, expected (N, 2) or (N, 3)")
        if corners.shape[1] != points.shape[1]:
            raise ValueError(
                f"passive_haptics: shape of facets = {corners.shape}, expected (M, {points.shape[1]}), "
                + ("the two ends of each segment" if points.shape[1] == 2 else "the three corners of each triangle")
            )
        large = np.iinfo(np.int64).max
        self._set(_native.mesh(points, np.minimum(corners, large).astype(np.int64) if corners.dtype.kind == "u" else corners))

    def _set(self, held: Any) -> mesh:
        self._held = held
        return self

    @property
    def vertices(self) -> Array:
        """A copy of the vertices, N x d [m]."""
        of: Array = self._held.vertices()
        return of

    @property
    def facets(self) -> Integers:
        """A copy of the indices of vertices, M x d."""
        of: Integers = self._held.facets()
        return of

    @property
    def dimension(self) -> int:
        """2 in the plane, 3 in space."""
        return int(self.vertices.shape[1])

    @property
    def closed(self) -> bool:
        """True if the facets enclose their wall or their free space without a hole."""
        return bool(self._held.closed())

    @property
    def hole(self) -> str:
        """Why it is not closed, by vertices and facets; "" if it is."""
        return str(self._held.hole())

    @property
    def turned_edges(self) -> int:
        """Edges (in the plane: vertices) of two facets of which one faces the wrong side."""
        return int(self._held.turned_edges())

    @property
    def content(self) -> float:
        """The enclosed area [m^2] or volume [m^3] of a closed mesh; < 0 if the outside is solid."""
        return float(self._held.content())

    def plausibility(self, reach: float) -> str:
        """A line for each thing that looks odd beside a device of this reach [m]; "" if there is none."""
        return str(self._held.plausibility(number(reach, "reach")))

    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of the vertices and facets."""
        return {"vertices": self.vertices, "facets": self.facets}

    def __len__(self) -> int:
        """The number of facets."""
        return len(self.facets)

    def __repr__(self) -> str:
        vertices, facets = self.vertices, self.facets
        if max(len(vertices), len(facets)) > LARGEST_SHOWN:
            return f"mesh(<{len(vertices)} vertices>, <{len(facets)} facets>)"
        return f"mesh({vertices.tolist()}, {facets.tolist()})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, mesh):
            return NotImplemented
        return np.array_equal(self.vertices, other.vertices) and np.array_equal(self.facets, other.facets)

    def __reduce__(self) -> tuple[Any, ...]:
        return mesh, (self.vertices, self.facets)


def _table(rows: Rows, name: str, expected: str) -> Any:
    """An array of two axes."""
    try:
        table = np.asarray(rows)
    except ValueError:
        table = np.empty(0)
    if type(rows) not in (list, tuple, np.ndarray, np.memmap):
        raise TypeError(f"passive_haptics: {name} = {rows!r} ({type(rows).__name__}), expected a numpy.ndarray, {expected}")
    if table.ndim != 2:
        raise ValueError(f"passive_haptics: shape of {name} = {table.shape}, expected {expected}")
    return table


def _read(form: str, path: Path, metres_per_unit: float) -> tuple[mesh, str]:
    try:
        name = os.fsencode(path)
    except TypeError:
        raise TypeError(f"passive_haptics: path = {path!r}, expected the name of a file, a str or an os.PathLike") from None
    if b"\0" in name:
        raise ValueError(f"passive_haptics: path = {path!r}, expected the name of a file, which has no zero byte")
    held, remarks = _native.read_mesh(form, name, number(metres_per_unit, "metres_per_unit"))
    return mesh.__new__(mesh)._set(held), remarks


def read_stl(path: Path, metres_per_unit: float = 1.0) -> tuple[mesh, str]:
    """The mesh of an STL file, in text or binary, and remarks on what of the file is not in it; "" if there is none.

    metres_per_unit: of the file's numbers, 1e-3 for millimetres. Raises ValueError with file and line.
    """
    return _read("stl", path, metres_per_unit)


def read_obj(path: Path, metres_per_unit: float = 1.0) -> tuple[mesh, str]:
    """The mesh of an OBJ file, all objects and groups as one, see read_stl."""
    return _read("obj", path, metres_per_unit)


def read_ply(path: Path, metres_per_unit: float = 1.0) -> tuple[mesh, str]:
    """The mesh of a PLY file, in text or binary, see read_stl."""
    return _read("ply", path, metres_per_unit)


class mesh_solid(shape):
    """The solid within a closed mesh whose normals point outward.

    In a scene of one wall it has one contact; a handle that is pushed more than half through a thin wall comes out at the
    other side.
    """

    _name = "mesh_solid"

    def __init__(self, surface: mesh) -> None:
        self._parameters = {"surface": expect(surface, mesh, "surface", "a mesh: mesh(vertices, facets)")}
        self._held = _native.mesh_solid(surface._held)


class mesh_surface(value):
    """A closed or an open mesh that stops what comes from its front, at any depth. A scene that has one is a world.

    Parameters
    ----------
    surface : mesh
    skin : float [m]
        From the surface to the point that stands for the handle on it.
    crease_angle : float [rad]
        Facets with normals that differ by less are one smooth surface.
    """

    def __init__(self, surface: mesh, skin: float = 1e-7, crease_angle: float = 0.5235987755982988) -> None:
        expect(surface, mesh, "surface", "a mesh: mesh(vertices, facets)")
        numbers = {"skin": number(skin, "skin"), "crease_angle": number(crease_angle, "crease_angle")}
        self._parameters = {"surface": surface, **numbers}
        self._held = _native.mesh_surface(surface._held, skin, crease_angle)

    @property
    def dimension(self) -> int:
        """2 in the plane, 3 in space."""
        return int(self._held.dimension())


class wall(value):
    """A shape that resists with a stiffness [N/m] times depth."""

    def __init__(self, shape: Union[shape, mesh_surface], stiffness: float = 1e7) -> None:
        if not isinstance(shape, mesh_surface):
            expect(shape, _shape, "shape", "a shape such as half_space(...): a wall is made of (shape, stiffness)")
        self._parameters = {"shape": shape, "stiffness": number(stiffness, "stiffness")}
        self._held = _native.wall(shape._held, stiffness)

    @property
    def dimension(self) -> int:
        """2 in the plane, 3 in space."""
        return int(self._parameters["shape"].dimension)


_shape = shape


class _any_scene(value):
    """What all scenes have."""

    walls: tuple[wall, ...]
    """The walls, numbered from 0 in their order."""
    effects: tuple[effect, ...] = ()
    """The effects in addition to the walls."""

    def _set(self, walls: collections.abc.Iterable[Any], is_world: bool) -> None:
        name = type(self).__name__
        self.walls = tuple(walls)
        if not self.walls:
            raise TypeError(f"passive_haptics: a {name} needs a wall, wall(shape, stiffness)")
        for i, each in enumerate(self.walls):
            expect(each, wall, f"wall {i} of a {name}", "a wall: put each shape into one, wall(shape)")
            if each.dimension != self.walls[0].dimension:
                raise ValueError(
                    f"passive_haptics: wall {i} of a {name} has dimension {each.dimension}, expected "
                    f"{self.walls[0].dimension}, as wall 0 has"
                )
        self._held = _native.scene([each._held for each in self.walls], is_world)

    @property
    def dimension(self) -> int:
        """2 in the plane, 3 in space."""
        return self.walls[0].dimension


class scene(_any_scene):
    """Walls, numbered from 0 in their order. Several walls, or a mesh_surface, are a world."""

    def __init__(self, *walls: wall) -> None:
        self._set(walls, False)
        self._parameters = {"walls": self.walls}

    def __repr__(self) -> str:
        return f"scene({', '.join(map(repr, self.walls))})"

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), tuple(self._parameters["walls"])


class world(_any_scene):
    """Many walls, of which a cycle looks at those that the handle can have reached since it last looked.

    At most d + 1 contacts, those of the largest forces. With a mesh among them all walls are felt as one surface.
    """

    def __init__(self, walls: collections.abc.Sequence[wall]) -> None:
        if not isinstance(walls, (list, tuple)):
            raise TypeError(f"passive_haptics: walls = {walls!r} ({type(walls).__name__}), expected a list of walls")
        self._set(walls, True)
        self._parameters = {"walls": list(walls)}


class held_scene(_any_scene):
    """A scene that is sampled once a period [s] and held between: a virtual environment that is slower than the loop of
    the brakes. 0 samples every time."""

    def __init__(self, scene: _any_scene, period: float) -> None:
        of = expect(scene, _any_scene, "scene", "a scene: held_scene(scene(wall(shape, stiffness)), period)")
        if isinstance(of, held_scene):
            raise TypeError("passive_haptics: scene of a held_scene is a held_scene itself, expected one that is not held")
        if of.effects:
            raise TypeError("passive_haptics: scene of a held_scene has effects, expected with_effects(held_scene(...), ...)")
        self.walls = of.walls
        self._parameters = {"scene": of, "period": number(period, "period")}
        self._held = _native.held_scene(of._held, period)


class with_effects(_any_scene):
    """A scene with effects in addition to its walls.

    Walls come first: what a cycle displays of them does not depend on the effects, except for the drag along them. Effects
    get the force that remains. They need direct_control, and a mechanism with as many joints and brakes as task dimensions.
    """

    def __init__(self, scene: _any_scene, *effects: effect) -> None:
        of = expect(scene, _any_scene, "scene", "a scene: with_effects(scene(wall(shape, stiffness)), effect, ...)")
        if of.effects:
            raise TypeError("passive_haptics: scene of with_effects has effects itself, expected all effects in one with_effects")
        if not effects:
            raise TypeError("passive_haptics: with_effects needs an effect: with_effects(scene, effect, ...)")
        for i, each in enumerate(effects):
            expect(each, effect, f"effect {i} of a scene", "an effect such as viscous_field(viscosity)")
        self.walls, self.effects = of.walls, effects
        self._parameters = {"scene": of, "effects": effects}
        self._held = _native.with_effects(of._held, [each._held for each in effects])

    def __repr__(self) -> str:
        return f"with_effects({', '.join(map(repr, (self._parameters['scene'], *self.effects)))})"

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._parameters["scene"], *self.effects)
