# SPDX-License-Identifier: GPL-3.0-or-later
"""Results as pickles, data frames, plots and intervals; arguments from other packages."""

import copy
import dataclasses
import json
import os
import pickle
import subprocess
import types

import numpy as np
import pytest

import shapegauge as sg
from support import CONFIGS, PROGRAM, bumpy_torus, toy


def same_scores(a, b):
    assert repr(a) == repr(b)
    assert a.to_latex() == b.to_latex()
    assert a.per_class == b.per_class
    assert a.intervals == b.intervals
    for measure in a:
        assert a.per_query[measure].tobytes() == b.per_query[measure].tobytes()
    assert a.precision.tobytes() == b.precision.tobytes()


def test_scores_can_be_pickled_and_copied():
    scores = sg.evaluate(*toy(), confidence=0.9, name="toy")
    for other in (pickle.loads(pickle.dumps(scores)), copy.deepcopy(scores), copy.copy(scores)):
        same_scores(other, scores)
    copied = copy.deepcopy(scores)
    copied.micro["FT"] = 0
    assert scores["FT"] != 0


def test_evaluate_accepts_condensed_distances_and_a_missing_diagonal():
    distances, labels = toy()
    scores = sg.evaluate(distances, labels)
    same_scores(sg.evaluate(distances[np.triu_indices(len(distances), 1)], labels), scores)
    for excluded in (np.nan, np.inf):
        matrix = distances.copy()
        np.fill_diagonal(matrix, excluded)
        same_scores(sg.evaluate(matrix, labels), scores)


def test_sdf_does_not_depend_on_the_length_of_normals():
    vertices, faces = bumpy_torus()
    centres = vertices[faces].mean(axis=1)
    normals = sg.normals(vertices, faces, at="faces")
    expected = sg.sdf(centres, "inscribed_ball", normals=normals).values
    np.testing.assert_allclose(sg.sdf(centres, "inscribed_ball", normals=0.01 * normals).values, expected, rtol=1e-9)


def test_fields_can_be_pickled_and_contain_their_sample_points():
    vertices, faces = bumpy_torus()
    field = sg.sdf(vertices, faces)
    np.testing.assert_allclose(field.points, vertices[faces].mean(axis=1), atol=1e-12)
    np.testing.assert_array_equal(sg.field(vertices, faces, "centricity", at="vertices", sources=4).points, vertices)
    back = pickle.loads(pickle.dumps(field))
    assert back.offset == field.offset == 0.05
    np.testing.assert_array_equal(back.points, field.points)
    np.testing.assert_array_equal(back.values, field.values)


def test_replacing_the_values_of_a_field_keeps_its_points_and_normals():
    field = sg.sdf(*bumpy_torus())
    scaled = dataclasses.replace(field, values=2 * field.values)
    np.testing.assert_array_equal(scaled.values, 2 * field.values)
    assert scaled.weights is field.weights and scaled.offset == field.offset == 0.05
    assert scaled.points is field.points and scaled.normals is field.normals


def test_numpy_functions_reject_a_field_instead_of_its_values():
    field = sg.sdf(*bumpy_torus())
    values, weights = field
    assert values is field.values and weights is field.weights and field[0] is values
    assert np.mean(field.values) == values.mean()
    for statistic in (np.mean, np.median, np.max, np.asarray):
        with pytest.raises(TypeError, match="values"):
            statistic(field)


def test_data_frame_of_scores_has_one_row_per_query():
    pandas = pytest.importorskip("pandas")
    distances, labels = toy()
    scores = sg.evaluate(distances, labels)
    frame = scores.to_frame()
    assert isinstance(frame, pandas.DataFrame)
    assert list(frame["class"]) == labels
    assert list(frame.columns) == ["class", *scores.measures]
    assert frame["FT"].mean() == pytest.approx(scores["FT"])


def test_plot_draws_the_precision_recall_curve():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    scores = sg.evaluate(*toy(), name="toy")
    axes = scores.plot(color="red")
    assert scores.plot(axes) is axes
    first, second = axes.lines
    assert first.get_color() == "red" and second.get_label() == "toy"
    np.testing.assert_array_equal(first.get_xdata(), scores.recall)
    np.testing.assert_array_equal(first.get_ydata(), scores.precision)


def test_confidence_intervals_match_the_command_line(tmp_path):
    distances, labels = toy()
    np.save(tmp_path / "d.npy", distances)
    (tmp_path / "labels.csv").write_text("".join(f"{label}\n" for label in labels))
    command = [PROGRAM, "evaluate", tmp_path / "d.npy", "--labels", tmp_path / "labels.csv", "--format", "json",
               "--confidence", "0.9", "--blocks", "queries", "--resamples", "500", "--seed", "7"]
    printed = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    scores = sg.evaluate(distances, labels, confidence=0.9, blocks="queries", resamples=500, seed=7)
    low, high = scores.intervals["micro"]["FT"]
    assert low < scores["FT"] < high
    assert [low, high] in _lists_in(printed)


def _lists_in(json_value):
    if isinstance(json_value, list):
        yield json_value
    for part in json_value.values() if isinstance(json_value, dict) else json_value if isinstance(json_value, list) else ():
        yield from _lists_in(part)


def test_evaluate_compares_features_by_a_named_distance():
    features = np.random.default_rng(1).random((7, 5)).astype(np.float32)
    labels = list("aaabbbb")
    distances = sg.distances(features, "l1")
    np.testing.assert_allclose(distances, np.abs(features[:, None] - features[None]).sum(axis=-1), rtol=1e-6)
    assert repr(sg.evaluate(features, labels, distance="l1")) == repr(sg.evaluate(distances, labels))
    assert sg.distances(features, "d2").shape == (7, 7)
    with pytest.raises(sg.InputError, match="l3"):
        sg.distances(features, "l3")
    with pytest.raises(sg.InputError, match="similarity"):
        sg.evaluate(features, labels, distance="l1", similarity=True)


def test_subclasses_give_graded_relevance_within_a_class():
    # The query first, then a model of another subclass, of none, and of its own.
    distances = np.array([[0, 1, 2, 3], [1, 0, 2, 3], [1, 2, 0, 3], [1, 2, 3, 0]], dtype=float)
    scores = sg.evaluate(distances, list("aaaa"), "paper", measures=["nDCG@N"], subclasses=["x", "y", "a", "x"])
    gains = 3 + 1 + 2 / np.log2(3) + 3 / np.log2(4)
    ideal = 3 + 3 + 2 / np.log2(3) + 1 / np.log2(4)
    assert abs(scores.per_query["nDCG@N"][0] - gains / ideal) < 1e-12
    plain = sg.evaluate(distances, list("aaaa"), "paper", measures=["nDCG@N"], subclasses=[None, "", "a", "a"])
    assert plain["nDCG@N"] == 1
    for wrong, words in [(list("xyz"), "3 subclasses for 4 models"), ("xyzx", "subclasses must be a list"),
                         (["x", [1], "y", "x"], "row 1 is a list"),
                         (np.array(["x", np.nan, "y", "x"]), '"nan" in row 1 ')]:
        with pytest.raises(sg.InputError, match=words):
            sg.evaluate(distances, list("aaaa"), subclasses=wrong)
    with pytest.raises(sg.InputError, match="relevance instead"):
        sg.evaluate(distances, list("aaaa"), targets=list("aaaa"), subclasses=list("xyzx"))


@pytest.mark.parametrize("labels, subclasses", [
    ([1, 1, 1, 1], [2.0, 3.0, 1.0, 2.0]),
    ([1.0, 1.0, 1.0, 1.0], [2, 3, 1, 2]),
    ([1, 1, 1, 1], np.array([2, 3, np.nan, 2])),
    (["1", "1", "1", "1"], ["2", "3 ", " 1", b"2"]),
    ((label for label in [1, 1, 1, 1]), (name for name in ["2", "3", None, "2"])),
])
def test_subclasses_and_labels_may_have_any_type(labels, subclasses):
    distances = np.array([[0, 1, 2, 3], [1, 0, 2, 3], [1, 2, 0, 3], [1, 2, 3, 0]], dtype=float)
    expected = sg.evaluate(distances, list("aaaa"), "paper", measures=["nDCG@N"], subclasses=["x", "y", "a", "x"])
    scores = sg.evaluate(distances, labels, "paper", measures=["nDCG@N"], subclasses=subclasses)
    assert scores.micro == expected.micro


def test_binary_relevance_matrix_gives_the_same_scores_as_labels():
    distances, labels = toy()
    same = np.equal.outer(labels, labels)
    by_labels = sg.evaluate(distances, labels, protocol="trec")
    by_relevance = sg.evaluate(distances, relevance=same)
    assert by_relevance.protocol == "trec"
    assert by_relevance.micro == by_labels.micro
    by_targets = sg.evaluate(distances[:3], labels[:3], protocol="trec", targets=labels)
    assert sg.evaluate(distances[:3], relevance=same[:3]).micro == by_targets.micro
    same[0] = False  # without relevant models it is not a query
    with pytest.warns(UserWarning, match="omitted from all scores: 1 query"):
        others = sg.evaluate(distances, relevance=same, measures=["mAP"])
    assert list(others.queries) == [1, 2, 3, 4, 5, 6]
    counted = sg.evaluate(distances, relevance=same, measures=["mAP"], minimum_class_size=1)
    assert list(counted.per_query["mAP"]) == [0, *others.per_query["mAP"]]
    assert len(sg.evaluate(distances, relevance=same, evaluator="trec_eval").queries) == 7
    beyond = np.where(same, 2**32, 0)
    for wrong, words in [(same[:3], "3 x 7"), (same * 0.5, "whole numbers"),
                         (beyond, "grade 4294967296 in row 1, column 0 .* to 2147483647"),
                         (beyond * -1.0, "grade -4294967296.0")]:
        with pytest.raises(sg.InputError, match=words):
            sg.evaluate(distances, relevance=wrong)
    objects = same.astype(object)
    assert sg.evaluate(distances, relevance=objects).micro == sg.evaluate(distances, relevance=same).micro
    objects[1, 2] = None
    for wrong, words in [(np.ma.array(same, mask=np.eye(7)), "grades of relevance have masked entries"),
                         (same.astype(str), "must be real numbers, not text"), (objects, "entry 1, 2 .* is None"),
                         ({1, 2}, "relevance must be a matrix, not a set"), ({1: 2}, "must be a matrix, not a dict"),
                         ([[1, 2], [3]], "grades of relevance cannot be made an array")]:
        with pytest.raises(sg.InputError, match=words):
            sg.evaluate(distances, relevance=wrong)
    with pytest.raises(sg.InputError, match="pass labels, or relevance"):
        sg.evaluate(distances)


def test_negative_relevance_means_not_judged():
    distances = [[0, 1, 2, 3]] * 4  # the first model has one miss before its hit
    grades = np.zeros((4, 4), int)
    for miss, bpref in [(0, 0), (-1, 1)]:
        grades[0] = [0, miss, 1, 0]
        assert sg.evaluate(distances, relevance=grades, measures=["bpref"])["bpref"] == bpref
    grades[3] = -1  # not a query
    assert list(sg.evaluate(distances, relevance=grades, evaluator="trec_eval").queries) == [0, 1, 2]


def test_evaluate_accepts_queries_that_are_not_targets():
    queries, others = np.array([0.0, 10]), np.array([1.0, 2, 9, 12])
    scores = sg.evaluate(np.abs(np.subtract.outer(queries, others)), ["a", "b"], targets=["a", "b", "b", "a"])
    assert scores.per_query["NN"].tolist() == [1, 1]
    assert scores.per_query["FT"].tolist() == [0.5, 0.5]
    with pytest.raises(sg.InputError, match="labels and targets"):
        sg.evaluate(np.zeros((2, 4)), ["a", "b"], targets=["a"])


def test_run_accepts_a_dict_and_reports_progress(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with open(f"{CONFIGS}/quickstart.json", encoding="utf-8") as file:
        configuration = json.load(file)
    configuration["dataset"] = {"generate": {"classes": 2, "models_per_class": 2, "faces": 1000}}
    configuration.pop("$schema", None)
    calls = []
    run = sg.run(configuration, "out", cache="", on_progress=lambda *how_far: calls.append(how_far))
    assert run.left_out == [] and "NN" in run.summary
    assert {stage for stage, _, _ in calls} >= {"signatures"}

    def stop(stage, done, total):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        sg.run(configuration, "stopped", cache="", on_progress=stop)
    with pytest.raises(sg.InputError, match="configuration: .*nonsense"):
        sg.run({**configuration, "nonsense": 1})


@pytest.mark.parametrize("name, folder", [("..", "unnamed"), (".", "unnamed"), ("a/b c", "a_b_c")])
def test_run_writes_to_a_results_folder_named_after_the_experiment(tmp_path, monkeypatch, name, folder):
    monkeypatch.chdir(tmp_path)
    with open(f"{CONFIGS}/quickstart.json", encoding="utf-8") as file:
        configuration = json.load(file)
    configuration.pop("$schema", None)
    configuration["name"] = name
    configuration["dataset"] = {"generate": {"classes": 2, "models_per_class": 2, "faces": 1000}}
    run = sg.run(configuration, cache="")
    assert run.folder == os.path.join("results", folder) and os.path.exists(tmp_path / run.folder / "manifest.json")
    assert os.listdir(tmp_path) == ["results"] and os.listdir("results") == [folder]


def test_run_does_not_overwrite_its_inputs(tmp_path):
    vertices, faces = bumpy_torus()
    for name in ("a/1.off", "a/2.off", "b/3.off", "b/4.off"):
        (tmp_path / "data" / name).parent.mkdir(parents=True, exist_ok=True)
        sg.write(tmp_path / "data" / name, vertices, faces)
    configuration = {"name": "small", "dataset": {"layout": "folders", "root": str(tmp_path / "data")},
                     "signatures": [{"name": "d2", "descriptor": {"type": "d2", "points": 64}}]}
    with pytest.raises(sg.InputError, match="the results would overwrite the input"):
        sg.run(configuration, tmp_path / "data", replace=True, cache="")
    (tmp_path / "summary.json").write_text(json.dumps(configuration))
    with pytest.raises(sg.InputError, match="the results would overwrite the input"):
        sg.run(tmp_path / "summary.json", tmp_path, replace=True, cache="")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["data", "summary.json"]
    assert sorted(path.name for path in (tmp_path / "data").iterdir()) == ["a", "b"]


def test_error_messages_of_run_refer_to_python_arguments(tmp_path):
    (tmp_path / "summary.csv").write_text("")
    configuration = {"name": "made", "dataset": {"generate": {"classes": 2, "models_per_class": 2, "faces": 1000}},
                     "signatures": [{"name": "d2", "descriptor": {"type": "d2"}}]}
    with pytest.raises(sg.InputError, match="another folder with output, or replace=True"):
        sg.run(configuration, tmp_path, cache="")
    with pytest.raises(sg.InputError, match="^setting foo: expected dotted.key=value"):
        sg.run(configuration, tmp_path, settings="foo", cache="")


def test_objects_of_other_packages_are_accepted_as_shapes(tmp_path):
    vertices, faces = bumpy_torus()
    expected = sg.sdf(vertices, faces).values
    block = types.SimpleNamespace(type="triangle", data=faces)
    line = types.SimpleNamespace(type="line", data=faces[:, :2])
    meshio = types.SimpleNamespace(points=vertices, cells=[line, block])
    array = lambda values: types.SimpleNamespace(cpu=lambda: types.SimpleNamespace(numpy=lambda: values))
    tensors = types.SimpleNamespace(vertex={"positions": array(vertices)}, triangle={"indices": array(faces)})
    mesh = types.SimpleNamespace(vertices=vertices, faces=faces)
    scene = types.SimpleNamespace(geometry={"torus": mesh}, dump=lambda concatenate: mesh)
    for shape in (meshio, tensors, scene):
        assert sg.sdf(shape).values.tobytes() == expected.tobytes()
    cloud = types.SimpleNamespace(points=vertices, cells=[types.SimpleNamespace(type="vertex", data=faces[:, :1])])
    assert len(sg.sdf(cloud, offset=0.05).values) == len(vertices)
    quads = types.SimpleNamespace(points=vertices, cells=[types.SimpleNamespace(type="quad", data=faces)])
    with pytest.raises(sg.InputError, match="kind quad"):
        sg.sdf(quads)


def test_meshio_objects_are_accepted_as_shapes():
    meshio = pytest.importorskip("meshio")
    vertices, faces = bumpy_torus()
    mesh = meshio.Mesh(vertices, [("triangle", faces)])
    assert sg.sdf(mesh).values.tobytes() == sg.sdf(vertices, faces).values.tobytes()


def test_quads_are_split_into_two_triangles(tmp_path):
    vertices = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    quads = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
    values, weights = sg.sdf(vertices, quads)
    expected, _ = sg.sdf(vertices, quads[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3))
    np.testing.assert_array_equal(values, expected)
    np.testing.assert_allclose(weights, 0.5)
    arrow = np.array([[0, 0, 0], [2, 0, 0], [0.2, 0.2, 0], [0, 2, 0]])  # concave
    for first in range(4):
        sg.write(tmp_path / "arrow.off", arrow, [np.roll(range(4), first)])
        shape = sg.read(tmp_path / "arrow.off")
        a, b, c = (shape.vertices[shape.faces[:, k]] for k in range(3))
        twice_areas = np.cross(b - a, c - a)[:, 2]
        assert (twice_areas > 0).all() and sum(twice_areas) / 2 == pytest.approx(0.4)
