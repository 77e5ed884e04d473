# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes as arguments: arrays, or objects of trimesh, Open3D, PyVista and meshio."""

from __future__ import annotations

import numbers as _numbers
import os as _os
from typing import Any, Tuple

import numpy as _numpy

from ._arguments import array_of, kind_of, shape_text
from ._native import InputError

ShapeArrays = Tuple[_numpy.ndarray, _numpy.ndarray, _numpy.ndarray]


def settings_after(vertices: Any, faces: Any, *settings: tuple[Any, Any]) -> tuple[Any, ...]:
    """Returns the faces and the settings. settings: values, each with its default, in the order of the arguments.

    Settings may follow an object, or the points of a cloud, instead of faces: sdf(mesh, "cone_sdf", 0.05). They are then
    moved to their own parameters.
    """
    values = [value for value, _ in settings]
    is_setting = isinstance(faces, (str, _numbers.Number))
    if faces is None or not (is_setting or is_shape_object(vertices)):
        return (faces, *values)
    if not is_setting:
        raise InputError(f"the {type(vertices).__name__} already has faces; leave faces out")
    is_set = [type(value) is not type(default) or value != default for value, default in settings]
    if is_set[-1] and all(is_set):
        raise TypeError(f"too many positional arguments after the {type(vertices).__name__}: {values[-1]!r}")
    moved = zip(values, is_set, values[1:])
    return (None, faces, *(previous if is_moved else value for previous, is_moved, value in moved))


def is_shape_object(value: Any) -> bool:
    """Returns whether the value is an object with the arrays of a shape, not an array."""
    if hasattr(value, "__array__"):
        return False
    return hasattr(value, "vertices") or hasattr(value, "points") or _is_scene(value) or _is_tensor_geometry(value)


def _is_scene(value: Any) -> bool:
    """Returns whether the value is a trimesh scene: meshes with transformations."""
    return hasattr(value, "geometry") and callable(getattr(value, "dump", None))


def _is_tensor_geometry(value: Any) -> bool:
    """Returns whether the value is a mesh or a point cloud of open3d.t."""
    return any("positions" in getattr(value, part, ()) for part in ("vertex", "point"))


def _tensor_array(values: Any, name: str) -> Any:
    return values[name].cpu().numpy() if name in values else None


def _arrays_of_tensors(shape: Any) -> tuple[Any, Any, Any]:
    if "positions" in getattr(shape, "point", ()):
        return _tensor_array(shape.point, "positions"), None, _tensor_array(shape.point, "normals")
    return _tensor_array(shape.vertex, "positions"), _tensor_array(shape.triangle, "indices"), None


def _faces_of_cells(mesh: Any) -> Any:
    """Returns the triangles among the cells of a meshio mesh; none for a cloud."""
    faces = []
    for block in mesh.cells:
        kind, cells = (block.type, block.data) if hasattr(block, "type") else block
        if kind == "triangle":
            faces.append(array_of(cells, "cells"))
        elif kind not in ("vertex", "line"):
            raise InputError(f"the {type(mesh).__name__} has cells of the kind {kind}; split them into triangles first")
    return _numpy.concatenate(faces) if faces else None


def _attribute(shape: Any, name: str) -> Any:
    value = getattr(shape, name, None)
    if callable(value):
        raise InputError(f"{name} of the {type(shape).__name__} is a function; give its arrays")
    return value


def _faces_of_points(mesh: Any) -> Any:
    """The faces of an object whose vertices are `points`: none for a cloud (Open3D), or a padded list (PyVista)."""
    if hasattr(mesh, "cells") and not hasattr(mesh, "faces"):
        if not isinstance(mesh.cells, (list, tuple)):
            raise InputError(f"{kind_of(mesh)} has cells of several kinds; give its points and its triangles")
        return _faces_of_cells(mesh)
    faces = _attribute(mesh, "faces")
    if faces is None:
        return None
    array = array_of(faces, "faces")
    if array.ndim != 1:
        return array
    if array.size % 4 != 0 or (array.reshape(-1, 4)[:, 0] != 3).any():
        raise InputError(f"the {type(mesh).__name__} has faces that are no triangles; split them into triangles first")
    return array.reshape(-1, 4)[:, 1:]


def _arrays_of_object(shape: Any) -> tuple[Any, Any, Any]:
    """Returns the vertices, faces and normals of an object."""
    if _is_scene(shape):
        shape = shape.dump(concatenate=True)
    if _is_tensor_geometry(shape):
        return _arrays_of_tensors(shape)
    if not hasattr(shape, "vertices"):
        return _attribute(shape, "points"), _faces_of_points(shape), _attribute(shape, "normals")
    faces = _attribute(shape, "faces")
    faces = _attribute(shape, "triangles") if faces is None else faces
    return _attribute(shape, "vertices"), faces, _attribute(shape, "normals")


def shape_arrays(vertices: Any, faces: Any, normals: Any) -> ShapeArrays:
    """Vertices, faces and normals as arrays, from arrays or from one object instead of vertices."""
    if is_shape_object(vertices):
        if faces is not None:
            raise InputError(f"the {type(vertices).__name__} already has faces; leave faces out")
        vertices, faces, object_normals = _arrays_of_object(vertices)
        is_cloud = faces is None or len(faces) == 0
        normals = object_normals if normals is None and is_cloud else normals
    if isinstance(vertices, (str, bytes, _os.PathLike)):
        raise InputError("vertices must be n x 3, not the path of a file: read it with read()")
    if isinstance(vertices, (tuple, list)) and len(vertices) == 2 and getattr(vertices[0], "ndim", 0) == 2:
        raise InputError("vertices must be n x 3, not a pair of arrays: give vertices and faces as two arguments")
    vertices = _rows(vertices, "vertices", _numpy.float64)
    faces = _rows(_split_quads(vertices, [] if faces is None else faces), "faces", _numpy.int32)
    normals = _rows([] if normals is None else normals, "normals", _numpy.float64)
    if len(normals) > 0 and len(faces) > 0:
        raise InputError("normals are for point clouds; a mesh has its own: leave normals out")
    if len(normals) > 0 and len(normals) != len(vertices):
        raise InputError(f"there are {len(normals)} normals for {len(vertices)} points")
    return vertices, faces, _unit_vectors(normals)


def _unit_vectors(normals: _numpy.ndarray) -> _numpy.ndarray:
    """Returns the vectors with length 1, as readers of files do; zeros stay zero."""
    if not _numpy.isfinite(normals).all():
        raise InputError("normals have a component that is not a finite number")
    lengths = _numpy.linalg.norm(normals, axis=1, keepdims=True)
    lengths[(lengths == 0) | (abs(lengths - 1) < 1e-12)] = 1
    return normals / lengths


def _split_quads(vertices: _numpy.ndarray, faces: Any) -> Any:
    """Splits faces of four corners, m x 4, into 2 m triangles; returns other faces as they are.

    The diagonal is that from the first corner or, if its triangles overlap in a concave quad, the other one.
    """
    array = array_of(faces, "faces")
    if array.ndim != 2 or array.shape[1] != 4:
        return faces
    triangles = array[:, [0, 1, 2, 0, 2, 3]]
    if array.dtype.kind in "iu" and array.size > 0 and 0 <= array.min() and array.max() < len(vertices):
        corners = vertices[array]
        first, diagonal, last = (corners[:, k] - corners[:, 0] for k in (1, 2, 3))
        with _numpy.errstate(all="ignore"):  # coordinates beyond 1e77
            overlap = (_numpy.cross(first, diagonal) * _numpy.cross(diagonal, last)).sum(axis=1) < 0
        triangles[overlap] = array[overlap][:, [1, 2, 3, 1, 3, 0]]
    return triangles.reshape(-1, 3)


def _rows(values: Any, what: str, kind: Any) -> _numpy.ndarray:
    array = array_of(values, what)
    expected = "n x 3, or n x 4 for quads" if what == "faces" else "n x 3"
    if array.ndim == 0:
        raise InputError(f"{what} must be {expected}, not {kind_of(values)}")
    if array.size == 0 and array.ndim <= 2 and (array.ndim == 1 or array.shape[0] == 0):
        array = array.reshape(0, 3)
    if array.ndim != 2 or array.shape[1] != 3:
        hint = "; split polygons into triangles first" if what == "faces" and array.ndim == 2 else ""
        raise InputError(f"{what} must be {expected}, not {shape_text(array)}{hint}")
    if kind is _numpy.int32 and array.size > 0:
        if array.dtype.kind not in "iu":
            raise InputError(f"{what} must be whole numbers, not {array.dtype}; convert them with astype(int)")
        if not (0 <= array.min() and array.max() < 2**31):
            raise InputError(f"{what} must be vertex indices from 0 on")
    return _numpy.ascontiguousarray(array, dtype=kind)
