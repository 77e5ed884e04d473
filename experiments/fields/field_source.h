#pragma once

#include <optional>

#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// A shape that fields are computed of, one after the other, and what they share. Keeps a reference to the shape.
class FieldSource {
 public:
  explicit FieldSource(const Shape& shape) : shape_(&shape) {}

  [[nodiscard]] const Shape& shape() const { return *shape_; }

  /// Made when it is first asked for; throws what its constructor throws.
  const OffsetSdfSolver& offset_sdf_solver() {
    if (!offset_sdf_solver_) offset_sdf_solver_.emplace(*shape_);
    return *offset_sdf_solver_;
  }

 private:
  const Shape* shape_;
  std::optional<OffsetSdfSolver> offset_sdf_solver_;
};

}  // namespace shapegauge
