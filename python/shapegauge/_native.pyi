# SPDX-License-Identifier: GPL-3.0-or-later
"""The native functions behind the package: arrays as the package makes them, settings as JSON."""

from typing import Any, Callable, Optional

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
def with_arguments(message: str) -> str: ...
def settings() -> str: ...

most_threads: int
missing_value_words: list[str]

def read(path: str) -> tuple[ndarray, ndarray, ndarray]: ...
def write(path: str, vertices: ndarray, faces: ndarray, normals: ndarray) -> Optional[str]: ...
def field(
    vertices: ndarray, faces: ndarray, normals: ndarray, settings: str, remove_outliers: bool, threads: int
) -> dict[str, Any]: ...
def check(
    vertices: ndarray, faces: ndarray, min_wall: float, min_gap: float, min_area: float, separation_angle_degrees: float,
    threads: int
) -> dict[str, Any]: ...
def segment(
    vertices: ndarray, faces: ndarray, normals: ndarray, settings: str, remove_outliers: bool, threads: int
) -> tuple[ndarray, list[str]]: ...
def describe(vertices: ndarray, faces: ndarray, normals: ndarray, settings: str, remove_outliers: bool,
             threads: int) -> tuple[ndarray, list[str]]: ...
def evaluate(
    distances: ndarray,
    labels: list[int],
    targets: Optional[list[int]],
    subclasses: list[int],
    relevance: Optional[ndarray],
    protocol: str,
    ties: str,
    measures: list[str],
    curve: str,
    minimum_class_size: int,
    evaluator: str,
    negated: bool,
    threads: int,
) -> tuple[Evaluation, list[str]]: ...
def intervals(
    evaluation: Evaluation, confidence: float, blocks: str, resamples: int, seed: int, threads: int
) -> tuple[list[tuple[float, float]], list[tuple[float, float]]]: ...
def check_features(features: ndarray) -> Optional[str]: ...
def feature_distances(features: ndarray, distance: str, threads: int) -> ndarray: ...
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
def rerank(distances: ndarray, method: str, settings: str, threads: int) -> tuple[ndarray, list[str]]: ...
def run(
    document: str,
    source: str,
    folder: str,
    overrides: list[str],
    output: str,
    replace: bool,
    cache_folder: Optional[str],
    threads: int,
    progress: Optional[Callable[[str, int, int], object]],
) -> FinishedRun: ...

def file_safe_name(name: str) -> str: ...

class MethodRequest:
    def __init__(self, configuration: str, source: str, signature: str, articulated: bool) -> None: ...

class Index:
    notes: list[str]
    left_out: list[str]
    file: str
    signature: str
    def models(self) -> list[tuple[str, str]]: ...
    def failures(self) -> list[tuple[str, str]]: ...
    def check_page(self, queries: list[Any], page: str, replace: bool) -> None: ...
    def search(
        self,
        queries: list[Any],
        count: int,
        rerank: bool,
        page_title: Optional[str],
        up: str,
        threads: int,
        progress: Optional[Callable[[str, int, int], object]],
    ) -> tuple[list[tuple[str, Optional[int], list[int], ndarray, str]], str]: ...

def write_page(page: str, text: str) -> None: ...
def open_index(
    collection: str,
    file: Optional[str],
    request: MethodRequest,
    configuration_file: str,
    update: bool,
    cache: Optional[str],
    threads: int,
    progress: Optional[Callable[[str, int, int], object]],
) -> Index: ...
