"""What a call of sg.sdf() costs beside the computation.

    PYTHONPATH=build/python /usr/bin/python3 benchmarks/python_overhead.py build/shapegauge MESH

By turns the conventional SDF of the mesh is computed by the package, and by the program, which says what the C++ call
alone took (`sdf --timings`). One thread; of each the fastest of 30.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import time

import shapegauge as sg

program, mesh = sys.argv[1:]
vertices, faces, _ = sg.read(mesh)
package, alone = [], []
with tempfile.TemporaryDirectory() as folder:
    timings = pathlib.Path(folder) / "timings.json"
    command = [program, "sdf", mesh, "--method", "cone_sdf", "--threads", "1", "--replace", "-o",
               pathlib.Path(folder) / "sdf.csv"]
    for _ in range(30):
        start = time.perf_counter()
        sg.sdf(vertices, faces, method="cone_sdf", threads=1)
        package.append(time.perf_counter() - start)
        subprocess.run([*command, "--timings", timings], check=True, stderr=subprocess.DEVNULL)
        seconds = json.loads(timings.read_text())
        alone.append(seconds["build_seconds"] + seconds["query_seconds"])
print(f"{len(faces)} faces: {1e3 * min(package):.1f} ms by the package, {1e3 * min(alone):.1f} ms the C++ call alone, "
      f"{100 * (min(package) / min(alone) - 1):+.1f} %")
