# SPDX-License-Identifier: GPL-3.0-or-later
"""Defaults of signatures and docstrings are those of the registries."""

import inspect
import json

import numpy as np
import pytest
from support import bumpy_torus

import shapegauge as sg
from shapegauge import _native

REGISTERED = json.loads(_native.settings())


def section(name):
    return {key: setting["default"] for key, setting in REGISTERED["sections"][name]["settings"].items()}


COMPARISON = {key: setting["default"] for key, setting in REGISTERED["options"]["compare"].items() if key != "average"}


@pytest.mark.parametrize("function, registered", [
    (sg.evaluate, {**section("evaluation"), **{key: COMPARISON[key] for key in ("resamples", "seed")}}),
    (sg.compare, {**section("evaluation"), **COMPARISON}),
    (sg.fuse, {key: value for key, value in section("signature").items() if key != "score"}),
    (sg.segment, {"method": section("segmentation_method")["method"]}),
    (sg.rerank, {"method": next(iter(REGISTERED["rerank"]))}),
    (sg.field, {"type": next(iter(REGISTERED["fields"]))}),
], ids=lambda value: getattr(value, "__name__", ""))
def test_default_arguments_match_the_registered_settings(function, registered):
    parameters = inspect.signature(function).parameters
    assert {name: parameters[name].default for name in registered} == registered


def test_fuse_uses_the_registered_weight_by_default():
    distances = [np.abs(np.subtract.outer(x, x)) for x in (np.arange(6.0) ** 2, np.arange(6.0)[::-1] ** 1.5)]
    weight = section("sum_term")["weight"]
    assert (sg.fuse(distances) == sg.fuse(distances, weight=[weight, weight])).all()
    assert (sg.fuse(distances) != sg.fuse(distances, weight=[weight, 2 * weight])).any()


def test_sdf_uses_the_registered_defaults():
    vertices, faces = bumpy_torus()
    cone = {name: setting["default"] for name, setting in REGISTERED["fields"]["cone_sdf"]["settings"].items()}
    field = sg.sdf(vertices, faces, "cone_sdf", **cone)
    assert (field.values == sg.sdf(vertices, faces, "cone_sdf").values).all()
    offset = REGISTERED["options"]["sdf"]["offset"]["default"]
    assert sg.sdf(vertices, faces).offset == offset
    accuracy = REGISTERED["fields"]["offset_sdf"]["settings"]["accuracy"]["default"]
    assert (sg.sdf(vertices, faces).values == sg.sdf(vertices, faces, offset=offset, accuracy=accuracy).values).all()


def test_sdf_accepts_every_setting_of_every_thickness_method():
    thicknesses = {name: entry["settings"] for name, entry in REGISTERED["fields"].items() if entry["is_thickness"]}
    parameters = inspect.signature(sg.sdf).parameters
    for settings in thicknesses.values():
        assert set(settings) <= set(parameters)
    vertices, faces = bumpy_torus()
    *others, last = (f'"{name}"' for name in thicknesses)
    for method in [*(REGISTERED["fields"].keys() - thicknesses.keys()), "thickness"]:
        with pytest.raises(sg.InputError, match=f"must be {', '.join(others)} or {last}, not"):
            sg.sdf(vertices, faces, method)
    post = sg.sdf(vertices, faces, "cone_sdf", engine="cgal", postprocess=True).values
    assert (post == sg.field(vertices, faces, "cone_sdf", engine="cgal", postprocess=True).values).all()
    assert post.min() == 0 and post.max() == 1
    with pytest.raises(sg.InputError, match='postprocess requires method="cone_sdf", not "inscribed_ball"'):
        sg.sdf(vertices, faces, "inscribed_ball", postprocess=True)


def test_sdf_by_inscribed_balls_equals_the_field_inscribed_ball():
    vertices, faces = bumpy_torus()
    ball = sg.field(vertices, faces, "inscribed_ball", separation_angle_degrees=30).values
    assert (sg.sdf(vertices, faces, "inscribed_ball", separation_angle_degrees=30).values == ball).all()
    assert (ball != sg.sdf(vertices, faces, "inscribed_ball").values).any()


@pytest.mark.parametrize("function, kind", [(sg.field, "fields"), (sg.describe, "descriptors"), (sg.rerank, "rerank")],
                         ids=lambda value: getattr(value, "__name__", value))
def test_docstrings_list_every_registered_method_with_its_settings(function, kind):
    lines = inspect.getdoc(function).splitlines()
    for name, entry in REGISTERED[kind].items():
        begin = next(i for i, line in enumerate(lines) if line.strip().startswith(f'"{name}": '))
        end = next((i for i in range(begin, len(lines)) if not lines[i].strip()), len(lines))
        text = " ".join(line.strip() for line in lines[begin:end])
        for setting, known in entry["settings"].items():
            default = "required" if known["default"] is None else f"default: {json.dumps(known['default'])}"
            assert f" {setting}: {known['meaning'].rstrip('.')} ({known['values']}; {default})" in text
