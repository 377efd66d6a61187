"""The package as a whole: its version, its size, its stubs, its headers, its examples."""

import glob
import os
import pickle
import re
import subprocess
import sys
import threading

import numpy as np
import pytest

import passive_haptics as ph
from devices import Case
from passive_haptics import _native, classes

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
EXAMPLE = os.path.join(ROOT, "examples", "python")
LARGEST_MODULE = 8e6  # bytes


def read(*path):
    with open(os.path.join(*path), encoding="utf-8") as file:
        return file.read()


def run(*command, **options):
    done = subprocess.run(command, text=True, capture_output=True, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_version_is_the_librarys():
    numbers = re.findall(r"VERSION_\w+ (\d+)", read(ROOT, "include", "passive_haptics", "core", "version.hpp"))
    assert ph.__version__ == ".".join(numbers)


def test_module_is_small():
    assert os.path.getsize(_native.__file__) < LARGEST_MODULE


def test_classes_are_those_of_the_catalogue():
    folder = os.path.dirname(ph.__file__)
    assert read(folder, "catalogue.py") == classes.module_text(_native)
    assert read(folder, "_native.pyi") == classes.stub_text(_native)


@pytest.mark.skipif(not os.path.exists("/usr/bin/mypy"), reason="Debian's mypy is not installed")
def test_types_pass_mypy(tmp_path):
    options = dict(cwd=tmp_path, env={**os.environ, "MYPYPATH": os.path.dirname(os.path.dirname(ph.__file__))})
    run("/usr/bin/mypy", "--strict", "-p", "passive_haptics", **options)
    run("/usr/bin/mypy", "--strict", os.path.join(ROOT, "docs", "guide", "python.py"), **options)
    (tmp_path / "wrong.py").write_text("import passive_haptics as ph\nph.two_link().dofs\nph.plot\n")
    found = subprocess.run(["/usr/bin/mypy", "--strict", "wrong.py"], text=True, capture_output=True, **options).stdout
    assert '"two_link" has no attribute "dofs"' in found and "wrong.py:3: error: Module has no attribute" in found
    assert "Found 2 errors" in found


def test_guide_runs():
    text = run(sys.executable, os.path.join(ROOT, "docs", "guide", "python.py"))
    assert "0.4 s: 19 mm along the wall,  2.04 mm deep, feels 2.01 N\n" in text  # as in the README
    assert "length_1 [m] = -1: expected a finite number > 0" in text


def test_help_is_what_the_example_prints():
    pytest.importorskip("matplotlib")
    program = os.path.join(ROOT, "docs", "guide", "pictures.py")
    text = run(sys.executable, program, "--help", env={**os.environ, "COLUMNS": "100"})
    assert text == read(ROOT, "examples", "help", "python.txt")


def test_page_names_the_packages_that_the_scripts_install():
    page = re.search(r"sudo apt install (.*)", read(ROOT, "docs", "guide", "python.md")).group(1)
    script = re.search(r'python_packages="([^"]*)"', read(ROOT, ".ci", "setup.sh")).group(1)
    assert page.split() == script.split()


def test_own_mechanism_is_bound_with_the_package_alone(tmp_path):
    for path in glob.glob(os.path.join(EXAMPLE, "own_mechanism", "*")):
        (tmp_path / os.path.basename(path)).write_text(read(path))
    run(sys.executable, "setup.py", "build_ext", "--inplace", cwd=tmp_path)
    program = """
import pickle
import passive_haptics as ph
from polar import polar_arm
arm = polar_arm()
assert arm.position([0, 0.2]).tolist() == [0.2, 0]
assert pickle.loads(pickle.dumps(arm)) == arm
assert arm.brakes() == ph.two_link().brakes()
assert arm.recommended_law() == ph.on_off_control(lead=arm.brakes().parameters["time_constant"][0])
scene = ph.scene(ph.wall(ph.half_space([0.2, 0], [-1, 0]), 1e3))
control = ph.controller(arm, arm.brakes(), scene, ph.direct_control())
result = control(ph.device_state(0, [0, 0.202], [0, 0.1], [1, 0]))
assert abs(result.capacity[1] - 1) < 1e-12 and result.display == ph.display_class.exact  # 1 N at most
print(repr(arm), result.desired_force)
"""
    assert "polar_arm() [-2" in run(sys.executable, "-c", program, cwd=tmp_path)


def test_a_value_that_was_not_made_is_an_error():
    wall = ph.wall(ph.half_space([0, 0.2], [0, -1]))
    arm = ph.two_link()
    control = ph.controller(arm, arm.brakes(), ph.scene(wall), ph.direct_control())
    for kind, use in (
        (ph.two_link, lambda x: x.position([0, 1])), (ph.two_link, repr), (ph.two_link, lambda x: arm == x), (ph.mesh, len),
        (ph.controller, repr), (ph.wall, ph.scene), (ph.half_space, ph.wall), (ph.brakes, control.set_brakes),
        (ph.device_state, control), (ph.device_state, repr), (ph.step_result, repr), (ph.device_state, pickle.dumps),
    ):  # fmt: skip
        with pytest.raises(TypeError, match="without parameters: expected a call"):
            use(kind.__new__(kind))


def test_python_goes_on_during_a_batch():
    """Another thread runs while a batch is computed, and threads may share a controller."""
    case = Case("two_link", 200_000, 5)
    control = case.controller("direct_control")
    expected = control.batch(case.q, case.qd, case.hand_force)
    results = []
    threads = [
        threading.Thread(target=lambda: results.append(control.batch(case.q, case.qd, case.hand_force)))
        for _ in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 4 and all(result == expected for result in results)


def test_a_batch_can_be_interrupted():
    program = """
import os, signal, threading
import numpy as np
from devices import Case
case = Case("spatial_chain_7", 100_000, 1)
q, qd, force = (np.tile(x, (40, 1)) for x in (case.q, case.qd, case.hand_force))
control = case.controller("direct_control")
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's job in the background has none
threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    control.batch(q, qd, force, fields=[])
    print("ran to its end")
except KeyboardInterrupt:
    print("interrupted")
"""
    assert run(sys.executable, "-c", program, cwd=os.path.dirname(__file__)).strip() == "interrupted"
