# SPDX-License-Identifier: GPL-3.0-or-later
"""Helpers shared by the tests of the package."""

import os
import subprocess
import types

import numpy as np

PROGRAM = os.environ["SHAPEGAUGE_PROGRAM"]
CONFIGS = os.environ["SHAPEGAUGE_CONFIGS"]


def program(*arguments):
    """Runs the command line; returns the lines of standard error."""
    run = subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True, text=True)
    return run.stderr.splitlines()


def bumpy_torus(rings=40, sides=24):
    """A closed mesh of varying thickness."""
    u, v = np.meshgrid(np.arange(rings) * 2 * np.pi / rings, np.arange(sides) * 2 * np.pi / sides, indexing="ij")
    r = 0.3 + 0.1 * np.sin(3 * u)
    vertices = np.stack([(1 + r * np.cos(v)) * np.cos(u), (1 + r * np.cos(v)) * np.sin(u), r * np.sin(v)], -1)
    i, j = np.meshgrid(np.arange(rings), np.arange(sides), indexing="ij")
    at = lambda a, b: (a % rings) * sides + b % sides
    faces = np.concatenate([
        np.stack([at(i, j), at(i + 1, j), at(i + 1, j + 1)], -1).reshape(-1, 3),
        np.stack([at(i, j), at(i + 1, j + 1), at(i, j + 1)], -1).reshape(-1, 3)
    ])
    return vertices.reshape(-1, 3), faces


def mesh_object(vertices, faces):
    """An object with arrays, like those of trimesh."""
    return types.SimpleNamespace(vertices=vertices, faces=faces)


def toy():
    """A = 0, 1, 4 and B = 2, 3.5, 7, 9 on a line, with scores computed by hand."""
    positions = np.array([0, 1, 4, 2, 3.5, 7, 9])
    return np.abs(np.subtract.outer(positions, positions)), list("aaabbbb")
