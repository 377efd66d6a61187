"""Builds the module polar next to the installed package: python setup.py build_ext."""

import passive_haptics
from pybind11.setup_helpers import Pybind11Extension
from setuptools import setup

flags = ["-O2", "-g0", "-DNDEBUG", "-DPASSIVE_HAPTICS_FLATTEN=", "-Wno-psabi"]
folders = passive_haptics.include_folders()
polar = Pybind11Extension("polar", ["polar_arm.cpp"], cxx_std=20, include_dirs=folders, extra_compile_args=flags)
setup(name="polar", ext_modules=[polar])
