# SPDX-License-Identifier: GPL-3.0-or-later
"""Installation by pip from the source folder, without network."""

import pathlib
import shutil
import subprocess
import sys
import zipfile

import pytest

import shapegauge

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = """
import pathlib, sys
import numpy as np
import shapegauge as sg
assert pathlib.Path(sg.__file__).is_relative_to(sys.prefix), sg.__file__
assert (pathlib.Path(sg.__file__).parent / "py.typed").exists()
positions = np.array([0, 1, 2, 10, 11, 12])
distances = np.abs(np.subtract.outer(positions, positions))
print(sg.__version__, sg.evaluate(distances, list("aaabbb"))["NN"])
"""


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """Wheel of the source folder, with the native module of the build under test."""
    pytest.importorskip("setuptools")
    pytest.importorskip("wheel")
    if not shutil.which("cmake"):
        pytest.skip("cmake is not installed")
    folder = tmp_path_factory.mktemp("wheel")
    source = folder / "source"
    source.mkdir()
    for name in ("pyproject.toml", "setup.py", "README.md", "CMakeLists.txt", "LICENSE"):
        shutil.copy(ROOT / name, source)
    shutil.copytree(ROOT / "python", source / "python", ignore=shutil.ignore_patterns("__pycache__"))
    build = pathlib.Path(shapegauge.__file__).parents[2]
    assert (build / "CMakeCache.txt").exists()
    pip = [sys.executable, "-m", "pip", "wheel", "--no-index", "--no-deps", "--no-build-isolation", "-w", str(folder)]
    environment = {"SHAPEGAUGE_BUILD_FOLDER": str(build), "PATH": "/usr/bin:/bin", "HOME": str(folder)}
    done = subprocess.run([*pip, str(source)], env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return next(folder.glob("*.whl"))


def test_wheel_contains_the_package_and_its_type_stubs(wheel):
    names = zipfile.ZipFile(wheel).namelist()
    for name in ("__init__.py", "_search.py", "_native.pyi", "py.typed"):
        assert f"shapegauge/{name}" in names
    assert any(name.startswith("shapegauge/_native.") and name.endswith(".so") for name in names)
    assert shapegauge.__version__ in wheel.name
    assert "none-any" not in wheel.name


def test_wheel_runs_in_a_virtual_environment(wheel, tmp_path):
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", tmp_path / "venv"], check=True)
    python = tmp_path / "venv" / "bin" / "python"
    pip = [python, "-m", "pip", "install", "--no-index", "--no-deps", wheel]
    done = subprocess.run(pip, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    run = subprocess.run([python, "-I", "-c", PROGRAM], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert run.stdout.split() == [shapegauge.__version__, "1.0"]
