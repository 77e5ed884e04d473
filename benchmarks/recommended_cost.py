# SPDX-License-Identifier: GPL-3.0-or-later
"""Processor time of the recommended method, in units of the conventional SDF of the same meshes.

    python3 benchmarks/recommended_cost.py build/shapegauge MESH...

Runs, alternately and with one thread, configs/recommended.json from an empty cache and `sdf --method cone_sdf` of every face;
whole processes, reading and writing included. Prints the least seconds of each and their ratio. Three meshes or more.
"""

import argparse
import pathlib
import resource
import subprocess
import tempfile

CONFIGURATION = pathlib.Path(__file__).resolve().parents[1] / "configs" / "recommended.json"


def processor_seconds(command):
    """Processor time of a command and its children."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def data_set(folder, meshes):
    """Writes a data set of the meshes, in two classes, and returns its description."""
    rows = [f"{i},{mesh.resolve()},{'ab'[i % 2]}" for i, mesh in enumerate(meshes)]
    (folder / "models.csv").write_text("\n".join(["id,path,class", *rows]) + "\n")
    return f'dataset={{"layout": "csv", "root": "{folder}"}}'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("executable")
    parser.add_argument("meshes", nargs="+", type=pathlib.Path)
    parser.add_argument("--repetitions", type=int, default=5)
    arguments = parser.parse_args()
    if len(arguments.meshes) < 3:
        parser.error("three meshes or more are needed: two of a class")
    method, cone = [], []
    for repetition in range(arguments.repetitions):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            method.append(processor_seconds(
                [arguments.executable, "run", CONFIGURATION, "--set", data_set(folder, arguments.meshes), "--threads", "1",
                 "--set", "report=false", "--cache", folder / "cache", "--output", folder / "results"]))
            cone.append(sum(processor_seconds(
                [arguments.executable, "sdf", mesh, "--method", "cone_sdf", "--threads", "1", "-o", folder / "values.csv",
                 "--replace"]) for mesh in arguments.meshes))
    shapes = len(arguments.meshes)
    print(f"recommended method {min(method) / shapes:.3f} s a shape, cone {min(cone) / shapes:.3f} s, "
          f"ratio {min(method) / min(cone):.2f}")


if __name__ == "__main__":
    main()
