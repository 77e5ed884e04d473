# SPDX-License-Identifier: GPL-3.0-or-later
"""Warnings of the package equal those of the command line."""

import json
import re
import warnings

import numpy as np
import pytest

import shapegauge as sg
from support import bumpy_torus, program, toy

# A torus with a hole in the top of one of its thick parts, wider than an automatic offset closes.
VERTICES, FACES = bumpy_torus()
CENTRES = VERTICES[FACES].mean(axis=1)
OPEN = FACES[(CENTRES[:, 2] < 0) | (np.hypot(CENTRES[:, 0] - np.sqrt(0.75), CENTRES[:, 1] - 0.5) > 0.25)]


def untied():
    """Distances without ties, and labels."""
    positions = np.array([0, 1.1, 4.3, 2.05, 3.7, 7.2, 9.9])
    return np.abs(np.subtract.outer(positions, positions)), list("aaabbbb")


def warned(call):
    """Returns the result of the call and its warnings."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        result = call()
    assert all(warning.filename == __file__ for warning in caught)  # they refer to the caller's line
    return result, [str(warning.message) for warning in caught]


def commands_warnings(lines):
    """Returns the warnings of the command line in the wording of the package."""
    marker = "shapegauge: warning: "
    return [line[len(marker):] for line in lines if line.startswith(marker)]


def in_python(sentence):
    """Replaces the options in a sentence by arguments."""
    return re.sub(r"--(\w+) ([\d.]+)", r"\1=\2", re.sub(r"--(\w+) auto\b", r"\1='auto'", sentence))


def test_offset_too_small_to_close_mesh_gaps_gives_a_warning(tmp_path):
    sg.write(tmp_path / "open.off", VERTICES, OPEN)
    shape = sg.read(tmp_path / "open.off")
    for offset in (0.02, "auto"):
        output = program("sdf", tmp_path / "open.off", "--method", "offset_sdf", "--offset", offset, "--replace", "-o",
                         tmp_path / "x.csv")
        _, found = warned(lambda: sg.sdf(shape, offset=offset))
        assert found == [in_python(sentence) for sentence in commands_warnings(output)]
        assert any("leaks" in sentence for sentence in found)
        fields = [{"type": "offset_sdf", "offset": offset}, {"type": "cone_sdf"}]
        output = program("describe", tmp_path / "open.off", "--descriptor", "joint_histogram", "--set",
                         f"fields={json.dumps(fields)}", "--replace", "-o", tmp_path / "x.npy")
        _, found = warned(lambda: sg.describe(shape, "joint_histogram", fields=fields))
        assert found == [in_python(sentence) for sentence in commands_warnings(output)]
        output = program("normals", tmp_path / "open.off", "--offset", offset, "--replace", "-o",
                         tmp_path / "x.xyz")
        _, found = warned(lambda: sg.normals(shape, offset))
        assert found == [in_python(sentence) for sentence in commands_warnings(output)]
        assert any("both sides" in sentence for sentence in found)
    assert "offset=" in found[0]
    _, found = warned(lambda: sg.segment(shape, "paper", offset=0.02))
    assert any("leaks" in sentence for sentence in found)
    _, found = warned(lambda: sg.sdf(VERTICES, FACES, offset=0.02))
    assert found == []


def test_field_contains_the_automatically_chosen_offset(tmp_path):
    sg.write(tmp_path / "cloud.ply", VERTICES)
    field, found = warned(lambda: sg.sdf(sg.read(tmp_path / "cloud.ply"), offset="auto"))
    program("sdf", tmp_path / "cloud.ply", "--method", "offset_sdf", "--offset", "auto", "--timings", tmp_path / "t.json",
            "-o", tmp_path / "x.csv")
    report = json.loads((tmp_path / "t.json").read_text())["offset"]
    assert report["automatic"] and field.offset == report["offset"] > 0.01
    values, weights = field
    assert values is field.values and weights is field.weights
    np.testing.assert_array_equal(field.normals, sg.normals(VERTICES, "auto"))
    assert sg.sdf(VERTICES, FACES, offset=0.07).offset == 0.07
    assert sg.field(VERTICES, FACES, "offset_sdf", offset=0.07).offset == 0.07
    assert sg.sdf(VERTICES, FACES, "cone_sdf").offset is None and sg.sdf(VERTICES, FACES, "cone_sdf").normals is None


def test_run_warns_of_omitted_models_by_name(tmp_path):
    for model in ("a/one", "a/two", "b/one", "b/two"):
        (tmp_path / "shapes" / model).parent.mkdir(parents=True, exist_ok=True)
        sg.write(tmp_path / "shapes" / f"{model}.off", VERTICES * (2 if "two" in model else 1), FACES)
    (tmp_path / "shapes/b/three.off").write_text("OFF\n")
    configuration = {"name": "omitted", "dataset": {"root": str(tmp_path / "shapes"), "layout": "folders"},
                     "on_error": "skip",
                     "signatures": [{"name": "cone", "field": {"type": "cone_sdf"}, "histogram": {"range": "dataset"}}]}
    run, found = warned(lambda: sg.run(configuration, tmp_path / "out", cache=""))
    assert len(run.left_out) == 1 and "three" in run.left_out[0]
    assert f"omitted {run.left_out[0]}" in found


def test_sdf_of_a_hollow_body_warns_that_it_measures_the_hull():
    axis = VERTICES * [1, 1, 0]
    axis /= np.linalg.norm(axis, axis=1, keepdims=True)
    vertices = np.concatenate([VERTICES, (VERTICES + axis) / 2])  # inner surface: halfway to the axis of the tube
    faces = np.concatenate([FACES, FACES[:, ::-1] + len(VERTICES)])
    _, found = warned(lambda: sg.sdf(vertices, faces))
    assert [sentence for sentence in found if "hollow (1 inner surface)" in sentence and "hull" in sentence] == found
    _, found = warned(lambda: sg.sdf(vertices, faces, "inscribed_ball"))
    assert found == []


def ball_with_outliers(count):
    """Random points of a unit sphere, and outliers at both ends of the array."""
    points = np.random.default_rng(1).normal(size=(3000, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    far = [[30.0, 0, 0], *[[0, -40.0, 0]] * (count - 1)][:count]
    return np.concatenate([np.reshape(far[:1], (-1, 3)), points, np.reshape(far[1:], (-1, 3))])


def test_outliers_are_removed_on_request_or_with_automatic_offset(tmp_path):
    points = ball_with_outliers(2)
    clean = sg.sdf(points[1:-1], offset="auto")
    for settings in ({"offset": "auto"}, {"offset": clean.offset, "remove_outliers": True}):
        found, messages = warned(lambda: sg.sdf(points, **settings))
        assert len(messages) == 1 and messages[0].startswith("2 of 3002 points are outliers")
        assert found.offset == clean.offset
        assert np.isnan(found.values[[0, -1]]).all() and (found.weights[[0, -1]] == 0).all()
        assert (found.values[1:-1] == clean.values).all() and (found.weights[1:-1] == clean.weights).all()
        assert (found.points == points).all() and (found.normals[1:-1] == clean.normals).all()
    field, messages = warned(lambda: sg.sdf(points, offset=0.05))
    assert np.isfinite(field.values).all()
    assert any("use remove_outliers=True" in sentence for sentence in messages)
    sg.write(tmp_path / "cloud.ply", points)
    lines = program("sdf", tmp_path / "cloud.ply", "--method", "offset_sdf", "--offset", "0.05", "-o",
                    tmp_path / "x.csv")
    lines = [line.replace("--remove-outliers", "remove_outliers=True") for line in commands_warnings(lines)]
    assert sorted(in_python(line) for line in lines) == sorted(messages)


def test_removed_outliers_belong_to_no_part_and_do_not_change_features():
    points = ball_with_outliers(2)
    labels, messages = warned(lambda: sg.segment(points, remove_outliers=True))
    assert (labels[[0, -1]] == -1).all() and (labels[1:-1] == sg.segment(points[1:-1])).all() and len(messages) == 1
    features, _ = warned(lambda: sg.describe(points, "d2", remove_outliers=True))
    assert (features == sg.describe(points[1:-1], "d2")).all()
    _, messages = warned(lambda: sg.describe(points, "d2"))
    assert any("outliers" in sentence for sentence in messages)


def test_normals_unrelated_to_the_surface_are_ignored(tmp_path):
    points = ball_with_outliers(0)
    others = points[::-1]
    for measure in (lambda normals: sg.sdf(points, offset=0.05, normals=normals).values,
                    lambda normals: sg.segment(points, normals=normals),
                    lambda normals: sg.describe(points, "surflet_pairs", normals=normals)):
        found, messages = warned(lambda: measure(others))
        assert (found == warned(lambda: measure(None))[0]).all()
        assert sum("normals of the points are ignored" in sentence for sentence in messages) == 1
        assert not any("normals" in sentence for sentence in warned(lambda: measure(points))[1])
    np.savetxt(tmp_path / "cloud.xyz", np.hstack([points, others]))
    lines = program("sdf", tmp_path / "cloud.xyz", "-o", tmp_path / "x.csv")
    assert sum("normals of the points are ignored" in line for line in commands_warnings(lines)) == 1


def test_zero_normals_are_treated_as_missing():
    points = ball_with_outliers(0)
    zero = np.zeros_like(points)
    assert (sg.sdf(points, offset="auto", normals=zero).values == sg.sdf(points, offset="auto").values).all()
    with pytest.raises(sg.InputError, match="the points have none"):
        sg.sdf(points, method="inscribed_ball", normals=zero)


def test_ties_give_a_warning_with_bounds_of_scores():
    # All distances but one are equal: FT is what the order of equals makes of it.
    labels = [0, 0, 0, 1, 1, 1]
    distances = 1 - np.eye(6)
    distances[0, 1] = distances[1, 0] = 2
    scores, found = warned(lambda: sg.evaluate(distances, labels))
    assert scores.queries_with_ties == 6
    tied = [sentence for sentence in found if "equal distance" in sentence]
    assert len(tied) == 1 and "6 of 6 queries" in tied[0] and "ties='index'" in tied[0]
    assert "FT" in tied[0] and "0.0 to 83.3" in tied[0]
    _, found = warned(lambda: sg.evaluate(*toy()))
    assert len(found) == 1 and "3 of 7 queries" in found[0] and "FT" not in found[0]  # their order changes no FT
    _, found = warned(lambda: sg.evaluate(*untied()))
    assert found == []


def test_warning_counts_models_omitted_as_queries():
    distances, _ = untied()
    scores, found = warned(lambda: sg.evaluate(distances, list("aaabbxy")))
    assert scores.models_left_out == 2
    assert [sentence for sentence in found if "omitted as queries: 2 models" in sentence]


def test_reranking_warns_as_the_command_line_does(tmp_path):
    distances, _ = toy()
    distances[0, 1] += 0.5
    for number, matrix in enumerate([distances, distances.max() - distances]):
        np.save(tmp_path / "d.npy", matrix)
        lines = program("rerank", tmp_path / "d.npy", "-o", tmp_path / f"r{number}.npy", "--neighbours", 2)
        _, found = warned(lambda: sg.rerank(matrix, neighbours=2))
        assert found == commands_warnings(lines) and "not symmetric" in found[-1]
    assert "looks like a matrix of similarities; re-ranking takes distances" in found[0]


def test_similarities_passed_as_distances_give_a_warning():
    distances, labels = untied()
    similarities = distances.max() - distances
    _, found = warned(lambda: sg.evaluate(similarities, labels))
    assert any("similarity=True" in sentence for sentence in found)
    assert not any("--" in sentence for sentence in found)
    scores, found = warned(lambda: sg.evaluate(similarities, labels, similarity=True))
    assert scores.micro == sg.evaluate(distances, labels).micro and found == []


def test_compare_warns_of_equal_distances_and_too_few_classes():
    distances, labels = untied()
    methods = {"good": distances, "tied": np.round(distances / 5)}
    _, found = warned(lambda: sg.compare(methods, labels, blocks="classes"))
    assert [sentence for sentence in found if sentence.startswith("tied: ") and "equal distance" in sentence]
    assert [sentence for sentence in found if "blocks='queries'" in sentence and "test='t'" in sentence]
    assert not [sentence for sentence in found if sentence.startswith("good: ") or "--" in sentence]
    _, found = warned(lambda: sg.compare([distances, distances], labels, test="t"))
    assert len(found) == 1 and "p_classes" in found[0]  # two classes


def test_write_warns_of_coordinates_too_large_for_stl(tmp_path):
    assert warned(lambda: sg.write(tmp_path / "near.stl", VERTICES, FACES))[1] == []
    _, (warning,) = warned(lambda: sg.write(tmp_path / "far.stl", VERTICES + 1e9, FACES))
    assert "single precision of STL" in warning
    assert warned(lambda: sg.write(tmp_path / "far.ply", VERTICES + 1e9, FACES))[1] == []


def test_features_equal_in_single_precision_give_a_warning():
    features = np.random.default_rng(1).random((7, 4))
    labels = list("aaabbbb")
    assert warned(lambda: sg.distances(features, distance="l2"))[1] == []
    for far in (features + 1e9, features * 1e-46):
        _, (warning,) = warned(lambda: sg.distances(far, distance="l2"))
        assert "6 rows equal others" in warning
        assert warning in warned(lambda: sg.evaluate(far, labels, distance="l2"))[1]
