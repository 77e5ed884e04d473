# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the Python package with the command line and with known results."""

import json
import os
import subprocess
import types

import numpy as np
import pytest

import shapegauge as sg
from support import CONFIGS, PROGRAM, bumpy_torus, program, toy

@pytest.fixture(scope="module")
def torus():
    return bumpy_torus()


@pytest.fixture
def torus_file(torus, tmp_path):
    sg.write(tmp_path / "torus.off", *torus)
    return tmp_path / "torus.off"


def test_read_returns_the_vertices_and_faces_of_a_file(torus, torus_file):
    shape = sg.read(torus_file)
    np.testing.assert_array_equal(shape.vertices, torus[0])
    np.testing.assert_array_equal(shape.faces, torus[1])
    assert shape.normals.shape == (0, 3)
    assert repr(shape) == "<Shape: 960 vertices, 1920 faces>"


@pytest.mark.parametrize("method", ["offset_sdf", "cone_sdf"])
@pytest.mark.parametrize("at", ["faces", "vertices"])
def test_sdf_matches_the_command_line(torus_file, tmp_path, method, at):
    shape = sg.read(torus_file)
    values, weights = sg.sdf(shape, method=method, at=at)
    offset = ["--offset", "0.05"] if method == "offset_sdf" else []
    program("sdf", torus_file, "--method", method, "--at", at, *offset, "-o", tmp_path / "sdf.csv")
    table = np.genfromtxt(tmp_path / "sdf.csv", delimiter=",", names=True)
    np.testing.assert_array_equal(values, table["sdf"])
    np.testing.assert_array_equal(weights, table["weight"])
    assert 0.2 < np.median(values) < 0.9  # the tube is 0.4 to 0.8 thick


def test_sdf_does_not_depend_on_threads_or_memory_layout(torus):
    vertices, faces = torus
    one, _ = sg.sdf(vertices, faces, threads=1)
    two, _ = sg.sdf(np.asfortranarray(vertices), faces.astype(np.int64), threads=2)
    np.testing.assert_array_equal(one, two)
    assert one.base is not None  # the array of the computation, not a copy


class Rows:
    """Like a vector of Open3D: a sequence of rows convertible by NumPy."""

    def __init__(self, rows=()):
        self.rows = [tuple(row) for row in rows]

    def __len__(self):
        return len(self.rows)

    def __getitem__(self, index):
        return self.rows[index]


def open3d_objects(vertices, faces, normals):
    """A mesh and a cloud of Open3D; mock objects with the same attributes if it is not installed."""
    try:
        import open3d
    except ImportError:
        return (types.SimpleNamespace(vertices=Rows(vertices), triangles=Rows(faces), vertex_normals=Rows()),
                types.SimpleNamespace(points=Rows(vertices), normals=Rows(normals)))
    rows = open3d.utility.Vector3dVector
    mesh = open3d.geometry.TriangleMesh(rows(vertices), open3d.utility.Vector3iVector(faces))
    cloud = open3d.geometry.PointCloud(rows(vertices))
    cloud.normals = rows(normals)
    return mesh, cloud


def test_open3d_objects_are_accepted_as_shapes(torus):
    vertices, faces = torus
    normals = sg.normals(vertices)
    mesh, cloud = open3d_objects(vertices, faces, normals)
    np.testing.assert_array_equal(sg.sdf(mesh).values, sg.sdf(vertices, faces).values)
    np.testing.assert_array_equal(sg.sdf(cloud).values, sg.sdf(vertices, normals=normals).values)
    _, bare = open3d_objects(vertices, faces, [])
    np.testing.assert_array_equal(sg.normals(bare), sg.normals(vertices))


def test_normals_of_a_cloud_point_outward(torus):
    vertices, _ = bumpy_torus(80, 48)
    normals = sg.normals(vertices)
    assert normals.shape == vertices.shape
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-6)
    middle = vertices.copy()
    middle[:, 2] = 0
    middle /= np.linalg.norm(middle, axis=1, keepdims=True)
    assert ((normals * (vertices - middle)).sum(axis=1) > 0).mean() > 0.97


def test_field_computes_centricity_and_rejects_unknown_types(torus):
    values, weights = sg.field(*torus, type="centricity", sources=10)
    assert values.shape == weights.shape == (1920,)
    assert (values > 0).all()
    with pytest.raises(sg.InputError, match="no_such"):
        sg.field(*torus, type="no_such")
    with pytest.raises(ValueError, match="wrong"):
        sg.field(*torus, type="cone_sdf", wrong=1)


def test_segment_matches_the_command_line(torus_file, tmp_path):
    labels = sg.segment(sg.read(torus_file), parts=3)
    program("segment", torus_file, "--parts", 3, "-o", tmp_path / "torus.seg")
    np.testing.assert_array_equal(labels, np.loadtxt(tmp_path / "torus.seg", dtype=int))
    assert labels.dtype == np.int32


def test_segment_by_the_method_of_chen_2018_matches_the_command_line(torus_file, tmp_path):
    labels = sg.segment(sg.read(torus_file), method="paper", field="cone_sdf", parts=2)
    arguments = ["--method", "paper", "--field", "cone_sdf", "--parts", 2]
    program("segment", torus_file, *arguments, "-o", tmp_path / "torus.seg")
    np.testing.assert_array_equal(labels, np.loadtxt(tmp_path / "torus.seg", dtype=int))


@pytest.mark.parametrize(
    "settings", [{"method": "pape"}, {"method": "paper", "patches": 9}, {"part": 3}, {"perturbations": []}]
)
def test_segment_rejects_unknown_settings(torus_file, settings):
    with pytest.raises(ValueError, match=list(settings)[-1]):
        sg.segment(sg.read(torus_file), **settings)


def test_describe_matches_the_command_line(torus_file, tmp_path):
    features = sg.describe(sg.read(torus_file), descriptor="d2", points=500)
    program("describe", torus_file, "--descriptor", "d2", "--set", "points=500", "-o", tmp_path / "d2.npy")
    np.testing.assert_array_equal(features, np.load(tmp_path / "d2.npy")[0].astype(np.float32))


def test_scores_match_a_hand_computation():
    scores = sg.evaluate(*toy(), name="toy")
    assert scores["NN"] == pytest.approx(4 / 7)
    assert scores.macro["FT"] == pytest.approx((1 / 3 + 1 / 2) / 2)
    assert scores.per_query["NN"].tolist() == [1, 1, 0, 0, 0, 1, 1]
    assert scores.per_class["a"]["NN"] == pytest.approx(2 / 3)
    assert dict(scores) == scores.micro
    assert "57.14" in repr(scores) and "toy" in scores.to_markdown() and r"\begin" in scores.to_latex()
    assert scores.to_csv().count("\n") == 3 and "<table>" in scores._repr_html_()
    with pytest.raises(KeyError, match="FT"):
        scores["no such measure"]


def test_scores_and_comparisons_match_the_command_line(tmp_path):
    generator = np.random.default_rng(5)
    labels = np.repeat(np.arange(12), 6)
    points = labels[:, None] + generator.normal(size=(72, 3))
    first = np.linalg.norm(points[:, None] - points[None], axis=2)
    second = first + 0.5 * np.abs(np.subtract.outer(points[:, 0], points[:, 0]))
    for name, matrix in (("first", first), ("second", second)):
        np.save(tmp_path / f"{name}.npy", matrix)
    np.save(tmp_path / "labels.npy", labels)
    of_files = [tmp_path / "first.npy", "--labels", tmp_path / "labels.npy", "--format", "json"]
    data = json.loads(subprocess.run([PROGRAM, "evaluate", *map(str, of_files)], check=True, capture_output=True).stdout)
    assert sg.evaluate(first, labels).micro == data["micro"]
    of_files = [tmp_path / "first.npy", tmp_path / "second.npy", *of_files[1:]]
    data = json.loads(subprocess.run([PROGRAM, "compare", *map(str, of_files)], check=True, capture_output=True).stdout)
    comparison = sg.compare({"first": first, "second": second}, labels)
    assert comparison.results == data
    assert "first" in repr(comparison) and r"\begin" in comparison.to_latex() and "|" in comparison.to_markdown()


def test_reranked_distances_match_the_command_line(tmp_path):
    distances, _ = toy()
    np.save(tmp_path / "toy.npy", distances)
    program("rerank", tmp_path / "toy.npy", "--neighbours", 3, "-o", tmp_path / "better.npy")
    np.testing.assert_array_equal(sg.rerank(distances, neighbours=3), np.load(tmp_path / "better.npy"))


def test_rerank_accepts_neighbours_as_number_list_or_auto():
    distances, _ = toy()
    np.testing.assert_array_equal(sg.rerank(distances, neighbours="auto"),
                                  sg.rerank(distances, neighbours=np.array([4, 5, 7, 10, 14, 20])))
    assert not np.array_equal(sg.rerank(distances, neighbours="auto"), sg.rerank(distances, neighbours=4))


def test_fuse_adds_weighted_and_scaled_distances():
    distances, _ = toy()
    other = np.sqrt(distances)
    plain = sg.fuse([distances, other], [2, 0.5], scale="none")
    np.testing.assert_allclose(plain, 2 * distances + 0.5 * other, rtol=1e-14)
    assert sg.fuse([distances, other]).shape == distances.shape
    local = sg.fuse([distances, other], scale="local", weights="agreement")
    np.testing.assert_allclose(local, sg.fuse([1024 * distances, other / 8], scale="local", weights="agreement"),
                               rtol=1e-12)


def test_features_do_not_depend_on_the_unit_of_a_shape():
    vertices, faces = bumpy_torus()
    fixed = {"fields": [{"type": "cone_sdf"}, {"type": "centricity"}],
             "axes": [{"bins": 16, "low": 0, "high": 1}, {"bins": 16, "low": 0, "high": 2}]}
    for descriptor, settings in (("joint_histogram", fixed), ("surflet_pairs", {}), ("shape_dna", {})):
        features = sg.describe(vertices, faces, descriptor, **settings)
        assert np.count_nonzero(features) > 5
        np.testing.assert_array_equal(features, sg.describe(4 * vertices, faces, descriptor, **settings))


SMALL = ["dataset.generate.classes=2", "dataset.generate.models_per_class=3", "dataset.generate.faces=1000"]


def test_run_writes_the_same_files_as_the_command_line(tmp_path):
    configuration = os.path.join(CONFIGS, "quickstart.json")
    done = sg.run(configuration, tmp_path / "python", settings=SMALL, cache="")
    sets = [word for one in SMALL for word in ("--set", one)]
    program("run", configuration, "--output", tmp_path / "program", "--no-cache", *sets)
    for name in ("summary.csv", "per_query.csv", "pr_curves.csv"):
        assert (tmp_path / "python" / name).read_bytes() == (tmp_path / "program" / name).read_bytes()
    assert done.left_out == [] and "Results in" in repr(done)


def test_run_of_a_segmentation_writes_the_same_files_as_the_command_line(tmp_path):
    document = {
        "name": "parts",
        "dataset": {"generate": {"classes": 1, "models_per_class": 2, "faces": 1000}},
        "segmentation": [{"name": "three", "method": "best", "parts": 3}],
    }
    (tmp_path / "parts.json").write_text(json.dumps(document))
    one_setting = "segmentation.0.parts=2"
    done = sg.run(tmp_path / "parts.json", tmp_path / "python", cache="", settings=one_setting)
    program("run", tmp_path / "parts.json", "--output", tmp_path / "program", "--no-cache", "--set", one_setting)
    names = [path.name for path in (tmp_path / "program").glob("*.csv") if path.name != "timings.csv"]
    assert names and "three" in done.summary
    for name in names:
        assert (tmp_path / "python" / name).read_bytes() == (tmp_path / "program" / name).read_bytes()
