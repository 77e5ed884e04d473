#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Offset for measuring a shape. Lengths are fractions of the bounding-box diagonal.
struct ChosenOffset {
  double offset = 0;
  double gap = 0;                            ///< gap_size() of the shape
  std::optional<AutomaticOffset> automatic;  ///< the choice made for "auto"
};

/// Converts the result of automatic_offset().
ChosenOffset chosen_automatically(const AutomaticOffset& automatic);

/// Returns the given offset or, without one, automatic_offset(). Throws InputError for a shape without extent.
ChosenOffset choose_offset(std::optional<double> given, const Shape& shape);

/// Returns true if an automatically chosen offset leaves wider gaps open.
bool leaves_gaps_open(const ChosenOffset& chosen);

/// Returns the warning about an offset smaller than the gaps of the shape, if it is.
std::optional<std::string> leak_warning(const ChosenOffset& chosen);

/// Returns the warning about two-sided samples, whose SDF is below half the offset: both of their sides are about
/// equally far from the outside. The input's orientation, or chance, then determines the outward side. This occurs
/// where the offset surface leaks into a shape (99 % of the samples of random point clouds) and on sheets, but never on
/// closed meshes. `values` are those of the offset SDF; `offset` is a fraction of the diagonal.
std::optional<std::string> two_sided_warning(const Shape& shape, const Eigen::VectorXd& values, double offset);

/// Says of a hollow body (cavity_count()) whether values are those of its hull, as the offset SDF computes them, or of
/// its wall. Nothing for other shapes.
std::optional<std::string> hollow_remark(const Shape& shape, bool measures_hull);

}  // namespace shapegauge
