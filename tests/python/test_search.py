# SPDX-License-Identifier: GPL-3.0-or-later
"""Index and search: the same as the command line."""

import json
import pathlib
import subprocess

import numpy as np
import pytest

import shapegauge as sg
from support import PROGRAM, bumpy_torus, mesh_object

METHOD = {"name": "quick", "signatures": [{"name": "d2", "descriptor": {"type": "d2"}}]}


@pytest.fixture
def models(tmp_path):
    """Boxes and tori of several proportions, and one invalid file."""
    folder = tmp_path / "models"
    folder.mkdir()
    vertices, faces = bumpy_torus()
    for i in range(4):
        sg.write(folder / f"torus{i}.off", vertices * [1, 1, 1 + 0.2 * i], faces)
        sg.write(folder / f"flat{i}.off", vertices * [1, 1, 0.1 + 0.02 * i], faces)
    (folder / "broken.off").write_text("OFF\n1 0 0\n")
    return folder


def opened(models, **settings):
    with pytest.warns(UserWarning, match="omitted broken.off"):
        return sg.Index(models, method=METHOD, cache="", **settings)


def test_index_lists_its_shapes_and_files(models):
    index = opened(models)
    assert len(index) == 8
    assert index.names == sorted(index.names)
    assert [str(models / name) for name in index.names] == index.files
    assert list(index.left_out) == ["broken.off"]
    assert index.signature == "d2"
    assert index.file == str(models) + ".quick.search-index"
    assert len(sg.Index(models, method=METHOD, cache="")) == 8  # described before: no warning
    assert len(sg.Index(models, method=METHOD, cache="", update=False)) == 8


def test_search_matches_the_command_line(models, tmp_path):
    index = opened(models)
    method = tmp_path / "quick.json"
    method.write_text(json.dumps({**METHOD, "dataset": {"layout": "folders", "root": "."}}))
    command = [PROGRAM, "search", models / "flat1.off", models, "-k", "5", "--format", "json", "--method", method,
               "--cache", tmp_path / "cache"]
    printed = json.loads(subprocess.run(command, capture_output=True, text=True).stdout)["queries"][0]
    answer = index.search(models / "flat1.off", k=5)
    assert answer.member == printed["name"] == "flat1.off"
    assert answer.names == [one["name"] for one in printed["results"]]
    assert answer.distances.tolist() == [one["distance"] for one in printed["results"]]
    assert set(answer.names[:3]) == {"flat0.off", "flat2.off", "flat3.off"}
    assert [found.file for found in answer] == [str(models / name) for name in answer.names]


def test_search_accepts_a_file_an_object_or_arrays_as_query(models, tmp_path):
    index = opened(models)
    vertices, faces = bumpy_torus()
    vertices = vertices * [1, 1, 0.15]
    sg.write(tmp_path / "query.off", vertices, faces)
    expected = index.search(tmp_path / "query.off", k=3)
    read = sg.read(tmp_path / "query.off")
    for query in (read, mesh_object(read.vertices, read.faces), (read.vertices, read.faces)):
        answer = index.search(query, k=3)
        assert answer.names == expected.names
        assert answer.distances.tolist() == expected.distances.tolist()
    assert expected.member is None


def test_search_returns_one_answer_per_query(models, tmp_path):
    index = opened(models)
    answers = index.search([models / "flat0.off", models / "broken.off", models / "torus0.off"], k=2)
    assert [len(answer) for answer in answers] == [2, 0, 2]
    assert "broken.off" in answers[1].failure
    with pytest.raises(sg.InputError, match="broken.off"):
        index.search(models / "broken.off")


def test_search_reranks_and_writes_a_page_on_request(models, tmp_path):
    index = opened(models)
    plain = index.search(models / "flat0.off")
    calls = []
    reranked = index.search(models / "flat0.off", rerank=True, page=tmp_path / "page.html",
                            on_progress=lambda stage, done, total: calls.append((stage, done, total)))
    assert sorted(plain.names) == sorted(reranked.names)
    assert plain.distances.tolist() != reranked.distances.tolist()
    assert "flat0.off" in (tmp_path / "page.html").read_text()
    assert {stage for stage, _, _ in calls} >= {"queries", "pictures"}
    assert all(0 <= done <= total for _, done, total in calls)


def test_search_page_shows_the_requested_up_axis(models, tmp_path):
    index = opened(models)
    query = models / "flat0.off"
    pages = {up: tmp_path / f"{up}.html" for up in ("auto", "y", "z")}
    for up, page in pages.items():
        index.search(query, page=page, up=up)
    assert pages["auto"].read_text() == pages["y"].read_text() != pages["z"].read_text()
    with pytest.raises(sg.InputError, match='unknown up "north"'):
        index.search(query, up="north")


def test_search_page_overwrites_existing_pages_only_on_request(models, tmp_path):
    index = opened(models)
    query = models / "flat0.off"
    before = {path: path.read_bytes() for path in (query, pathlib.Path(index.file))}
    for page, words in [(query, "must end in .html or .htm"), (index.file, "must end in .html or .htm"),
                        (tmp_path / "absent" / "page.html", "cannot write")]:
        with pytest.raises(sg.InputError, match=words):
            index.search(query, page=page)
    assert {path: path.read_bytes() for path in before} == before
    page = tmp_path / "page.html"
    page.symlink_to(query)
    with pytest.raises(sg.InputError, match="page would overwrite the input"):
        index.search(query, page=page, replace=True)
    page.unlink()
    page.write_text("mine")
    with pytest.raises(sg.InputError, match="page.html exists; give another name, or overwrite it with replace=True"):
        index.search(query, page=page)
    assert page.read_text() == "mine"
    index.search(query, page=page, replace=True)
    assert "flat0.off" in page.read_text()


def test_index_updates_for_removed_files_and_rebuilds_for_another_method(models):
    opened(models)
    (models / "broken.off").unlink()
    index = sg.Index(models, method=METHOD, cache="")
    assert index.left_out == {}
    with pytest.warns(UserWarning, match="of another method or program"):
        other = {**METHOD, "signatures": [{"name": "d2", "descriptor": {"type": "d2", "bins": 20}}]}
        assert sg.Index(models, method=other, cache="").signature == "d2"


def test_index_does_not_overwrite_files_that_are_not_indexes(models):
    before = (models / "flat0.off").read_bytes()
    with pytest.raises(sg.InputError, match="flat0.off is not an index"):
        sg.Index(models, models / "flat0.off", method=METHOD, cache="")
    assert (models / "flat0.off").read_bytes() == before


def test_search_messages_refer_to_python_arguments(models, tmp_path):
    with pytest.warns(UserWarning, match="choose another file with index$"):
        sg.Index(models, tmp_path / "absent" / "index", method=METHOD, cache="")
    opened(models, index=tmp_path / "one")
    other = {**METHOD, "signatures": [{"name": "d2", "descriptor": {"type": "d2", "bins": 20}}]}
    with pytest.raises(sg.InputError, match="rebuild it by searching without update=False"):
        sg.Index(models, tmp_path / "one", method=other, cache="", update=False)
    reranked = {"name": "r", "signatures": [*METHOD["signatures"],
                                            {"name": "better", "rerank": {"of": "d2", "method": "diffusion"}}]}
    with pytest.raises(sg.InputError, match="rerank=True"):
        sg.Index(models, method=reranked, signature="better", cache="")


def test_data_frame_of_search_results_lists_names_files_and_distances(models):
    pytest.importorskip("pandas")
    frame = opened(models).search(models / "flat0.off", k=4).to_frame()
    assert list(frame.columns) == ["name", "file", "distance"]
    assert list(frame.index) == [1, 2, 3, 4]
    assert np.all(np.diff(frame["distance"]) >= 0)


@pytest.mark.parametrize("arguments, words", [
    ({"k": 0}, "k is 0"),
    ({"rerank": "yes"}, "rerank must be True or False"),
    ({"query": 7}, "query must be the path"),
    ({"query": "absent.off"}, "absent.off"),
    ({"on_progress": 3}, "on_progress must be a function"),
])
def test_search_rejects_zero_results_and_arguments_of_the_wrong_type(models, arguments, words):
    index = opened(models)
    with pytest.raises(sg.InputError, match=words):
        index.search(**{"query": models / "flat0.off", **arguments})


def test_index_rejects_missing_collections_and_incompatible_arguments(models, tmp_path):
    for arguments, words in [((tmp_path / "absent", ), "absent"), ((models / "flat0.off", ), "is not a collection")]:
        with pytest.raises(sg.InputError, match=words):
            sg.Index(*arguments)
    with pytest.raises(sg.InputError, match="signature requires method"):
        sg.Index(models, signature="d2")
    with pytest.raises(sg.InputError, match="articulated"):
        sg.Index(models, method=METHOD, articulated=True)
    with pytest.raises(sg.InputError, match="signatures"):
        sg.Index(models, method={"name": "x", "signatures": 3})
