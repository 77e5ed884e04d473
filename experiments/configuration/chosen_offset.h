#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "shapegauge/core/base/setting_names.h"
#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The offset that a shape is measured with. Lengths are fractions of the bounding-box diagonal.
struct ChosenOffset {
  double offset = 0;
  double gap = 0;                            ///< gap_size() of the shape
  std::optional<AutomaticOffset> automatic;  ///< the choice made for "auto"
};

/// The given offset or, without one, automatic_offset(). Throws InputError where the shape has no extent.
ChosenOffset choose_offset(std::optional<double> given, const Shape& shape);

/// Whether an automatically chosen offset leaves gaps open that are too wide for it.
bool leaves_gaps_open(const ChosenOffset& chosen);

/// The warning about an offset that is smaller than the gaps of the shape; nothing for any other.
std::optional<std::string> leak_warning(const ChosenOffset& chosen, Audience audience);

/// The warning about samples whose two sides are about equally far from the outside: their SDF is below half the
/// offset. The input's orientation, or chance, then decides which side counts as outward. This happens where the offset
/// surface leaks into a shape (99 % of the samples of random point clouds) and on sheets, but never on closed meshes.
/// `values` are those of the offset SDF; `offset` is a fraction of the diagonal.
std::optional<std::string> two_sided_warning(const Shape& shape, const Eigen::VectorXd& values, double offset);

}  // namespace shapegauge
