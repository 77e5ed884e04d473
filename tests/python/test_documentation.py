# SPDX-License-Identifier: GPL-3.0-or-later
"""Output shown in docs/manual/python.md equals that of the code."""

import contextlib
import io
import json
import os
import re
import subprocess
import sys

import pytest

DOCS = os.path.join(os.environ["SHAPEGAUGE_CONFIGS"], "..", "docs/manual")


def test_example_prints_the_output_shown_in_the_manual():
    with open(os.path.join(DOCS, "python.md"), encoding="utf-8") as file:
        example, output = re.search(r"```python\n(.*?)```\n\nprints\n\n```\n(.*?)```", file.read(), re.S).groups()
    run = subprocess.run([sys.executable, "-c", example], check=True, capture_output=True, text=True)
    assert run.stdout == output


def test_notebook_contains_the_outputs_of_its_cells():
    pytest.importorskip("matplotlib").use("Agg")
    with open(os.path.join(DOCS, "example.ipynb"), encoding="utf-8") as file:
        cells = [cell for cell in json.load(file)["cells"] if cell["cell_type"] == "code"]
    assert any(output["output_type"] == "display_data" for cell in cells for output in cell["outputs"])
    names = {}
    for cell in cells:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec("".join(cell["source"]), names)
        stored = [output["text"] for output in cell["outputs"] if output.get("name") == "stdout"]
        assert printed.getvalue() == "".join("".join(text) for text in stored)
