# SPDX-License-Identifier: GPL-3.0-or-later
"""Uses of the package that mypy checks (test_types.py); never run. Lines marked `error` must be errors."""

import pathlib
from typing import Any, List, Tuple

import numpy as np

import shapegauge as sg

vertices, faces, normals = sg.read(pathlib.Path("hand.off"))
field: sg.ScalarField = sg.sdf(vertices, faces, method="offset_sdf", offset=0.05, at="faces")
of_cloud: sg.ScalarField = sg.sdf(vertices, offset="auto")
report: sg.CheckReport = sg.check(vertices, faces, min_wall=1.2)
thinnest: float = min(wall.minimum for wall in report.walls)
values, weights = field
offset: float | None = field.offset
labels: np.ndarray = sg.segment(vertices, faces, parts=3)
sg.write("hand.ply", vertices, faces)
scores: sg.Scores = sg.evaluate(np.zeros((2, 2)), ["a", "a"], confidence=0.95)
tier: float = scores["FT"]
low: Tuple[float, float] = scores.intervals["micro"]["FT"]
run: sg.Run = sg.run({"name": "n"}, on_progress=lambda stage, done, total: None)
left_out: List[str] = run.left_out
index = sg.Index("models", threads=2)
names: List[str] = index.names
answer: Any = index.search("chair.obj", k=3)
wrong: str = scores["FT"]  # error
sg.evaluate(np.zeros((2, 2)), ["a", "a"], protokoll="psb")  # error
sg.read(7)  # error
