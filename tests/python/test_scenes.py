"""Meshes, worlds, held scenes and effects: cycles are those of C++, bit for bit; files, arrays and what they refuse."""

import os
import pickle
import subprocess

import numpy as np
import pytest

import passive_haptics as ph
from devices import Case, middle

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
REFERENCE = os.environ.get("PASSIVE_HAPTICS_PYTHON_REFERENCE")
STATES = min(20_000, int(os.environ.get("PASSIVE_HAPTICS_PYTHON_STATES", "20000")))
SEED, PERIOD = 47, 0.02
EDGES = 70  # rows of a Case that are no motion
TETRAHEDRON = os.path.join(ROOT, "docs", "guide", "mesh_file.stl")
CORNERS = np.array([[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]])
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
SQUARE = ph.mesh(np.array([[0, 0], [0.1, 0], [0.1, 0.1], [0, 0.1]]), np.array([[0, 1], [1, 2], [2, 3], [3, 0]]))

needs_reference = pytest.mark.skipif(REFERENCE is None, reason="tests/run python names the program to compare with")


def potato(centre, d):
    """A closed surface about a centre [m]."""
    if d == 2:
        angles = 2 * np.pi * np.arange(40) / 40
        radii = 0.02 * (1 + 0.2 * np.sin(2 * angles))
        rows = centre + (radii * [np.cos(angles), np.sin(angles)]).T
        return rows, np.column_stack([np.arange(40), (np.arange(40) + 1) % 40])
    rows, facets = [], []
    rings, sectors = 9, 16
    for i in range(rings):
        for j in range(sectors):
            polar, around = np.pi * (i + 0.5) / rings, 2 * np.pi * j / sectors
            out = np.array([np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar)])
            rows.append(centre + 0.02 * (1 + 0.2 * np.sin(2 * around) * np.sin(polar)) * out)
            if i > 0:
                a, b = (i - 1) * sectors + j, (i - 1) * sectors + (j + 1) % sectors
                facets += [[a, a + sectors, b], [b, a + sectors, b + sectors]]
    top, bottom = len(rows), len(rows) + 1
    rows += [centre + [0, 0, 0.02], centre - [0, 0, 0.02]]
    last = (rings - 1) * sectors
    for j in range(sectors):
        facets += [[top, j, (j + 1) % sectors], [bottom, last + (j + 1) % sectors, last + j]]
    return np.array(rows), np.array(facets)


class Scenes(Case):
    """A Case whose states move slowly about the wall, with a potato and balls in it."""

    def __init__(self, name):
        super().__init__(name, STATES, SEED)
        n, d = self.device.dof, self.device.task_dimension
        k = np.arange(STATES)[:, None] * 20_000 / STATES  # one way, of however many states
        reach = 0.3 * np.sin(k * 1e-3 * (1 + np.arange(n) * 0.618) * 3)
        self.q[EDGES:] = (middle(name, n) + reach)[EDGES:]
        random = np.random.default_rng(SEED)
        self.rows, self.facets = potato(self.point + 0.01 * self.normal, d)
        self.centres = self.point + random.uniform(-0.08, 0.08, (60, d))
        self.radii = random.uniform(0.002, 0.01, 60)

    def write(self, path):
        super().write(path)
        balls = np.column_stack([self.centres, self.radii])
        numbers = [[len(self.rows), len(self.facets), len(balls)], self.rows.ravel(), self.facets.ravel(), balls.ravel()]
        np.concatenate(numbers).astype(float).tofile(f"{path}.shapes")

    def solid(self):
        return ph.mesh_solid(ph.mesh(self.rows, self.facets))

    def world(self):
        k = self.stiffness
        walls = [ph.wall(ph.ball(centre, radius), k) for centre, radius in zip(self.centres, self.radii)]
        walls.append(ph.wall(ph.half_space(self.point, self.normal), 2 * k))
        walls.append(ph.wall(self.solid(), k))
        beside = self.rows.copy()
        beside[:, 0] += 0.015
        walls.append(ph.wall(ph.mesh_surface(ph.mesh(beside, self.facets)), 3 * k))
        return ph.world(walls)

    def scene_of(self, mode):
        if mode == "held":
            return ph.held_scene(self.scene(), PERIOD)
        if mode == "mesh_solid":
            return ph.scene(ph.wall(self.solid(), self.stiffness))
        if mode == "effects":
            return ph.with_effects(self.scene(), *self.effects())
        if mode == "effects_in_world":
            return ph.with_effects(self.world(), *self.effects())
        return ph.held_scene(self.world(), PERIOD) if mode == "held_world" else self.world()

    def effects(self):
        d = len(self.point)
        viscosity = [[3 - i if i == j else 1 if i < j else -1 for j in range(d)] for i in range(d)]
        return (
            ph.viscous_field(viscosity),
            ph.rough_walls(0.3, 1),
            ph.guide("line", self.point, [1] * d, stiffness=200, tolerance=0.002, viscosity=1),
            ph.end_stops([0.3] * d, [0.6] * d, [5] * d),
            ph.detents(self.point, [1] * d, spacing=0.01, strength=1.5),
        )


def cycles(case, scene, law):
    control = ph.controller(case.device, case.brakes(), scene, case.law(law))
    states = zip(case.time.tolist(), case.q, case.qd, case.hand_force)
    return control, [control(ph.device_state(*state)) for state in states]


PAIRS = [(mode, law) for mode in ("held", "mesh_solid") for law in ("direct_control", "saturated_direct_control", "recommended")]
PAIRS += [(mode, law) for mode in ("world", "held_world") for law in ("direct_control", "recommended")]
PAIRS += [(mode, "direct_control") for mode in ("effects", "effects_in_world")]


@needs_reference
@pytest.mark.parametrize("name", ["tendon_two_link", "delta"])
@pytest.mark.parametrize("mode,law", PAIRS)
def test_cycles_in_scenes(name, mode, law, tmp_path):
    from test_equal_to_cpp import assert_same_bits, numbers_of

    case = Scenes(name)
    case.write(tmp_path / "states")
    command = [REFERENCE, name, f"{law} in scenes", mode, tmp_path / "states", tmp_path / "results"]
    subprocess.run(command, check=True)
    theirs = np.fromfile(tmp_path / "results").reshape(STATES, -1)
    _, results = cycles(case, case.scene_of(mode), law)
    ours = np.frombuffer(b"".join(numbers_of(result) for result in results)).reshape(theirs.shape)
    assert_same_bits(ours, theirs, f"cycles of {name} in {mode} under {law}")
    walls = {result.wall_number for result in results}
    assert len(walls) >= 4 if "world" in mode else walls == {-1, 0}


def test_batches_in_scenes_are_first_cycles():
    case = Scenes("tendon_two_link")
    every = slice(EDGES, None, 200)
    states = case.q[every], case.qd[every], case.hand_force[every], case.time[every]
    for mode, law in PAIRS:
        control = ph.controller(case.device, case.brakes(), case.scene_of(mode), case.law(law))
        batch = control.batch(*states)
        for k, (q, qd, force, time) in enumerate(zip(*states)):
            control.reset()
            assert control(ph.device_state(time, q, qd, force)).capacity.tobytes() == batch.capacity[k].tobytes()


def test_scenes_of_different_kinds_are_not_equal():
    walls = [ph.wall(ph.half_space([0, 0], [0, -1])), ph.wall(ph.ball([0, 0], 1))]
    scenes = [ph.scene(*walls), ph.world(walls), ph.held_scene(ph.scene(*walls), 0.1), ph.held_scene(ph.world(walls), 0.1)]
    scenes += [ph.with_effects(ph.world(walls), ph.rough_walls()), ph.with_effects(ph.world(walls), ph.rough_walls(0.1))]
    for i, a in enumerate(scenes):
        assert [a == b for b in scenes] == [i == j for j in range(len(scenes))]
        assert a.dimension == 2


def test_a_mesh_of_a_file():
    mesh, remarks = ph.read_stl(TETRAHEDRON, metres_per_unit=1e-3)
    assert remarks == "" and len(mesh) == 4 and mesh.dimension == 3
    assert mesh.vertices.shape == (4, 3) and mesh.facets.shape == (4, 3)
    assert mesh.plausibility(0.4) == ""
    assert "metres_per_unit is 1e-3?" in ph.read_stl(TETRAHEDRON)[0].plausibility(0.4)
    assert ph.mesh(mesh.vertices, mesh.facets) == mesh
    solid, by_arrays = ph.mesh_solid(mesh), ph.mesh_solid(ph.mesh(CORNERS, FACES))
    for x in ([0.01, 0.02, 0.02], [0.03, 0.03, -0.001], [1, 1, 1]):
        assert solid.distance(x) == pytest.approx(by_arrays.distance(x), rel=1e-12)
    assert solid.distance([0.03, 0.03, -0.001]) == pytest.approx(0.001, rel=1e-9)
    assert solid.gradient([0.03, 0.03, -0.001]).tolist() == [0, 0, -1]


@pytest.mark.parametrize("read,text", [
    (ph.read_obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nKd 1 1 1\n"),
    (ph.read_ply, "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
     "element face 4\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
     "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"),
])  # fmt: skip
def test_other_files(read, text, tmp_path):
    path = tmp_path / "tetrahedron"
    path.write_text(text)
    mesh, remarks = read(path, 0.1)
    assert ("line 9: 'Kd'" in remarks) == (read is ph.read_obj)
    assert len(mesh) == 4 and np.ptp(mesh.vertices) == 0.1
    assert read(str(path), 0.1) == (mesh, remarks)
    with pytest.raises(ValueError, match=r"^passive_haptics: mesh file .*tetrahedron: .*: expected "):
        path.write_text(text.replace("0 1 0", "0 one 0"))
        read(path)


def test_polylines():
    solid = ph.mesh_solid(SQUARE)
    assert solid.dimension == 2
    assert solid.distance([0.05, 0.03]) == pytest.approx(-0.03)
    box = ph.box([0.05, 0.05], [0.05, 0.05])
    for x in np.random.default_rng(SEED).uniform(-0.1, 0.2, (100, 2)):
        assert solid.distance(x) == pytest.approx(box.distance(x), abs=1e-15)


def test_large_meshes_have_a_short_repr():
    rows, facets = potato(np.zeros(3), 3)
    mesh = ph.mesh(rows, facets)
    assert repr(mesh) == "mesh(<146 vertices>, <288 facets>)"
    assert mesh.vertices.tobytes() == rows.tobytes() and (mesh.facets == facets).all()
    strided = ph.mesh(np.asfortranarray(rows)[::1], facets.astype("u2")[:, ::1])
    assert strided == mesh and pickle.loads(pickle.dumps(mesh)) == mesh
    with pytest.raises(ValueError, match="read-only"):
        mesh.vertices[:] = 0
