# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of functions: accepted forms and errors."""

import inspect
import types

import numpy as np
import pytest

import shapegauge as sg
from support import bumpy_torus, mesh_object, toy

VERTICES, FACES = bumpy_torus(20, 12)
MESH = mesh_object(VERTICES, FACES)


def objects():
    """The same mesh in the data structures of several libraries."""
    padded = np.c_[np.full(len(FACES), 3), FACES].ravel()
    return [
        MESH,
        types.SimpleNamespace(vertices=VERTICES, triangles=FACES),  # Open3D
        types.SimpleNamespace(points=VERTICES, faces=padded),  # PyVista
        sg.Shape(VERTICES, FACES, np.zeros((0, 3))),
    ]


@pytest.mark.parametrize("mesh", objects(), ids=["trimesh", "Open3D", "PyVista", "Shape"])
def test_positional_settings_work_alike_after_mesh_objects_and_arrays(mesh):
    both = (VERTICES, FACES)
    for settings in (("offset_sdf", 0.03), ("offset_sdf", 0.2), ("cone_sdf",), ()):
        np.testing.assert_array_equal(sg.sdf(mesh, *settings).values, sg.sdf(*both, *settings).values)
    assert (sg.sdf(mesh, "offset_sdf", 0.03).values != sg.sdf(mesh, "offset_sdf", 0.2).values).any()
    np.testing.assert_array_equal(sg.field(mesh, "cone_sdf").values, sg.field(*both, "cone_sdf").values)
    np.testing.assert_array_equal(sg.normals(mesh, 0.2), sg.normals(*both, offset=0.2))
    np.testing.assert_array_equal(sg.describe(mesh, "d2"), sg.describe(*both, "d2"))
    np.testing.assert_array_equal(sg.segment(mesh, "paper", parts=2), sg.segment(*both, "paper", parts=2))


def test_functions_accept_arrays_by_keyword_and_clouds_without_faces():
    by_name = sg.sdf(vertices=VERTICES, faces=FACES, offset=0.1).values
    np.testing.assert_array_equal(by_name, sg.sdf(VERTICES, faces=FACES, method="offset_sdf", offset=0.1).values)
    np.testing.assert_array_equal(sg.describe(VERTICES, "d2"), sg.describe(VERTICES, None, "d2"))
    np.testing.assert_array_equal(sg.normals(VERTICES, 0.2), sg.normals(VERTICES, offset=0.2))
    np.testing.assert_array_equal(sg.sdf(MESH, None, "cone_sdf").values, sg.sdf(MESH, "cone_sdf").values)
    assert list(inspect.signature(sg.sdf).parameters)[:4] == ["vertices", "faces", "method", "offset"]
    assert list(inspect.signature(sg.write).parameters) == ["path", "vertices", "faces", "normals"]


def test_write_accepts_mesh_and_cloud_objects(tmp_path):
    sg.write(tmp_path / "mesh.off", MESH)
    np.testing.assert_array_equal(sg.read(tmp_path / "mesh.off").faces, FACES)
    normals = VERTICES / np.linalg.norm(VERTICES, axis=1, keepdims=True)
    sg.write(tmp_path / "cloud.ply", types.SimpleNamespace(points=VERTICES), normals)
    np.testing.assert_allclose(sg.read(tmp_path / "cloud.ply").normals, normals, atol=1e-6)


def test_settings_accept_numpy_numbers():
    expected = sg.field(MESH, "centricity", sources=5).values
    np.testing.assert_array_equal(sg.field(MESH, "centricity", sources=np.int64(5)).values, expected)
    surface = sg.sdf(MESH, "cone_sdf", at={"surface": np.int32(50)}, threads=np.int64(1))
    assert surface.values.shape == (50,)
    np.testing.assert_array_equal(sg.sdf(VERTICES.astype(object), FACES.astype(object)).values, sg.sdf(MESH).values)


DISTANCES, LABELS = toy()
CALLS = [
    # Unknown or incompatible arguments.
    (lambda: sg.sdf(MESH, "cone_sdf", "garbage"), "offset"),
    (lambda: sg.sdf(MESH, "cone_sdf", 0.05, 3), "positional"),
    (lambda: sg.sdf(VERTICES, FACES, "offset_sdf", 0.05, "fine"), "positional"),
    (lambda: sg.sdf(MESH, "offset_sdf", rays=9), "rays"),
    (lambda: sg.sdf(MESH, FACES), "faces"),
    (lambda: sg.sdf(MESH, faces=FACES), "faces"),
    (lambda: sg.sdf(), "vertices"),
    (lambda: sg.sdf(MESH, nonsense=1), "nonsense"),
    (lambda: sg.field(MESH, "centricity", 5), "positional"),
    (lambda: sg.normals(MESH, "auto", 3), "positional"),
    (lambda: sg.segment(MESH, "best", 3), "positional"),
    (lambda: sg.segment(MESH, name="x"), "name"),
    (lambda: sg.describe(MESH, "d2", 3), "positional"),
    (lambda: sg.describe(MESH, "light_field", type="d2"), "type"),
    (lambda: sg.write("x.off", MESH, 3), "normals"),
    (lambda: sg.sdf(MESH, normals=VERTICES), "normals"),
    (lambda: sg.sdf(VERTICES, normals=VERTICES[:-1]), "normals for"),
    (lambda: sg.sdf(VERTICES[:-1], normals=VERTICES), "normals for"),
    # Arrays.
    (lambda: sg.sdf([[0, 0, 0]], [[0, 1, 2]]), "outside 0..0"),
    (lambda: sg.sdf([[0, 0, 0], [1, 0, 0], [0, np.nan, 0]], [[0, 1, 2]]), "finite"),
    (lambda: sg.sdf([[0, 0, 0], [1, 0, 0], [0, None, 0]], [[0, 1, 2]]), "entry 2, 1 "),
    (lambda: sg.sdf([[0, 0], [1, 0, 0], [0, 0, 1]], [[0, 1, 2]]), "vertices"),
    (lambda: sg.sdf(np.zeros((4, 2)), [[0, 1, 2]]), "n x 3"),
    (lambda: sg.sdf(np.zeros((5, 0)), [[0, 1, 2]]), "n x 3"),
    (lambda: sg.sdf(VERTICES * 1j, FACES), "complex"),
    (lambda: sg.sdf(VERTICES > 0, FACES), "booleans"),
    (lambda: sg.sdf(VERTICES.astype(str), FACES), "text"),
    (lambda: sg.sdf(np.ma.masked_greater(VERTICES, 0), FACES), "masked"),
    (lambda: sg.sdf([], []), "extent"),
    (lambda: sg.sdf("hand.off"), "path of a file"),
    (lambda: sg.sdf(None), "None"),
    (lambda: sg.sdf((np.eye(3), [[0, 1, 2]])), "two arguments"),
    (lambda: sg.sdf(object()), "n x 3"),
    (lambda: sg.sdf(np.eye(3), [[0.0, 1.0, 2.0]]), "whole numbers"),
    (lambda: sg.sdf(np.eye(3), [[0, 1, -1]]), "indices"),
    (lambda: sg.sdf(np.eye(4), [[0, 1, 2, 3]]), "n x 3"),
    (lambda: sg.sdf(np.zeros((5, 3)), [[0, 1, 2, 3, 4]]), "n x 4 for quads"),
    (lambda: sg.sdf(np.zeros((5, 3)), remove_outliers=1), "remove_outliers must be True or False"),
    (lambda: sg.sdf(np.eye(3), [[0, 1, 2, 3]]), "vertex outside"),
    (lambda: sg.sdf(np.eye(3), [[0, 1, 2, 0, 1]]), "triangles"),
    (lambda: sg.sdf(types.SimpleNamespace(points=VERTICES, faces=[4, 0, 1, 2, 3])), "triangles"),
    (lambda: sg.sdf(types.SimpleNamespace(points=VERTICES, cells=np.array([4, 0, 1, 2, 3]))), "cells"),
    # Settings.
    (lambda: sg.sdf(MESH, threads=-1), "threads is -1"),
    (lambda: sg.sdf(MESH, threads=True), "threads"),
    (lambda: sg.sdf(MESH, threads=1.5), "threads"),
    (lambda: sg.evaluate(DISTANCES, LABELS, threads=10**30), "threads"),
    (lambda: sg.sdf(MESH, offset=float("nan")), "offset is nan"),
    (lambda: sg.sdf(MESH, offset=-1), "offset"),
    (lambda: sg.sdf(MESH, "x"), "cone"),
    (lambda: sg.sdf(np.eye(3), normals=np.full((3, 3), np.nan)), "normals"),
    (lambda: sg.sdf(MESH, "cone_sdf", opening_angle_degrees=500), "opening_angle_degrees: "),
    (lambda: sg.sdf(MESH, "cone_sdf", rays={1}), "rays"),
    (lambda: sg.sdf(MESH, "cone_sdf", separation_angle_degrees=5), 'separation_angle_degrees requires method="inscribed_ball"'),
    (lambda: sg.sdf(MESH, "inscribed_ball", separation_angle_degrees=180), "separation_angle_degrees: "),
    (lambda: sg.field(MESH, "centricity", sources=float("inf")), "sources is inf"),
    (lambda: sg.field(MESH, 5), "type"),
    (lambda: sg.describe(MESH, "x"), "^descriptor: "),
    (lambda: sg.read("no such file.off"), "no such file.off"),
    (lambda: sg.read(3), "path"),
    (lambda: sg.read("nul\0byte.off"), "path"),
    (lambda: sg.read(""), "path"),
    (lambda: sg.write(3, MESH), "path"),
    (lambda: sg.sdf([[10**400, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]), "too large"),
    (lambda: sg.sdf(MESH, offset=10**400), "finite"),
    # Distances.
    (lambda: sg.evaluate(np.zeros((3, 4)), [0, 0, 1]), "n x n"),
    (lambda: sg.evaluate(DISTANCES[0], LABELS), "of pairs"),
    (lambda: sg.rerank(DISTANCES[0]), "squareform"),
    (lambda: sg.evaluate(DISTANCES.astype(int) + 2**53, LABELS), "2.53"),
    (lambda: sg.evaluate(DISTANCES * 1j, LABELS), "complex"),
    (lambda: sg.evaluate(DISTANCES.astype(str), LABELS), "text"),
    (lambda: sg.evaluate(np.full((7, 7), np.nan), LABELS), "row 0, column 1"),
    (lambda: sg.evaluate(np.zeros((0, 0)), []), "no class"),
    (lambda: sg.evaluate(DISTANCES, LABELS, "x"), "protocol"),
    (lambda: sg.evaluate(DISTANCES, LABELS, ties="x"), "ties"),
    (lambda: sg.evaluate(DISTANCES, LABELS, measures="x"), '"x"'),
    (lambda: sg.evaluate(DISTANCES, LABELS, measures=[1]), "measures"),
    (lambda: sg.evaluate(DISTANCES, LABELS, measures={"FT", "NN"}), "order"),
    (lambda: sg.evaluate(DISTANCES, LABELS, minimum_class_size=0), "minimum_class_size"),
    (lambda: sg.evaluate(DISTANCES, LABELS, minimum_class_size=9), "no class has 9"),
    (lambda: sg.evaluate(DISTANCES, LABELS, similarity=1), "similarity"),
    (lambda: sg.compare(DISTANCES, LABELS), "list of distances"),
    (lambda: sg.compare({"a": DISTANCES}, LABELS), "two methods"),
    (lambda: sg.compare({1: DISTANCES, "1": DISTANCES}, LABELS), "same name"),
    (lambda: sg.compare({"a": DISTANCES, "b": DISTANCES[:3, :3]}, LABELS), "b: "),
    (lambda: sg.compare([DISTANCES, DISTANCES], LABELS, confidence=2), "confidence"),
    (lambda: sg.compare([DISTANCES, DISTANCES], LABELS, confidence=0.4), "confidence is 0.4; it must be from 0.5"),
    (lambda: sg.compare([DISTANCES, DISTANCES], LABELS, resamples=0), "resamples is 0; it must be a whole number from 1"),
    (lambda: sg.rerank(DISTANCES, neighbors=4), 'did you mean "neighbours"'),
    (lambda: sg.compare([DISTANCES, DISTANCES], LABELS, confidence="x"), "confidence"),
    (lambda: sg.compare([DISTANCES, DISTANCES], LABELS, seed=-1), "seed"),
    (lambda: sg.compare([DISTANCES, DISTANCES], LABELS, blocks="x"), "blocks"),
    (lambda: sg.fuse(DISTANCES), "n x n"),
    (lambda: sg.fuse([]), "distances"),
    (lambda: sg.fuse([DISTANCES, DISTANCES[:3, :3]]), "one size"),
    (lambda: sg.fuse([DISTANCES, DISTANCES], [1]), "weight"),
    (lambda: sg.fuse([DISTANCES, DISTANCES], [1, -1]), "weight"),
    (lambda: sg.fuse([DISTANCES], scale="x"), "scale"),
    (lambda: sg.fuse([DISTANCES], weights="x"), "weights"),
    (lambda: sg.rerank(np.zeros((3, 3)), wrong=1), "wrong"),
    (lambda: sg.rerank(DISTANCES, neighbours=[4, 0]), "neighbours"),
    (lambda: sg.rerank(DISTANCES, neighbours="x"), "neighbours"),
    (lambda: sg.rerank(DISTANCES, neighbours=[]), "neighbours"),
    (lambda: sg.rerank(np.zeros((3, 3)), "x"), "x"),
    (lambda: sg.rerank(DISTANCES, neighbours=float("nan")), "neighbours is nan"),
    (lambda: sg.rerank(DISTANCES - 1), "negative"),
    # Experiments.
    (lambda: sg.run("no such file.json"), "no such file.json"),
    (lambda: sg.run({"signatures": []}), "signatures"),
    (lambda: sg.run(3), "configuration must be the path"),
    (lambda: sg.run("no such file.json", settings={"a": "b"}), "settings"),
]


@pytest.mark.parametrize("call, words", CALLS)
def test_invalid_arguments_of_each_function_raise_an_error_of_one_line(call, words):
    with pytest.raises((sg.InputError, TypeError), match=words) as caught:
        call()
    assert "\n" not in str(caught.value) and "json.exception" not in str(caught.value)
    if caught.type is TypeError:  # invalid call, reported by Python
        assert words in ("positional", "nonsense", "vertices")


def test_measures_argument_accepts_one_name_or_any_iterable():
    ft = sg.evaluate(DISTANCES, LABELS, measures=["FT"]).micro
    assert sg.evaluate(DISTANCES, LABELS, measures="FT").micro == ft
    assert sg.evaluate(DISTANCES, LABELS, measures=(name for name in ["FT"])).micro == ft
    comparison = sg.compare({"a": DISTANCES, "b": DISTANCES}, LABELS, measures="FT")
    assert list(comparison.results["measures"]) == ["FT"]


@pytest.mark.filterwarnings("ignore")
def test_compare_names_listed_methods_by_their_position():
    listed = sg.compare([DISTANCES, DISTANCES.max() - DISTANCES], LABELS, resamples=100)
    named = sg.compare({"method 1": DISTANCES, "method 2": DISTANCES.max() - DISTANCES}, LABELS, resamples=100)
    assert listed.results == named.results
    assert "method 2" in repr(listed)


def test_strings_that_are_not_unicode_are_rejected():
    for call in (lambda: sg.describe(MESH, "\udcff"), lambda: sg.segment(MESH, "\udcff"),
                 lambda: sg.field(MESH, "centricity", sources="\udcff"),
                 lambda: sg.run({"name": "a", "dataset": {"root": "x\udcff"}})):
        with pytest.raises(sg.InputError, match="not Unicode text"):
            call()


def test_recursive_settings_are_rejected():
    configuration = {"name": "endless", "signatures": []}
    configuration["signatures"].append({"more": configuration})
    with pytest.raises(sg.InputError, match="^configuration contains itself, or is nested more than 100 deep$"):
        sg.run(configuration)
    values = []
    values.append(values)
    with pytest.raises(sg.InputError, match="^bins contains itself"):
        sg.describe(MESH, "histogram", bins=values)
