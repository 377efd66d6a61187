"""Builds the package: its module by CMake, and the classes of the catalogue from it. In a clone all that is made on the way
goes to build/python; PASSIVE_HAPTICS_CMAKE_BUILD names another folder of CMake, such as build/examples, whose catalogue the
module then shares."""

import os
import re
import shutil
import subprocess
import sys

import pybind11
from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist
from wheel.bdist_wheel import bdist_wheel

here = os.path.dirname(os.path.abspath(__file__))
root = os.path.join(here, "..", "..")
if not os.path.isdir(os.path.join(root, "include", "passive_haptics")):
    root = os.path.join(here, "library")  # an sdist brings it
root = os.path.abspath(root)
build = os.path.join(os.environ.get("PASSIVE_HAPTICS_BUILD", os.path.join(root, "build")), "python")
headers = os.path.join(root, "include", "passive_haptics")
version = ".".join(re.findall(r"VERSION_\w+ (\d+)", open(os.path.join(headers, "core", "version.hpp"), encoding="utf-8").read()))


class build_by_cmake(build_ext):
    """Builds the module _native, the headers for mechanisms of a user, and the classes of the catalogue."""

    def run(self):
        if shutil.which("cmake") is None:
            sys.exit("passive_haptics: cmake is missing: expected Debian's cmake and ninja-build")
        given = os.environ.get("PASSIVE_HAPTICS_CMAKE_BUILD")
        folder = given or os.path.join(build, "cmake")
        source = root if given else os.path.join(root, "examples", "python")
        is_new = not os.path.exists(os.path.join(folder, "CMakeCache.txt"))
        generator = ["-G", "Ninja"] if is_new and shutil.which("ninja") else []
        subprocess.check_call(["cmake", "-S", source, "-B", folder, *generator, f"-DPASSIVE_HAPTICS_PYTHON={sys.executable}"])
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(len(os.sched_getaffinity(0))))
        subprocess.check_call(["cmake", "--build", folder, "--target", "passive_haptics_python", "--parallel", jobs])
        package = os.path.join(self.build_lib, "passive_haptics")
        made = os.path.join(folder, "examples", "python") if given else folder
        module = next(name for name in os.listdir(made) if name.startswith("_native."))
        shutil.copy2(os.path.join(made, module), package)
        subprocess.check_call([sys.executable, os.path.join(package, "classes.py")])
        to = os.path.join(package, "include")
        shutil.rmtree(to, ignore_errors=True)
        shutil.copytree(headers, os.path.join(to, "passive_haptics"))
        shutil.copytree(os.path.join(here, "include", "passive_haptics_python"), os.path.join(to, "passive_haptics_python"))


class sdist_with_library(sdist):
    """Puts the library and the examples that the module is made of into the source distribution."""

    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        to = os.path.join(base_dir, "library")
        for name in ("CMakeLists.txt", "install.cmake", "LICENSE", "README.md"):
            os.makedirs(to, exist_ok=True)
            shutil.copy2(os.path.join(root, name), to)
        for name in ("include", *(os.path.join("examples", part) for part in ("catalogue", "common", "log", "python/source"))):
            shutil.copytree(os.path.join(root, name), os.path.join(to, name), ignore=shutil.ignore_patterns("__pycache__"))
        shutil.copy2(os.path.join(here, "CMakeLists.txt"), os.path.join(to, "examples", "python"))
        shutil.copytree(os.path.join(here, "include"), os.path.join(base_dir, "include"), dirs_exist_ok=True)


class wheel_with_license(bdist_wheel):
    """Puts the licence into the wheel."""

    def egg2dist(self, egginfo_path, distinfo_path):
        super().egg2dist(egginfo_path, distinfo_path)
        shutil.copy2(os.path.join(root, "LICENSE"), distinfo_path)


os.chdir(here)
os.makedirs(build, exist_ok=True)
setup(
    version=version,
    packages=["passive_haptics"],
    package_dir={"": "package"},
    package_data={"passive_haptics": ["py.typed"]},
    ext_modules=[Extension("passive_haptics._native", [])],
    long_description=open(os.path.join(root, "README.md"), encoding="utf-8").read(),
    long_description_content_type="text/markdown",
    # A module built with an older pybind11 crashes with NumPy 2
    install_requires=["numpy<2" if pybind11.version_info < (2, 12) else "numpy"],
    cmdclass={"build_ext": build_by_cmake, "sdist": sdist_with_library, "bdist_wheel": wheel_with_license},
    options={
        "build": {"build_base": os.path.join(build, "build")},
        "egg_info": {"egg_base": build},
    },
    zip_safe=False,
)
