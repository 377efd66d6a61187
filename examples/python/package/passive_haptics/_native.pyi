"""Made by examples/python/stubs.py. Do not edit."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Literal, NoReturn

from passive_haptics.arrays import Array, Booleans, Integers, Numbers, Path, Records, Rows
from passive_haptics.results import (
    contact_metrics,
    contact_report,
    display_class,
    power_class,
    run_end,
    status,
    wall_limits,
)

class _class(type): ...
__version__: str
def status_text(value: int) -> str:
    """A status in words."""
def power_text(value: int) -> str:
    """A power class in words."""
def display_text(value: int) -> str:
    """A display class in words."""
def run_end_text(value: int) -> str:
    """The end of a run in words."""
class shape(metaclass=_class):
    """A shape of a wall, as a signed distance."""
    def __init__(self, /, *args: NoReturn, **kwargs: NoReturn) -> None: ...
    @property
    def dimension(self) -> int:
        """2 in the plane, 3 in space."""
    def distance(self, x: Numbers) -> float:
        """The signed distance [m] at x [m], positive in free space."""
    def gradient(self, x: Numbers) -> Array:
        """The unit vector at x [m] out of the wall."""
class half_space(shape):
    """The wall behind a plane. Of vectors of 2 numbers in the plane, of 3 in space.

    Parameters:
        surface_point [m]: a finite number; default [0.0, 0.0]
        normal [1]: a direction; no default
    """
    def __init__(self, surface_point: Numbers = ..., normal: Numbers = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class ball(shape):
    """A round wall, touched from outside or, hollow, from inside. Of vectors of 2 numbers in the plane, of 3 in space.

    Parameters:
        centre [m]: a finite number; default [0.0, 0.0]
        radius [m]: a finite number > 0; no default
        inside: solid, hollow; default 'solid'
    """
    def __init__(self, centre: Numbers = ..., radius: float = ..., inside: Literal["solid", "hollow"] = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class box(shape):
    """A rectangular wall. Of vectors of 2 numbers in the plane, of 3 in space.

    Parameters:
        centre [m]: a finite number; default [0.0, 0.0]
        half_extents [m]: a finite number >= 0; default [0.0, 0.0]
        axes [1]: a finite number; default [[1.0, 0.0], [0.0, 1.0]]
    """
    def __init__(self, centre: Numbers = ..., half_extents: Numbers = ..., axes: Rows = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class capsule(shape):
    """A rounded bar. Of vectors of 2 numbers in the plane, of 3 in space.

    Parameters:
        from_ [m]: a finite number; default [0.0, 0.0]
        to [m]: a finite number; default [0.0, 0.0]
        radius [m]: a finite number >= 0; default 0.0
    """
    def __init__(self, from_: Numbers = ..., to: Numbers = ..., radius: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class convex_polygon(shape):
    """A convex polygon in the plane, of 3 to 8 corners [m], either way round."""
    def __init__(self, corners: Rows) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class offset(shape):
    """A shape whose surface moves this far [m] to the free side; < 0 shrinks it."""
    def __init__(self, shape: shape, growth: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class complement(shape):
    """A shape with wall and free space swapped."""
    def __init__(self, shape: shape) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class mesh(metaclass=_class):
    """A surface that never changes: triangles in space, or segments in the plane.

    vertices: N x d [m], of float64. facets: M x d indices of vertices, whole numbers. The corners of a triangle run counterclockwise seen from the free side; of a segment the free side is on its right. Both may be lists of rows. A ValueError names the first facet that is wrong.
    """
    def __init__(self, vertices: Rows, facets: Rows) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __len__(self) -> int:
        """The number of facets."""
    @property
    def closed(self) -> bool:
        """Whether the facets enclose their wall or their free space without a hole."""
    @property
    def content(self) -> float:
        """The enclosed area [m^2] or volume [m^3] of a closed mesh; < 0 if the outside is solid."""
    @property
    def dimension(self) -> int:
        """2 in the plane, 3 in space."""
    @property
    def facets(self) -> Integers:
        """A copy of the indices of vertices, M x d."""
    @property
    def hole(self) -> str:
        """Why it is not closed, by vertices and facets; "" if it is."""
    def plausibility(self, reach: float) -> str:
        """A line for each thing that looks odd beside a device of this reach [m]; "" if there is none."""
    @property
    def turned_edges(self) -> int:
        """Edges (in the plane: vertices) of two facets of which one faces the wrong side."""
    @property
    def vertices(self) -> Array:
        """A copy of the vertices, N x d [m]."""
def read_stl(path: Path, metres_per_unit: float = ...) -> tuple[mesh, str]:
    """The mesh of an STL file, in text or binary, and what of the file is not in it, in words; "" where all is. metres_per_unit: the unit of the file [m], 1e-3 for millimetres; 1 where none is given. A ValueError names the file, the line or byte, and what was expected there."""
def read_obj(path: Path, metres_per_unit: float = ...) -> tuple[mesh, str]:
    """The mesh of an OBJ file: all objects and groups as one, and what of the file is not in it, in words; "" where all is. metres_per_unit: the unit of the file [m], 1e-3 for millimetres; 1 where none is given. A ValueError names the file, the line or byte, and what was expected there."""
def read_ply(path: Path, metres_per_unit: float = ...) -> tuple[mesh, str]:
    """The mesh of a PLY file, in text or binary, and what of the file is not in it, in words; "" where all is. metres_per_unit: the unit of the file [m], 1e-3 for millimetres; 1 where none is given. A ValueError names the file, the line or byte, and what was expected there."""
class mesh_solid(shape):
    """The solid within a closed mesh whose normals point outward. In a scene of one wall it has one contact; what is pushed more than half through a thin wall comes out at the other side."""
    def __init__(self, surface: mesh) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class mesh_surface(metaclass=_class):
    """A closed or an open mesh that stops what comes from its front, at any depth. A scene that has one is a world.

    Parameters:
        skin [m]: from the surface to the point that stands for the handle on it; default 1e-07
        crease_angle [rad]: facets whose normals differ by less are one smooth surface; default 0.5235987755982988
    """
    def __init__(self, surface: mesh, skin: float = ..., crease_angle: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class wall(metaclass=_class):
    """A shape that resists with stiffness [N/m] times depth; 1e7 where none is given."""
    def __init__(self, shape: shape | mesh_surface, stiffness: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class scene(metaclass=_class):
    """Walls, numbered from 0 in their order. Several walls, or a mesh_surface, are a world."""
    def __init__(self, *walls: wall) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def dimension(self) -> int:
        """2 in the plane, 3 in space."""
    @property
    def walls(self) -> tuple[wall, ...]:
        """The walls."""
class world(scene):
    """Many walls, numbered from 0 in their order, of which a cycle looks at those that the handle can have reached since it last looked. At most d + 1 contacts, those of the largest forces. With a mesh among them all walls are felt as one surface. For a law that takes several walls."""
    def __init__(self, walls: Sequence[wall]) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class held_scene(scene):
    """A scene that is sampled once a period [s] and held between: a virtual environment that is slower than the loop of the brakes. 0 samples every time."""
    def __init__(self, scene: scene, period: float) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class effect(metaclass=_class):
    """A force beside that of the walls, which resists motion."""
    def __init__(self, /, *args: NoReturn, **kwargs: NoReturn) -> None: ...
class viscous_field(effect):
    """A resistance to all motion, F = -B v. viscosity: a d x d matrix; no motion may be driven by it. Of vectors of 2 numbers in the plane, of 3 in space.

    Parameters:
        viscosity [N s/m]: a finite number; default [[0.0, 0.0], [0.0, 0.0]]
    """
    def __init__(self, viscosity: Rows = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class guide(effect):
    """A resistance to what leaves a line or a plane; motion along it and back is free. Of vectors of 2 numbers in the plane, of 3 in space.

    Parameters:
        along: line, plane; default 'line'
        point [m]: a finite number; default [0.0, 0.0]
        direction [1]: a direction; default [1.0, 0.0]
        stiffness [N/m]: a finite number >= 0; default 0.0
        tolerance [m]: a finite number >= 0; default 0.0
        viscosity [N s/m]: a finite number >= 0; default 0.0
        velocity_dead_band [m/s]: a finite number > 0; default 0.003
    """
    def __init__(self, along: Literal["line", "plane"] = ..., point: Numbers = ..., direction: Numbers = ..., stiffness: float = ..., tolerance: float = ..., viscosity: float = ..., velocity_dead_band: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class detents(effect):
    """Periodic positions along a direction that resist being left. Of vectors of 2 numbers in the plane, of 3 in space.

    Parameters:
        origin [m]: a finite number; default [0.0, 0.0]
        direction [1]: a direction; default [1.0, 0.0]
        spacing [m]: a finite number > 0; no default
        strength [N]: a finite number >= 0; default 0.0
        velocity_dead_band [m/s]: a finite number > 0; default 0.003
    """
    def __init__(self, origin: Numbers = ..., direction: Numbers = ..., spacing: float = ..., strength: float = ..., velocity_dead_band: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class rough_walls(effect):
    """Friction on all walls that are touched, under the load with which the hand presses.

    Parameters:
        coefficient: a finite number >= 0; default 0.0
        viscosity [N s/m]: a finite number >= 0; default 0.0
        velocity_dead_band [m/s]: a finite number > 0; default 0.003
    """
    def __init__(self, coefficient: float = ..., viscosity: float = ..., velocity_dead_band: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class end_stops(effect):
    """Limits of the joints, which resist motion further out. Of vectors of as many numbers as there are joints, 2 or 3. For a sliding joint read N for N m and m for rad.

    Parameters:
        lower [rad]: anything; default [-inf, -inf]
        upper [rad]: anything; default [inf, inf]
        stiffness [N m/rad]: a finite number >= 0; default [0.0, 0.0]
        rate_dead_band [rad/s]: a finite number > 0; default [0.02, 0.02]
    """
    def __init__(self, lower: Numbers = ..., upper: Numbers = ..., stiffness: Numbers = ..., rate_dead_band: Numbers = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class with_effects(scene):
    """A scene with effects beside its walls. Walls come first: what a cycle displays of them does not depend on the effects, but for the drag along them. Effects get what the brakes can do besides. For direct_control, and mechanisms with as many joints and brakes as task dimensions."""
    def __init__(self, scene: scene, *effects: effect) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None
    @property
    def effects(self) -> tuple[effect, ...]:
        """The effects."""
class law(metaclass=_class):
    """A control law."""
    def __init__(self, /, *args: NoReturn, **kwargs: NoReturn) -> None: ...
class direct_control(law):
    """The paper's direct control (7)-(12).

    Parameters:
        velocity_dead_band [m/s]: a finite number >= 0; default 0.0
    """
    def __init__(self, velocity_dead_band: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class saturated_direct_control(law):
    """Direct control whose alpha scales torques that are already cut to the limits. One wall.

    Parameters:
        velocity_dead_band [m/s]: a finite number >= 0; default 0.0
    """
    def __init__(self, velocity_dead_band: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class velocity_direct_control(law):
    """The law that recommended_law returns for a mechanism with inertia and a force sensor.

    Parameters:
        depth_gain [1/s]: a finite number > 0; default 20.0
        velocity_limit [m/s]: a finite number > 0; default 0.1
        velocity_lag [s]: a finite number > 0; default 0.0075
        integral_time [s]: a finite number > 0; default 0.1
        release_length [m]: a finite number > 0; default 0.00016
        hand_mass [kg]: a finite number >= 0; default 0.4
        force_share [1]: 0 to 1; default 0.22
        rate_lag [s]: a finite number >= 0; default 0.004
        horizon [s]: a finite number >= 0; default 0.005
        rest_depth [m]: a finite number >= 0; default 0.002
        depth_per_jump [1]: a finite number >= 0; default 4.5
        approach_speed [m/s]: a finite number >= 0; default 0.1
    """
    def __init__(self, depth_gain: float = ..., velocity_limit: float = ..., velocity_lag: float = ..., integral_time: float = ..., release_length: float = ..., hand_mass: float = ..., force_share: float = ..., rate_lag: float = ..., horizon: float = ..., rest_depth: float = ..., depth_per_jump: float = ..., approach_speed: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class on_off_control(law):
    """The whole approximated force or none, by a relay. recommended_law for a mechanism without inertia.

    Parameters:
        reference_depth [m]: a finite number; default 0.0015
        hysteresis [m]: a finite number >= 0; default 0.0001
        lead [s]: a finite number >= 0; default 0.02
    """
    def __init__(self, reference_depth: float = ..., hysteresis: float = ..., lead: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class no_direct_control(law):
    """The approximated force as it is, alpha = 1."""
    def __init__(self) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class brake_parameters(metaclass=_class):
    """The parameters of the brakes of a device."""
    def __init__(self, /, *args: NoReturn, **kwargs: NoReturn) -> None: ...
class mechanism(metaclass=_class):
    """A mechanism: joint positions in, end effector out."""
    def __init__(self, /, *args: NoReturn, **kwargs: NoReturn) -> None: ...
    @property
    def brake_count(self) -> int:
        """m, the brakes."""
    def brake_rates(self, q: Numbers, qd: Numbers) -> Array:
        """The rates of the brakes, w = T qd [rad/s or m/s]."""
    def brake_signs(self, q: Numbers, qd: Numbers, hand_force: Numbers | None = ..., brakes: brake_parameters | None = ...) -> Array:
        """The signs of the brakes: those of their rates, at rest those of the hand's torque."""
    def braked_wall_at(self, q: Numbers, velocity: Numbers, normal: Numbers, brakes: brake_parameters, residual_torque: Numbers, resolution: Numbers, hand_mass: float) -> braked_wall:
        """The wall of this normal that the brakes can make at q, touched with a velocity [m/s], for limits_of(). residual_torque [N m] of each brake, resolution: a count of each encoder [rad or m], hand_mass [kg]. Of a mechanism with inertia; TypeError for others."""
    def design_map(self, q: Array, direction: Numbers | Array, normal: Numbers | Array, brakes: brake_parameters | None = ..., push: float = ..., *, motor_limit: Numbers | None = ...) -> Records:
        """The figures of the device at N places of a task, an array with the fields outcome (status), display (display_class), cosine of gamma [1], drag for each newton that is displayed [1], strongest force along the normal [N], sink_slope [1] and isotropy of E [1]. q: N x n joint positions; direction of the motion and normal of the wall: N x d, or one vector for all. push [N]. N is at most 100 million. Ctrl-C ends it."""
    def displayable(self, q: Numbers, velocity: Numbers, normal: Numbers, brakes: brake_parameters | None = ...) -> displayable_force:
        """What the brakes can display along the normal of a wall while the handle moves with a velocity (its direction counts). Brakes without limits where none are given."""
    @property
    def dof(self) -> int:
        """n, the joints."""
    def jacobian(self, q: Numbers) -> Array:
        """J in v = J qd, d x n [m/rad or 1]."""
    def nearest_force(self, q: Numbers, signs: Numbers, desired_force: Numbers) -> Array:
        """The force [N] nearest to the desired one that brakes of these signs can make. Of a device with as many brakes and joints as task dimensions; TypeError for others."""
    def passive_fme(self, q: Numbers, segments: int = ...) -> list[tuple[tuple[int, int], Array]]:
        """The four passive FMEs: the signs of the torques, and the closed outline [N] as K rows of 2 numbers. NaN at a singular pose. Of two brakes on two joints in the plane; TypeError for others."""
    def position(self, q: Numbers) -> Array:
        """The end effector [m], base frame."""
    def recommended_law(self, brakes: brake_parameters | None = ...) -> law:
        """The law for a device with a force sensor whose user has not chosen one."""
    def reference_forces(self, q: Numbers) -> tuple[Array, status]:
        """The forces of unit torques, a column for each brake [N per N m] (6); NaN unless the status is ok. Of a device with as many brakes and joints as task dimensions; TypeError for others."""
    def sink_depth(self, q: Array, direction: Numbers | Array, normal: Numbers | Array, brakes: brake_parameters | None = ..., push: float = ..., *, motor_limit: Numbers | None = ...) -> float:
        """The depth [m] to which a hand that pushes [N] sinks on a path, at least. q: N x n joint positions at the middles of N >= 2 equal parts of the path; direction and normal of the wall there: N x d, or one vector for all."""
    def sink_slope(self, q: Numbers, direction: Numbers, normal: Numbers, brakes: brake_parameters | None = ..., push: float = ..., *, motor_limit: Numbers | None = ...) -> tuple[float, status]:
        """The least slope [1], metres into a wall for each metre along it, at which the brakes resist a push [N] while a hand leads the end effector in this direction; infinite where they do at none. Brakes without limits where none are given. motor_limit: the torque of a motor beside each brake [N m]."""
    @property
    def task_dimension(self) -> int:
        """d, the size of a position."""
    def velocity(self, q: Numbers, qd: Numbers) -> Array:
        """The velocity of the end effector [m/s]."""
class device_state(metaclass=_class):
    """What a device measures, once a control cycle: time [s], joint positions [rad or m] and rates, and what the hand does to the handle [N] in the base frame; None without a force sensor."""
    def __init__(self, time: float, q: Numbers, qd: Numbers, hand_force: Numbers | None = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def hand_force(self) -> Array | None:
        """What the hand does to the handle [N], base frame."""
    @property
    def q(self) -> Array:
        """Joint positions [rad or m]."""
    @property
    def qd(self) -> Array:
        """Joint rates [rad/s or m/s]."""
    @property
    def time(self) -> float:
        """[s], of a clock that does not jump."""
class step_result(metaclass=_class):
    """What one control cycle decides, and why."""
    def __init__(self, /, *args: NoReturn, **kwargs: NoReturn) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def alpha(self) -> float:
        """Scale factor of the law (12)."""
    @property
    def approximation_cosine(self) -> float:
        """cos(gamma)."""
    @property
    def capacity(self) -> Array:
        """The most each brake may hold [N m], to be commanded."""
    @property
    def cone_coefficients(self) -> Array:
        """Torques that make Fc [N m]."""
    @property
    def contacts(self) -> list[contact_report]:
        """Each touched wall, under any law; empty if the scene has one wall."""
    @property
    def control_force(self) -> Array:
        """Fc [N], base frame, before alpha and limits."""
    @property
    def desired_force(self) -> Array:
        """Fd [N], base frame."""
    @property
    def display(self) -> display_class:
        """How Fd is displayed."""
    @property
    def outcome(self) -> status:
        """ok, or why the brakes were released."""
    @property
    def power(self) -> power_class:
        """Of the desired force."""
    @property
    def saturated(self) -> bool:
        """Whether a torque limit was reached."""
    @property
    def settled_signs(self) -> Array:
        """s* once the self-motion has settled; empty of a device that has none."""
    @property
    def settled_velocity(self) -> Array:
        """v' [m/s], to which s* belongs; empty of a device that has none."""
    @property
    def signs(self) -> Array:
        """s, -1, 0 or 1 of each brake."""
    @property
    def torque(self) -> Array:
        """What the mechanism is predicted to feel (3) [N m]."""
    @property
    def wall_number(self) -> int:
        """Wall that demands the force; -1 in free space."""
class displayable_force(metaclass=_class):
    """What brakes can display along the normal of a wall."""
    def __init__(self, /, *args: NoReturn, **kwargs: NoReturn) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def angle(self) -> float:
        """gamma [rad] between the normal and the nearest force."""
    @property
    def display(self) -> display_class:
        """How a force along the normal is displayed."""
    @property
    def max_approximated_force(self) -> float:
        """The most along the normal [N] of the nearest force."""
    @property
    def max_force(self) -> float:
        """The most along the normal [N] of all forces."""
    @property
    def outcome(self) -> status:
        """ok, or why nothing is known."""
    @property
    def signs(self) -> Array:
        """s of the brakes in this motion."""
class batch_result(metaclass=_class):
    """What batch() stores: an array for each member of step_result, a row or a number for each state; None where it was not wanted. Arrays of rows stand in memory column by column."""
    def __init__(self, /, *args: NoReturn, **kwargs: NoReturn) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def __len__(self) -> int:
        """N."""
    @property
    def alpha(self) -> Array:
        """Scale factor of the law (12), N."""
    @property
    def approximation_cosine(self) -> Array:
        """cos(gamma), N."""
    @property
    def capacity(self) -> Array:
        """The most each brake may hold [N m], N x m."""
    @property
    def cone_coefficients(self) -> Array:
        """Torques that make Fc [N m], N x m."""
    @property
    def control_force(self) -> Array:
        """Fc [N], N x d."""
    @property
    def desired_force(self) -> Array:
        """Fd [N], N x d."""
    @property
    def display(self) -> Integers:
        """display_class, N."""
    @property
    def outcome(self) -> Integers:
        """status, N."""
    @property
    def power(self) -> Integers:
        """power_class, N."""
    @property
    def saturated(self) -> Booleans:
        """Whether a torque limit was reached, N."""
    @property
    def signs(self) -> Array:
        """s, N x m."""
    @property
    def torque(self) -> Array:
        """What the mechanism is predicted to feel [N m], N x m."""
    @property
    def wall_number(self) -> Integers:
        """-1 in free space, N."""
class controller(metaclass=_class):
    """A mechanism, its brakes, a scene and a law, called once a cycle or for many states at once. max_approximation_angle [rad]: beyond it nothing is displayed. limits: what gives way at a torque limit. A pickled controller remembers nothing of its motion."""
    def __init__(self, mechanism: mechanism, brakes: brake_parameters, scene: scene, law: law, max_approximation_angle: float = ..., limits: Literal["keep_direction", "clamp_each"] = ...) -> None: ...
    def __call__(self, state: device_state) -> step_result:
        """One control cycle."""
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def batch(self, q: Array, qd: Array, hand_force: Array | None = ..., time: Array | None = ..., *, fields: Iterable[str] | None = ..., out: batch_result | None = ...) -> batch_result:
        """The cycle of N states, each the first of a motion. q and qd: N x n, hand_force: N x d, time: N, of float64. Columns that are one piece of memory (order='F') are read where they stand. fields: names of the results that are wanted beside capacity and outcome; None: all. out: an earlier result of as many states, whose arrays are written again. Python's lock is released."""
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
    def reset(self) -> None:
        """Forgets the motion so far, and the scene the handle."""
    def set_brakes(self, brakes: brake_parameters) -> None:
        """Other brakes of the device from the next cycle on, such as some that are off (torque_lower = torque_upper = 0). What the law remembers stays."""
class braked_wall(metaclass=_class):
    """A wall at one place of a device, the hand that comes, and the control, along the wall's normal.

    Parameters:
        force [N]: a finite number >= 0; default 10.0
        approximated_force [N]: a finite number >= 0; default 8.0
        residual_force [N]: a finite number; default 0.0
        sliding_residual [N]: a finite number; default 0.0
        inertia [kg]: a finite number > 0; default 0.7
        depth_resolution [m]: a finite number >= 0; default 0.0001
        approach_speed [m/s]: a finite number >= 0; default 0.1
        time_constant [s]: a finite number >= 0; default 0.02
        push [N]: a finite number; default 2.0
        hand_stiffness [N/m]: a finite number >= 0; default 0.0
        hand_damping [N s/m]: a finite number >= 0; default 20.0
        control_period [s]: a finite number > 0; default 0.001
        scene_period [s]: a finite number >= 0; default 0.001
        reaction_time [s]: a finite number >= 0; default 0.004
        averaging_time [s]: a finite number > 0; default 0.014366197723675814
        rest_depth [m]: a finite number >= 0; default 0.002
        depth_per_jump [1]: a finite number >= 0; default 4.5
    """
    def __init__(self, force: float = ..., approximated_force: float = ..., residual_force: float = ..., sliding_residual: float = ..., inertia: float = ..., depth_resolution: float = ..., approach_speed: float = ..., time_constant: float = ..., push: float = ..., hand_stiffness: float = ..., hand_damping: float = ..., control_period: float = ..., scene_period: float = ..., reaction_time: float = ..., averaging_time: float = ..., rest_depth: float = ..., depth_per_jump: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
def limits_of(wall: braked_wall) -> wall_limits:
    """What a wall made of brakes can be."""
class brake_model(metaclass=_class):
    """What one brake of a simulated device makes of a command."""
    def __init__(self, /, *args: NoReturn, **kwargs: NoReturn) -> None: ...
class coulomb_brake(brake_model):
    """Friction that follows its command with a lag.

    Parameters:
        torque_limit [N m]: a finite number >= 0; default 1.0
        time_constant [s]: a finite number >= 0; default 0.02
        fall_ratio [1]: a finite number > 0; default 1.0
        gain [1]: a finite number > 0; default 1.0
        residual: a dict
            strength [N m]: a finite number >= 0; default 0.0
            drag [N m s]: a finite number >= 0; default 0.0
    """
    def __init__(self, torque_limit: float = ..., time_constant: float = ..., fall_ratio: float = ..., gain: float = ..., residual: Mapping[str, object] = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class stribeck_brake(brake_model):
    """A coulomb_brake whose friction is larger at rest.

    Parameters:
        coulomb: a dict
            torque_limit [N m]: a finite number >= 0; default 1.0
            time_constant [s]: a finite number >= 0; default 0.02
            fall_ratio [1]: a finite number > 0; default 1.0
            gain [1]: a finite number > 0; default 1.0
            residual: a dict
                strength [N m]: a finite number >= 0; default 0.0
                drag [N m s]: a finite number >= 0; default 0.0
        static_ratio [1]: a finite number >= 1; default 1.5
        stribeck_rate [rad/s]: a finite number > 0; default 0.05
    """
    def __init__(self, coulomb: Mapping[str, object] = ..., static_ratio: float = ..., stribeck_rate: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class eddy_current_brake(brake_model):
    """Drag by eddy currents: no torque at rest.

    Parameters:
        peak_torque [N m]: a finite number >= 0; default 27.76
        critical_rate [rad/s]: a finite number > 0; default 102.1
        time_constant [s]: a finite number >= 0; default 0.02
        residual: a dict
            strength [N m]: a finite number >= 0; default 0.0
            drag [N m s]: a finite number >= 0; default 0.0
    """
    def __init__(self, peak_torque: float = ..., critical_rate: float = ..., time_constant: float = ..., residual: Mapping[str, object] = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class magnetorheological_brake(brake_model):
    """A magnetorheological brake, with saturation and hysteresis.

    Parameters:
        torque_limit [N m]: a finite number >= 0; default 1.0
        saturation [1]: a finite number > 0; default 1.5
        coercive_current [1]: a finite number >= 0; default 0.02
        time_constant [s]: a finite number >= 0; default 0.02
        residual: a dict
            strength [N m]: a finite number >= 0; default 0.0
            drag [N m s]: a finite number >= 0; default 0.0
    """
    def __init__(self, torque_limit: float = ..., saturation: float = ..., coercive_current: float = ..., time_constant: float = ..., residual: Mapping[str, object] = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class presliding_brake(brake_model):
    """A coulomb_brake that turns elastically before it slips.

    Parameters:
        model: a dict
            torque_limit [N m]: a finite number >= 0; default 1.0
            time_constant [s]: a finite number >= 0; default 0.02
            fall_ratio [1]: a finite number > 0; default 1.0
            gain [1]: a finite number > 0; default 1.0
            residual: a dict
                strength [N m]: a finite number >= 0; default 0.0
                drag [N m s]: a finite number >= 0; default 0.0
        presliding [rad]: a finite number >= 0; default 0.003
    """
    def __init__(self, model: Mapping[str, object] = ..., presliding: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class simulated_device(metaclass=_class):
    """A device without hardware, at rest at joint positions q [rad or m]: a mechanism with inertia, real brakes and a hand's mass [kg] on its handle. brakes: what brakes() of the mechanism returns, for brakes that are what their controller believes, or a brake model for each brake. A pickled one, and parameters, are those of the start."""
    def __init__(self, mechanism: mechanism, brakes: brake_parameters | Sequence[brake_model], hand_mass: float, q: Numbers) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def advance(self, dt: float, capacity: Numbers, muscle_force: Numbers) -> None:
        """One time step dt [s] under commanded capacities [N m] and the force that the hand's muscles exert [N]. No time passes where dt is not a finite number > 0. A dt over twice the time constants of the hand's spring and damper makes the motion grow until it is NaN."""
    @property
    def brake_force(self) -> Array:
        """The force at the handle that does what these torques do [N]."""
    @property
    def brake_torque(self) -> Array:
        """Mean torque of the brakes in the last step [N m]."""
    @property
    def energy(self) -> dict[str, float]:
        """Where the energy came from and went since the motion was set [J], and the largest power of a brake [W]."""
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
    @property
    def position(self) -> Array:
        """The handle now [m]."""
    @property
    def q(self) -> Array:
        """Joint positions now [rad or m]."""
    @property
    def qd(self) -> Array:
        """Joint rates now [rad/s or m/s]."""
    @property
    def rates(self) -> Array:
        """Rates of the brakes [rad/s or m/s]."""
    @property
    def sensed_force(self) -> Array:
        """Force of the hand on the handle in the last step [N]."""
    def set_motion(self, q: Numbers, qd: Numbers) -> None:
        """Sets joint positions [rad or m] and rates, and begins the energy balance anew."""
    @property
    def velocity(self) -> Array:
        """The handle's velocity [m/s]."""
class following_hand(metaclass=_class):
    """A hand that moves along a wall in a direction and presses on it, at start [m] at time 0.

    Parameters:
        speed [m/s]: a finite number; default 0.05
        stiffness [N/m]: a finite number >= 0; default 200.0
        damping [N s/m]: a finite number >= 0; default 20.0
        push [N]: a finite number; default 2.0
        normal_stiffness [N/m]: a finite number >= 0; default 0.0
        target_depth [m]: a finite number; default 0.0
        normal_damping [N s/m]: a finite number >= 0; default 20.0
        mass [kg]: a finite number >= 0; default 0.5
    """
    def __init__(self, direction: Numbers, start: Numbers, speed: float = ..., stiffness: float = ..., damping: float = ..., push: float = ..., normal_stiffness: float = ..., target_depth: float = ..., normal_damping: float = ..., mass: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class wall_following_parameters(metaclass=_class):
    """Timing and sensing of a wall-following experiment.

    Parameters:
        time_step [s]: a finite number > 0; default 0.0001
        control_period [s]: a finite number > 0; default 0.001
        sensor_corner [Hz]: a finite number >= 0; default 200.0
        sensor_scale [1]: a finite number > 0; default 1.0
        sensor_noise [N]: a finite number >= 0; default 0.0
        noise_seed: anything; default 1
        encoder_resolution [rad or m]: a finite number >= 0; default 0.0007669903939428206
        rate_corner [Hz]: a finite number >= 0; default 50.0
        path_end [m]: a finite number; default 0.17
        max_duration [s]: a finite number > 0; default 8.0
        max_depth [m]: a finite number > 0; default 1.0
        watched_brake: anything; default 1
    """
    def __init__(self, time_step: float = ..., control_period: float = ..., sensor_corner: float = ..., sensor_scale: float = ..., sensor_noise: float = ..., noise_seed: int = ..., encoder_resolution: float = ..., rate_corner: float = ..., path_end: float = ..., max_duration: float = ..., max_depth: float = ..., watched_brake: int = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
def follow_wall(device: simulated_device, controller: controller, shape: shape, hand: following_hand, parameters: wall_following_parameters | None = ..., *, record: bool = ...) -> tuple[contact_metrics, Records]:
    """The wall-following experiment: a hand moves the device along a shape, the wall whose depth is measured, under a controller. Returns its figures and, if record is true, an array with a row for each time step (else none): time [s], depth [m], position [m], velocity [m/s], rates of the brakes, brake_torque [N m], brake_power [W], hand_force [N], brake_force [N], and of the latest control cycle capacity [N m], alpha, outcome, power, display, saturated and wall_number. The device and the controller go on from where they are; time begins at 0, so reset() a controller that has run before. Ctrl-C ends it."""
class brakes_2(brake_parameters):
    """The brakes of a device with 2 of them. torque_lower = torque_upper = 0: the brake is off. One of them 0: it works one way.

    Parameters:
        torque_limit [N m]: a finite number >= 0; default [1.0, 1.0]
        rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02]
        torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09]
        time_constant [s]: a finite number >= 0; default [0.02, 0.02]
        torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf]
        torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf]
    """
    def __init__(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class tendon_two_link(mechanism):
    """The paper's device: two links, both brakes at the base, coupled by tendons.

    It has 2 joints, 2 brakes and 2 task dimensions.

    Parameters:
        length_1 [m]: a finite number > 0; default 0.15
        length_2 [m]: a finite number > 0; default 0.15
        mass_1 [kg]: a finite number > 0; default 0.2
        mass_2 [kg]: a finite number > 0; default 0.2
        handle_mass [kg]: a finite number >= 0; default 0.1
        rotor_inertia_1 [kg m^2]: a finite number >= 0; default 5e-05
        rotor_inertia_2 [kg m^2]: a finite number >= 0; default 5e-05
        reduction_2 [1]: a finite number > 0; default 0.4
    """
    def __init__(self, length_1: float = ..., length_2: float = ..., mass_1: float = ..., mass_2: float = ..., handle_mass: float = ..., rotor_inertia_1: float = ..., rotor_inertia_2: float = ..., reduction_2: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def brakes(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> brakes_2:
        """The brakes of this device.

        Parameters:
            torque_limit [N m]: a finite number >= 0; default [1.0, 1.0]
            rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02]
            torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09]
            time_constant [s]: a finite number >= 0; default [0.02, 0.02]
            torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf]
            torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf]
        """
    def inverse(self, x: Numbers, branch: Literal["left", "right"] = ...) -> tuple[Array, status]:
        """Joint positions that put the handle at x [m], and whether it is in reach."""
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class two_link(mechanism):
    """Two links in a plane, a brake on each joint.

    It has 2 joints, 2 brakes and 2 task dimensions.

    Parameters:
        length_1 [m]: a finite number > 0; default 0.15
        length_2 [m]: a finite number > 0; default 0.15
        mass_1 [kg]: a finite number > 0; default 0.2
        mass_2 [kg]: a finite number > 0; default 0.2
        handle_mass [kg]: a finite number >= 0; default 0.1
        rotor_inertia_1 [kg m^2]: a finite number >= 0; default 5e-05
        rotor_inertia_2 [kg m^2]: a finite number >= 0; default 5e-05
    """
    def __init__(self, length_1: float = ..., length_2: float = ..., mass_1: float = ..., mass_2: float = ..., handle_mass: float = ..., rotor_inertia_1: float = ..., rotor_inertia_2: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def brakes(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> brakes_2:
        """The brakes of this device.

        Parameters:
            torque_limit [N m]: a finite number >= 0; default [1.0, 1.0]
            rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02]
            torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09]
            time_constant [s]: a finite number >= 0; default [0.02, 0.02]
            torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf]
            torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf]
        """
    def inverse(self, x: Numbers, branch: Literal["left", "right"] = ...) -> tuple[Array, status]:
        """Joint positions that put the handle at x [m], and whether it is in reach."""
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class five_bar(mechanism):
    """Two legs that meet at the handle (pantograph).

    It has 2 joints, 2 brakes and 2 task dimensions.

    Parameters:
        base_distance [m]: a finite number >= 0; default 0.025
        proximal_1 [m]: a finite number > 0; default 0.063
        proximal_2 [m]: a finite number > 0; default 0.063
        distal_1 [m]: a finite number > 0; default 0.075
        distal_2 [m]: a finite number > 0; default 0.075
        assembly: left, right; default 'left'
        proximal_mass [kg]: a finite number > 0; default 0.05
        distal_mass [kg]: a finite number >= 0; default 0.05
        handle_mass [kg]: a finite number >= 0; default 0.1
        rotor_inertia [kg m^2]: a finite number >= 0; default [5e-05, 5e-05]
        gravity [m/s^2]: a finite number; default [0.0, 0.0]
    """
    def __init__(self, base_distance: float = ..., proximal_1: float = ..., proximal_2: float = ..., distal_1: float = ..., distal_2: float = ..., assembly: Literal["left", "right"] = ..., proximal_mass: float = ..., distal_mass: float = ..., handle_mass: float = ..., rotor_inertia: Numbers = ..., gravity: Numbers = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def brakes(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> brakes_2:
        """The brakes of this device.

        Parameters:
            torque_limit [N m]: a finite number >= 0; default [1.0, 1.0]
            rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02]
            torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09]
            time_constant [s]: a finite number >= 0; default [0.02, 0.02]
            torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf]
            torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf]
        """
    def inverse(self, x: Numbers) -> tuple[Array, status]:
        """Base angles that put the handle at x [m], elbows outward, and whether it is in reach."""
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class xy_table(mechanism):
    """Two orthogonal slides, a brake on each.

    It has 2 joints, 2 brakes and 2 task dimensions.

    Parameters:
        mass_x [kg]: a finite number > 0; default 0.5
        mass_y [kg]: a finite number > 0; default 0.5
    """
    def __init__(self, mass_x: float = ..., mass_y: float = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def brakes(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> brakes_2:
        """The brakes of this device.

        Parameters:
            torque_limit [N m]: a finite number >= 0; default [1.0, 1.0]
            rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02]
            torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09]
            time_constant [s]: a finite number >= 0; default [0.02, 0.02]
            torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf]
            torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf]
        """
    def inverse(self, x: Numbers) -> tuple[Array, status]:
        """Joint positions that put the handle at x [m], and whether it is in reach."""
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class brakes_4(brake_parameters):
    """The brakes of a device with 4 of them. torque_lower = torque_upper = 0: the brake is off. One of them 0: it works one way.

    Parameters:
        torque_limit [N m]: a finite number >= 0; default [1.0, 1.0, 1.0, 1.0]
        rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02, 0.02, 0.02]
        torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09, 1e-09, 1e-09]
        time_constant [s]: a finite number >= 0; default [0.02, 0.02, 0.02, 0.02]
        torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf, -inf, -inf]
        torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf, inf, inf]
    """
    def __init__(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class five_bar_with_four_brakes(mechanism):
    """A five-bar with brakes on both base joints, their difference and their sum.

    It has 2 joints, 4 brakes and 2 task dimensions.

    Parameters:
        base_distance [m]: a finite number >= 0; default 0.025
        proximal_1 [m]: a finite number > 0; default 0.063
        proximal_2 [m]: a finite number > 0; default 0.063
        distal_1 [m]: a finite number > 0; default 0.075
        distal_2 [m]: a finite number > 0; default 0.075
        assembly: left, right; default 'left'
        proximal_mass [kg]: a finite number > 0; default 0.05
        distal_mass [kg]: a finite number >= 0; default 0.05
        handle_mass [kg]: a finite number >= 0; default 0.1
        rotor_inertia [kg m^2]: a finite number >= 0; default [5e-05, 5e-05, 5e-05, 5e-05]
        gravity [m/s^2]: a finite number; default [0.0, 0.0]
    """
    def __init__(self, base_distance: float = ..., proximal_1: float = ..., proximal_2: float = ..., distal_1: float = ..., distal_2: float = ..., assembly: Literal["left", "right"] = ..., proximal_mass: float = ..., distal_mass: float = ..., handle_mass: float = ..., rotor_inertia: Numbers = ..., gravity: Numbers = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def brakes(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> brakes_4:
        """The brakes of this device.

        Parameters:
            torque_limit [N m]: a finite number >= 0; default [1.0, 1.0, 1.0, 1.0]
            rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02, 0.02, 0.02]
            torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09, 1e-09, 1e-09]
            time_constant [s]: a finite number >= 0; default [0.02, 0.02, 0.02, 0.02]
            torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf, -inf, -inf]
            torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf, inf, inf]
        """
    def inverse(self, x: Numbers) -> tuple[Array, status]:
        """Base angles that put the handle at x [m], elbows outward, and whether it is in reach."""
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class brakes_3(brake_parameters):
    """The brakes of a device with 3 of them. torque_lower = torque_upper = 0: the brake is off. One of them 0: it works one way.

    Parameters:
        torque_limit [N m]: a finite number >= 0; default [1.0, 1.0, 1.0]
        rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02, 0.02]
        torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09, 1e-09]
        time_constant [s]: a finite number >= 0; default [0.02, 0.02, 0.02]
        torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf, -inf]
        torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf, inf]
    """
    def __init__(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class delta(mechanism):
    """Three arms that move a platform in space without turning it.

    It has 3 joints, 3 brakes and 3 task dimensions.

    Parameters:
        base_radius [m]: a finite number >= 0; default 0.05
        platform_radius [m]: a finite number >= 0; default 0.02
        upper_arm [m]: a finite number > 0; default 0.07
        forearm [m]: a finite number > 0; default 0.13
        assembly: lower, upper; default 'lower'
        upper_arm_mass [kg]: a finite number > 0; default 0.05
        forearm_mass [kg]: a finite number >= 0; default 0.03
        platform_mass [kg]: a finite number >= 0; default 0.1
        rotor_inertia [kg m^2]: a finite number >= 0; default [5e-05, 5e-05, 5e-05]
        gravity [m/s^2]: a finite number; default [0.0, 0.0, 0.0]
    """
    def __init__(self, base_radius: float = ..., platform_radius: float = ..., upper_arm: float = ..., forearm: float = ..., assembly: Literal["lower", "upper"] = ..., upper_arm_mass: float = ..., forearm_mass: float = ..., platform_mass: float = ..., rotor_inertia: Numbers = ..., gravity: Numbers = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def brakes(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> brakes_3:
        """The brakes of this device.

        Parameters:
            torque_limit [N m]: a finite number >= 0; default [1.0, 1.0, 1.0]
            rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02, 0.02]
            torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09, 1e-09]
            time_constant [s]: a finite number >= 0; default [0.02, 0.02, 0.02]
            torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf, -inf]
            torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf, inf]
        """
    def inverse(self, x: Numbers) -> tuple[Array, status]:
        """Base angles that put the platform at x [m], elbows outward, and whether it is in reach."""
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class planar_chain_3(mechanism):
    """A serial chain of 3 joints in the plane, a brake on each.

    It has 3 joints, 3 brakes and 2 task dimensions.

    Parameters:
        joints: anything, a list of 3 dicts
            kind: revolute, prismatic; default 'revolute'
            axis [1]: anything; default [0.0, 0.0]
            point [m]: anything; default [0.0, 0.0]
        handle [m]: a finite number; no default
    """
    def __init__(self, joints: Sequence[Mapping[str, object]] = ..., handle: Numbers = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def brakes(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> brakes_3:
        """The brakes of this device.

        Parameters:
            torque_limit [N m]: a finite number >= 0; default [1.0, 1.0, 1.0]
            rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02, 0.02]
            torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09, 1e-09]
            time_constant [s]: a finite number >= 0; default [0.02, 0.02, 0.02]
            torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf, -inf]
            torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf, inf]
        """
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class planar_chain_3_with_inertia(mechanism):
    """A serial chain of 3 joints in the plane, a brake on each, with inertia.

    It has 3 joints, 3 brakes and 2 task dimensions.

    Parameters:
        geometry: a dict
            joints: anything, a list of 3 dicts
                kind: revolute, prismatic; default 'revolute'
                axis [1]: anything; default [0.0, 0.0]
                point [m]: anything; default [0.0, 0.0]
            handle [m]: a finite number; no default
        inertia: a dict
            links: anything, a list of 3 dicts
                mass [kg]: a finite number > 0; no default
                centre [m]: a finite number; default [0.0, 0.0]
                about_centre [kg m^2]: anything; default [0.0]
            rotor_inertia [kg m^2 or kg]: a finite number >= 0; default [5e-05, 5e-05, 5e-05]
            handle_mass [kg]: a finite number >= 0; default 0.1
            gravity [m/s^2]: a finite number; default [0.0, 0.0]
    """
    def __init__(self, geometry: Mapping[str, object] = ..., inertia: Mapping[str, object] = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def brakes(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> brakes_3:
        """The brakes of this device.

        Parameters:
            torque_limit [N m]: a finite number >= 0; default [1.0, 1.0, 1.0]
            rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02, 0.02]
            torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09, 1e-09]
            time_constant [s]: a finite number >= 0; default [0.02, 0.02, 0.02]
            torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf, -inf]
            torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf, inf]
        """
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class planar_chain_4(mechanism):
    """A serial chain of 4 joints in the plane, a brake on each.

    It has 4 joints, 4 brakes and 2 task dimensions.

    Parameters:
        joints: anything, a list of 4 dicts
            kind: revolute, prismatic; default 'revolute'
            axis [1]: anything; default [0.0, 0.0]
            point [m]: anything; default [0.0, 0.0]
        handle [m]: a finite number; no default
    """
    def __init__(self, joints: Sequence[Mapping[str, object]] = ..., handle: Numbers = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def brakes(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> brakes_4:
        """The brakes of this device.

        Parameters:
            torque_limit [N m]: a finite number >= 0; default [1.0, 1.0, 1.0, 1.0]
            rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02, 0.02, 0.02]
            torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09, 1e-09, 1e-09]
            time_constant [s]: a finite number >= 0; default [0.02, 0.02, 0.02, 0.02]
            torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf, -inf, -inf]
            torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf, inf, inf]
        """
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class planar_chain_4_with_inertia(mechanism):
    """A serial chain of 4 joints in the plane, a brake on each, with inertia.

    It has 4 joints, 4 brakes and 2 task dimensions.

    Parameters:
        geometry: a dict
            joints: anything, a list of 4 dicts
                kind: revolute, prismatic; default 'revolute'
                axis [1]: anything; default [0.0, 0.0]
                point [m]: anything; default [0.0, 0.0]
            handle [m]: a finite number; no default
        inertia: a dict
            links: anything, a list of 4 dicts
                mass [kg]: a finite number > 0; no default
                centre [m]: a finite number; default [0.0, 0.0]
                about_centre [kg m^2]: anything; default [0.0]
            rotor_inertia [kg m^2 or kg]: a finite number >= 0; default [5e-05, 5e-05, 5e-05, 5e-05]
            handle_mass [kg]: a finite number >= 0; default 0.1
            gravity [m/s^2]: a finite number; default [0.0, 0.0]
    """
    def __init__(self, geometry: Mapping[str, object] = ..., inertia: Mapping[str, object] = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def brakes(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> brakes_4:
        """The brakes of this device.

        Parameters:
            torque_limit [N m]: a finite number >= 0; default [1.0, 1.0, 1.0, 1.0]
            rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02, 0.02, 0.02]
            torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09, 1e-09, 1e-09]
            time_constant [s]: a finite number >= 0; default [0.02, 0.02, 0.02, 0.02]
            torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf, -inf, -inf]
            torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf, inf, inf]
        """
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class spatial_chain_3(mechanism):
    """A serial chain of 3 joints in space, a brake on each.

    It has 3 joints, 3 brakes and 3 task dimensions.

    Parameters:
        joints: anything, a list of 3 dicts
            kind: revolute, prismatic; default 'revolute'
            axis [1]: anything; default [0.0, 0.0, 0.0]
            point [m]: anything; default [0.0, 0.0, 0.0]
        handle [m]: a finite number; no default
    """
    def __init__(self, joints: Sequence[Mapping[str, object]] = ..., handle: Numbers = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def brakes(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> brakes_3:
        """The brakes of this device.

        Parameters:
            torque_limit [N m]: a finite number >= 0; default [1.0, 1.0, 1.0]
            rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02, 0.02]
            torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09, 1e-09]
            time_constant [s]: a finite number >= 0; default [0.02, 0.02, 0.02]
            torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf, -inf]
            torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf, inf]
        """
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class spatial_chain_3_with_inertia(mechanism):
    """A serial chain of 3 joints in space, a brake on each, with inertia.

    It has 3 joints, 3 brakes and 3 task dimensions.

    Parameters:
        geometry: a dict
            joints: anything, a list of 3 dicts
                kind: revolute, prismatic; default 'revolute'
                axis [1]: anything; default [0.0, 0.0, 0.0]
                point [m]: anything; default [0.0, 0.0, 0.0]
            handle [m]: a finite number; no default
        inertia: a dict
            links: anything, a list of 3 dicts
                mass [kg]: a finite number > 0; no default
                centre [m]: a finite number; default [0.0, 0.0, 0.0]
                about_centre [kg m^2]: anything; default [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]
            rotor_inertia [kg m^2 or kg]: a finite number >= 0; default [5e-05, 5e-05, 5e-05]
            handle_mass [kg]: a finite number >= 0; default 0.1
            gravity [m/s^2]: a finite number; default [0.0, 0.0, 0.0]
    """
    def __init__(self, geometry: Mapping[str, object] = ..., inertia: Mapping[str, object] = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def brakes(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> brakes_3:
        """The brakes of this device.

        Parameters:
            torque_limit [N m]: a finite number >= 0; default [1.0, 1.0, 1.0]
            rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02, 0.02]
            torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09, 1e-09]
            time_constant [s]: a finite number >= 0; default [0.02, 0.02, 0.02]
            torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf, -inf]
            torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf, inf]
        """
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class brakes_6(brake_parameters):
    """The brakes of a device with 6 of them. torque_lower = torque_upper = 0: the brake is off. One of them 0: it works one way.

    Parameters:
        torque_limit [N m]: a finite number >= 0; default [1.0, 1.0, 1.0, 1.0, 1.0, 1.0]
        rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02, 0.02, 0.02, 0.02, 0.02]
        torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09]
        time_constant [s]: a finite number >= 0; default [0.02, 0.02, 0.02, 0.02, 0.02, 0.02]
        torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf, -inf, -inf, -inf, -inf]
        torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf, inf, inf, inf, inf]
    """
    def __init__(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class spatial_chain_6(mechanism):
    """A serial chain of 6 joints in space, a brake on each.

    It has 6 joints, 6 brakes and 3 task dimensions.

    Parameters:
        joints: anything, a list of 6 dicts
            kind: revolute, prismatic; default 'revolute'
            axis [1]: anything; default [0.0, 0.0, 0.0]
            point [m]: anything; default [0.0, 0.0, 0.0]
        handle [m]: a finite number; no default
    """
    def __init__(self, joints: Sequence[Mapping[str, object]] = ..., handle: Numbers = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def brakes(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> brakes_6:
        """The brakes of this device.

        Parameters:
            torque_limit [N m]: a finite number >= 0; default [1.0, 1.0, 1.0, 1.0, 1.0, 1.0]
            rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02, 0.02, 0.02, 0.02, 0.02]
            torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09]
            time_constant [s]: a finite number >= 0; default [0.02, 0.02, 0.02, 0.02, 0.02, 0.02]
            torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf, -inf, -inf, -inf, -inf]
            torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf, inf, inf, inf, inf]
        """
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class brakes_7(brake_parameters):
    """The brakes of a device with 7 of them. torque_lower = torque_upper = 0: the brake is off. One of them 0: it works one way.

    Parameters:
        torque_limit [N m]: a finite number >= 0; default [1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0]
        rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02]
        torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09]
        time_constant [s]: a finite number >= 0; default [0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02]
        torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf, -inf, -inf, -inf, -inf, -inf]
        torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf, inf, inf, inf, inf, inf]
    """
    def __init__(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
class spatial_chain_7(mechanism):
    """A serial chain of 7 joints in space, a brake on each.

    It has 7 joints, 7 brakes and 3 task dimensions.

    Parameters:
        joints: anything, a list of 7 dicts
            kind: revolute, prismatic; default 'revolute'
            axis [1]: anything; default [0.0, 0.0, 0.0]
            point [m]: anything; default [0.0, 0.0, 0.0]
        handle [m]: a finite number; no default
    """
    def __init__(self, joints: Sequence[Mapping[str, object]] = ..., handle: Numbers = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def brakes(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> brakes_7:
        """The brakes of this device.

        Parameters:
            torque_limit [N m]: a finite number >= 0; default [1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0]
            rate_dead_band [rad/s]: a finite number >= 0; default [0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02]
            torque_dead_band [N m]: a finite number >= 0; default [1e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09]
            time_constant [s]: a finite number >= 0; default [0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02]
            torque_lower [N m]: a number <= 0, or -inf where there is no bound; default [-inf, -inf, -inf, -inf, -inf, -inf, -inf]
            torque_upper [N m]: a number >= 0, or inf where there is no bound; default [inf, inf, inf, inf, inf, inf, inf]
        """
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
def _read_log(path: bytes, name: str) -> tuple[list[str], list[str], list[Any]]:
    """Names, units and columns of a log, arrays of numbers or lists of words. name: of the file, in errors."""
def _log_text(names: list[str], units: list[str], values: list[Any], with_header: bool) -> bytes:
    """The lines of a log."""
def _check_log(path: bytes, name: str, names: list[str], units: list[str], values: list[Any]) -> None:
    """Throws ValueError if a log is not the one that was to be written."""
def _unit_of_column(name: str) -> str | None:
    """The unit of a column of the library's logs, empty of words, or None."""
def _is_along_axes(name: str) -> bool:
    """Whether the parts of these columns are _x, _y and _z."""
class python_mechanism(mechanism):
    """A mechanism whose functions are written in Python, a brake on each of its joints. It does all that a compiled one does, slower: each call of a function takes microseconds.

    dof and task_dimension: 2 and 2, 3 and 2, 4 and 2, 3 and 3, 6 and 3, or 7 and 3. position(q) returns the end effector [m], base frame, of joint positions q [rad or m], an array of dof numbers. jacobian(q) returns J in v = J qd, task_dimension x dof [m/rad or 1]; without it J is found by central differences, to about ten digits. With inertia, up to 4 joints: mass_matrix(q) returns M, dof x dof [kg m^2, kg m or kg], bias_torque(q, qd) returns c in M qdd + c [N m or N], bias_acceleration(q, qd) returns Jd qd [m/s^2]; all three or none. At the first q, the functions are compared with each other; a jacobian that is not the derivative of position (1e-4), a mass matrix that is not symmetric and positive definite, or a torque or acceleration that is not finite is a ValueError with the entry; check=False turns this off. An exception of a function comes out of the call as it is. NaN ends a cycle with status.state_not_finite or another status. The mechanism pickles if its functions do. Equal mechanisms have equal functions.
    """
    def __init__(self, dof: int, task_dimension: int, position: Callable[[Array], Numbers], jacobian: Callable[[Array], Rows] | None = ..., mass_matrix: Callable[[Array], Rows] | None = ..., bias_torque: Callable[[Array, Array], Numbers] | None = ..., bias_acceleration: Callable[[Array, Array], Numbers] | None = ..., check: bool = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    __hash__: None  # type: ignore[assignment]
    def brakes(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers = ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> brake_parameters:
        """The brakes of this device: torque_limit [N m], rate_dead_band [rad/s], torque_dead_band [N m], time_constant [s], torque_lower and torque_upper [N m], a number for each joint."""
    @property
    def parameters(self) -> dict[str, Any]:
        """A copy of all parameters, by their names."""
