// SPDX-License-Identifier: GPL-3.0-or-later
// The check of walls and gaps.
#include <utility>

#include "python/native.h"
#include "shapegauge/core/check/part_check.h"

namespace py = pybind11;

namespace shapegauge {

namespace {

py::list regions(const ThinRegions& found, const char* kind, const char* edge) {
  py::list list;
  for (const ThinRegion& region : found.regions) {
    using Faces = Eigen::VectorX<std::int32_t>;
    py::dict entry;
    entry["kind"] = region.is_edge ? edge : kind;
    entry["area"] = region.area;
    entry["minimum"] = region.minimum;
    entry["median"] = region.median;
    entry["position"] = array_of(Eigen::VectorXd(region.position));
    entry["opposite"] = array_of(Eigen::VectorXd(region.opposite));
    entry["faces"] =
        array_of(Faces(Eigen::Map<const Faces>(region.faces.data(), static_cast<Eigen::Index>(region.faces.size()))));
    list.append(std::move(entry));
  }
  return list;
}

py::dict check(const Eigen::Ref<const Points>& vertices, const Eigen::Ref<const Triangles>& faces, double min_wall,
               double min_gap, double min_area, double separation_angle_degrees, int threads) {
  const PartReport report = compute(threads, [&] {
    return check_part(shape_of(vertices, faces, Points(0, 3)),
                      {.min_wall = min_wall,
                       .min_gap = min_gap,
                       .min_area = min_area,
                       .ball = {.separation_angle_degrees = separation_angle_degrees}});
  });
  py::dict result;
  result["passes"] = report.passes();
  result["walls"] = regions(report.walls, "wall", "edge");
  result["gaps"] = regions(report.gaps, "gap", "notch");
  result["small_regions"] = report.walls.small_regions + report.gaps.small_regions;
  result["voids"] = report.voids;
  result["closed"] = report.closed;
  return result;
}

}  // namespace

void bind_check(py::module_& module) { module.def("check", &check); }

}  // namespace shapegauge
