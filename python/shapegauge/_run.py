"""Experiments from their configurations."""

import collections as _collections
import os as _os

from . import _native
from ._arguments import number_of_threads, path_of, switch, warn, words


class Run(_collections.namedtuple("Run", ["folder", "summary", "left_out"])):
    """A finished experiment: the folder of its results, the summary as text, and the models it went on without."""

    __slots__ = ()

    def __repr__(self):
        return f"{self.summary}\nResults in {self.folder}"


def run(configuration, output=None, *, settings=(), replace=False, cache=None, threads=0):
    """Runs an experiment from its configuration, as `shapegauge run`: retrieval, comparison or segmentation.

    configuration: the path of its file. output: the folder for the results; by default results/<name of the file>.
    settings: changes, as in ["signatures.0.histogram.bins=40"]. cache: its folder; "": none. Ctrl-C stops it; what is
    done is in the cache.

    >>> sg.run("configs/quickstart.json")
    """
    configuration = path_of(configuration, "configuration")
    if output is None:
        output = _os.path.join("results", _os.path.splitext(_os.path.basename(configuration))[0])
    output = path_of(output, "output")
    done = _native.run(configuration, words(settings, "settings"), output, switch(replace, "replace"),
                       cache if cache in (None, "") else path_of(cache, "cache"), number_of_threads(threads))
    warn(done.warnings + [f"left out {one}" for one in done.left_out])
    return Run(output, done.summary, done.left_out)
