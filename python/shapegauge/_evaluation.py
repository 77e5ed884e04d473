# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances: evaluation, comparison, re-ranking."""

from __future__ import annotations

import collections.abc as _abc
import dataclasses as _dataclasses
import json as _json
import numbers as _numbers
from typing import TYPE_CHECKING, Any, Callable, Iterable, Iterator, Mapping, Optional, Sequence, Union

import numpy as _numpy

from . import _native
from ._arguments import (array_of, check_order, finite_number, index_of, matrix_of, number_of_threads, ordered, plain,
                         square_matrix, switch, warn, with_article, word, words)
from ._native import InputError
from ._settings import REGISTERED, listing_of_all, number_of, settings_of, with_settings

if TYPE_CHECKING:
    import matplotlib.axes
    import pandas

Intervals = Mapping[str, "tuple[float, float]"]


class Scores(_abc.Mapping):
    """Scores of a distance matrix, fractions from 0 to 1. scores["FT"] is the mean over queries.

    micro, macro: measure -> mean over queries, over classes. per_query: measure -> array, by `queries` (rows of the
    matrix). per_class: class -> measure -> mean. recall, precision: precision-recall curve. intervals: "micro" and
    "macro" -> measure -> low and high end, if evaluate() had a confidence. queries_with_ties: number of queries with
    relevant and other models at equal distance. models_left_out: number of models whose classes are too small for queries.
    """

    def __init__(self, native: _native.Evaluation, class_names: Sequence[Any], name: str,
                 intervals: Optional[Mapping[str, Intervals]] = None) -> None:
        self._native = native
        self._name = name
        self.protocol = native.protocol
        self.measures = list(native.measures)
        self.micro: dict[str, float] = dict(zip(self.measures, map(float, native.micro)))
        self.macro: dict[str, float] = dict(zip(self.measures, map(float, native.macro)))
        self.queries = _numpy.array(native.queries)
        self.query_classes = [class_names[label] if label >= 0 else None for label in native.query_classes]
        self.per_query = {measure: native.per_query[:, k].copy() for k, measure in enumerate(self.measures)}
        self.per_class: dict[Any, dict[str, float]] = {
            class_names[label]: dict(zip(self.measures, map(float, row)))
            for label, row in zip(native.classes, native.per_class) if label >= 0
        }
        self.recall = _numpy.array(native.recall)
        self.precision = _numpy.array(native.precision)
        self.intervals = dict(intervals or {})
        self.queries_with_ties = native.queries_with_ties
        self.models_left_out = native.models_left_out

    def __getitem__(self, measure: str) -> float:
        if measure not in self.micro:
            raise KeyError(f"{measure}; there are {', '.join(self.measures)}")
        return self.micro[measure]

    def __iter__(self) -> Iterator[str]:
        return iter(self.micro)

    def __len__(self) -> int:
        return len(self.micro)

    def __repr__(self) -> str:
        return self._native.table(self._name, "table").rstrip("\n")

    def _repr_html_(self) -> str:
        cells = "".join(f"<th>{measure}</th>" for measure in self.measures)
        rows = "".join(
            f"<tr><th>{name}</th>" + "".join(f"<td>{100 * value:.2f}</td>" for value in scores.values()) + "</tr>"
            for name, scores in (("micro", self.micro), ("macro", self.macro)))
        return f"<table><tr><th>{self.protocol}, %</th>{cells}</tr>{rows}</table>"

    def to_latex(self) -> str:
        """Returns the table as LaTeX."""
        return self._native.table(self._name, "latex")

    def to_markdown(self) -> str:
        """Returns the table as Markdown."""
        return self._native.table(self._name, "markdown")

    def to_csv(self) -> str:
        """Returns the table as CSV."""
        return self._native.table(self._name, "csv")

    def to_frame(self) -> pandas.DataFrame:
        """Returns a pandas frame with a row for each query: its class, then its measures."""
        import pandas
        rows = pandas.Index(self.queries, name="query")
        columns: dict[str, Any] = {"class": self.query_classes, **self.per_query}
        return pandas.DataFrame(columns, index=rows)

    def plot(self, ax: Optional[matplotlib.axes.Axes] = None, **options: Any) -> matplotlib.axes.Axes:
        """Draws the precision-recall curve into matplotlib axes, or new ones. options: those of Axes.plot()."""
        if ax is None:
            from matplotlib import pyplot
            ax = pyplot.figure().add_subplot()
            ax.set(xlabel="Recall", ylabel="Precision", xlim=(0, 1), ylim=(0, 1.02))
            ax.grid(alpha=0.3)
        ax.plot(self.recall, self.precision, **{"label": self._name, **options})
        ax.legend()
        return ax


def _is_missing(label: Any) -> bool:
    """Returns True for a missing label: None, NaN, pandas.NA, NaT, a masked entry, empty text."""
    if label is None or label is _numpy.ma.masked:
        return True
    if isinstance(label, (str, bytes)):
        return not label.strip()
    try:
        return bool(label != label)
    except TypeError:  # the truth of pandas.NA
        return True
    except ValueError:  # that of an array, which is no label either
        return False


def _label(label: Any, row: str, noun: str = "label") -> Any:
    """Converts a label to a number or text."""
    if isinstance(label, (bool, _numpy.bool_, str)):
        return str(label).strip() if isinstance(label, str) else bool(label)
    if isinstance(label, bytes):
        return label.decode("utf-8", "replace").strip()
    if isinstance(label, _numbers.Integral):
        return int(label)
    if isinstance(label, _numbers.Real):
        if not float(label).is_integer():
            raise InputError(f"the {noun} of row {row} is {label}; it must be a whole number or text")
        return int(float(label))
    if isinstance(label, (_abc.Iterable, _numbers.Complex)):
        kind = with_article(type(label).__name__)
        raise InputError(f"the {noun} of row {row} is {kind}; it must be a whole number or text")
    return str(label)


def _rows_text(rows: Sequence[Any]) -> str:
    """Returns "row 3", or "rows 3, 5" with at most ten rows."""
    listed = ", ".join(map(str, rows[:10])) + (f" and {len(rows) - 10} more" if len(rows) > 10 else "")
    return f"{'row' if len(rows) == 1 else 'rows'} {listed}"


def _check_text(array: _numpy.ndarray, nouns: str) -> None:
    """Rejects missing values that NumPy has made text: np.array(["a", nan])."""
    texts = [label.decode("utf-8", "replace") if isinstance(label, bytes) else label for label in array.tolist()]
    for text in _native.missing_value_words:
        made = [row for row, label in enumerate(texts) if label == text]
        if made:
            raise InputError(f'the text of the {nouns} is "{text}" in {_rows_text(made)} (counted from 0): NumPy makes it '
                             "of missing values; give a list, or an array of dtype=object")


def _check_kinds(classes: Sequence[Any], row_text: Callable[[int], str]) -> None:
    """Rejects labels that differ only in their type: 1 and "1", 1 and True."""
    first: dict[str, tuple[int, Any]] = {}
    for row, label in enumerate(classes):
        if label is None:
            continue
        for text in {str(label), str(int(label)) if isinstance(label, bool) else str(label)}:
            earlier, other = first.setdefault(text, (row, label))
            if type(other) is not type(label):
                raise InputError(f"the labels of rows {row_text(earlier)} and {row_text(row)} (counted from 0) are "
                                 f"{other!r} and {label!r}, which differ only in type; convert them to one type")


def _label_list(labels: Any, nouns: str = "labels") -> list[Any]:
    """The labels in their order; a column or a row of a table is one dimension."""
    if hasattr(labels, "__array__") and not isinstance(labels, _numpy.generic):
        array = labels if isinstance(labels, _numpy.ndarray) else _numpy.asarray(labels)
        if array.ndim == 0:
            raise InputError(f"{nouns} must be a list, not a single value")
        if array.ndim > 1 and (array.size == 0 or max(array.shape) != array.size):
            raise InputError(f"{nouns} must have one dimension, not be {' x '.join(map(str, array.shape))}; of a table "
                             "with a column for each class, take the argmax of its rows")
        flat = array.ravel()
        if flat.dtype.kind in "US":
            _check_text(flat, nouns)
        mask = _numpy.ma.getmaskarray(flat) if isinstance(flat, _numpy.ma.MaskedArray) else _numpy.zeros(len(flat), bool)
        return [None if hidden else label for label, hidden in zip(_numpy.asarray(flat).tolist(), mask)]
    return ordered(labels, nouns)


def _listed(labels: Any) -> Any:
    """Returns the labels such that they can be read several times: a generator gives them once."""
    return labels if labels is None or hasattr(labels, "__array__") else ordered(labels, "labels")


_MISSING_LABELS = ("error", "no_class")


def _class_numbers(labels: Any, models: int, missing_labels: str, noun: str = "labels",
                   targets_from: Optional[int] = None) -> tuple[list[Any], list[int]]:
    """The names of the classes, ascending, and each model's number among them, -1 where it has none. Labels from the
    index targets_from on are those of targets."""
    def row_text(row: int) -> str:
        if targets_from is None:
            return str(row)
        return f"{row} of labels" if row < targets_from else f"{row - targets_from} of targets"

    if missing_labels not in _MISSING_LABELS:
        raise InputError(f'missing_labels must be "error" or "no_class", not {missing_labels!r}')
    labels = _label_list(labels)
    if len(labels) != models:
        raise InputError(f"there are {len(labels)} {noun} for {models} models")
    missing = [row for row, label in enumerate(labels) if _is_missing(label)]
    if missing and missing_labels == "error":
        found = "label is missing" if len(missing) == 1 else "labels are missing"
        raise InputError(f"{len(missing)} {found}, in {_rows_text(list(map(row_text, missing)))} (counted from 0); leave "
                         'these models out, or use missing_labels="no_class": they are then neither queries nor relevant')
    hidden = set(missing)
    classes: list[Any] = [None if row in hidden else _label(label, row_text(row)) for row, label in enumerate(labels)]
    _check_kinds(classes, row_text)
    if len({type(label) is str for row, label in enumerate(classes) if row not in hidden}) == 2:
        classes = [label if label is None else str(label) for label in classes]  # numbers and text are text
    names = sorted({label for row, label in enumerate(classes) if row not in hidden})
    for text in _native.missing_value_words:
        rows = [row_text(row) for row, label in enumerate(classes) if label == text]
        if rows:
            warn([f'the label of {_rows_text(rows)} (counted from 0) is the text "{text}", which many programs write for '
                  'missing values; if these models are unlabelled, give None and missing_labels="no_class"'])
    number_of = {name: number for number, name in enumerate(names)}
    return names, [-1 if row in hidden else number_of[label] for row, label in enumerate(classes)]


def evaluate(distances: Any, labels: Any = None, protocol: Optional[str] = None, *, measures: Union[str, Iterable[str]] = (),
             ties: str = "index", minimum_class_size: int = 2, similarity: bool = False, missing_labels: str = "error",
             threads: int = 0, name: str = "method", distance: Optional[str] = None, targets: Any = None,
             subclasses: Any = None, relevance: Any = None, curve: str = "", evaluator: str = "",
             confidence: Optional[float] = None, blocks: str = "classes", resamples: int = 10000, seed: int = 1) -> Scores:
    """Evaluates distances against the classes of the models: labels[i] is the class of row i and column i.

    distances: n x n floats, or those of pairs as SciPy's pdist() has them; or, with `distance`, features, one row per
    model. distance: distance between features, such as "l2", or the name of a descriptor. similarity: larger is more
    similar. labels: text or integers. protocol: "psb" (a query is removed from its list), "paper" (it is the first hit)
    or "trec" (as psb, with measures of text retrieval; default with relevance). measures: such as ["NN", "P@10"]
    (default: those of the protocol). ties: order at equal distance: "index", "optimistic" (relevant models first),
    "pessimistic" (last) or "expected" (mean over all orders). minimum_class_size: queries of smaller classes are
    omitted. missing_labels: "error", or "no_class": a model without a label is neither a query nor relevant. targets:
    labels of the columns, if these are other models than the rows. subclasses: subclass of each model, for nDCG@N;
    None, "" or the label of the model: none. relevance: n x n grades instead of labels, 0 for not relevant, negative
    for not judged. curve: interpolation of precision and recall as in "psb", "paper", "trec" or "trec_eval", or "raw"
    for none (default: that of the protocol). evaluator: program to reproduce, such as "shrec21", instead of protocol,
    measures, ties and minimum_class_size. confidence: level of `intervals`, such as 0.95 (default: no intervals).
    blocks: unit of resampling, "classes" or "queries". resamples, seed: number and seed of the resamples. threads: 0
    for all cores. name: shown in tables.

    >>> scores = sg.evaluate(distances, labels, protocol="psb")
    >>> scores["FT"]
    0.9144
    """
    if evaluator and (protocol is not None or measures or ties != "index" or minimum_class_size != 2 or curve):
        raise InputError("an evaluator determines protocol, measures, ties, minimum_class_size and curve; omit these")
    if protocol is None:
        protocol = "psb" if relevance is None else "trec"
    settings = _Settings(protocol, measures, ties, minimum_class_size, similarity, missing_labels, distance, threads,
                         targets, subclasses, relevance, curve, evaluator)
    scores = _evaluate(distances, labels, settings, word(name, "name"))
    if confidence is not None:
        low_and_high = _native.intervals(scores._native, _number(confidence, "confidence"), word(blocks, "blocks"),
                                         _number(resamples, "resamples"), _number(seed, "seed"),
                                         number_of_threads(threads))
        if not low_and_high[0]:
            warn([f"no intervals: fewer than two {blocks}"])
        scores.intervals = {average: dict(zip(scores.measures, ends))
                            for average, ends in zip(("micro", "macro"), low_and_high) if ends}
    return scores


def _number(value: Any, name: str) -> Any:
    """Returns a number within the bounds of an option of comparisons."""
    return number_of(value, name, REGISTERED["options"]["compare"][name])


def _distances_of(distances: Any, distance: Optional[str], rectangular: bool, threads: int,
                  prefix: str = "") -> _numpy.ndarray:
    if distance is None:
        return matrix_of(distances, "distances") if rectangular else square_matrix(distances, accepts_condensed=True)
    features = matrix_of(distances, "features")
    warning = _native.check_features(features)
    with _numpy.errstate(over="ignore"):  # infinite features are refused
        single = features.astype(_numpy.float32)
    found = _native.feature_distances(single, word(distance, "distance"), number_of_threads(threads))
    warn([] if warning is None else [warning], prefix)
    return found


def _grades(relevance: Any, shape: tuple[int, ...]) -> _numpy.ndarray:
    grades = array_of(relevance, "grades of relevance", with_bools=True)
    if grades.ndim == 0:
        raise InputError(f"relevance must be a matrix, not {with_article(type(relevance).__name__)}")
    if grades.shape != shape:
        raise InputError(f"relevance is {' x '.join(map(str, grades.shape))} for distances of "
                         f"{' x '.join(map(str, shape))}")
    if not (grades == _numpy.round(grades)).all():
        raise InputError("relevance must be whole numbers or bools")
    limits = _numpy.iinfo(_numpy.int32)
    outside = _numpy.argwhere((grades < limits.min) | (grades > limits.max))
    if len(outside) > 0:
        row, column = outside[0]
        raise InputError(f"relevance has the grade {grades[row, column]} in row {row}, column {column} (counted from 0); "
                         f"grades are whole numbers from {limits.min} to {limits.max}")
    return _numpy.ascontiguousarray(grades, dtype=_numpy.int32)


def _subclass_numbers(subclasses: Any, labels: Any) -> list[int]:
    """Numbers of the subclasses, -1 for none; empty if there are none at all."""
    if subclasses is None:
        return []
    def texts(values: list[Any], noun: str) -> list[str]:
        return ["" if _is_missing(value) else str(_label(value, str(row), noun)) for row, value in enumerate(values)]

    names, of_models = texts(_label_list(subclasses, "subclasses"), "subclass"), texts(_label_list(labels), "label")
    if len(names) != len(of_models):
        raise InputError(f"there are {len(names)} subclasses for {len(of_models)} models")
    numbers: dict[str, int] = {}
    return [-1 if name in ("", label) else numbers.setdefault(name, len(numbers))
            for name, label in zip(names, of_models)]


@_dataclasses.dataclass
class _Settings:
    """Settings of an evaluation, as evaluate() describes them."""

    protocol: str
    measures: Any
    ties: str
    minimum_class_size: int
    similarity: bool
    missing_labels: str
    distance: Optional[str]
    threads: int
    targets: Any = None
    subclasses: Any = None
    relevance: Any = None
    curve: str = ""
    evaluator: str = ""


def _check_arguments(distances: Any, labels: Any, settings: _Settings) -> None:
    """Rejects arguments that exclude each other, and pandas objects in different orders."""
    targets, relevance, subclasses = settings.targets, settings.relevance, settings.subclasses
    if settings.distance is not None and settings.similarity:
        raise InputError("distance applies to features, which are not similarities; omit similarity")
    if labels is None and relevance is None:
        raise InputError("labels are None; pass labels, or relevance instead")
    if labels is not None and relevance is not None:
        raise InputError("labels and relevance exclude each other; omit one")
    if subclasses is not None and (targets is not None or relevance is not None):
        raise InputError("subclasses require the same models in rows and columns; with targets use relevance instead")
    check_order([("rows of " + ("distances" if settings.distance is None else "features"), index_of(distances)),
                 ("labels", index_of(labels)), ("subclasses", index_of(subclasses)),
                 ("rows of relevance", index_of(relevance))])
    if settings.distance is None:
        check_order([("columns of distances", index_of(distances, "columns")), ("targets", index_of(targets)),
                     ("columns of relevance", index_of(relevance, "columns"))])


def _evaluate(distances: Any, labels: Any, settings: _Settings, name: str, prefix: str = "") -> Scores:
    """Evaluates one matrix. prefix: of warnings."""
    settings.similarity = switch(settings.similarity, "similarity")
    labels = _listed(labels)
    _check_arguments(distances, labels, settings)
    targets, relevance = settings.targets, settings.relevance
    rectangular = targets is not None or relevance is not None
    matrix = _distances_of(distances, settings.distance, rectangular, settings.threads, prefix)
    square = targets is None and matrix.shape[0] == matrix.shape[1]
    names: list[Any] = []
    numbers, columns, grades = [0] * matrix.shape[0], [0] * matrix.shape[1], None
    if relevance is not None:
        grades = _grades(relevance, matrix.shape)
    elif targets is None:
        names, numbers = _class_numbers(labels, len(matrix), settings.missing_labels)
    else:
        of_rows = _label_list(labels)
        names, both = _class_numbers(of_rows + _label_list(targets, "targets"), sum(matrix.shape),
                                     settings.missing_labels, "labels and targets", targets_from=len(of_rows))
        numbers, columns = both[:matrix.shape[0]], both[matrix.shape[0]:]
    smallest = number_of(settings.minimum_class_size, "minimum_class_size",
                         settings_of("sections", "evaluation")["minimum_class_size"])
    native, warnings = _native.evaluate(
        -matrix if settings.similarity else matrix, numbers, None if square else columns,
        _subclass_numbers(settings.subclasses, labels), grades, word(settings.protocol, "protocol"),
        word(settings.ties, "ties"), words(settings.measures, "measures"), word(settings.curve, "curve"), smallest,
        word(settings.evaluator, "evaluator"), settings.similarity, number_of_threads(settings.threads))
    warn(warnings, prefix)
    return Scores(native, names or ["all"], name)


class Comparison:
    """Comparison of methods. results: settings, averages and pairs, as in `shapegauge compare --format json`."""

    def __init__(self, native: _native.ComparedMethods) -> None:
        self._native = native
        self.results = _json.loads(native.json())

    def __repr__(self) -> str:
        return (self._native.summary("table") + "\n" + self._native.pairs("table")).rstrip("\n")

    def to_latex(self) -> str:
        """Returns the methods with intervals and marks as LaTeX."""
        return self._native.summary("latex")

    def to_markdown(self) -> str:
        """Returns the methods and all pairs as Markdown."""
        return self._native.summary("markdown") + "\n" + self._native.pairs("markdown")

    def to_csv(self) -> str:
        """Returns all pairs as CSV."""
        return self._native.pairs("csv")


def _named_methods(methods: Any) -> dict[str, Any]:
    """Returns the methods by name."""
    if isinstance(methods, (list, tuple)):
        methods = {f"method {number}": distances for number, distances in enumerate(methods, start=1)}
    if not isinstance(methods, _abc.Mapping):
        kind = with_article(type(methods).__name__)
        raise InputError(f"methods must be a dict of names and distances, or a list of distances, not {kind}")
    named = {str(name): distances for name, distances in methods.items()}
    if len(named) < len(methods):
        raise InputError("two keys of methods have the same name as text, as 1 and \"1\" have; rename one")
    if len(named) < 2:
        raise InputError(f"a comparison needs at least two methods, not {len(named)}")
    return named


def compare(methods: Any, labels: Any, protocol: str = "psb", *, measures: Union[str, Iterable[str]] = (),
            test: str = "randomisation", blocks: str = "queries", confidence: float = 0.95, resamples: int = 10000,
            seed: int = 1, ties: str = "index", minimum_class_size: int = 2, similarity: bool = False,
            missing_labels: str = "error", distance: Optional[str] = None, threads: int = 0) -> Comparison:
    """Compares methods on the same queries. methods: name -> distances, or a list of distances.

    test: significance test of each pair, "randomisation", "t" or "bootstrap". blocks: unit of resampling, "queries", or
    "classes" as a sample of all classes. confidence: level of the intervals. distance: distance between features, if
    the methods are features. The other arguments are those of evaluate(). Returns a Comparison: intervals of the
    averages, and for each pair its difference, p-values and effect size. p_classes tests for classes like these.

    >>> sg.compare({"a": first, "b": second}, labels, measures=["FT", "DCG"])
    """
    methods = _named_methods(methods)
    settings = _Settings(protocol, words(measures, "measures"), ties, minimum_class_size, similarity, missing_labels,
                         distance, threads)
    check_order((f"rows of {name}", index_of(values)) for name, values in methods.items())
    labels = _listed(labels)
    scores = []
    for name, distances in methods.items():
        try:
            scores.append(_evaluate(distances, labels, settings, name, f"{name}: "))
        except InputError as error:
            raise InputError(f"{name}: {error}") from None
    test = "randomisation" if test == "randomization" else word(test, "test")  # the older word
    native = _native.compare(list(methods), [one._native for one in scores], test,
                             word(blocks, "blocks"), _number(confidence, "confidence"),
                             _number(resamples, "resamples"), _number(seed, "seed"),
                             number_of_threads(threads))
    warn(native.warnings)
    return Comparison(native)


def distances(features: Any, distance: str, *, threads: int = 0) -> _numpy.ndarray:
    """Computes the n x n distances between features, one row per model. distance: "l1", "l2", ... or the name of a
    descriptor, which selects its own distance.

    >>> sg.distances(features, "light_field")
    """
    return _distances_of(features, distance, True, threads)


def fuse(distances: Any, weight: Optional[Iterable[float]] = None, *, scale: str = "median", weights: str = "given",
         threads: int = 0) -> _numpy.ndarray:
    """Sums distances of the same models, without labels. The result is n x n.

    distances: a list of n x n distances. weight: factor of each (default: 1). scale: divisor of each matrix, its
    "median", "mean", "none" or "local" (each model's mean distance to its ten nearest); "ranks" replaces the latter by
    log(1 + mean of the two models' ranks among each other's neighbours). weights: "given" (`weight`) or "agreement"
    (`weight` times factors estimated from how well nearest models agree between matrices and within one).

    >>> both = sg.fuse([first, second], scale="ranks", weights="agreement")
    """
    listed = ordered(distances, "distances")
    matrices = [square_matrix(matrix) for matrix in listed]
    check_order((f"rows of distances[{i}]", index_of(matrix)) for i, matrix in enumerate(listed))
    if not matrices:
        raise InputError("distances is an empty list; pass at least one matrix")
    numbers = [1.0] * len(matrices) if weight is None else ordered(weight, "weight")
    if len(numbers) != len(matrices):
        raise InputError(f"weight has {len(numbers)} numbers for {len(matrices)} distances")
    terms = [{"of": str(i), "weight": finite_number(number, f"weight[{i}]")} for i, number in enumerate(numbers)]
    settings = {"sum": terms, "scale": word(scale, "scale"), "weights": word(weights, "weights")}
    return _native.fuse(matrices, _json.dumps(settings), number_of_threads(threads))


@with_settings([("Methods and their settings", listing_of_all("rerank"))])
def rerank(distances: Any, method: str = "diffusion", *, threads: int = 0, **settings: Any) -> _numpy.ndarray:
    """Re-ranks distances, unsupervised, using the whole set. The result is n x n.

    method: "diffusion", "k_reciprocal" or "query_expansion". settings: those of the method, below.

    >>> better = sg.rerank(distances, neighbours="auto")
    """
    settings = {name: plain(value, name) for name, value in settings.items()}
    reranked, warnings = _native.rerank(square_matrix(distances), word(method, "method"), _json.dumps(settings),
                                        number_of_threads(threads))
    warn(warnings)
    return reranked
