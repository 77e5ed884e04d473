# SPDX-License-Identifier: GPL-3.0-or-later
"""Annotations of the package, checked by mypy if installed."""

import pathlib
import re
import shutil
import subprocess

import pytest

import shapegauge

HERE = pathlib.Path(__file__).resolve().parent


def mypy(tmp_path, *arguments):
    if not shutil.which("mypy"):
        pytest.skip("mypy is not installed")
    command = ["mypy", "--no-error-summary", "--cache-dir", str(tmp_path), "--ignore-missing-imports", *map(str, arguments)]
    package = pathlib.Path(shapegauge.__file__).parents[1]
    return subprocess.run(command, capture_output=True, text=True, env={"MYPYPATH": str(package), "PATH": "/usr/bin:/bin"})


def test_every_function_of_the_package_is_annotated(tmp_path):
    run = mypy(tmp_path, "--disallow-untyped-defs", "--warn-unused-ignores", HERE.parents[1] / "python" / "shapegauge")
    assert run.returncode == 0, run.stdout


def test_mypy_reports_exactly_the_errors_marked_in_a_sample_file(tmp_path):
    source = HERE / "typed_use.py"
    run = mypy(tmp_path, "--follow-imports=silent", source)
    found = {int(line) for line in re.findall(rf"{source.name}:(\d+): error", run.stdout)}
    expected = {number for number, line in enumerate(source.read_text().splitlines(), start=1) if line.endswith("# error")}
    assert found == expected, run.stdout
