"""Shape diameter function, shape signatures and retrieval evaluation.

Arrays are NumPy's: vertices are n x 3 floats, faces m x 3 vertex indices, points n x 3 floats, distances n x n floats.
Wherever vertices are asked for, an object with ``vertices`` and ``faces`` (trimesh), with ``vertices`` and ``triangles``
or with ``points`` (Open3D, meshio) does as well, and then stands alone: what follows the shape comes after it. A shape without
faces is a point cloud.

Unusable input raises InputError, a ValueError that says what is wrong. Values are the same bytes as the command line's,
for any number of threads, and what the command line warns of is a Python warning. Ctrl-C stops computations.
"""

from . import _native
from ._evaluation import Comparison, Scores, compare, distances, evaluate, fuse, rerank
from ._native import InputError
from ._run import Run, run
from ._search import Answer, Found, Index
from ._shapes import ScalarField, Shape, describe, field, normals, read, sdf, segment, write

__all__ = [
    "Answer", "Comparison", "Found", "Index", "InputError", "Run", "ScalarField", "Scores", "Shape", "compare", "describe",
    "distances", "evaluate", "field", "fuse", "normals", "read", "rerank", "run", "sdf", "segment", "write",
]
__version__ = _native.version()
