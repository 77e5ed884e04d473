# SPDX-License-Identifier: GPL-3.0-or-later
"""The check of a part: regions with their faces."""

import numpy as np
import pytest

import shapegauge as sg

# A plate of thickness 1: faces 0 to 3 are its large sides.
VERTICES = np.array([[x, y, z] for z in (0, 1) for y in (0, 12) for x in (0, 20)], float)
FACES = np.array([[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4], [2, 6, 7], [2, 7, 3], [0, 4, 6],
                  [0, 6, 2], [1, 3, 7], [1, 7, 5]])


def test_check_reports_the_thin_sides_of_a_plate_with_their_faces():
    report = sg.check(VERTICES, FACES, min_wall=1.2, min_gap=0.5)
    assert not report.passes
    assert report.closed and report.voids == 0 and report.gaps == [] and report.small_regions == 0
    assert sorted(region.faces.tolist() for region in report.walls) == [[0, 1], [2, 3]]
    for region in report.walls:
        assert region.kind == "wall"
        assert region.area == pytest.approx(240)
        assert region.minimum == pytest.approx(1) and region.median == pytest.approx(1)
        assert np.linalg.norm(region.position - region.opposite) == pytest.approx(1)


def test_check_passes_a_plate_thicker_than_the_minimum_wall():
    assert sg.check(VERTICES, FACES, 0.9).passes
    assert sg.check(VERTICES, FACES, min_wall=1.2, min_area=241).small_regions == 2


@pytest.mark.parametrize("arguments, word", [
    ({}, "min_wall"), ({"min_wall": -1}, "min_wall"), ({"min_gap": float("nan")}, "min_gap"),
    ({"min_wall": 1, "min_area": -1}, "min_area"), ({"min_wall": 1, "separation_angle_degrees": 180}, "separation")])
def test_check_rejects_missing_negative_and_nan_limits(arguments, word):
    with pytest.raises(sg.InputError, match=word):
        sg.check(VERTICES, FACES, **arguments)


def test_check_warns_of_an_open_mesh():
    with pytest.warns(UserWarning, match="not closed"):
        assert not sg.check(VERTICES, FACES[:-1], min_wall=1.2).closed
