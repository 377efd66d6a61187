"""Builds the module polar beside the installed package: python setup.py build_ext."""

import passive_haptics
from pybind11.setup_helpers import Pybind11Extension, build_ext
from setuptools import setup

setup(
    name="polar",
    ext_modules=[
        Pybind11Extension(
            "polar",
            ["polar_arm.cpp"],
            cxx_std=20,
            include_dirs=passive_haptics.include_folders(),
            extra_compile_args=["-O2", "-g0", "-DNDEBUG", "-DPASSIVE_HAPTICS_FLATTEN=", "-Wno-psabi"],
        )
    ],
    cmdclass={"build_ext": build_ext},
)
