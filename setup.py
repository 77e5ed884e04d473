# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the Python package for pip, by CMake: the packages of scripts/setup.sh must be installed.

The environment variable SHAPEGAUGE_BUILD_FOLDER names a build folder to use, and keep; there only what has changed is
compiled.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
VERSION = re.search(r"project\(shapegauge VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


class BuildByCMake(build_ext):
    """The native half of the package is a target of CMake."""

    def build_extension(self, extension):
        existing = os.environ.get("SHAPEGAUGE_BUILD_FOLDER")
        folder = pathlib.Path(existing) if existing else pathlib.Path(self.build_temp).resolve()
        if not (folder / "CMakeCache.txt").exists():
            settings = {"CMAKE_BUILD_TYPE": "Release", "SHAPEGAUGE_BUILD_TESTS": "OFF", "SHAPEGAUGE_UNITY_BUILD": "ON",
                        "Python3_EXECUTABLE": sys.executable}
            options = [f"-D{name}={value}" for name, value in settings.items()]
            subprocess.run(["cmake", "-G", "Ninja", "-S", str(ROOT), "-B", str(folder), *options], check=True)
        subprocess.run(["cmake", "--build", str(folder), "--target", "shapegauge_python"], check=True)
        made = next((folder / "python" / "shapegauge").glob("_native*.so"))
        destination = pathlib.Path(self.get_ext_fullpath(extension.name))
        destination.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(made, destination)


setup(version=VERSION, ext_modules=[Extension("shapegauge._native", [])], cmdclass={"build_ext": BuildByCMake})
