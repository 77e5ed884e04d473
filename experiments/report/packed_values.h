#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace shapegauge {

/// The bytes in base64 (RFC 4648, with padding).
std::string base64(std::string_view bytes);

/// Non-negative numbers in two bytes each: {"scale", "values"}, where the value is scale * n / 65534 for each
/// little-endian n in the base64 text, and 65535 stands for infinity and for no value. Scale is the largest finite
/// value, or 1.
nlohmann::ordered_json packed(const Eigen::Ref<const Eigen::VectorXd>& values);

/// The value with so many significant digits: the fewest characters that say enough.
double rounded(double value, int digits);

}  // namespace shapegauge
