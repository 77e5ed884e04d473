# SPDX-License-Identifier: GPL-3.0-or-later
"""Search for similar shapes in a collection."""

from __future__ import annotations

import collections.abc as _abc
import json as _json
import os as _os
from typing import TYPE_CHECKING, Any, Iterator, NamedTuple, Optional, Sequence, Union

import numpy as _numpy

from . import _native
from ._arguments import Progress, number_of_threads, path_of, plain, progress_of, switch, warn, word
from ._native import InputError
from ._settings import REGISTERED, number_of
from ._shape_arrays import is_shape_object, shape_arrays

if TYPE_CHECKING:
    import pandas

    from ._arguments import PathLike


class Found(NamedTuple):
    """Result of a search: name in the collection, file, and distance from the query."""

    name: str
    file: str
    distance: float


class Answer(_abc.Sequence):
    """Answer to a query: a sequence of Found, nearest first.

    query: name of the query. member: its name in the collection, if it is a member; otherwise None. names, distances:
    those of the shapes found. failure: reason for a missing answer, or "".
    """

    def __init__(self, query: str, member: Optional[str], found: Sequence[Found], failure: str = "") -> None:
        self.query = query
        self.member = member
        self.failure = failure
        self._found = list(found)

    @property
    def names(self) -> list[str]:
        return [one.name for one in self._found]

    @property
    def distances(self) -> _numpy.ndarray:
        return _numpy.array([one.distance for one in self._found])

    def __getitem__(self, rank: Any) -> Any:
        return self._found[rank]

    def __len__(self) -> int:
        return len(self._found)

    def __iter__(self) -> Iterator[Found]:
        return iter(self._found)

    def __repr__(self) -> str:
        if self.failure:
            return f"<Answer to {self.query}: {self.failure}>"
        width = max((len(one.name) for one in self._found), default=0)
        lines = [f"{rank:>4}  {one.name:<{width}}  {one.distance:.4g}" for rank, one in enumerate(self._found, start=1)]
        return "\n".join([f"<Answer to {self.query}>", *lines])

    def to_frame(self) -> pandas.DataFrame:
        """Returns a pandas frame with a row for each shape found, by rank: name, file, distance."""
        import pandas
        ranks = pandas.RangeIndex(1, len(self) + 1, name="rank")
        return pandas.DataFrame(self._found, columns=list(Found._fields), index=ranks)


class Index:
    """Index of a collection of shape files, as in `shapegauge search` (docs/manual/search.md).

    collection: a folder, a list of files (.txt) or a data set (.cla, .csv, .json). index: file of the index (default:
    next to the collection). method: path of a configuration, or a dict (default: the recommended method). signature:
    name of one of its signatures. articulated: use the recommended method for articulated shapes. update: check for
    new, changed and removed files; the first time, all are described. cache: folder of cached results; "" for none.
    on_progress: called with stage, done and total.

    >>> index = sg.Index("models")
    >>> index.search("chair.obj", k=3).names
    ['chairs/a.off', 'chairs/c.off', 'stools/b.off']
    """

    def __init__(self, collection: PathLike, index: Optional[PathLike] = None, *,
                 method: Union[None, PathLike, _abc.Mapping[str, Any]] = None, signature: str = "", articulated: bool = False,
                 update: bool = True, cache: Optional[PathLike] = None, threads: int = 0, on_progress: Optional[Progress] = None) -> None:
        request, method_file = _method_request(method, word(signature, "signature"), switch(articulated, "articulated"))
        self._threads = number_of_threads(threads)
        self._native = _native.open_index(path_of(collection, "collection"),
                                          None if index is None else path_of(index, "index"), request, method_file,
                                          switch(update, "update"),
                                          "" if cache == "" else None if cache is None else path_of(cache, "cache"),
                                          self._threads, progress_of(on_progress))
        warn(self._native.notes + [f"omitted {one}" for one in self._native.left_out])
        self._models = self._native.models()

    @property
    def names(self) -> list[str]:
        """Names of the shapes, in order."""
        return [name for name, _ in self._models]

    @property
    def files(self) -> list[str]:
        """Files of the shapes."""
        return [file for _, file in self._models]

    @property
    def left_out(self) -> dict[str, str]:
        """Shapes that cannot be described: name -> reason."""
        return dict(self._native.failures())

    @property
    def signature(self) -> str:
        """Name of the signature that is compared."""
        return self._native.signature

    @property
    def file(self) -> str:
        """File of the index."""
        return self._native.file

    def __len__(self) -> int:
        return len(self._models)

    def __repr__(self) -> str:
        return f"<Index: {len(self)} shapes by {self.signature!r} in {self.file}>"

    def search(self, query: Any, k: int = 10, *, rerank: bool = False, page: Optional[PathLike] = None,
               up: str = "auto", replace: bool = False, on_progress: Optional[Progress] = None) -> Any:
        """Returns an Answer with the k shapes most similar to the query, or a list of Answers for a list of queries.

        query: path of a file, an object with vertices and faces, or a tuple of arrays (vertices, faces). A file of the
        collection is excluded from its own answer. rerank: re-rank results by diffusion over the collection's
        distances. page: file for an HTML page with pictures (.html). up: axis that points up on the page: auto (as the
        files state, otherwise y for OFF, OBJ and glTF, z for others), x, y, z, -x, -y or -z. replace: overwrite an
        existing page. An unusable single query raises InputError; in a list, its Answer has the failure.
        """
        several = isinstance(query, list)
        queries = [_query(one) for one in (query if several else [query])]
        file = None if page is None else path_of(page, "page")
        if file is not None:
            self._native.check_page(queries, file, switch(replace, "replace"))
        title = f"{len(queries)} {'query' if len(queries) == 1 else 'queries'}"
        count = number_of(k, "k", REGISTERED["options"]["search"]["count"])
        answers, html = self._native.search(queries, count, switch(rerank, "rerank"), None if file is None else title,
                                            word(up, "up"), self._threads, progress_of(on_progress))
        found = [self._answer(*answer) for answer in answers]
        warn(self._native.notes)
        if not several and found[0].failure:
            raise InputError(found[0].failure)
        if file is not None:
            _native.write_page(file, html)
        return found if several else found[0]

    def _answer(self, query: str, member: Optional[int], models: list[int], distances: _numpy.ndarray,
                failure: str) -> Answer:
        found = [Found(*self._models[model], distance) for model, distance in zip(models, map(float, distances))]
        return Answer(query, None if member is None else self._models[member][0], found, failure)


def _method_request(method: Any, signature: str, articulated: bool) -> tuple[_native.MethodRequest, str]:
    """Returns the method, and the file that its index is named after."""
    if articulated and method is not None:
        raise InputError("method and articulated=True exclude each other; omit one")
    if method is None:
        if signature:
            raise InputError("signature requires method, the configuration that defines it")
        return _native.MethodRequest("", "", "", articulated), ""
    if isinstance(method, _abc.Mapping):
        document = plain(method, "method")
        name = document.get("name", "method")
        return (_native.MethodRequest(_json.dumps(document), "method", signature, False),
                f"{_os.path.basename(word(name, 'method.name'))}.json")
    file = path_of(method, "method")
    return _native.MethodRequest("", file, signature, False), file


def _query(query: Any) -> Any:
    """Returns a path, or the arrays of a shape."""
    if is_shape_object(query) or hasattr(query, "__array__"):
        return shape_arrays(query, None, None)
    if isinstance(query, tuple):
        if not 1 <= len(query) <= 3:
            raise InputError(f"a query of arrays is a tuple of 1 to 3 (vertices, faces, normals), not of {len(query)}")
        return shape_arrays(*query, *[None] * (3 - len(query)))
    return path_of(query, "query")
