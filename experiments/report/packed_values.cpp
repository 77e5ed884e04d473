#include "shapegauge/experiments/report/packed_values.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <openssl/evp.h>

namespace shapegauge {

std::string base64(std::string_view bytes) {
  std::string text;
  // In pieces, as OpenSSL counts in int; whole groups of three bytes, so that the pieces fit together.
  constexpr std::size_t piece = 3 << 20;
  for (std::size_t begin = 0; begin < bytes.size(); begin += piece) {
    const std::string_view part = bytes.substr(begin, piece);
    std::vector<unsigned char> encoded(4 * (part.size() + 2) / 3 + 4);
    const std::vector<unsigned char> plain(part.begin(), part.end());
    const int length = EVP_EncodeBlock(encoded.data(), plain.data(), static_cast<int>(plain.size()));
    text.append(encoded.begin(), encoded.begin() + length);
  }
  return text;
}

nlohmann::ordered_json packed(const Eigen::Ref<const Eigen::VectorXd>& values) {
  constexpr double levels = 65534;
  double scale = 0;
  for (const double value : values) {
    if (std::isfinite(value)) scale = std::max(scale, value);
  }
  if (!(scale > 0)) scale = 1;
  std::string bytes;
  bytes.reserve(2 * static_cast<std::size_t>(values.size()));
  for (const double value : values) {
    const bool finite = std::isfinite(value);
    const auto level =
        finite ? static_cast<std::uint16_t>(std::lround(levels * std::max(0.0, value) / scale)) : std::uint16_t{65535};
    bytes.push_back(static_cast<char>(level & 0xff));
    bytes.push_back(static_cast<char>(level >> 8));
  }
  return {{"scale", scale}, {"values", base64(bytes)}};
}

double rounded(double value, int digits) {
  return std::isfinite(value) ? std::stod(fmt::format("{:.{}g}", value, digits)) : value;
}

}  // namespace shapegauge
