# SPDX-License-Identifier: GPL-3.0-or-later
"""Labels of models: accepted types and missing values."""

import numpy as np
import pytest

import shapegauge as sg
from support import program, toy

DISTANCES, LABELS = toy()


class NotAvailable:
    """Like pandas.NA: comparisons return the object itself, whose truth value is undefined."""

    def __eq__(self, other):
        return self

    def __ne__(self, other):
        return self

    def __bool__(self):
        raise TypeError("boolean value of NA is ambiguous")


MISSING = [None, float("nan"), np.nan, "", "  ", np.float32("nan"), np.datetime64("NaT"), NotAvailable()]


@pytest.mark.parametrize("missing", MISSING)
def test_missing_labels_raise_an_error_that_names_the_rows(missing):
    labels = ["a", "a", missing, "b", "b", missing, "b"]
    with pytest.raises(sg.InputError, match="2 labels.* 2, 5 "):
        sg.evaluate(DISTANCES, labels)
    array = np.empty(7, object)
    array[:] = labels
    with pytest.raises(sg.InputError, match="2 labels.* 2, 5 "):
        sg.compare({"first": DISTANCES, "second": DISTANCES}, array)


def test_missing_values_in_label_arrays_raise_an_error():
    with pytest.raises(sg.InputError, match="row 4 "):
        sg.evaluate(DISTANCES, np.array([1, 1, 1, 2, np.nan, 2, 2]))
    with pytest.raises(sg.InputError, match="row 4 "):
        sg.evaluate(DISTANCES, np.ma.array([1, 1, 1, 2, 2, 2, 2], mask=[0, 0, 0, 0, 1, 0, 0]))
    many = np.full(30, np.nan)
    with pytest.raises(sg.InputError, match="30 labels.*20 more"):
        sg.evaluate(np.zeros((30, 30)), many)


@pytest.mark.parametrize("text", ["nan", "NaN", "None", "<NA>", "NaT", "NULL"])
def test_labels_that_spell_a_missing_value_give_a_warning(text, tmp_path):
    labels = [text, "a", text, "b", "b", "a", "b"]
    for values in (labels, np.array(labels, object)):
        with pytest.warns(UserWarning, match=f'the label of rows 0, 2 .* is the text "{text}"'):
            sg.evaluate(DISTANCES, values)
    with pytest.warns(UserWarning, match=f'the label of row 1 of targets .* is the text "{text}"'):
        sg.evaluate(DISTANCES[:, :3], LABELS, targets=["a", text, "b"])
    with pytest.raises(sg.InputError, match=f'"{text}" in rows 0, 2 .*dtype=object'):
        sg.evaluate(DISTANCES, np.array(labels))
    np.save(tmp_path / "D.npy", DISTANCES)
    (tmp_path / "labels.txt").write_text("\n".join(labels))
    lines = program("evaluate", tmp_path / "D.npy", "--labels", tmp_path / "labels.txt")
    assert any(f'2 models have the class "{text}"' in line for line in lines)


def test_missing_target_labels_are_named_by_their_rows():
    targets = ["a", "b", None]
    with pytest.raises(sg.InputError, match="1 label is missing, in row 2 of targets "):
        sg.evaluate(DISTANCES[:, :3], LABELS, targets=targets)
    with pytest.raises(sg.InputError, match="2 labels are missing, in rows 0 of labels, 2 of targets "):
        sg.evaluate(DISTANCES[:, :3], [None, *LABELS[1:]], targets=targets)
    with pytest.raises(sg.InputError, match="the label of row 1 of targets is 1.5;"):
        sg.evaluate(DISTANCES[:, :2], LABELS, targets=[1, 1.5])


@pytest.mark.filterwarnings("ignore")
def test_unlabelled_models_are_neither_queries_nor_relevant():
    scores = sg.evaluate(DISTANCES, ["a", "a", None, "b", "b", "", "b"], missing_labels="no_class")
    assert scores.queries.tolist() == [0, 1, 3, 4, 6]
    assert set(scores.per_class) == {"a", "b"}
    # They stay in the results of other queries, like models in classes of one.
    alone = sg.evaluate(DISTANCES, ["a", "a", "x", "b", "b", "y", "b"])
    assert scores.micro == alone.micro and scores.per_class == alone.per_class
    # The nearest to the third of b, at 3.5, is the model at 4, which has no class.
    assert scores.per_query["NN"].tolist() == [1, 1, 0, 0, 0]
    assert (scores.models_left_out, alone.models_left_out) == (0, 2)
    with pytest.raises(sg.InputError, match="missing_labels"):
        sg.evaluate(DISTANCES, LABELS, missing_labels="x")


def test_evaluate_accepts_labels_in_any_ordered_iterable():
    expected = sg.evaluate(DISTANCES, LABELS)
    for labels in (tuple(LABELS), np.array(LABELS), iter(LABELS), (label for label in LABELS), np.array([LABELS]).T,
                   np.array(LABELS, object), np.array(LABELS, "S"), [f" {label}" for label in LABELS]):
        scores = sg.evaluate(DISTANCES, labels)
        assert scores.per_class == expected.per_class
    numbers = sg.evaluate(DISTANCES, [1, 1, 1, 2, 2, 2, 2])
    assert set(numbers.per_class) == {1, 2} and numbers.micro == expected.micro
    assert sg.evaluate(DISTANCES, [1.0, 1, np.int8(1), 2, 2, 2, 2]).per_class == numbers.per_class
    assert set(sg.evaluate(DISTANCES, [1, 1, 1, "x", "x", "x", "x"]).per_class) == {"1", "x"}
    generated = sg.compare({"a": DISTANCES, "b": DISTANCES}, (label for label in LABELS), resamples=100)
    assert generated.results == sg.compare({"a": DISTANCES, "b": DISTANCES}, LABELS, resamples=100).results


@pytest.mark.parametrize("labels, words", [
    (set(LABELS), "set"),
    (dict(enumerate(LABELS)), "dict"),
    ("aaabbbb", "str"),
    (5, "int"),
    (np.array(5), "single"),
    (None, "None"),
    (LABELS[:6], "6 labels for 7 models"),
    (np.eye(7)[:, :2], "7 x 2"),
    ([1, 1, 1, 2, 2, 2, 2.5], "row 6 is 2.5"),
    ([1, 1, "1", "x", "x", "x", "x"], "rows 0 and 2 .* are 1 and '1'"),
    ([True, True, True, 1, 1, 1, 1], "rows 0 and 3 .* are True and 1"),
    ([True, True, True, "True", "b", "b", "b"], "rows 0 and 3 "),
    (np.array(["a", "a", "a", "b", "b", "b", np.nan]), "in row 6 .*dtype=object"),
    (np.array(["a", np.nan, "a", "b", "b", np.nan, "b"]), "in rows 1, 5 "),
    ([1, 1, 1, 2, 2, 2, float("inf")], "row 6 is inf"),
    ([1, 1, 1, 2, 2, 2, (2,)], "row 6 is a tuple"),
    ([1, 1, 1, 2, 2, 2, np.ones(2)], "row 6 is an? ndarray"),
])
def test_labels_of_mixed_types_and_missing_labels_in_arrays_are_rejected(labels, words):
    with pytest.raises(sg.InputError, match=words):
        sg.evaluate(DISTANCES, labels)
