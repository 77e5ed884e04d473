#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the length of headers that many sources include, and that headers do not include JSON in full.

    check_header_lines.py SOURCES COMPILER FOLDERS

FOLDERS are include directories, separated by semicolons. Lines are counted after the preprocessor (`g++ -E -P`).
"""

import concurrent.futures
import os
import pathlib
import subprocess
import sys

# Most lines of each header: those with GCC 12 and Eigen 3.4, and 5 % more.
BOUNDS = {
    "core/base/error.h": 21_000,
    "core/base/interruption.h": 21_000,
    "core/base/text.h": 26_000,
    "core/base/parameter.h": 30_000,
    "core/base/option_parameters.h": 30_000,
    "core/base/random_numbers.h": 30_000,
    "core/base/parallel.h": 38_000,
    "core/base/registry.h": 47_000,
    "core/base/distance_rows.h": 97_000,
    "core/io/file_bytes.h": 48_000,
    "core/shape/shape.h": 98_000,
    "core/shape/connectivity.h": 99_000,
    "core/shape/samples.h": 100_000,
    "core/sdf/offset_sdf.h": 100_000,
    "core/fields/field.h": 113_000,
    "retrieval/distance_matrix.h": 103_000,
    "retrieval/descriptors/descriptor.h": 105_000,
    "metrics/evaluation.h": 105_000,
    "datasets/files/table.h": 27_000,
    "datasets/layouts/dataset.h": 60_000,
    "experiments/configuration/configuration.h": 121_000,
    "experiments/configuration/json_document.h": 56_000,
    "experiments/engine/experiment.h": 121_000,
    "experiments/signatures/compute_signatures.h": 123_000,
}
# Lines of <string> with GCC 12, by which the bounds are scaled for standard libraries with longer headers.
STRING = 19_200
FOLDERS_OF_SOURCES = ["app", "core", "datasets", "experiments", "metrics", "pages", "retrieval", "segmentation"]


def lines_of(compiler, folders, header):
    """Returns the number of lines of a header and all that it includes."""
    command = [compiler, "-x", "c++", "-std=c++20", "-DNDEBUG", "-E", "-P", "-", *folders]
    result = subprocess.run(command, input=f"#include <{header}>\n", text=True, capture_output=True)
    if result.returncode:
        sys.exit(f"{header} does not compile by itself:\n{result.stderr}")
    return result.stdout.count("\n")


def long_headers(compiler, folders):
    """Returns an error for each header that is longer than its bound."""
    scale = max(1, lines_of(compiler, folders, "string") / STRING)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        counts = list(pool.map(lambda header: lines_of(compiler, folders, f"shapegauge/{header}"), BOUNDS))
    for header, count in zip(BOUNDS, counts):
        print(f"{count:7} of {BOUNDS[header]:7} {header}")
    return [f"{header} has {count} lines after the preprocessor, more than {BOUNDS[header]}: include less "
            "(docs/developer/testing.md#cost-of-headers)"
            for header, count in zip(BOUNDS, counts) if count > BOUNDS[header] * scale]


def json_headers(sources):
    """Returns an error for each header that includes JSON in full."""
    found = {header.relative_to(sources).as_posix() for folder in FOLDERS_OF_SOURCES
             for header in (sources / folder).rglob("*.h") if "<nlohmann/json.hpp>" in header.read_text()}
    return [f"{header} includes nlohmann/json.hpp: include nlohmann/json_fwd.hpp there, and the rest in sources"
            for header in sorted(found)]


def main():
    sources, compiler, folders = sys.argv[1:]
    wrong = long_headers(compiler, [f"-I{folder}" for folder in folders.split(";") if folder])
    wrong += json_headers(pathlib.Path(sources))
    sys.exit("\n".join(wrong) if wrong else 0)


main()
