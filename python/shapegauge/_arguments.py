# SPDX-License-Identifier: GPL-3.0-or-later
"""Validates the arguments of the package's functions, and converts them to NumPy arrays and JSON."""

from __future__ import annotations

import collections as _collections
import collections.abc as _abc
import itertools as _itertools
import math as _math
import numbers as _numbers
import os as _os
import sys as _sys
import warnings as _warnings
from typing import Any, Callable, Iterable, Optional, Union

import numpy as _numpy

from . import _native
from ._native import InputError

PathLike = Union[str, bytes, "_os.PathLike[Any]"]
Progress = Callable[[str, int, int], object]
_PACKAGE = __name__.split(".", maxsplit=1)[0]


def progress_of(on_progress: Optional[Progress]) -> Optional[Progress]:
    """Returns the progress callback, or None."""
    if on_progress is not None and not callable(on_progress):
        raise InputError(f"on_progress must be a function of stage, done and total, not {kind_of(on_progress)}")
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
        raise InputError(f"{name} must be the path of a file, not {kind_of(path)}") from None
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
        raise InputError(f"{name} must be a string, not {kind_of(value)}")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise InputError(f"{name} is {_shown(value)}, which is not Unicode text: it has half of a surrogate pair") from None
    return str(value)


def switch(value: Any, name: str) -> bool:
    """Validates a bool."""
    if not isinstance(value, (bool, _numpy.bool_)):
        raise InputError(f"{name} must be True or False, not {kind_of(value)}")
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
        raise InputError(f"{name} must be a list, not {kind_of(values)}, which has no order")
    if isinstance(values, (str, bytes)) or not isinstance(values, _abc.Iterable):
        raise InputError(f"{name} must be a list, not {kind_of(values)}")
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
    raise InputError(f"{name} must be a number, a string, a bool, a list or a dict, not {kind_of(value)}")


def with_article(noun: str) -> str:
    """Returns the noun with "a" or "an"."""
    return f"{'an' if noun[0] in 'aeiouAEIOU' else 'a'} {noun}"


def kind_of(value: Any) -> str:
    """Returns the type of a value with its article: "a list"."""
    return "None" if value is None else with_article(type(value).__name__)


def _shown(value: Any) -> str:
    return repr(value) if isinstance(value, (str, _numbers.Number)) else kind_of(value)


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
    for index, value in _numpy.ndenumerate(array):
        if not (with_bools if isinstance(value, bools) else isinstance(value, _numbers.Real)):
            where = f"entry {', '.join(map(str, index))} (counted from 0)"
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
    """Rejects pandas objects whose rows are in different orders: they would be matched by position.

    indexes: what each describes and its index, None if it has none. Indexes with different names are not compared.
    """
    known = [(what, index, list(map(_comparable, index))) for what, index in indexes if index is not None]
    for (what, index, names), (other, second, others) in _itertools.combinations(known, 2):
        if names == others or _collections.Counter(names) != _collections.Counter(others):
            continue
        row = next(i for i, (one, two) in enumerate(zip(names, others)) if one != two)
        raise InputError(f"the {what} and the {other} are in different orders: row {row} (counted from 0) is "
                         f"{_shown(index[row])} and {_shown(second[row])}; reindex one like the other")


def shape_text(array: _numpy.ndarray) -> str:
    """Returns the dimensions of an array: "2 x 3"."""
    return " x ".join(map(str, array.shape))


def _exact_doubles(array: _numpy.ndarray, what: str) -> _numpy.ndarray:
    """Returns the array in float64, which rounds integers beyond 2^53: they are rejected."""
    limit = 2**53
    if array.dtype.kind in "iu" and array.size > 0 and max(int(array.max()), -int(array.min())) > limit:
        raise InputError(f"{what} have an integer beyond 2^53, where numbers are rounded; scale them, or give floats")
    return _numpy.ascontiguousarray(array, dtype=_numpy.float64)


def matrix_of(values: Any, what: str) -> _numpy.ndarray:
    """Returns a matrix of float64."""
    array = array_of(values, what)
    if array.ndim != 2:
        raise InputError(f"{what} must be a matrix, not {kind_of(values) if array.ndim == 0 else shape_text(array)}")
    return _exact_doubles(array, what)


def _square_of_condensed(condensed: _numpy.ndarray) -> _numpy.ndarray:
    """Returns the symmetric matrix with these distances above its diagonal, row by row, as SciPy's pdist() has them."""
    models = (1 + _math.isqrt(1 + 8 * len(condensed))) // 2
    if models * (models - 1) // 2 != len(condensed):
        raise InputError(f"distances must be n x n, or the n (n - 1) / 2 of pairs, not {len(condensed)}")
    square = _numpy.zeros((models, models))
    square[_numpy.triu_indices(models, 1)] = condensed
    return square + square.T


def square_matrix(distances: Any, accepts_condensed: bool = False) -> _numpy.ndarray:
    """Returns a square matrix of float64. NaN on the diagonal is 0."""
    array = array_of(distances, "distances")
    if array.ndim == 1 and accepts_condensed:
        return _square_of_condensed(_exact_doubles(array, "distances"))
    if array.ndim != 2 or array.shape[0] != array.shape[1]:
        found = kind_of(distances) if array.ndim == 0 else shape_text(array)
        hint = "; scipy.spatial.distance.squareform() makes a condensed vector square" if array.ndim == 1 else ""
        raise InputError(f"distances must be n x n, not {found}{hint}")
    check_order([("rows of distances", index_of(distances)), ("columns of distances", index_of(distances, "columns"))])
    matrix = _exact_doubles(array, "distances")
    missing = _numpy.flatnonzero(_numpy.isnan(matrix.diagonal()))
    if len(missing) > 0:
        matrix = matrix.copy()
        matrix[missing, missing] = 0
    return matrix
