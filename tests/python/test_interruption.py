# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C stops computations: the exception is raised and no thread continues.

Each call would take long. It is interrupted after half a second of CPU time; the bound is for slow machines.
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
    points = random.normal(size=(count, 3)).astype(np.float32)
    return sum(np.abs(np.subtract.outer(column, column)) for column in points.T).astype(float)
"""

# Makes the calls one after the other. Of each, prints whether the native function raised, and the CPU seconds used in the
# following half second.
WATCHED = """
import sys, time
raised = []
def profile(_, event, function):
    if event == "c_exception" and "_native" in str(getattr(function, "__module__", "")):
        raised.append(function)
for preparation, call in {calls}:
    exec(preparation)
    raised.clear()
    try:
        print("begun", flush=True)
        sys.setprofile(profile)
        exec(compile(call, "call", "exec"))  # exec() of a text lets Python end as if interrupted
        print("finished", 0, flush=True)
    except KeyboardInterrupt:
        sys.setprofile(None)
        begin = time.process_time()
        time.sleep(0.5)
        print(bool(raised), time.process_time() - begin, flush=True)
"""

CALLS = {
    "sdf": ("points = cloud(300_000)", "sg.sdf(points, 'offset_sdf', 0.005, accuracy='fine')"),
    "sdf of a mesh": ("mesh = bumpy_torus(500, 300)", "sg.sdf(*mesh, 'cone_sdf', rays=1000)"),
    "normals": ("points = cloud(500_000)", "sg.normals(points, 0.005)"),
    "field": ("mesh = bumpy_torus(300, 200)", "sg.field(*mesh, 'centricity', sources=1000)"),
    "spectrum": ("mesh = bumpy_torus(150, 100)", "sg.field(*mesh, 'heat_kernel', eigenvalues=1000)"),
    "segment": ("mesh = bumpy_torus(700, 400)", "sg.segment(*mesh)"),
    "describe": ("mesh = bumpy_torus(900, 500)", "sg.describe(*mesh, 'light_field')"),
    "evaluate": ("matrix = distances(3000)", "sg.evaluate(matrix, np.arange(3000) % 7, ties='expected', "
                 "measures=[f'F1@{k}' for k in range(1, 2500)])"),
    "compare": ("matrix = distances(700)", "sg.compare([matrix, matrix + matrix.T], np.arange(700) % 350, "
                "blocks='queries', resamples=10_000_000)"),
    "distances": ("features = random.random((5000, 600))", "sg.distances(features, distance='jensen-shannon')"),
    "rerank": ("matrix = distances(3000)", "sg.rerank(matrix)"),
}


def cpu_seconds(process):
    """The CPU time of a process so far, which does not depend on what else the machine does."""
    with open(f"/proc/{process.pid}/stat", encoding="utf-8") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def started(code, folder):
    """Starts Python with the code."""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([os.path.dirname(__file__), *sys.path])}
    return subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                            cwd=folder, env=environment)


def test_ctrl_c_stops_computations(tmp_path):
    process = started(PREPARATION + WATCHED.format(calls=list(CALLS.values())), tmp_path)
    try:
        for name in CALLS:
            if process.stdout.readline() != "begun\n":
                process.kill()
                pytest.fail(f"{name}: {process.stderr.read()}")
            begun = cpu_seconds(process)
            while process.poll() is None and cpu_seconds(process) < begun + 0.5:
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            end = threading.Timer(BOUND, process.kill)
            end.start()
            stopped, busy = (process.stdout.readline() or "killed 0").split()
            end.cancel()
            assert stopped == "True", name  # raised by the computation, not after it
            assert float(busy) < 0.25, name  # no thread continues
        assert process.wait(BOUND) == 0
    finally:
        process.kill()


def test_ctrl_c_stops_an_experiment_and_leaves_no_results(tmp_path):
    configuration = os.path.join(CONFIGS, "quickstart.json")
    many = ["dataset.generate.classes=16", "dataset.generate.models_per_class=60"]
    code = f"import shapegauge as sg; sg.run({configuration!r}, {str(tmp_path / 'out')!r}, settings={many!r}, cache='')"

    process = started(code, tmp_path)
    try:
        for _ in range(600):  # until it computes
            if (tmp_path / "out" / "dataset").exists() or process.poll() is not None:
                break
            time.sleep(0.1)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=BOUND)
    finally:
        process.kill()
    assert errors.rstrip().endswith("KeyboardInterrupt") and process.returncode in (130, -signal.SIGINT)
    assert not (tmp_path / "out" / "manifest.json").exists() and not (tmp_path / "out" / ".shapegauge-lock").exists()


def test_evaluate_works_after_an_interruption():
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


def test_signal_handlers_that_do_not_raise_do_not_interrupt_a_computation():
    distances, labels = toy()
    heard = []
    earlier = signal.signal(signal.SIGALRM, lambda *_: heard.append(1))
    signal.setitimer(signal.ITIMER_REAL, 0.01, 0.01)
    try:
        comparison = sg.compare([distances, distances.T], labels, resamples=50_000, blocks="queries")
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, earlier)
    assert heard and comparison.results["resamples"] == 50_000


def test_evaluate_in_another_thread_gives_the_scores_of_the_main_thread():
    distances, labels = toy()
    found = []
    thread = threading.Thread(target=lambda: found.append(sg.evaluate(distances, labels).micro))
    thread.start()
    thread.join()
    assert found == [sg.evaluate(distances, labels).micro]
