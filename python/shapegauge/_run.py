# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs experiments from their configurations."""

from __future__ import annotations

import json as _json
import os as _os
from typing import Any, Iterable, Mapping, NamedTuple, Optional, Union

from . import _native
from ._arguments import PathLike, Progress, number_of_threads, path_of, plain, progress_of, switch, warn, words
from ._settings import REGISTERED, with_settings


class Run(NamedTuple):
    """Finished experiment: result folder, summary as text, and omitted models."""

    folder: str
    summary: str
    left_out: list[str]

    def __repr__(self) -> str:
        return f"{self.summary}\nResults in {self.folder}"


@with_settings([("Kinds of experiments",
                 "\n".join(f"{kind}: {meaning}" for kind, meaning in REGISTERED["experiments"].items()))])
def run(configuration: Union[PathLike, Mapping[str, Any]], output: Optional[PathLike] = None, *,
        settings: Union[str, Iterable[str]] = (), replace: bool = False, cache: Optional[PathLike] = None,
        threads: int = 0, on_progress: Optional[Progress] = None) -> Run:
    """Runs an experiment from its configuration, as `shapegauge run`. Kinds of experiments: below.

    configuration: path of the file, or a dict, whose paths are relative to the working directory. output: folder for
    the results (default: results/<name of the file, or of the experiment>). settings: overrides such as
    ["signatures.0.histogram.bins=40"]. replace: overwrite results of another configuration. cache: folder of cached
    results; "" for none. threads: 0 for all cores. on_progress: called with stage, done and total. Ctrl-C stops the
    run; completed shapes stay in the cache.

    >>> sg.run("configs/quickstart.json")
    """
    if isinstance(configuration, Mapping):
        document = plain(configuration, "configuration")
        text, source, folder = _json.dumps(document), "configuration", ""
        name = _native.file_safe_name(str(document.get("name", "experiment")))
    else:
        text, source = "", path_of(configuration, "configuration")
        folder = _os.path.dirname(source)
        name = _os.path.splitext(_os.path.basename(source))[0]
    output = _os.path.join("results", name) if output is None else path_of(output, "output")
    done = _native.run(text, source, folder, words(settings, "settings"), output, switch(replace, "replace"),
                       "" if cache == "" else None if cache is None else path_of(cache, "cache"),
                       number_of_threads(threads), progress_of(on_progress))
    warn(done.warnings + [f"omitted {one}" for one in done.left_out])
    return Run(output, done.summary, done.left_out)
