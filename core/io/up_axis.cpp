// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/io/up_axis.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <system_error>

#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/shape_file.h"

namespace shapegauge {

namespace {

/// Returns the axis that a comment of the file states, if any.
std::optional<UpAxis> stated_axis(const std::filesystem::path& file) {
  constexpr std::uintmax_t length = 256;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) return std::nullopt;
  stream.seekg(-static_cast<std::streamoff>(std::min<std::uintmax_t>(length, stream.tellg())), std::ios::end);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t comment = bytes.rfind(fmt::format("\n{}", up_comment));
  if (comment == std::string::npos) return std::nullopt;
  const std::size_t word = comment + 1 + up_comment.size();
  return value_of_word<UpAxis>(bytes.substr(word, bytes.find_first_of("\r\n", word) - word));
}

UpAxis axis_of_format(const std::filesystem::path& file) {
  const std::string extension = lower_case(file.extension().string());
  const ShapeFormat* const format = shape_formats().find_if(
      [&](const ShapeFormat& one) { return std::ranges::count(one.extensions, extension) > 0; });
  return format != nullptr && format->y_is_up ? UpAxis::y : UpAxis::z;
}

}  // namespace

Parameter up_parameter() {
  return {.name = "up",
          .kind = ParameterKind::choice,
          .default_value = word_of(UpAxis::automatic),
          .choices = words_of<UpAxis>,
          .description =
              "Upward axis. auto: from a comment \"# up: z\" in the file, otherwise y for OFF, OBJ and glTF, and z "
              "for other formats."};
}

std::string read_up_comment(const std::filesystem::path& file) {
  const std::optional<UpAxis> axis = stated_axis(file);
  return axis ? fmt::format("{}{}", up_comment, word_of(*axis)) : "";
}

Eigen::Vector3d up_direction(UpAxis axis, const std::filesystem::path& file) {
  if (axis == UpAxis::automatic) axis = stated_axis(file).value_or(UpAxis::automatic);
  if (axis == UpAxis::automatic) axis = axis_of_format(file);
  const std::string_view word = word_of(axis);
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
  up[word.back() - 'x'] = word.size() > 1 ? -1 : 1;
  return up;
}

}  // namespace shapegauge
