#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the commands of docs/manual/scaling.md for GNU parallel or make, and compares the results with those of one process.

Arguments: the page, a folder, and the tool, parallel or make. Exit status 77, with the reason, without the tool.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys


def block_with(text, page):
    """Returns the code block of the page that contains the text."""
    blocks = re.findall(r"^```\w+\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    return next(block for block in blocks if text in block)


def results_in(folder):
    files = {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    files.pop("shape_seconds.csv")
    manifest = json.loads(files.pop("manifest.json"))
    return files, manifest["execution"]["cache"]


def main():
    page, folder, tool = pathlib.Path(sys.argv[1]).read_text(), pathlib.Path(sys.argv[2]), sys.argv[3]
    if not shutil.which(tool):
        print(f"skipped: {tool} is not installed")
        sys.exit(77)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)

    def run(command):
        subprocess.run(["bash", "-e", "-c", command], cwd=folder, check=True)

    run("shapegauge --quiet dataset generate shapes --classes 3 --models-per-class 3 --faces 1000")
    signature = {"name": "cone", "field": {"type": "cone_sdf"}, "histogram": {"range": "dataset"}}
    experiment = {"name": "parts", "dataset": {"layout": "shrec11", "root": "shapes"}, "signatures": [signature]}
    (folder / "experiment.json").write_text(json.dumps(experiment))
    run("shapegauge run experiment.json --no-cache --output alone")
    if tool == "make":
        (folder / "Makefile").write_text(block_with("results/manifest.json:", page))
        run("make -j 2")
    else:
        run(block_with("parallel shapegauge", page))
    expected, _ = results_in(folder / "alone")
    found, cache = results_in(folder / ("results" if tool == "make" else "results/parts"))
    assert cache["field"] == {"from_cache": 9, "computed": 0}, cache
    different = [name for name in expected.keys() | found.keys() if expected.get(name) != found.get(name)]
    assert not different, different


main()
