"""What a Python user may get wrong: each ends in an exception that names the value and what was expected."""

import numpy as np
import pytest

import passive_haptics as ph

nan, inf = float("nan"), float("inf")
arm = ph.tendon_two_link()
table = ph.xy_table()
shape = ph.half_space([0, 0.2], [0, -1])
wall = ph.wall(shape)
scene = ph.scene(wall)
control = ph.controller(arm, arm.brakes(), scene, ph.direct_control())
relay = ph.controller(arm, arm.brakes(), scene, ph.on_off_control())
rows = np.zeros((10, 2))
ones = np.zeros(10)
results = control.batch(rows, rows, rows)
read_only = control.batch(rows, rows, rows)
read_only.alpha.flags.writeable = False
narrow, lists = (control.batch(rows, rows, rows) for _ in range(2))
narrow.alpha, lists.alpha = np.zeros(10, "f4"), [0.0] * 10
state = ph.device_state(0, [0.5, 0.5], [0, 0], [0, 0])
legs = ph.five_bar_with_four_brakes()
chain = ph.planar_arm([0.1, 0.1, 0.1])
simulated = ph.simulated_device(arm, arm.brakes(), 0.5, [0.7, 0.8])
hand = ph.following_hand([1, 0], simulated.position)
rough = ph.rough_walls()
corners = np.array([[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]])
faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


class subclass(np.ndarray):
    pass


class liar:
    """Says that it is long, and has nothing."""

    def __len__(self):
        return 2

    def __getitem__(self, i):
        raise RuntimeError("nothing here")


MISUSES = [
    # Parameters
    (lambda: ph.tendon_two_link(lenght_1=0.2), TypeError, "has no parameter 'lenght_1': expected length_1, "),
    (lambda: ph.tendon_two_link(reduction_2=nan), ValueError, "reduction_2 [1] = nan: expected a finite number > 0"),
    (lambda: ph.tendon_two_link(reduction_2="0.4"), TypeError, "reduction_2 = '0.4' (str): expected a number"),
    (lambda: ph.tendon_two_link(reduction_2=True), TypeError, "reduction_2 = True (bool): expected a number"),
    (lambda: ph.tendon_two_link(reduction_2=1j), TypeError, "reduction_2 = 1j (complex): expected a number"),
    (lambda: ph.tendon_two_link(reduction_2=np.bool_(1)), TypeError, "(numpy.bool_): expected a number"),
    (lambda: ph.tendon_two_link(reduction_2=10**400), ValueError, "expected a number that a double can hold"),
    (lambda: ph.tendon_two_link(reduction2=0.4), TypeError, "; did you mean reduction_2?"),
    (lambda: ph.five_bar(assembly="up"), ValueError, "assembly = 'up' (str): expected 'left' or 'right'"),
    (lambda: ph.five_bar(assembly=1), TypeError, "assembly = 1 (int): expected 'left' or 'right'"),
    (lambda: ph.serial_chain([{}] * 5, [0, 1]), ValueError, "5 joints and a handle of 2 numbers: expected 2, 3 or 4 joints"),
    (lambda: ph.serial_chain("abc", [0, 1]), TypeError, "joints = 'abc' (str): expected a list of dicts"),
    (lambda: ph.serial_chain([{"kind": "ball"}] * 3, [0, 1]), ValueError, "joints[0].kind = 'ball'"),
    (lambda: ph.serial_chain([{"pont": [0, 1]}] * 3, [0, 1]), TypeError, "joints[0] has no parameter 'pont': expected kind, axis, "),
    (lambda: arm.brakes(torque_limit=[1, 1, 1]), ValueError, "length of torque_limit = 3: expected 2"),
    (lambda: arm.brakes(torque_limit=[1, None]), TypeError, "torque_limit[1] = None (NoneType): expected a number"),
    (lambda: arm.brakes(torque_limit=["1", 1]), TypeError, "torque_limit[0] = '1' (str): expected a number"),
    (lambda: arm.brakes(torque_limit=np.array(["1", "2"])), TypeError, "torque_limit has dtype <U1"),
    (lambda: arm.brakes(torque_limit=np.array([1, 2], dtype=object)), TypeError, "torque_limit has dtype object"),
    (lambda: arm.brakes(torque_limit=np.array([True, False])), TypeError, "torque_limit has dtype bool"),
    (lambda: arm.brakes(torque_limit=np.ones((1, 2))), ValueError, "shape of torque_limit = (1, 2): expected 1 axis"),
    (lambda: arm.brakes(torque_limit=np.ma.ones(2)), TypeError, "expected a numpy.ndarray"),
    (lambda: ph.brakes(1, count=10**8), ValueError, "count = 100000000: expected 1 to 8"),
    (lambda: ph.brakes([]), ValueError, "count = 0: expected 1 to 8"),
    (lambda: ph.brakes(1, count="2"), TypeError, "count = '2' (str): expected a whole number"),
    (lambda: ph.planar_arm(0.3), TypeError, "lengths = 0.3 (float): expected a list or an array of numbers"),
    (lambda: ph.wall_following_parameters(noise_seed=np.float32(2.5)), TypeError, "noise_seed = 2.5 (numpy.float32): expected a whole"),
    (lambda: setattr(arm, "length_1", 0.3), AttributeError,
     "a tendon_two_link does not change: expected a new one, tendon_two_link(..., length_1=0.3)"),
    (lambda: arm.length_1, AttributeError, "a tendon_two_link has no length_1: expected parameters['length_1']"),
    # Shapes, walls and scenes
    (lambda: ph.half_space(), TypeError, "half_space needs a vector of 2 or 3 numbers among surface_point, normal"),
    (lambda: ph.half_space([0, 0], [0, 0]), ValueError, "|normal| of a half_space = 0: expected a direction"),
    (lambda: ph.half_space([0, 0], [0, 0, 1]), ValueError, "length of normal = 3: expected 2"),
    (lambda: ph.half_space([0, 0, 0, 0], [0, 1]), ValueError, "length of surface_point of half_space = 4: expected 2"),
    (lambda: ph.ball(0.1, [0, 0]), TypeError, "expected"),
    (lambda: ph.offset(3, 0.1), TypeError, "shape = 3 (int): expected a shape"),
    (lambda: ph.wall(1e5, shape), TypeError, "a wall is made of (shape, stiffness)"),
    (lambda: ph.wall(shape, -1), ValueError, "stiffness of a wall [N/m] = -1: expected a finite number >= 0"),
    (lambda: ph.wall(shape, stifness=1), TypeError, "wall has no parameter 'stifness': expected shape, stiffness"),
    (lambda: ph.scene(), TypeError, "a scene needs a wall"),
    (lambda: ph.scene(shape), TypeError, "expected a wall: put each shape into one, wall(shape)"),
    (lambda: ph.scene([wall]), TypeError, "wall 0 of a scene = [wall("),
    (lambda: ph.scene(wall, ph.wall(ph.ball([0, 0, 0], 1))), ValueError, "wall 1 of a scene has dimension 3: expected 2"),
    (lambda: shape.distance([0, 0, 0]), ValueError, "length of x = 3: expected 2"),
    # Meshes, worlds and held scenes
    (lambda: ph.mesh(corners.astype(object), faces), TypeError, "vertices has dtype object: expected real numbers: vertices.astype(fl"),
    (lambda: ph.mesh(corners, faces + 0.5), ValueError, "facet 0 of a mesh: index of a vertex = 0.5: expected a whole number"),
    (lambda: ph.mesh(corners, faces > 0), TypeError, "facets has dtype bool: expected real numbers"),
    (lambda: ph.mesh(corners.ravel(), faces), ValueError, "shape of vertices = (12,): expected 2 axes"),
    (lambda: ph.mesh(np.zeros((4, 4)), faces), ValueError, "shape of vertices = (4, 4): expected (N, 2) or (N, 3)"),
    (lambda: ph.mesh(corners, faces[:, :2]), ValueError, "shape of facets = (4, 2): expected (M, 3), the three corners"),
    (lambda: ph.mesh(corners[:, :2].copy(), faces), ValueError, "shape of facets = (4, 3): expected (M, 2), the two ends"),
    (lambda: ph.mesh(corners, faces + 2), ValueError, "facet 0 of a mesh: index of a vertex = 4.0: expected a whole number"),
    (lambda: ph.mesh(None, faces), TypeError, "vertices = None (NoneType): expected a list or an array"),
    (lambda: ph.mesh([[0, 0], [1]], [[0, 1]]), ValueError, "vertices = [[0, 0], [1]] (list): expected rows of equal length"),
    (lambda: ph.mesh([["a", "b"]], [[0, 1]]), TypeError, "vertices has dtype <U1: expected real numbers"),
    (lambda: ph.mesh([liar()], faces), ValueError, "vertices = [<"),
    (lambda: ph.mesh(np.ma.array(corners), faces), TypeError, "expected a numpy.ndarray"),
    (lambda: ph.mesh_solid(corners), TypeError, "expected a mesh: mesh(vertices, facets)"),
    (lambda: ph.read_stl(__file__), ValueError, "test_misuse.py: "),
    (lambda: ph.read_obj(__file__), ValueError, "test_misuse.py: "),
    (lambda: ph.read_ply(__file__), ValueError, "test_misuse.py: "),
    (lambda: ph.read_stl(__file__, 0), ValueError, "metres_per_unit = 0: expected a finite number > 0"),
    (lambda: ph.read_stl(__file__, "mm"), TypeError, "metres_per_unit = 'mm' (str): expected a number"),
    (lambda: ph.mesh(corners, faces).plausibility(-1), ValueError, "reach [m] = -1: expected"),
    (lambda: ph.offset(ph.mesh_surface(ph.mesh(corners, faces)), 0.1), TypeError, "shape = mesh_surface(surface=mesh([["),
    (lambda: ph.world([]), TypeError, "a world needs a wall, wall(shape, stiffness)"),
    (lambda: ph.world([wall, shape]), TypeError, "wall 1 of a world = half_space("),
    (lambda: ph.world([wall, ph.wall(ph.ball([0, 0, 0], 1))]), ValueError, "wall 1 of a world has dimension 3: expected 2"),
    (lambda: ph.held_scene(wall, 0.05), TypeError, "expected a scene: held_scene(scene(wall(shape, stiffness)), period)"),
    (lambda: ph.held_scene(scene, -1), ValueError, "period of a held_scene [s] = -1: expected"),
    (lambda: ph.held_scene(scene, "1"), TypeError, "period = '1' (str): expected a number"),
    # Effects
    (lambda: ph.viscous_field(), TypeError, "viscous_field needs a vector of 2 or 3 numbers among viscosity"),
    (lambda: ph.viscous_field(3), TypeError, "viscous_field needs a vector of 2 or 3 numbers among viscosity"),
    (lambda: ph.viscous_field([[1, 0], [0, 1, 2]]), ValueError, "viscosity = [[1, 0], [0, 1, 2]] (list): expected rows of equal length"),
    (lambda: ph.viscous_field([1, 0, 0, 0]), ValueError, "length of viscosity of viscous_field = 4: expected 2 or 3"),
    (lambda: ph.guide("circle", [0, 0], [1, 0]), ValueError, "along = 'circle' (str): expected 'line' or 'plane'"),
    (lambda: ph.with_effects(scene), TypeError, "with_effects needs an effect"),
    (lambda: ph.with_effects(wall, rough), TypeError, "expected a scene: with_effects(scene(wall("),
    (lambda: ph.with_effects(scene, rough, wall), TypeError, "effect 1 of a scene = wall("),
    (lambda: ph.with_effects(ph.with_effects(scene, rough), rough), TypeError, "scene has effects: expected one without: "),
    (lambda: ph.held_scene(ph.with_effects(scene, rough), 0.1), TypeError, "with_effects(held_scene(...), effect, ...)"),
    (lambda: ph.controller(arm, arm.brakes(), ph.with_effects(scene, rough), ph.no_direct_control()), ValueError,
     "scene with effects: expected one without: they need direct_control, and "),
    (lambda: ph.controller(legs, legs.brakes(), ph.with_effects(scene, rough), ph.direct_control()), ValueError,
     "scene with effects: expected one without: they need direct_control, and "),
    (lambda: ph.controller(arm, arm.brakes(), ph.with_effects(scene, ph.detents([0] * 3, [1] * 3, 0.1)), ph.direct_control()),
     ValueError, "effect 0 of the scene has vectors of 3 numbers: expected 2, as its walls"),
    # Controllers
    (lambda: ph.controller(arm, scene, arm.brakes(), ph.direct_control()), TypeError, "brakes = scene(wall(shape=half_space(surface_poin... (scene): expected w"),
    (lambda: ph.controller("arm", arm.brakes(), scene, ph.direct_control()), TypeError, "mechanism = 'arm' (str)"),
    (lambda: ph.controller(arm, ph.delta().brakes(), scene, ph.direct_control()), TypeError, "for its number of brakes"),
    (lambda: ph.controller(arm, arm.brakes(), scene, "direct_control"), TypeError, "expected a law such as"),
    (lambda: ph.controller(ph.delta(), ph.delta().brakes(), scene, ph.direct_control()), ValueError,
     "scene has dimension 2: expected 3"),
    (lambda: ph.controller(arm, arm.brakes(), scene, ph.direct_control(), max_approximation_angle=2), ValueError,
     "max_approximation_angle [rad] = 2: expected an angle > 0 and <= pi/2"),
    (lambda: ph.controller(arm, arm.brakes(), scene, ph.direct_control(), limits="none"), ValueError, "limits = 'none'"),
    # States
    (lambda: control(3), TypeError, "state = 3 (int): expected a device_state"),
    (lambda: control(None), TypeError, "state = None (NoneType): expected a device_state"),
    (lambda: ph.device_state(None, [0, 0], [0, 0]), TypeError, "time = None (NoneType): expected a number"),
    (lambda: ph.device_state(0, "ab", [0, 0]), TypeError, "q = 'ab' (str): expected a list or an array"),
    (lambda: control(ph.device_state(0, [0], [0, 0], [0, 0])), ValueError, "length of q = 1: expected 2"),
    (lambda: control(ph.device_state(0, [0, 0], [0, 0], [0, 0, 0])), ValueError, "length of hand_force = 3: expected 2"),
    (lambda: control(ph.device_state(0, [0, 0], [0, 0])), ValueError, "hand_force = None: expected a force"),
    (lambda: arm.position([1, 2, 3]), ValueError, "length of q = 3: expected 2"),
    (lambda: arm.passive_fme([1, 2], 0), ValueError, "segments of a passive_fme_outline = 0: expected 1 "),
    (lambda: arm.inverse([0.1, 0.1], "up"), ValueError, "branch = 'up': expected 'left' or 'right'"),
    # Design and simulation
    (lambda: arm.nearest_force([1, 1], [1, 0.5], [0, 1]), ValueError, "signs = [1, 0.5] (list): expected -1, 0 or 1 for each brake"),
    (lambda: arm.nearest_force([1, 1], [nan, 1], [0, 1]), ValueError, "signs = [nan, 1] (list): expected -1, 0 or 1"),
    (lambda: arm.passive_fme([1, 2], 2.5), TypeError, "segments = 2.5 (float): expected a whole number"),
    (lambda: arm.sink_depth(rows, [1, 0], [0, 1], push="2"), TypeError, "push = '2' (str): expected a number"),
    (lambda: hand.force(None, [0, 0], [0, 0], [0, 1], 0), TypeError, "time = None (NoneType): expected a number"),
    (lambda: ph.simulated_device(arm, arm.brakes(), 0.5, "ab"), TypeError, "q = 'ab' (str): expected a list or an array of numbers"),
    (lambda: legs.reference_forces([2, 1]), TypeError, "reference_forces needs as many brakes and joints as task dim"),
    (lambda: legs.passive_fme([2, 1]), TypeError, "passive_fme needs two brakes on two joints in the plane"),
    (lambda: ph.simulated_device(chain, chain.brakes(), 1, [0, 0, 0]), TypeError, "needs a mechanism with inertia"),
    (lambda: arm.sink_depth(rows[:1], [1, 0], [0, 1]), ValueError, "samples of a sink_depth = 1: expected 2 or more"),
    (lambda: arm.design_map(rows, [1, 0, 0], [0, 1]), ValueError, "length of direction = 3: expected 2"),
    (lambda: arm.design_map(rows, [1, 0], rows[:3]), ValueError, "number of rows of normal = 3: expected 10, as q has"),
    (lambda: arm.design_map(rows, [1, 0], [0, 1], scene), TypeError, "expected what brakes() of the mechanism returns"),
    (lambda: ph.simulated_device(arm, [ph.coulomb_brake()], 1, [0, 0]), ValueError, "number of brakes = 1: expected 2"),
    (lambda: ph.simulated_device(arm, [1, 2], 1, [0, 0]), TypeError, "brakes[0] = 1 (int): expected a brake model"),
    (lambda: ph.simulated_device(arm, arm.brakes(), -1, [0, 0]), ValueError, "hand_mass [kg] = -1"),
    (lambda: ph.following_hand([0, 0], [0, 0]), ValueError, "expected a direction of finite length > 0"),
    (lambda: ph.following_hand([1, 0], [0, 0, 0]), ValueError, "number of components of the start = 3: expected 2"),
    (lambda: simulated.advance(1e-4, [1], [0, 0]), ValueError, "length of capacity = 1: expected 2"),
    (lambda: ph.follow_wall(arm, control, shape, hand), TypeError, "expected a simulated_device"),
    (lambda: ph.follow_wall(simulated, arm, shape, hand), TypeError, "expected a controller"),
    (lambda: ph.follow_wall(simulated, control, wall, hand), TypeError, "expected a shape"),
    (lambda: ph.follow_wall(simulated, control, ph.ball([0, 0, 0], 1), hand), ValueError, "dimension of the shape = 3: expected 2, that of the device"),
    (lambda: ph.follow_wall(simulated, control, shape, hand, ph.wall_following_parameters(watched_brake=2)), ValueError,
     "watched_brake = 2: expected a brake of the device"),
    # Batches
    (lambda: control.batch([[0, 0]], rows, rows), ValueError, "shape of qd = (10, 2): expected (1, 2)"),
    (lambda: control.batch(None, rows, rows), TypeError, "q = None (NoneType): expected a list or an array of numbers"),
    (lambda: control.batch([[1, 2], [3]], rows, rows), ValueError, "q = [[1, 2], [3]] (list): expected rows of equal length"),
    (lambda: control.batch(rows.astype(complex), rows, rows), TypeError, "q has dtype complex128: expected real numbers: q.astype(float)"),
    (lambda: control.batch(rows.astype(object), rows, rows), TypeError, "q has dtype object: expected real numbers: q.astype(float)"),
    (lambda: control.batch(np.ma.array(rows), rows, rows), TypeError, "q is a MaskedArray: expected a numpy.ndarray"),
    (lambda: control.batch(rows.view(np.matrix), rows, rows), TypeError, "q is a matrix: expected a numpy.ndarray"),
    (lambda: control.batch(rows.view(subclass), rows, rows), TypeError, "q is a subclass"),
    (lambda: control.batch(rows[0], rows, rows), ValueError, "shape of q = (2,): expected 2 axes"),
    (lambda: control.batch(np.zeros((10, 3)), rows, rows), ValueError, "shape of q = (10, 3): expected (N, 2)"),
    (lambda: control.batch(rows.T, rows, rows), ValueError, "shape of q = (2, 10): expected (N, 2)"),
    (lambda: control.batch(rows, rows[:9], rows), ValueError, "shape of qd = (9, 2): expected (10, 2)"),
    (lambda: control.batch(rows, rows, rows[:9]), ValueError, "shape of hand_force = (9, 2): expected (10, 2)"),
    (lambda: control.batch(rows, rows, rows, ones[:9]), ValueError, "length of time = 9: expected 10"),
    (lambda: control.batch(rows, rows, rows, 0.0), TypeError, "time = 0.0 (float): expected a list or an array of numbers"),
    (lambda: control.batch(rows, rows, rows, rows), ValueError, "shape of time = (10, 2): expected 1 axis"),
    (lambda: control.batch(rows, rows), ValueError, "the law needs a hand force"),
    (lambda: control.batch(rows, rows, rows, fields=["force"]), ValueError, "fields has 'force': expected names among capacity, torque, outcome, powe"),
    (lambda: control.batch(rows, rows, rows, fields=[1]), ValueError, "fields has 1: expected names among capacity, torque, outcome, power, dis"),
    (lambda: control.batch(rows, rows, rows, out=rows), TypeError, "expected what batch() returned"),
    (lambda: control.batch(rows[:5], rows[:5], rows[:5], out=results), ValueError, "of shape (10, 2), writable: expected an array of float64 of shape (5, 2)"),
    (lambda: control.batch(rows, rows, rows, out=read_only), ValueError, "out.alpha = float64 of shape (10,), read-only"),
    (lambda: control.batch(rows, rows, rows, out=narrow), ValueError, "float32 of shape (10,), writable: expected an array of float64 of shape (10,), writable"),
    (lambda: control.batch(rows, rows, rows, out=lists), ValueError, "out.alpha = [0.0, 0.0, "),
    (lambda: control.batch(rows, rows, results.desired_force, out=results), ValueError,
     "hand_force shares memory with out.desired_force"),
]  # fmt: skip


@pytest.mark.parametrize("number", range(len(MISUSES)))
def test_misuse(number):
    call, kind, text = MISUSES[number]
    with pytest.raises(kind) as caught:
        call()
    assert text in str(caught.value)
    if text:
        assert str(caught.value).startswith("passive_haptics: ")


@pytest.mark.parametrize("read", [ph.read_stl, ph.read_log, ph.load])
def test_files_that_cannot_be_read(read, tmp_path):
    for path, error in (("no such file", FileNotFoundError), (tmp_path, IsADirectoryError), ("a\0b", ValueError), ([], TypeError)):
        with pytest.raises(error):
            read(path)


def test_what_is_no_misuse():
    """Arrays of any strides, also read-only ones; numbers of NumPy; no states at all."""
    random = np.random.default_rng(7)
    big = random.uniform(-1, 1, (3, 40, 4))
    q, qd, force = big[0, ::-2, 1:3], big[1, ::-2, 3:1:-1], big[2, 39::-2, ::3]
    for x in (q, qd, force):
        x.flags.writeable = False
    expected = control.batch(*(np.array(x) for x in (q, qd, force)))
    assert control.batch(q, qd, force) == expected
    assert control.batch(*(np.asfortranarray(x) for x in (q, qd, force))) == expected
    unaligned = np.frombuffer(b"x" + np.ascontiguousarray(q).tobytes(), dtype=np.uint8)[1:].view("f8").reshape(q.shape)
    assert control.batch(unaligned, qd, force) == expected
    broadcast = np.broadcast_to([0.5, 0.5], (20, 2))
    assert control.batch(broadcast, broadcast, broadcast) == control.batch(*[np.array(broadcast)] * 3)
    assert len(control.batch(rows[:0], rows[:0], rows[:0])) == 0
    assert len(control.batch(rows[:1], rows[:1], rows[:1])) == 1
    assert ph.ball(np.array([0, 1], dtype="i2"), np.float32(0.5)).parameters["radius"] == 0.5
    assert relay(ph.device_state(0, (0.5, 0.5), np.zeros(2))).outcome == ph.status.ok
    assert relay.batch(rows, rows).outcome.tolist() == [0] * 10


def test_states_that_are_not_finite_are_no_misuse():
    for bad in (nan, inf, -inf):
        result = control(ph.device_state(0, [bad, 0], [0, 0], [0, 0]))
        assert result.outcome == ph.status.state_not_finite
        assert result.capacity.tolist() == [0, 0]
