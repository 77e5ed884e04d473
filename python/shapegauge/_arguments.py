"""Validates the arguments of the package's functions, and converts them to NumPy arrays and JSON."""

from __future__ import annotations

import collections as _collections
import collections.abc as _abc
import functools as _functools
import inspect as _inspect
import itertools as _itertools
import math as _math
import numbers as _numbers
import os as _os
import sys as _sys
import warnings as _warnings
from typing import TYPE_CHECKING, Any, Callable, Iterable, Optional, Tuple, Union

import numpy as _numpy

from . import _native
from ._native import InputError

if TYPE_CHECKING:
    from typing import Concatenate, ParamSpec, Protocol, TypeVar, overload

    Settings = ParamSpec("Settings")
    Result = TypeVar("Result", covariant=True)

    class OfShape(Protocol[Settings, Result]):
        """A function of a shape: of vertices and faces, or of one object that has both."""

        @overload
        def __call__(self, vertices: Any, faces: Any, *args: Settings.args, **kwargs: Settings.kwargs) -> Result: ...
        @overload
        def __call__(self, vertices: Any, *args: Settings.args, **kwargs: Settings.kwargs) -> Result: ...

    class OfPathAndShape(Protocol[Settings, Result]):
        """Like OfShape, with a path as first argument."""

        @overload
        def __call__(self, path: PathLike, vertices: Any, faces: Any, *args: Settings.args,
                     **kwargs: Settings.kwargs) -> Result: ...
        @overload
        def __call__(self, path: PathLike, vertices: Any, *args: Settings.args, **kwargs: Settings.kwargs) -> Result: ...

PathLike = Union[str, bytes, "_os.PathLike[Any]"]
Progress = Callable[[str, int, int], object]
ShapeArrays = Tuple[_numpy.ndarray, _numpy.ndarray, _numpy.ndarray]
_PACKAGE = __name__.split(".", maxsplit=1)[0]


def progress_of(on_progress: Optional[Progress]) -> Optional[Progress]:
    """Returns the progress callback, or None."""
    if on_progress is not None and not callable(on_progress):
        raise InputError(f"on_progress must be a function of stage, done and total, not {_kind(on_progress)}")
    return on_progress


def warn(sentences: Iterable[str], prefix: str = "") -> None:
    """Issues a warning for each sentence at the line that called the package."""
    level, frame = 1, _sys._getframe()
    while frame.f_back is not None and frame.f_globals.get("__name__", "").split(".")[0] == _PACKAGE:
        level, frame = level + 1, frame.f_back
    for sentence in sentences:
        _warnings.warn(prefix + _native.with_arguments(sentence), stacklevel=level)


def path_of(path: Any, name: str) -> str:
    """Returns the path as text."""
    try:
        text = _os.fsdecode(path)
    except TypeError:
        raise InputError(f"{name} must be the path of a file, not {_kind(path)}") from None
    if not text or "\0" in text:
        raise InputError(f"{name} is {text!r}, which is no path of a file")
    return text


def number_of_threads(threads: Any) -> int:
    """Returns the number of threads; 0 means all cores."""
    return whole_number(threads, "threads", 0, _native.most_threads)


def whole_number(value: Any, name: str, low: int, high: int) -> int:
    """Returns a whole number from low to high as an int."""
    is_whole = isinstance(value, _numbers.Integral) and not isinstance(value, bool)
    if not is_whole or not low <= int(value) <= high:
        raise InputError(f"{name} is {_shown(value)}; it must be a whole number from {low} to {high}")
    return int(value)


def word(value: Any, name: str) -> str:
    """Validates a string."""
    if not isinstance(value, str):
        raise InputError(f"{name} must be a string, not {_kind(value)}")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise InputError(f"{name} is {_shown(value)}, which is not Unicode text: it has half of a surrogate pair") from None
    return str(value)


def switch(value: Any, name: str) -> bool:
    """Validates a bool."""
    if not isinstance(value, (bool, _numpy.bool_)):
        raise InputError(f"{name} must be True or False, not {_kind(value)}")
    return bool(value)


def finite_number(value: Any, name: str) -> float:
    """Returns a finite number as a float."""
    is_number = isinstance(value, _numbers.Real) and not isinstance(value, bool)
    try:
        number = float(value) if is_number else _math.nan
    except OverflowError:  # of a large int
        number = _math.inf
    if not _math.isfinite(number):
        raise InputError(f"{name} is {_shown(value)}; it must be a finite number")
    return number


def words(values: Any, name: str) -> list[str]:
    """Returns a list of strings; a single string becomes a list of one."""
    if isinstance(values, str):
        return [str(values)]
    values = ordered(values, name)
    return [word(value, f"{name}[{i}]") for i, value in enumerate(values)]


def ordered(values: Any, name: str) -> list[Any]:
    """Returns the values as a list. Unordered collections are rejected."""
    if isinstance(values, (_abc.Set, _abc.Mapping)):
        raise InputError(f"{name} must be a list, not {_kind(values)}, which has no order")
    if isinstance(values, (str, bytes)) or not isinstance(values, _abc.Iterable):
        raise InputError(f"{name} must be a list, not {_kind(values)}")
    return list(values)


def plain(value: Any, name: str, depth: int = 0) -> Any:
    """A setting as JSON has it: NumPy's scalars and arrays as Python's numbers and lists. depth: of the value."""
    if depth > 100:
        whole = name.split(".", maxsplit=1)[0].split("[", maxsplit=1)[0]
        raise InputError(f"{whole} contains itself, or is nested more than 100 deep")
    if value is None or isinstance(value, (bool, _numpy.bool_)):
        return bool(value) if isinstance(value, _numpy.bool_) else value
    if isinstance(value, str):
        return word(value, name)
    if isinstance(value, _numbers.Integral) and abs(int(value)) < 2**63:
        return int(value)
    if isinstance(value, _numbers.Real):
        return finite_number(value, name)
    if isinstance(value, _numpy.ndarray):
        return plain(value.tolist(), name, depth + 1)
    if isinstance(value, _abc.Mapping):
        return {word(key, f"a key of {name}"): plain(part, f"{name}.{key}", depth + 1)
                for key, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(part, f"{name}[{i}]", depth + 1) for i, part in enumerate(value)]
    raise InputError(f"{name} must be a number, a string, a bool, a list or a dict, not {_kind(value)}")


def with_article(noun: str) -> str:
    """Returns the noun with "a" or "an"."""
    return f"{'an' if noun[0] in 'aeiouAEIOU' else 'a'} {noun}"


def _kind(value: Any) -> str:
    return "None" if value is None else with_article(type(value).__name__)


def _shown(value: Any) -> str:
    return repr(value) if isinstance(value, (str, _numbers.Number)) else _kind(value)


def array_of(values: Any, what: str, with_bools: bool = False) -> _numpy.ndarray:
    """The values as an array of real numbers. Nothing is converted that is not one: complex numbers, text, masks.
    with_bools: bools are the numbers 0 and 1."""
    if _numpy.ma.is_masked(values):
        raise InputError(f"{what} have masked entries; fill them, or leave their rows out")
    try:
        array = _numpy.asarray(values)
    except Exception as error:
        first_line = (str(error).splitlines() or [type(error).__name__])[0]
        raise InputError(f"{what} cannot be made an array: {first_line}") from None
    if array.dtype == object and array.ndim > 0:
        array = _numbers_of_objects(array, what, with_bools)
    if with_bools and array.dtype == bool:
        array = array.astype(_numpy.int64)
    if array.ndim > 0 and array.size > 0 and array.dtype.kind not in "fiu":
        names = {"b": "booleans", "c": "complex numbers", "U": "text", "S": "text"}
        raise InputError(f"{what} must be real numbers, not {names.get(array.dtype.kind, array.dtype)}")
    return array


def _numbers_of_objects(array: _numpy.ndarray, what: str, with_bools: bool) -> _numpy.ndarray:
    bools = (bool, _numpy.bool_)
    for place, value in _numpy.ndenumerate(array):
        if not (with_bools if isinstance(value, bools) else isinstance(value, _numbers.Real)):
            where = f"entry {', '.join(map(str, place))} (counted from 0)"
            raise InputError(f"{what} must be real numbers; {where} is {_shown(value)}")
    whole = array.size > 0 and all(isinstance(value, (_numbers.Integral, *bools)) for value in array.flat)
    try:
        return array.astype(_numpy.int64 if whole else _numpy.float64)
    except OverflowError:
        raise InputError(f"{what} have a number that is too large") from None


def index_of(values: Any, part: str = "index") -> Optional[list[Any]]:
    """Returns the names of the rows (or "columns") of a pandas object; None for others."""
    return list(getattr(values, part)) if hasattr(values, "iloc") and hasattr(values, part) else None


def _comparable(name: Any) -> Any:
    """Returns the name of a row such that missing ones (None, NaN, NaT, pandas.NA) are equal to themselves."""
    if isinstance(name, tuple):
        return tuple(map(_comparable, name))
    try:
        hash(name)
        return name if name == name else None
    except (TypeError, ValueError):  # pandas.NA is neither equal nor unequal; lists have no hash
        return repr(name)


def check_order(indexes: Iterable[tuple[str, Optional[list[Any]]]]) -> None:
    """Rejects pandas objects whose rows are in different orders: they would be taken by position.

    indexes: what each describes and its index, None if it has none. Indexes with different names are not compared.
    """
    known = [(what, index, list(map(_comparable, index))) for what, index in indexes if index is not None]
    for (what, index, names), (other, second, others) in _itertools.combinations(known, 2):
        if names == others or _collections.Counter(names) != _collections.Counter(others):
            continue
        row = next(i for i, (one, two) in enumerate(zip(names, others)) if one != two)
        raise InputError(f"the {what} and the {other} are in different orders: row {row} (counted from 0) is "
                         f"{_shown(index[row])} and {_shown(second[row])}; reindex one like the other")


def _shape_text(array: _numpy.ndarray) -> str:
    return " x ".join(map(str, array.shape))


def _rows(values: Any, what: str, kind: Any) -> _numpy.ndarray:
    array = array_of(values, what)
    if array.ndim == 0:
        raise InputError(f"{what} must be n x 3, not {_kind(values)}")
    if array.size == 0 and array.ndim <= 2 and (array.ndim == 1 or array.shape[0] == 0):
        array = array.reshape(0, 3)
    if array.ndim != 2 or array.shape[1] != 3:
        hint = "; split polygons into triangles first" if what == "faces" and array.ndim == 2 else ""
        raise InputError(f"{what} must be n x 3, not {_shape_text(array)}{hint}")
    if kind is _numpy.int32 and array.size > 0:
        if array.dtype.kind not in "iu":
            raise InputError(f"{what} must be whole numbers, not {array.dtype}; convert them with astype(int)")
        if not (0 <= array.min() and array.max() < 2**31):
            raise InputError(f"{what} must be vertex indices from 0 on")
    return _numpy.ascontiguousarray(array, dtype=kind)


def matrix_of(values: Any, what: str) -> _numpy.ndarray:
    """Returns a matrix of float64."""
    array = array_of(values, what)
    if array.ndim != 2:
        raise InputError(f"{what} must be a matrix, not {_kind(values) if array.ndim == 0 else _shape_text(array)}")
    return _numpy.ascontiguousarray(array, dtype=_numpy.float64)


def square_matrix(distances: Any) -> _numpy.ndarray:
    """Returns a square matrix of float64."""
    array = array_of(distances, "distances")
    if array.ndim != 2 or array.shape[0] != array.shape[1]:
        given = _kind(distances) if array.ndim == 0 else _shape_text(array)
        hint = "; scipy.spatial.distance.squareform() makes a condensed vector square" if array.ndim == 1 else ""
        raise InputError(f"distances must be n x n, not {given}{hint}")
    check_order([("rows of distances", index_of(distances)), ("columns of distances", index_of(distances, "columns"))])
    return _numpy.ascontiguousarray(array, dtype=_numpy.float64)


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
            raise InputError(f"{_kind(mesh)} has cells of several kinds; give its points and its triangles")
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
    """Vertices, faces and normals as arrays, from arrays or from one object in the place of vertices."""
    if is_shape_object(vertices):
        if faces is not None:
            raise InputError(f"the {type(vertices).__name__} brings its faces along; leave faces out")
        vertices, faces, own_normals = _arrays_of_object(vertices)
        is_cloud = faces is None or len(faces) == 0
        normals = own_normals if normals is None and is_cloud else normals
    vertices = _rows(vertices, "vertices", _numpy.float64)
    faces = _rows([] if faces is None else faces, "faces", _numpy.int32)
    normals = _rows([] if normals is None else normals, "normals", _numpy.float64)
    if len(normals) > 0 and len(faces) > 0:
        raise InputError("normals are for point clouds; a mesh has its own: leave normals out")
    if len(normals) > 0 and len(normals) != len(vertices):
        raise InputError(f"there are {len(normals)} normals for {len(vertices)} points")
    return vertices, faces, normals


def of_shape(leading: int = 0) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Decorates a function of a shape's arrays and settings, so that callers pass vertices and faces, or one object
    that has both. `leading`: number of arguments before the shape.

    Arguments are bound once for both forms: what follows the shape is the same, and what is left over is an error.
    """

    def decorate(function: Callable[..., Any]) -> Callable[..., Any]:
        parameters = list(_inspect.signature(function).parameters.values())
        before, settings = parameters[:leading], parameters[leading + 1:]
        kind = _inspect.Parameter.POSITIONAL_OR_KEYWORD
        of_settings = _inspect.Signature(before + settings)
        signature = _inspect.Signature(
            [*before, _inspect.Parameter("vertices", kind), _inspect.Parameter("faces", kind, default=None), *settings])

        @_functools.wraps(function)
        def call(*arguments: Any, **keywords: Any) -> Any:
            first, rest = list(arguments[:leading]), list(arguments[leading:])
            if "vertices" in keywords:
                rest.insert(0, keywords.pop("vertices"))
            if not rest:
                raise TypeError(f"{function.__name__}() needs vertices, or an object that has them")
            vertices = rest.pop(0)
            # What follows a cloud's points may be a setting: neither words nor numbers are faces.
            stands_alone = is_shape_object(vertices) and (not rest or rest[0] is not None)
            stands_alone = stands_alone or "faces" in keywords or not rest or isinstance(rest[0], (str, _numbers.Number))
            faces = keywords.pop("faces", None) if stands_alone else rest.pop(0)
            try:
                bound = of_settings.bind(*first, *rest, **keywords)
            except TypeError as error:
                raise TypeError(f"{function.__name__}(): {error}; its arguments are {signature}") from None
            arrays = shape_arrays(vertices, faces, bound.arguments.get("normals"))
            return function(*bound.args[:leading], arrays, *bound.args[leading:], **bound.kwargs)

        setattr(call, "__signature__", signature)
        return call

    return decorate


if TYPE_CHECKING:

    def shape_function(function: Callable[Concatenate[ShapeArrays, Settings], Result]) -> OfShape[Settings, Result]: ...

    def path_and_shape_function(
            function: Callable[Concatenate[PathLike, ShapeArrays, Settings], Result]
    ) -> OfPathAndShape[Settings, Result]: ...
else:
    shape_function = of_shape()
    path_and_shape_function = of_shape(leading=1)
