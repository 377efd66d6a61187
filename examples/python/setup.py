"""Builds the package. All that is made on the way goes to build/python of the repository."""

import glob
import os
import re
import shutil
import subprocess

from pybind11.setup_helpers import ParallelCompile, Pybind11Extension, build_ext
from setuptools import setup
from setuptools.command.build_py import build_py

root = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
build = os.path.join(root, "build", "python")
headers = os.path.join(root, "include", "passive_haptics")

LOG_SOURCES = ("known_columns", "log_columns", "log_reader", "log_row")  # of examples/log


def version():
    """The version of the library."""
    text = open(os.path.join(headers, "core", "version.hpp"), encoding="utf-8").read()
    part = lambda name: re.search(rf"VERSION_{name} (\d+)", text).group(1)
    return ".".join(part(name) for name in ("MAJOR", "MINOR", "PATCH"))


def files(*patterns):
    """The files of these patterns."""
    return sorted(name for pattern in patterns for name in glob.glob(pattern, recursive=True))


def eigen():
    """The folder of Eigen's headers."""
    try:
        flags = subprocess.check_output(["pkg-config", "--cflags-only-I", "eigen3"], text=True)
        return flags.strip().removeprefix("-I")
    except (OSError, subprocess.CalledProcessError):
        return "/usr/include/eigen3"


class build_with_headers(build_py):
    """Puts the headers into the package, so that a mechanism of a user's own can be bound with a wheel alone."""

    def run(self):
        super().run()
        folder = os.path.join(self.build_lib, "passive_haptics", "include")
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(headers, os.path.join(folder, "passive_haptics"))
        shutil.copytree("include/passive_haptics_python", os.path.join(folder, "passive_haptics_python"))


def is_out_of_date(object_file, source):
    """Whether a file must be compiled: it or a header that it includes is newer than its object file."""
    try:
        named = open(os.path.splitext(object_file)[0] + ".d", encoding="utf-8").read().replace("\\\n", " ").split()[1:]
        made = os.stat(object_file).st_mtime
        return any(os.stat(name).st_mtime > made for name in [*named, os.path.abspath(__file__)])
    except OSError:
        return True


class build_precompiled(build_ext):
    """Compiles source/precompiled.hpp once, for all sources that include it first. What runs cycles of many states is
    optimised more than what is called from Python."""

    def build_extensions(self):
        compiler, extension = self.compiler, self.extensions[0]
        precompiled = os.path.join(build, "precompiled", "precompiled.hpp.gch")
        # After the flags of pybind11 are known
        extension.include_dirs.insert(0, os.path.dirname(precompiled))
        os.makedirs(os.path.dirname(precompiled), exist_ok=True)
        if is_out_of_date(precompiled, "source/precompiled.hpp"):
            folders = [f"-I{folder}" for folder in [*extension.include_dirs, *compiler.include_dirs]]
            options = [*extension.extra_compile_args, "-O1", "-x", "c++-header", "-o", precompiled]
            listed = ["-MF", precompiled[:-4] + ".d"]
            compiler.spawn([*compiler.compiler_so, *folders, "source/precompiled.hpp", *options, *listed])
        compile_one = compiler._compile

        def compile_by_folder(object_file, source, extension_of_source, flags_of_all, last_flags, others):
            level = "-O2" if "/batches/" in source else "-O1"
            compile_one(object_file, source, extension_of_source, flags_of_all, [*last_flags, level], others)

        compiler._compile = compile_by_folder
        super().build_extensions()


# Bits as in a C++ program that does not contract products and sums. Without FLATTEN, which makes each cycle one
# function: it would take the compiler half an hour. source/batches/ has it, where it pays.
flags = ["-g0", "-DNDEBUG", "-ffp-contract=off", "-DPASSIVE_HAPTICS_FLATTEN=", "-Wno-psabi", "-MMD"]
# Memory for time: the compiler looks for garbage twice, not nine times
flags += ["--param=ggc-min-heapsize=524288", "--param=ggc-min-expand=100"]

os.chdir(os.path.dirname(os.path.abspath(__file__)))
os.makedirs(build, exist_ok=True)
ParallelCompile(
    "CMAKE_BUILD_PARALLEL_LEVEL", default=len(os.sched_getaffinity(0)), needs_recompile=is_out_of_date
).install()
setup(
    version=version(),
    packages=["passive_haptics"],
    package_dir={"": "package"},
    package_data={"passive_haptics": ["py.typed", "*.pyi"]},
    ext_modules=[
        Pybind11Extension(
            "passive_haptics._native",
            [*files("source/**/*.cpp"), *(f"../log/{name}.cpp" for name in LOG_SOURCES)],
            depends=files("source/**/*.hpp", "include/**/*.hpp", "../log/*.hpp", os.path.join(headers, "**", "*.hpp"), "setup.py"),
            cxx_std=20,
            include_dirs=["source", "include", os.path.join(root, "include"), os.path.join(root, "examples"), eigen()],
            extra_compile_args=flags,
            extra_link_args=["-s"],  # without the names of functions
        )
    ],
    cmdclass={"build_ext": build_precompiled, "build_py": build_with_headers},
    options={
        "build": {"build_base": os.path.join(build, "build")},
        "egg_info": {"egg_base": build},
    },
    zip_safe=False,
)
