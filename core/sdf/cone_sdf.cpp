// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/sdf/cone_sdf.h"

#include <fmt/format.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/sdf/cone_sdf_engines.h"
#include "shapegauge/core/shape/distinct_triangles.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

namespace {

void check(const ConeSdfOptions& options) {
  check_options("cone_sdf", cone_sdf_table, options);
  if (options.postprocess && options.engine != ConeSdfEngine::cgal) {
    throw InputError("the post-processing of the conventional SDF requires the cgal engine");
  }
}

void check(const Shape& shape, const Samples& samples, ConeSdfEngine engine) {
  require_usable(shape);
  if (is_cloud(shape)) {
    throw InputError(
        "the conventional SDF needs triangles, and the shape has none; use the SDF of the offset surface for points");
  }
  const bool at_faces = samples.site == SampleSite::faces;
  if (engine == ConeSdfEngine::cgal && !at_faces) {
    throw InputError("the cgal engine of the conventional SDF supports faces only; use faces, or the embree engine");
  }
  const bool at_surface = samples.site == SampleSite::surface;
  const Eigen::Index sites = at_faces     ? shape.triangles.rows()
                             : at_surface ? std::ssize(samples.triangles)
                                          : shape.vertices.rows();
  if (samples.points.rows() != sites || samples.normals.rows() != sites) {
    throw InputError(fmt::format("the samples do not match the shape: {} points and {} normals for {} {}",
                                 samples.points.rows(), samples.normals.rows(), sites,
                                 at_faces     ? "faces"
                                 : at_surface ? "triangles of the samples"
                                              : "vertices"));
  }
}

/// The samples of the mesh on its distinct triangles. At faces, each set of doubles has the sample of its first.
Samples on_distinct(const Samples& samples, const DistinctTriangles& mesh) {
  Samples result = samples;
  for (std::int32_t& triangle : result.triangles) triangle = mesh.triangle_of[static_cast<std::size_t>(triangle)];
  if (samples.site != SampleSite::faces) return result;
  const Eigen::Index count = mesh.shape.triangles.rows();
  result.points.conservativeResize(count, Eigen::NoChange);
  result.normals.conservativeResize(count, Eigen::NoChange);
  for (std::size_t f = mesh.triangle_of.size(); f-- > 0;) {  // the first of each set comes last
    result.points.row(mesh.triangle_of[f]) = samples.points.row(static_cast<Eigen::Index>(f));
    result.normals.row(mesh.triangle_of[f]) = samples.normals.row(static_cast<Eigen::Index>(f));
  }
  return result;
}

/// Extends values at the faces of the distinct triangles to all faces of the mesh.
void extend_to_doubles(Eigen::VectorXd& values, SampleSite site, const DistinctTriangles& mesh) {
  if (site == SampleSite::faces) values = values(mesh.triangle_of).eval();
}

}  // namespace

ConeSdfResult cone_sdf(const Shape& shape, const Samples& samples, const ConeSdfOptions& options) {
  check(options);
  check(shape, samples, options.engine);
  const DistinctTriangles mesh = distinct_triangles(shape);
  ConeSdfResult result = options.engine == ConeSdfEngine::cgal
                             ? cone_sdf_cgal(mesh.shape, options)
                             : cone_sdf_embree(mesh.shape, on_distinct(samples, mesh), options);
  extend_to_doubles(result.values, samples.site, mesh);
  result.missing = static_cast<std::size_t>(result.values.array().isNaN().count());
  return result;
}

}  // namespace shapegauge
