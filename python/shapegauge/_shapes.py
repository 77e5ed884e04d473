# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes: files, fields, normals, parts and features."""

from __future__ import annotations

import json as _json
from dataclasses import dataclass
from typing import Any, Iterator, Mapping, NamedTuple, Optional, Union

import numpy as _numpy

from . import _native
from ._arguments import PathLike, kind_of, number_of_threads, path_of, plain, switch, warn, word
from ._native import InputError
from ._settings import REGISTERED, listing, listing_of_all, settings_of, with_settings
from ._shape_arrays import ShapeArrays, is_shape_object, settings_after, shape_arrays

Sites = Union[str, Mapping[str, int]]


class Shape(NamedTuple):
    """Arrays of a shape: vertices (n x 3), faces (m x 3; none: a point cloud), normals of points (n x 3, or none)."""

    vertices: _numpy.ndarray
    faces: _numpy.ndarray
    normals: _numpy.ndarray

    def __repr__(self) -> str:
        if len(self.faces) == 0:
            return f"<Shape: {len(self.vertices)} points>"
        return f"<Shape: {len(self.vertices)} vertices, {len(self.faces)} faces>"


@dataclass(frozen=True, eq=False)
class ScalarField:
    """Values of a field with their weights (areas): ``values, weights = sg.sdf(mesh)``.

    values, weights: float64, one per sample; NaN for a missing value. points: positions of the samples, n x 3: centroids of
    faces, vertices, points of a cloud, or points on the surface. offset: offset of an offset SDF, given or chosen by
    "auto", as a fraction of the diagonal of the bounding box; otherwise None. normals: outward unit normals of an offset
    SDF, n x 3; otherwise None.
    """

    values: _numpy.ndarray
    weights: _numpy.ndarray
    offset: Optional[float] = None
    normals: Optional[_numpy.ndarray] = None
    points: Optional[_numpy.ndarray] = None

    def __iter__(self) -> Iterator[_numpy.ndarray]:
        return iter((self.values, self.weights))

    def __getitem__(self, index: int) -> _numpy.ndarray:
        return (self.values, self.weights)[index]

    def __array__(self, *arguments: Any, **settings: Any) -> _numpy.ndarray:
        raise TypeError("a ScalarField is not an array: use its .values, and its .weights for averages")


def read(path: PathLike) -> Shape:
    """Reads a mesh or a point cloud in any of the formats (docs/reference/file_formats.md).

    >>> sg.read("hand.off")
    <Shape: 5000 vertices, 9996 faces>
    """
    return Shape(*_native.read(path_of(path, "path")))


def write(path: PathLike, vertices: Any, faces: Any = None, normals: Any = None) -> None:
    """Writes a shape in the format of the extension. Warns if STL, of single precision, distorts the shape.

    >>> sg.write("hand.ply", *sg.read("hand.off"))
    """
    if is_shape_object(vertices) and normals is None:  # what follows an object are its normals
        faces, normals = None, faces
    warning = _native.write(path_of(path, "path"), *shape_arrays(vertices, faces, normals))
    warn([] if warning is None else [warning])


@with_settings([("Types and their settings", listing_of_all("fields"))])
def field(vertices: Any, faces: Any = None, type: str = "offset_sdf", *, at: Sites = "faces", normals: Any = None,
          remove_outliers: bool = False, threads: int = 0, **settings: Any) -> ScalarField:
    """A scalar field of any type that configurations know (docs/reference/configuration.md), in the units of the input.

    at: "faces", "vertices" or {"surface": n}; a cloud has its values at its points. remove_outliers: ignore isolated
    points of a cloud, whose values are NaN (done anyway with offset="auto"). settings: those of the type, below. Returns
    a ScalarField, which unpacks as values and weights.

    >>> values, weights = sg.field(mesh, "centricity", sources=24)
    """
    faces, type = settings_after(vertices, faces, (type, "offset_sdf"))
    found = _field(shape_arrays(vertices, faces, normals), word(type, "type"), at, settings, remove_outliers, threads)
    warn(found["leaks"] + found["hollow"] + found["without_value"])
    return _scalar_field(found)


def _field(shape: ShapeArrays, type: str, at: Sites, settings: Mapping[str, Any], remove_outliers: bool,
           threads: int) -> dict[str, Any]:
    settings = {"type": type, "at": plain(at, "at"), **{name: plain(value, name) for name, value in settings.items()}}
    return _native.field(*shape, _json.dumps(settings), switch(remove_outliers, "remove_outliers"),
                         number_of_threads(threads))


def _scalar_field(found: dict[str, Any]) -> ScalarField:
    normals = found["normals"]
    return ScalarField(found["values"], found["weights"], found["offset"], normals if len(normals) > 0 else None,
                       found["points"])


# The settings of each field of thickness.
_SDF_SETTINGS = {name: entry["settings"] for name, entry in REGISTERED["fields"].items() if entry["is_thickness"]}
_SDF_DEFAULTS = {"offset": REGISTERED["options"]["sdf"]["offset"]["default"]}


@with_settings([(f'Settings of method="{method}"', listing(settings, _SDF_DEFAULTS))
                for method, settings in _SDF_SETTINGS.items()])
def sdf(vertices: Any, faces: Any = None, method: Union[str, float] = "offset_sdf",
        offset: Union[None, float, str] = None, *, accuracy: Optional[str] = None, at: Sites = "faces",
        rays: Optional[int] = None, opening_angle_degrees: Optional[float] = None, engine: Optional[str] = None,
        postprocess: Optional[bool] = None, separation_angle_degrees: Optional[float] = None, normals: Any = None,
        remove_outliers: bool = False, threads: int = 0) -> ScalarField:
    """The thickness of a shape by the shape diameter function or inscribed balls, in the units of the input.

    method: "offset_sdf" (SDF of the offset surface, robust to noise and cracks, also for point clouds), "cone_sdf" (the
    conventional SDF, for closed meshes) or "inscribed_ball" (diameter of the largest inscribed ball). Each method has
    its own settings, below. at: "faces", "vertices" or {"surface": n}. remove_outliers: ignore isolated points of a
    cloud, whose values are NaN (done anyway with offset="auto"). Returns a ScalarField, which unpacks as values and
    weights; its `offset` is the one that "auto" chose.

    >>> values, weights = sg.sdf(vertices, faces, method="offset_sdf", offset=0.05, at="faces")
    >>> sg.sdf(points, offset="auto").offset
    0.0125
    >>> values, weights = sg.sdf(mesh, "cone_sdf")
    """
    faces, method, offset = settings_after(vertices, faces, (method, "offset_sdf"), (offset, None))
    if not isinstance(method, str) or method not in _SDF_SETTINGS:
        *others, last = (f'"{name}"' for name in _SDF_SETTINGS)
        shown = repr(method) if isinstance(method, str) else kind_of(method)
        raise InputError(f"method must be {', '.join(others)} or {last}, not {shown}")
    settings = {"offset": offset, "accuracy": accuracy, "rays": rays, "opening_angle_degrees": opening_angle_degrees,
                "engine": engine, "postprocess": postprocess, "separation_angle_degrees": separation_angle_degrees}
    method_settings = {name: value for name, value in settings.items() if value is not None}
    for name in method_settings:
        if name not in _SDF_SETTINGS[method]:
            other = next(other for other, settings in _SDF_SETTINGS.items() if name in settings)
            raise InputError(f'{name} requires method="{other}", not "{method}"')
    if method == "offset_sdf":
        method_settings = {**_SDF_DEFAULTS, **method_settings}
    found = _field(shape_arrays(vertices, faces, normals), method, at, method_settings, remove_outliers, threads)
    warn(found["leaks"] + found["hollow"] + found["without_value"])
    return _scalar_field(found)


def normals(vertices: Any, faces: Any = None, offset: Union[float, str] = "auto", *, at: Sites = "vertices",
            remove_outliers: bool = False, threads: int = 0) -> _numpy.ndarray:
    """Estimates outward unit normals, n x 3, robust to noise, cracks and orientation.

    offset: distance of the offset surface, a fraction of the diagonal of the bounding box, or "auto". at: "faces",
    "vertices" or {"surface": n}. remove_outliers: ignore isolated points of a cloud, whose normals are 0 (done anyway
    with offset="auto"). sdf() returns the same normals together with the offset chosen by "auto".

    >>> sg.normals(points).shape
    (5000, 3)
    """
    faces, offset = settings_after(vertices, faces, (offset, "auto"))
    found = _field(shape_arrays(vertices, faces, None), "offset_sdf", at, {"offset": offset}, remove_outliers, threads)
    warn(found["leaks"] + found["without_value"])
    return found["normals"]


def _with_settings(function: str, fixed: Mapping[str, str], settings: Mapping[str, Any]) -> str:
    """Returns the settings, with those of the function, as JSON."""
    for name in fixed:
        if name in settings:
            raise InputError(f"{function}() takes no setting {name}")
    return _json.dumps({**{name: plain(value, name) for name, value in settings.items()}, **fixed})


@with_settings([("Settings", listing({
    name: setting for name, setting in settings_of("sections", "segmentation_method").items() if name != "method"}))])
def segment(vertices: Any, faces: Any = None, method: str = "best", *, normals: Any = None,
            remove_outliers: bool = False, threads: int = 0, **settings: Any) -> _numpy.ndarray:
    """Cuts a shape into parts: int32 numbers of parts from 0 on, one per face, or a point of a cloud.

    method: "best" (semantic parts) or "paper" (clusters of similar thickness). remove_outliers: ignore isolated points
    of a cloud, whose numbers are -1. settings: those below, such as parts=3.

    >>> labels = sg.segment(vertices, faces)
    >>> labels = sg.segment(vertices, faces, "paper", field="cone_sdf", parts=4)
    >>> labels = sg.segment(mesh, "paper")
    """
    faces, method = settings_after(vertices, faces, (method, "best"))
    document = _with_settings("segment", {"name": "parts", "method": word(method, "method")}, settings)
    labels, warnings = _native.segment(*shape_arrays(vertices, faces, normals), document,
                                       switch(remove_outliers, "remove_outliers"), number_of_threads(threads))
    warn(warnings)
    return labels


@with_settings([("Descriptors and their settings", listing_of_all("descriptors"))])
def describe(vertices: Any, faces: Any = None, descriptor: str = "light_field", *, normals: Any = None,
             remove_outliers: bool = False, threads: int = 0, **settings: Any) -> _numpy.ndarray:
    """The features of a shape under a descriptor (docs/manual/descriptors.md), float32. The shape is scaled to unit area.

    settings: those of the descriptor, below. remove_outliers: ignore isolated points of a cloud.

    >>> features = sg.describe(vertices, faces, "light_field")
    >>> features = sg.describe(mesh, "d2")
    """
    faces, descriptor = settings_after(vertices, faces, (descriptor, "light_field"))
    shape = shape_arrays(vertices, faces, normals)
    document = _with_settings("describe", {"type": word(descriptor, "descriptor")}, settings)
    try:
        features, warnings = _native.describe(*shape, document, switch(remove_outliers, "remove_outliers"),
                                              number_of_threads(threads))
    except InputError as error:
        raise InputError(str(error).replace("the descriptor: type:", "descriptor:")) from None
    warn(warnings)
    return features
