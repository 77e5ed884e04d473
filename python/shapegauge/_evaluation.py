"""Distances: evaluation, comparison, re-ranking."""

import collections.abc as _abc
import json as _json
import numbers as _numbers

import numpy as _numpy

from . import _native
from ._arguments import (finite_number, number_of_threads, ordered, plain, square_matrix, switch, warn, whole_number,
                         with_article, word, words)
from ._native import InputError


class Scores(_abc.Mapping):
    """Scores of a distance matrix, fractions from 0 to 1. scores["FT"] is the mean over queries.

    micro, macro: measure -> mean over queries, over classes. per_query: measure -> array, by `queries` (rows of the
    matrix). per_class: class -> measure -> mean. recall, precision: the curve. queries_with_ties: queries with relevant
    and other models at equal distance. models_left_out: models that are no queries, since their classes are too small.
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
        self.queries_with_ties = native.queries_with_ties
        self.models_left_out = native.models_left_out

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


def _is_missing(label):
    """Whether a label stands for none: None, NaN, pandas.NA, NaT, a masked entry, empty text."""
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


def _label(label, row):
    """A label as a number or as text."""
    if isinstance(label, (bool, _numpy.bool_, str)):
        return str(label).strip() if isinstance(label, str) else bool(label)
    if isinstance(label, bytes):
        return label.decode("utf-8", "replace").strip()
    if isinstance(label, _numbers.Integral):
        return int(label)
    if isinstance(label, _numbers.Real):
        if not float(label).is_integer():
            raise InputError(f"the label of row {row} is {label}; labels are whole numbers or text")
        return int(label)
    if isinstance(label, (_abc.Iterable, _numbers.Complex)):
        kind = with_article(type(label).__name__)
        raise InputError(f"the label of row {row} is {kind}; labels are whole numbers or text")
    return str(label)


def _label_list(labels):
    """The labels in their order; a column or a row of a table is one dimension."""
    if hasattr(labels, "__array__") and not isinstance(labels, _numpy.generic):
        array = labels if isinstance(labels, _numpy.ndarray) else _numpy.asarray(labels)
        if array.ndim == 0:
            raise InputError("labels must be a list, not a single value")
        if array.ndim > 1 and (array.size == 0 or max(array.shape) != array.size):
            raise InputError(f"labels must have one dimension, not be {' x '.join(map(str, array.shape))}; of a table "
                             "with a column for each class, take the argmax of its rows")
        flat = array.ravel()
        mask = _numpy.ma.getmaskarray(flat) if isinstance(flat, _numpy.ma.MaskedArray) else _numpy.zeros(len(flat), bool)
        return [None if hidden else label for label, hidden in zip(_numpy.asarray(flat).tolist(), mask)]
    return ordered(labels, "labels")


_MISSING_LABELS = ("error", "no_class")


def _class_numbers(labels, models, missing_labels):
    """The names of the classes, ascending, and each model's number among them, -1 where it has none."""
    if missing_labels not in _MISSING_LABELS:
        raise InputError(f'missing_labels must be "error" or "no_class", not {missing_labels!r}')
    labels = _label_list(labels)
    if len(labels) != models:
        raise InputError(f"there are {len(labels)} labels for {models} models")
    missing = [row for row, label in enumerate(labels) if _is_missing(label)]
    if missing and missing_labels == "error":
        rows = ", ".join(map(str, missing[:10])) + (f" and {len(missing) - 10} more" if len(missing) > 10 else "")
        found = f"label is missing, in row {rows}" if len(missing) == 1 else f"labels are missing, in rows {rows}"
        raise InputError(f"{len(missing)} {found} (counted from 0); leave these models out, or say "
                         'missing_labels="no_class": then they are no queries, and relevant to none')
    hidden = set(missing)
    classes = [None if row in hidden else _label(label, row) for row, label in enumerate(labels)]
    if len({type(label) is str for row, label in enumerate(classes) if row not in hidden}) == 2:
        classes = [label if label is None else str(label) for label in classes]  # numbers and text are text
    names = sorted({label for row, label in enumerate(classes) if row not in hidden})
    number_of = {name: number for number, name in enumerate(names)}
    return names, [-1 if row in hidden else number_of[label] for row, label in enumerate(classes)]


def evaluate(distances, labels, protocol="psb", *, measures=(), ties="index", minimum_class_size=2, similarity=False,
             missing_labels="error", threads=0, name="method"):
    """Evaluates distances against the classes of the models: row i and column i are the model of labels[i].

    labels: whole numbers or text. protocol: "psb", "paper" or "trec". measures: a name such as "FT" or "P@10", or a
    list; none: the protocol's own. ties: the order of models at equal distance, "index", "optimistic", "pessimistic" or
    "expected". similarity: larger means more alike. missing_labels: what is done where a label is None, NaN or empty:
    "error", or "no_class" (the model is no query, and relevant to none). Warns of anomalies of the matrix. Returns
    Scores.

    >>> scores = sg.evaluate(distances, labels)
    >>> scores["FT"], scores.macro["NN"], scores.per_query["DCG"].mean()
    """
    return _evaluate(distances, labels, protocol, measures, ties, minimum_class_size, similarity, missing_labels,
                     threads, word(name, "name"), "")


def _evaluate(distances, labels, protocol, measures, ties, minimum_class_size, similarity, missing_labels, threads,
              name, prefix):
    matrix = square_matrix(distances)
    similarity = switch(similarity, "similarity")
    names, numbers = _class_numbers(labels, len(matrix), missing_labels)
    native, warnings = _native.evaluate(-matrix if similarity else matrix, numbers, word(protocol, "protocol"),
                                        word(ties, "ties"), words(measures, "measures"),
                                        whole_number(minimum_class_size, "minimum_class_size", 2, 1000000), similarity,
                                        number_of_threads(threads))
    warn(warnings, prefix)
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


def _named_methods(methods):
    """The methods by their names."""
    if isinstance(methods, (list, tuple)):
        methods = {f"method {number}": distances for number, distances in enumerate(methods, start=1)}
    if not isinstance(methods, _abc.Mapping):
        kind = with_article(type(methods).__name__)
        raise InputError(f"methods must be a dict of names and distances, or a list of distances, not {kind}")
    named = {str(name): distances for name, distances in methods.items()}
    if len(named) < len(methods):
        raise InputError("two methods have the same name")
    if len(named) < 2:
        raise InputError(f"a comparison takes two methods or more, not {len(named)}")
    return named


def compare(methods, labels, protocol="psb", *, measures=(), test="randomization", blocks="classes", confidence=0.95,
            resamples=10000, seed=1, ties="index", minimum_class_size=2, similarity=False, missing_labels="error",
            threads=0):
    """Compares methods on the same queries. methods: name -> distances, or a list of distances.

    blocks: what is resampled as a whole, "classes", or "queries" as if independent. The other arguments are those of
    evaluate(). Returns Comparison: intervals of the averages, and for each pair its difference, p-values and effect
    size.

    >>> sg.compare({"a": first, "b": second}, labels, measures=["FT", "DCG"])
    """
    methods = _named_methods(methods)
    measures = words(measures, "measures")
    if not hasattr(labels, "__array__"):
        labels = ordered(labels, "labels")  # a generator gives them once
    scores = []
    for name, distances in methods.items():
        try:
            scores.append(
                _evaluate(distances, labels, protocol, measures, ties, minimum_class_size, similarity, missing_labels,
                          threads, name, f"{name}: "))
        except InputError as error:
            raise InputError(f"{name}: {error}") from None
    native = _native.compare(list(methods), [one._native for one in scores], word(test, "test"),
                             word(blocks, "blocks"), finite_number(confidence, "confidence"),
                             whole_number(resamples, "resamples", 1, 10000000), whole_number(seed, "seed", 0, 2**53 - 1),
                             number_of_threads(threads))
    warn(native.warnings)
    return Comparison(native)


def fuse(distances, weight=None, *, scale="median", weights="given", threads=0):
    """Sums distances of the same models, without labels. The result is n x n.

    distances: a list of n x n distances. weight: a number for each (default: 1). scale: what each is divided by first,
    "median", "mean", "none", or "local", each model's mean distance to its ten nearest. weights: what the weights are
    multiplied by, "given" (nothing) or "agreement" (of the nearest models with those of the other distances, and with
    their own nearest).

    >>> both = sg.fuse([first, second], scale="local", weights="agreement")
    """
    matrices = [square_matrix(matrix) for matrix in ordered(distances, "distances")]
    if not matrices:
        raise InputError("distances is an empty list")
    numbers = [1.0] * len(matrices) if weight is None else ordered(weight, "weight")
    if len(numbers) != len(matrices):
        raise InputError(f"weight has {len(numbers)} numbers for {len(matrices)} distances")
    terms = [{"of": str(i), "weight": finite_number(number, f"weight[{i}]")} for i, number in enumerate(numbers)]
    settings = {"sum": terms, "scale": word(scale, "scale"), "weights": word(weights, "weights")}
    return _native.fuse(matrices, _json.dumps(settings), number_of_threads(threads))


def rerank(distances, method="diffusion", *, threads=0, **settings):
    """Distances re-ranked by those of the whole set, without labels. The result is n x n.

    method: "diffusion" (neighbours, damping, tie), "k_reciprocal" or "query_expansion". neighbours is a number, a list
    of numbers, over which the mean is taken, or "auto".

    >>> better = sg.rerank(distances, neighbours="auto")
    """
    settings = {name: plain(value, name) for name, value in settings.items()}
    return _native.rerank(square_matrix(distances), word(method, "method"), _json.dumps(settings),
                          number_of_threads(threads))
