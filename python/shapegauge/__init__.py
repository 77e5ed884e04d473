"""Shape diameter function, shape signatures and retrieval evaluation.

Arrays are NumPy's: vertices are n x 3 floats, faces m x 3 vertex indices, points n x 3 floats, distances n x n floats.
Wherever vertices are asked for, an object with ``vertices`` and ``faces`` (trimesh), with ``vertices`` and ``triangles``
or with ``points`` (Open3D) does as well, and then stands alone. A shape without faces is a point cloud.

Unusable input raises InputError, a ValueError that says what is wrong. Values are the same bytes as the command line's,
for any number of threads.
"""

import collections
import json as _json
import os as _os
import warnings as _warnings

import numpy as _numpy

from . import _native
from ._native import InputError

__all__ = [
    "Comparison", "InputError", "Run", "Scores", "Shape", "compare", "describe", "evaluate", "field", "normals", "read",
    "rerank", "run", "sdf", "segment", "write",
]
__version__ = _native.version()


class Shape(collections.namedtuple("Shape", ["vertices", "faces", "normals"])):
    """Arrays of a shape: vertices (n x 3), faces (m x 3; none: a point cloud), normals of points (n x 3, or none)."""

    __slots__ = ()

    def __repr__(self):
        if len(self.faces) == 0:
            return f"<Shape: {len(self.vertices)} points>"
        return f"<Shape: {len(self.vertices)} vertices, {len(self.faces)} faces>"


def _shape(vertices, faces=None, normals=None):
    """The arrays of a shape, from arrays or from an object that has them."""
    if faces is None:
        for name in ("faces", "triangles"):
            if hasattr(vertices, name) and hasattr(vertices, "vertices"):
                return _shape(vertices.vertices, getattr(vertices, name),
                              normals if normals is not None else getattr(vertices, "normals", None))
        if hasattr(vertices, "points"):
            given = getattr(vertices, "normals", None)
            return _shape(vertices.points, None, normals if normals is not None else given)
    vertices = _rows(vertices, "vertices", _numpy.float64)
    faces = _rows([] if faces is None else faces, "faces", _numpy.int32)
    normals = _rows([] if normals is None or len(faces) > 0 else normals, "normals", _numpy.float64)
    if len(normals) > 0 and len(normals) != len(vertices):
        raise InputError(f"there are {len(normals)} normals for {len(vertices)} points")
    return Shape(vertices, faces, normals)


def _alone(faces, word):
    """An object stands alone: the word in the place of its faces is the one that comes after them."""
    return (None, faces) if isinstance(faces, str) else (faces, word)


def _rows(values, what, kind):
    array = _numpy.asarray(values)
    if array.ndim == 0:
        raise InputError(f"{what} must be n x 3, not a single {type(values).__name__}")
    if array.size == 0:
        array = array.reshape(0, 3)
    if array.ndim != 2 or array.shape[1] != 3:
        raise InputError(f"{what} must be n x 3, not {' x '.join(map(str, array.shape))}")
    if kind is _numpy.int32:
        whole = _numpy.issubdtype(array.dtype, _numpy.integer) or array.size == 0
        if not whole:
            raise InputError(f"{what} must be whole numbers, not {array.dtype}")
        if array.size > 0 and not (0 <= array.min() and array.max() < 2**31):
            raise InputError(f"{what} must be vertex indices from 0 on")
    return _numpy.ascontiguousarray(array, dtype=kind)


def _square(distances):
    array = _numpy.ascontiguousarray(distances, dtype=_numpy.float64)
    if array.ndim != 2 or array.shape[0] != array.shape[1]:
        raise InputError(f"distances must be n x n, not {' x '.join(map(str, array.shape))}")
    return array


def read(path):
    """The shape in a file: OFF, OBJ, PLY, STL, or a point cloud (XYZ and others). Polygons are triangulated.

    >>> sg.read("hand.off")
    <Shape: 5000 vertices, 9996 faces>
    """
    return Shape(*_native.read(_os.fspath(path)))


def write(path, vertices, faces=None, normals=None):
    """Writes a shape; the extension tells the format.

    >>> sg.write("hand.ply", *sg.read("hand.off"))
    """
    _native.write(_os.fspath(path), *_shape(vertices, faces, normals))


def field(vertices, faces=None, type="offset_sdf", *, at="faces", normals=None, threads=0, **settings):
    """A scalar field of any type that configurations know (docs/configuration.md), in the units of the input.

    at: "faces", "vertices" or {"surface": n}; a cloud has its values at its points. settings: those of the type.
    Returns (values, weights): float64, one a sample; NaN where there is no value. The weights are areas.

    >>> values, weights = sg.field(mesh, "centricity", sources=24)
    """
    faces, type = _alone(faces, type)
    values, weights, _, _ = _field(_shape(vertices, faces, normals), type, at, settings, threads)
    return values, weights


def _field(shape, type, at, settings, threads):
    settings = {"type": type, "at": at, **settings}
    values, weights, normals, warnings, offset = _native.field(*shape, _json.dumps(settings), threads)
    for warning in warnings:
        _warnings.warn(warning, stacklevel=3)
    return values, weights, normals, offset


def sdf(vertices, faces=None, method="offset", *, offset=0.05, accuracy="standard", at="faces", rays=25,
        opening_angle=60, engine="embree", normals=None, threads=0):
    """The shape diameter function, in the units of the input.

    method: "offset" (of the offset surface: noise, cracks and point clouds do no harm) or "cone" (the conventional one,
    closed meshes). offset: a fraction of the diagonal of the bounding box, or "auto"; accuracy: "fast", "standard" or
    "fine", how fine its grid is. rays, opening_angle (degrees) and engine ("embree", "cgal") are the cone's. Returns
    (values, weights) as field().

    >>> values, weights = sg.sdf(vertices, faces, method="offset", offset=0.05, at="faces")
    >>> values, weights = sg.sdf(points, offset="auto")
    >>> values, weights = sg.sdf(mesh, "cone")
    """
    faces, method = _alone(faces, method)
    shape = _shape(vertices, faces, normals)
    if method == "offset":
        return _field(shape, "offset_sdf", at, {"offset": offset, "accuracy": accuracy}, threads)[:2]
    if method == "cone":
        settings = {"rays": rays, "opening_angle_degrees": opening_angle, "engine": engine}
        return _field(shape, "cone_sdf", at, settings, threads)[:2]
    raise InputError(f'method must be "offset" or "cone", not {method!r}')


def normals(vertices, faces=None, *, offset="auto", at="vertices", threads=0):
    """Outward unit normals by the offset surface, n x 3, however noisy, cracked or turned the input is.

    >>> sg.normals(points).shape
    (5000, 3)
    """
    return _field(_shape(vertices, faces), "offset_sdf", at, {"offset": offset}, threads)[2]


def segment(vertices, faces=None, method="best", *, normals=None, threads=0, **settings):
    """Cuts a shape into parts: int32 numbers of parts from 0 on, one a face, or a point of a cloud.

    method: "best", or the paper's pipeline, "paper". settings: those of a method in a configuration
    (docs/configuration.md, "Segmentation"), as parts=3: how many are wanted.

    >>> labels = sg.segment(vertices, faces)
    >>> labels = sg.segment(vertices, faces, "paper", field="cone", parts=4)
    >>> labels = sg.segment(mesh, "paper")
    """
    faces, method = _alone(faces, method)
    settings = _json.dumps({"name": "parts", "method": method, **settings})
    return _native.segment(*_shape(vertices, faces, normals), settings, threads)


def describe(vertices, faces=None, descriptor="light_field", *, normals=None, threads=0, **settings):
    """The features of a shape under a descriptor (docs/descriptors.md), float32. The shape is scaled to unit area.

    >>> features = sg.describe(vertices, faces, "light_field")
    >>> features = sg.describe(mesh, "d2")
    """
    faces, descriptor = _alone(faces, descriptor)
    shape = _shape(vertices, faces, normals)
    return _native.describe(*shape, _json.dumps({"type": descriptor, **settings}), threads)


class Scores(collections.abc.Mapping):
    """Scores of a distance matrix, fractions from 0 to 1. scores["FT"] is the mean over queries.

    micro, macro: measure -> mean over queries, over classes. per_query: measure -> array, by `queries` (rows of the
    matrix). per_class: class -> measure -> mean. recall, precision: the curve.
    """

    def __init__(self, native, class_names, name):
        self._native = native
        self._name = name
        self.protocol = native.protocol
        self.measures = list(native.measures)
        self.micro = dict(zip(self.measures, native.micro.tolist()))
        self.macro = dict(zip(self.measures, native.macro.tolist()))
        self.queries = _numpy.array(native.queries)
        self.per_query = {measure: native.per_query[:, k].copy() for k, measure in enumerate(self.measures)}
        self.per_class = {
            class_names[label]: dict(zip(self.measures, row.tolist()))
            for label, row in zip(native.classes, native.per_class)
        }
        self.recall = _numpy.array(native.recall)
        self.precision = _numpy.array(native.precision)

    def __getitem__(self, measure):
        if measure not in self.micro:
            raise KeyError(f"{measure}; there are {', '.join(self.measures)}")
        return self.micro[measure]

    def __iter__(self):
        return iter(self.micro)

    def __len__(self):
        return len(self.micro)

    def __repr__(self):
        return self._native.table(self._name, "text").rstrip("\n")

    def _repr_html_(self):
        cells = "".join(f"<th>{measure}</th>" for measure in self.measures)
        rows = "".join(
            f"<tr><th>{name}</th>" + "".join(f"<td>{100 * value:.2f}</td>" for value in scores.values()) + "</tr>"
            for name, scores in (("micro", self.micro), ("macro", self.macro)))
        return f"<table><tr><th>{self.protocol}, %</th>{cells}</tr>{rows}</table>"

    def to_latex(self):
        """The table for a paper."""
        return self._native.table(self._name, "latex")

    def to_markdown(self):
        """The table for a README."""
        return self._native.table(self._name, "markdown")

    def to_csv(self):
        """The table for other programs."""
        return self._native.table(self._name, "csv")


def _labels(labels, models):
    names, numbers = _numpy.unique(_numpy.asarray(labels), return_inverse=True)
    if len(numbers) != models:
        raise InputError(f"there are {len(numbers)} labels for {models} models")
    return names.tolist(), numbers.tolist()


def evaluate(distances, labels, protocol="psb", *, measures=(), ties="index", minimum_class_size=2, threads=0,
             name="method"):
    """Evaluates distances against the classes of the models: row i and column i are the model of labels[i].

    protocol: "psb", "paper" or "trec". measures: names such as "FT" or "P@10"; none: the protocol's own. ties: the order
    of models at equal distance, "index", "optimistic", "pessimistic" or "expected". What is odd about the matrix is
    warned of. Returns Scores.

    >>> scores = sg.evaluate(distances, labels)
    >>> scores["FT"], scores.macro["NN"], scores.per_query["DCG"].mean()
    """
    matrix = _square(distances)
    names, numbers = _labels(labels, len(matrix))
    native, odd = _native.evaluate(matrix, numbers, protocol, ties, list(measures), minimum_class_size, threads)
    for sentence in odd:
        _warnings.warn(sentence, stacklevel=2)
    return Scores(native, names, name)


class Comparison:
    """Methods side by side. results: settings, averages and pairs, as `shapegauge compare --format json` has them."""

    def __init__(self, native):
        self._native = native
        self.results = _json.loads(native.json())

    def __repr__(self):
        return (self._native.summary("text") + "\n" + self._native.pairs("text")).rstrip("\n")

    def to_latex(self):
        """The methods with intervals and marks, for a paper."""
        return self._native.summary("latex")

    def to_markdown(self):
        """The methods, then all pairs."""
        return self._native.summary("markdown") + "\n" + self._native.pairs("markdown")

    def to_csv(self):
        """All pairs, for other programs."""
        return self._native.pairs("csv")


def compare(methods, labels, protocol="psb", *, measures=(), test="randomization", confidence=0.95, resamples=10000,
            seed=1, ties="index", minimum_class_size=2, threads=0):
    """Compares methods on the same queries. methods: name -> distances. Classes are resampled as a whole.

    Returns Comparison: intervals of the averages, and for each pair its difference, p-values and effect size.

    >>> sg.compare({"a": first, "b": second}, labels, measures=["FT", "DCG"])
    """
    if len(methods) < 2:
        raise InputError("a comparison takes two methods or more")
    scores = [
        evaluate(distances, labels, protocol, measures=measures, ties=ties, minimum_class_size=minimum_class_size,
                 threads=threads) for distances in methods.values()
    ]
    evaluations = [one._native for one in scores]
    return Comparison(
        _native.compare(list(map(str, methods)), evaluations, test, confidence, resamples, seed, threads))


def rerank(distances, method="diffusion", *, threads=0, **settings):
    """Distances, improved by what they say of the whole set; no labels are used. The result is n x n.

    method: "diffusion" (neighbours, damping, tie), "k_reciprocal" or "query_expansion".

    >>> better = sg.rerank(distances, neighbours=10)
    """
    return _native.rerank(_square(distances), method, _json.dumps(settings), threads)


class Run(collections.namedtuple("Run", ["folder", "summary", "left_out"])):
    """A finished experiment: the folder of its results, the summary as text, and the models it went on without."""

    __slots__ = ()

    def __repr__(self):
        return f"{self.summary}\nResults in {self.folder}"


def run(configuration, output=None, *, settings=(), replace=False, cache=None, threads=0):
    """Runs an experiment from its configuration, as `shapegauge run`.

    output: the folder for the results; by default results/<name of the file>. settings: changes, as in
    ["signatures.0.histogram.bins=40"]. cache: its folder; "": none. Ctrl-C stops it; what is done is in the cache.

    >>> sg.run("configs/quickstart.json")
    """
    configuration = _os.fspath(configuration)
    if output is None:
        output = _os.path.join("results", _os.path.splitext(_os.path.basename(configuration))[0])
    done = _native.run(configuration, list(settings), _os.fspath(output), replace,
                       None if cache is None else _os.fspath(cache), threads)
    for sentence in done.warnings + [f"left out {one}" for one in done.left_out]:
        _warnings.warn(sentence, stacklevel=2)
    return Run(_os.fspath(output), done.summary, done.left_out)
