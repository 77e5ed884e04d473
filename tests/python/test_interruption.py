# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C stops computations: the exception is raised and no thread continues.

Each call would take long. It is interrupted after a second; the bound is for slow machines.
"""

import os
import signal
import subprocess
import sys
import threading
import time

import pytest

import shapegauge as sg
from support import CONFIGS, toy

BOUND = 60  # seconds

PREPARATION = """
import numpy as np
import shapegauge as sg
from support import bumpy_torus
random = np.random.default_rng(1)
def cloud(count):
    points = random.normal(size=(count, 3))
    return points / np.linalg.norm(points, axis=1, keepdims=True) * [1, 2, 3]
def distances(count):
    places = random.normal(size=(count, 3)).astype(np.float32)
    return sum(np.abs(np.subtract.outer(column, column)) for column in places.T).astype(float)
"""

# Prints whether the native function raised, and the CPU seconds used in the following half second.
WATCHED = """
import sys, time
raised = []
def profile(_, event, function):
    if event == "c_exception" and "_native" in str(getattr(function, "__module__", "")):
        raised.append(function)
print("begun", flush=True)
try:
    sys.setprofile(profile)
    {call}
except KeyboardInterrupt:
    sys.setprofile(None)
    begin = time.process_time()
    time.sleep(0.5)
    print(bool(raised), time.process_time() - begin)
    raise
"""

CALLS = {
    "sdf": ("points = cloud(3_000_000)", "sg.sdf(points, 'offset_sdf', 0.005, accuracy='fine')"),
    "sdf of a mesh": ("mesh = bumpy_torus(1000, 500)", "sg.sdf(*mesh, 'cone_sdf', rays=1000)"),
    "normals": ("points = cloud(3_000_000)", "sg.normals(points, 0.005)"),
    "field": ("mesh = bumpy_torus(500, 300)", "sg.field(*mesh, 'centricity', sources=1000)"),
    "spectrum": ("mesh = bumpy_torus(200, 150)", "sg.field(*mesh, 'heat_kernel', eigenvalues=1000)"),
    "segment": ("mesh = bumpy_torus(1500, 700)", "sg.segment(*mesh)"),
    "describe": ("mesh = bumpy_torus(1500, 1000)", "sg.describe(*mesh, 'light_field')"),
    "evaluate": ("matrix = distances(5000)", "sg.evaluate(matrix, np.arange(5000) % 7, ties='expected', "
                 "measures=[f'F1@{k}' for k in range(1, 4000)])"),
    "compare": ("matrix = distances(700)", "sg.compare([matrix, matrix + matrix.T], np.arange(700) % 350, "
                "blocks='queries', resamples=10_000_000)"),
    "distances": ("features = random.random((10000, 600))", "sg.distances(features, distance='jensen-shannon')"),
    "rerank": ("matrix = distances(6000)", "sg.rerank(matrix)"),
}


def cpu_seconds(process):
    """The CPU time of a process so far, which does not depend on what else the machine does."""
    with open(f"/proc/{process.pid}/stat", encoding="utf-8") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def interrupted(code, folder, is_under_way):
    """Runs the code, sends a signal once it computes, and returns the exit status and standard error."""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([os.path.dirname(__file__), *sys.path])}
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                               cwd=folder, env=environment)
    try:
        is_under_way(process)
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=BOUND)
    finally:
        process.kill()
    return process.returncode, output, errors


@pytest.mark.parametrize("name", CALLS)
def test_ctrl_c_stops_a_computation(name, tmp_path):
    preparation, call = CALLS[name]
    code = PREPARATION + preparation + WATCHED.format(call=call)

    def is_under_way(process):
        assert process.stdout.readline() == "begun\n"
        begun = cpu_seconds(process)
        while process.poll() is None and cpu_seconds(process) < begun + 1:
            time.sleep(0.05)

    status, output, errors = interrupted(code, tmp_path, is_under_way)
    assert errors.rstrip().endswith("KeyboardInterrupt") and status in (130, -signal.SIGINT)
    stopped, busy = output.split()
    assert stopped == "True"  # raised by the computation, not after it
    assert float(busy) < 0.25  # no thread continues


def test_ctrl_c_stops_an_experiment_and_leaves_no_results(tmp_path):
    configuration = os.path.join(CONFIGS, "quickstart.json")
    many = ["dataset.generate.classes=16", "dataset.generate.models_per_class=60"]
    code = f"import shapegauge as sg; sg.run({configuration!r}, {str(tmp_path / 'out')!r}, settings={many!r}, cache='')"

    def is_under_way(process):
        for _ in range(600):  # until it computes
            if (tmp_path / "out" / "dataset").exists() or process.poll() is not None:
                return
            time.sleep(0.1)

    status, _, errors = interrupted(code, tmp_path, is_under_way)
    assert errors.rstrip().endswith("KeyboardInterrupt") and status in (130, -signal.SIGINT)
    assert not (tmp_path / "out" / "manifest.json").exists() and not (tmp_path / "out" / ".shapegauge-lock").exists()


def test_computing_works_after_an_interruption():
    distances, labels = toy()
    before = sg.evaluate(distances, labels).micro

    def alarm(*_):
        raise TimeoutError

    earlier = signal.signal(signal.SIGALRM, alarm)
    signal.setitimer(signal.ITIMER_REAL, 0.5)
    try:
        # Any raising signal handler stops it, not only that of Ctrl-C.
        with pytest.raises(TimeoutError):
            sg.compare([distances, distances.T], labels, resamples=10_000_000, blocks="queries")
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, earlier)
    assert sg.evaluate(distances, labels).micro == before


def test_handlers_without_exceptions_do_not_interrupt():
    distances, labels = toy()
    heard = []
    earlier = signal.signal(signal.SIGALRM, lambda *_: heard.append(1))
    signal.setitimer(signal.ITIMER_REAL, 0.01, 0.01)
    try:
        comparison = sg.compare([distances, distances.T], labels, resamples=200_000, blocks="queries")
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, earlier)
    assert heard and comparison.results["resamples"] == 200_000


def test_other_threads_compute_as_well():
    distances, labels = toy()
    found = []
    thread = threading.Thread(target=lambda: found.append(sg.evaluate(distances, labels).micro))
    thread.start()
    thread.join()
    assert found == [sg.evaluate(distances, labels).micro]
