# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects of pandas: their rows are read by position, and must not be in different orders."""

import numpy as np
import pytest

import shapegauge as sg
from support import toy

DISTANCES, LABELS = toy()
NAMES = ["m0", "m1", "m2", "m3", "m4", "m5", "m6"]
SHUFFLED = [3, 0, 1, 2, 4, 5, 6]


class Series:
    """As much of pandas.Series as the package uses, which tests do not need to install."""

    def __init__(self, values, index=None):
        self.values = np.asarray(values)
        self.index = list(range(len(self.values))) if index is None else list(index)
        self.iloc = None

    def __array__(self, dtype=None, copy=None):
        return np.array(self.values, dtype=dtype)


class Frame(Series):
    """Likewise of pandas.DataFrame."""

    def __init__(self, values, index=None, columns=None):
        super().__init__(values, index)
        self.columns = list(range(self.values.shape[1])) if columns is None else list(columns)


class Missing:
    """As much of pandas.NA."""

    def __eq__(self, other):
        return self

    def __bool__(self):
        raise TypeError("boolean value of NA is ambiguous")

    __hash__ = object.__hash__


@pytest.fixture(params=["stand-ins", "pandas"])
def table(request):
    """The constructors of a series and a frame."""
    if request.param == "stand-ins":
        return Series, Frame
    pandas = pytest.importorskip("pandas")
    return pandas.Series, pandas.DataFrame


def shuffled(names):
    return [names[i] for i in SHUFFLED]


def test_data_frames_in_the_order_of_the_labels_give_the_scores_of_arrays(table):
    series, frame = table
    expected = sg.evaluate(DISTANCES, LABELS).micro
    assert sg.evaluate(frame(DISTANCES, NAMES, NAMES), series(LABELS, NAMES)).micro == expected
    assert sg.evaluate(frame(DISTANCES, NAMES), series(LABELS)).micro == expected  # one has no names
    assert sg.evaluate(DISTANCES, series(LABELS, [5, 3, 8, 1, 0, 2, 9])).micro == expected  # by position
    filtered = series(LABELS, [5, 9, 12, 13, 20, 21, 30])
    assert sg.evaluate(frame(DISTANCES, NAMES), filtered).micro == expected  # other names
    assert sg.evaluate(frame(DISTANCES, NAMES), series(LABELS, ["m1", "m0", *NAMES[2:6], "x"])).micro == expected
    np.testing.assert_array_equal(sg.rerank(frame(DISTANCES, NAMES, NAMES)), sg.rerank(DISTANCES))


def test_labels_in_another_order_than_the_rows_raise_an_error(table):
    series, frame = table
    labels = series(shuffled(LABELS), shuffled(NAMES))
    with pytest.raises(sg.InputError, match=r"the rows of distances and the labels are in different orders: row 0 "
                       r"\(counted from 0\) is 'm0' and 'm3'; reindex"):
        sg.evaluate(frame(DISTANCES, NAMES, NAMES), labels)
    with pytest.raises(sg.InputError, match="row 0 .* is 0 and 3"):  # an index of numbers that counts other rows
        sg.evaluate(frame(DISTANCES), series(shuffled(LABELS), SHUFFLED))
    with pytest.raises(sg.InputError, match="the rows of features and the labels"):
        sg.evaluate(frame(np.eye(7), NAMES), labels, distance="l1")
    with pytest.raises(sg.InputError, match="first: the rows of distances and the labels"):
        sg.compare({"first": frame(DISTANCES, NAMES), "second": DISTANCES}, labels)
    with pytest.raises(sg.InputError, match="the labels and the subclasses"):
        sg.evaluate(DISTANCES, labels, subclasses=series(LABELS, NAMES))


@pytest.mark.parametrize("missing", ["nan", "None", "NA", "tuple"])
def test_missing_names_in_a_pandas_index_equal_each_other(table, missing):
    series, frame = table
    not_available = Missing() if series is Series else pytest.importorskip("pandas").NA
    make = {"nan": lambda: float("nan"), "None": lambda: None, "tuple": lambda: ("m6", float("nan")),
            "NA": lambda: not_available}[missing]
    expected = sg.evaluate(DISTANCES, LABELS).micro
    names = [float(i) for i in range(6)] if missing == "nan" else NAMES[:6]
    if missing == "tuple":
        names = [(name, 1.0) for name in names]
    assert sg.evaluate(frame(DISTANCES, [*names, make()]), series(LABELS, [*names, make()])).micro == expected
    with pytest.raises(sg.InputError, match="the labels are in different orders: row 0 "):
        sg.evaluate(frame(DISTANCES, [*names, make()]), series(LABELS, [make(), *names]))


def test_columns_in_another_order_than_rows_or_targets_raise_an_error(table):
    series, frame = table
    turned = frame(DISTANCES[:, SHUFFLED], NAMES, shuffled(NAMES))
    for call in (lambda: sg.evaluate(turned, LABELS), lambda: sg.rerank(turned), lambda: sg.fuse([turned, DISTANCES])):
        with pytest.raises(sg.InputError, match="the rows of distances and the columns of distances are in different"):
            call()
    with pytest.raises(sg.InputError, match="the columns of distances and the targets"):
        sg.evaluate(turned, LABELS, targets=series(LABELS, NAMES))
    expected = sg.evaluate(DISTANCES[:, SHUFFLED], LABELS, targets=shuffled(LABELS)).micro
    assert sg.evaluate(turned, LABELS, targets=series(shuffled(LABELS), shuffled(NAMES))).micro == expected
    with pytest.raises(sg.InputError, match="the columns of distances and the columns of relevance"):
        sg.evaluate(frame(DISTANCES, NAMES, NAMES), relevance=frame(np.ones((7, 7), int), NAMES, shuffled(NAMES)))


def test_matrices_with_rows_in_different_orders_raise_an_error(table):
    _, frame = table
    other = frame(DISTANCES[np.ix_(SHUFFLED, SHUFFLED)], shuffled(NAMES), shuffled(NAMES))
    with pytest.raises(sg.InputError, match="the rows of a and the rows of b"):
        sg.compare({"a": frame(DISTANCES, NAMES, NAMES), "b": other}, LABELS)
    with pytest.raises(sg.InputError, match=r"the rows of distances\[0\] and the rows of distances\[1\]"):
        sg.fuse([frame(DISTANCES, NAMES, NAMES), other])
