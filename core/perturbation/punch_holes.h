#pragma once

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/random/random_numbers.h"

namespace shapegauge {

struct PunchHolesOptions {
  int number = 5;        ///< of holes; they may overlap
  double radius = 0.05;  ///< as a fraction of the bounding box's diagonal; at least 0
};

/// The mesh without the faces whose centroid is within the radius of one of so many points, random on its surface (see
/// sample_surface); a cloud without its points within the radius of some of them. Holes reach through thin parts. The
/// vertices of a mesh all stay. Throws InputError for options out of range, for a shape without extent or area, and
/// where nothing would be left.
Shape punch_holes(Shape shape, const PunchHolesOptions& options, RandomNumbers& random);

}  // namespace shapegauge
