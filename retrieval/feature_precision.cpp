#include "shapegauge/retrieval/feature_precision.h"

#include <cstddef>
#include <cstdint>

#include "shapegauge/core/base/single_precision.h"
#include "shapegauge/core/base/text.h"

namespace shapegauge {

std::optional<std::string> feature_precision_warning(const DistanceMatrix& features) {
  const std::size_t merged = rows_merged_in_single_precision(
      {features.data(), static_cast<std::size_t>(features.size())}, static_cast<std::size_t>(features.cols()));
  if (merged == 0) return std::nullopt;
  return "features are compared in single precision, in which " +
         count_text(static_cast<std::int64_t>(merged), "row equals another from which it differs",
                    "rows equal others from which they differ") +
         "; subtract the mean of each column, or scale the features";
}

}  // namespace shapegauge
