// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/pages/packed_numbers.h"

#include <algorithm>
#include <cmath>

#include "shapegauge/pages/html_page.h"

namespace shapegauge {

void append_short(std::string& bytes, long number) {
  bytes.push_back(static_cast<char>(number & 0xff));
  bytes.push_back(static_cast<char>(number >> 8 & 0xff));
}

std::string packed_shorts(const std::vector<std::int32_t>& numbers) {
  std::string bytes;
  for (const std::int32_t number : numbers) append_short(bytes, number);
  return base64(bytes);
}

std::string packed_values(const Eigen::Ref<const Eigen::VectorXd>& values, double low, double width) {
  std::string bytes;
  bytes.reserve(2 * static_cast<std::size_t>(values.size()));
  for (const double value : values) {
    append_short(bytes, std::isfinite(value) ? std::lround(top_level * std::max(0.0, value - low) / width) : no_level);
  }
  return base64(bytes);
}

}  // namespace shapegauge
