# SPDX-License-Identifier: GPL-3.0-or-later
"""The check of a part: walls that are too thin, gaps that are too narrow."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, List, Optional

import numpy as _numpy

from . import _native
from ._arguments import finite_number, number_of_threads, warn
from ._native import InputError
from ._settings import REGISTERED
from ._shape_arrays import settings_after, shape_arrays

_SEPARATION = REGISTERED["fields"]["inscribed_ball"]["settings"]["separation_angle_degrees"]["default"]


@dataclass(frozen=True, eq=False)
class ThinRegion:
    """Connected region of the surface below a limit (docs/manual/check.md).

    kind: "wall" or "gap"; "edge" or "notch" for the sides of a sharp one, which is no violation. minimum: the smallest
    thickness or width; it is measured from `position` to `opposite`. faces: indices of the faces that the region covers
    at least partly.
    """

    kind: str
    area: float
    minimum: float
    median: float
    position: _numpy.ndarray
    opposite: _numpy.ndarray
    faces: _numpy.ndarray


@dataclass(frozen=True, eq=False)
class CheckReport:
    """Result of check(): violations, then edges and notches, each largest first.

    small_regions: number of regions below min_area. voids: number of closed cavities. closed: the mesh is closed and
    consistently oriented.
    """

    passes: bool
    walls: List[ThinRegion]
    gaps: List[ThinRegion]
    small_regions: int
    voids: int
    closed: bool


def check(vertices: Any, faces: Any = None, min_wall: Optional[float] = None, min_gap: Optional[float] = None, *,
          min_area: float = 0, separation_angle_degrees: float = _SEPARATION, threads: int = 0) -> CheckReport:
    """Checks the walls and gaps of a mesh against limits, in the units of the input.

    min_wall: minimum thickness of walls. min_gap: minimum width of gaps. min_area: regions below this area are only
    counted. separation_angle_degrees: minimum angle at the ball's centre between its two contacts. threads: 0 for all
    cores.

    >>> report = sg.check(mesh, min_wall=1.2)
    >>> report.passes, [region.minimum for region in report.walls]
    (False, [0.8])
    """
    faces, min_wall, min_gap = settings_after(vertices, faces, (min_wall, None), (min_gap, None))
    if min_wall is None and min_gap is None:
        raise InputError("min_wall or min_gap is required, such as min_wall=1.2")
    wall, gap = (0.0 if limit is None else finite_number(limit, name)
                 for name, limit in (("min_wall", min_wall), ("min_gap", min_gap)))
    points, triangles, _ = shape_arrays(vertices, faces, None)
    found = _native.check(points, triangles, wall, gap, finite_number(min_area, "min_area"),
                          finite_number(separation_angle_degrees, "separation_angle_degrees"),
                          number_of_threads(threads))
    if not found["closed"]:
        warn(["the mesh is not closed and consistently oriented: where faces point inwards, walls and gaps are exchanged; "
              "repair the mesh"])
    for side in ("walls", "gaps"):
        found[side] = [ThinRegion(**region) for region in found[side]]
    return CheckReport(**found)
