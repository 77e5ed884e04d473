#include "shapegauge/experiments/configuration/apply_override.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <string>

#include "shapegauge/core/error.h"
#include "shapegauge/core/printable.h"
#include "shapegauge/experiments/configuration/parse_json.h"

namespace shapegauge {

namespace {

[[noreturn]] void fail(std::string_view assignment, std::string_view message) {
  throw InputError(fmt::format("--set {}: {}", printable(assignment, 100), message));
}

nlohmann::json& element(nlohmann::json& array, std::string_view index, std::string_view assignment) {
  std::size_t position = 0;
  const auto [end, failure] = std::from_chars(index.data(), index.data() + index.size(), position);
  if (failure != std::errc() || end != index.data() + index.size() || position >= array.size()) {
    fail(assignment, fmt::format("\"{}\" is not an index of an array of {} values (the first is 0)",
                                 printable(index, 60), array.size()));
  }
  return array[position];
}

nlohmann::json& child(nlohmann::json& parent, std::string_view key, std::string_view assignment) {
  if (parent.is_array()) return element(parent, key, assignment);
  if (parent.is_null()) parent = nlohmann::json::object();
  if (!parent.is_object()) {
    fail(assignment, fmt::format("there is no \"{}\" in {}, which is a {}", printable(key, 60),
                                 printable(parent.dump(), 60), parent.type_name()));
  }
  return parent[std::string(key)];
}

/// The library takes any bytes for a string, but writes and compares UTF-8 only.
bool is_utf8(std::string_view text) {
  try {
    static_cast<void>(nlohmann::json(text).dump());
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

}  // namespace

void apply_override(nlohmann::json& document, std::string_view assignment) {
  if (!is_utf8(assignment)) fail(assignment, "the bytes are not UTF-8");
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos || equals == 0) {
    fail(assignment, "expected dotted.key=value, for example signatures.0.histogram.bins=40");
  }
  constexpr auto most_keys = 100;
  if (std::ranges::count(assignment.substr(0, equals), '.') >= most_keys) {
    fail(assignment, fmt::format("more than {} keys", most_keys));
  }
  nlohmann::json* target = &document;
  std::string_view keys = assignment.substr(0, equals);
  while (true) {
    const std::size_t dot = keys.find('.');
    const std::string_view key = keys.substr(0, dot);
    if (key.empty()) fail(assignment, "a key between the dots is empty");
    target = &child(*target, key, assignment);
    if (dot == std::string_view::npos) break;
    keys.remove_prefix(dot + 1);
  }
  const std::string_view value = assignment.substr(equals + 1);
  *target = parse_if_json(value, "--set " + printable(assignment, 100)).value_or(nlohmann::json(value));
}

}  // namespace shapegauge
