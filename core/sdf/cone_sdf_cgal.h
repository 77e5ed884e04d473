#pragma once

#include "shapegauge/core/sdf/cone_sdf.h"

namespace shapegauge {

/// The cgal engine of cone_sdf(), which has checked the options: one value per triangle, on one thread. Throws
/// InputError where the triangles are no oriented manifold, which CGAL's mesh needs.
ConeSdfResult cone_sdf_cgal(const Shape& shape, const ConeSdfOptions& options);

}  // namespace shapegauge
