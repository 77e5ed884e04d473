# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape diameter function, shape signatures and retrieval evaluation.

Arrays are those of NumPy: vertices are n x 3 floats, faces m x 3 vertex indices, points n x 3 floats, distances n x n
floats. Instead of vertices and faces, functions accept an object with ``vertices`` and ``faces`` (trimesh), with
``vertices`` and ``triangles``, or with ``points`` (Open3D, meshio); further arguments follow it. A shape without faces is
a point cloud.

Unusable input raises InputError, a ValueError. Values are the same bytes as those of the command line, for any number of
threads; its warnings are Python warnings. Ctrl-C stops computations.
"""

from ._native import InputError, version as _version
from ._check import CheckReport, ThinRegion, check
from ._evaluation import Comparison, Scores, compare, distances, evaluate, fuse, rerank
from ._run import Run, run
from ._search import Answer, Found, Index
from ._shapes import ScalarField, Shape, describe, field, normals, read, sdf, segment, write

__all__ = [
    "Answer", "CheckReport", "Comparison", "Found", "Index", "InputError", "Run", "ScalarField", "Scores", "Shape",
    "ThinRegion", "check", "compare", "describe", "distances", "evaluate", "field", "fuse", "normals", "read", "rerank",
    "run", "sdf", "segment", "write",
]
__version__ = _version()
