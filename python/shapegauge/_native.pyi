"""The native functions behind the package: arrays as the package makes them, settings as JSON."""

from typing import Any, Optional

from numpy import ndarray

class InputError(ValueError): ...

class Evaluation:
    measures: list[str]
    queries: list[int]
    query_classes: list[int]
    classes: list[int]
    micro: ndarray
    macro: ndarray
    per_query: ndarray
    per_class: ndarray
    models_left_out: int
    queries_with_ties: int
    protocol: str
    recall: Any
    precision: Any
    def table(self, method: str, format: str) -> str: ...

class ComparedMethods:
    warnings: list[str]
    def json(self) -> str: ...
    def summary(self, format: str) -> str: ...
    def pairs(self, format: str) -> str: ...

class FinishedRun:
    summary: str
    warnings: list[str]
    left_out: list[str]

def version() -> str: ...
def read(path: str) -> tuple[ndarray, ndarray, ndarray]: ...
def write(path: str, vertices: ndarray, faces: ndarray, normals: ndarray) -> None: ...
def field(
    vertices: ndarray, faces: ndarray, normals: ndarray, settings: str, threads: int
) -> dict[str, Any]: ...
def segment(
    vertices: ndarray, faces: ndarray, normals: ndarray, settings: str, threads: int
) -> tuple[ndarray, list[str]]: ...
def describe(vertices: ndarray, faces: ndarray, normals: ndarray, settings: str, threads: int) -> ndarray: ...
def evaluate(
    distances: ndarray,
    labels: list[int],
    protocol: str,
    ties: str,
    measures: list[str],
    minimum_class_size: int,
    negated: bool,
    threads: int,
) -> tuple[Evaluation, list[str]]: ...
def compare(
    names: list[str],
    evaluations: list[Evaluation],
    test: str,
    blocks: str,
    confidence: float,
    resamples: int,
    seed: int,
    threads: int,
) -> ComparedMethods: ...
def fuse(distances: list[ndarray], settings: str, threads: int) -> ndarray: ...
def rerank(distances: ndarray, method: str, settings: str, threads: int) -> ndarray: ...
def run(
    configuration: str,
    overrides: list[str],
    output: str,
    replace: bool,
    cache_folder: Optional[str],
    threads: int,
) -> FinishedRun: ...
