#include "shapegauge/experiments/configuration/apply_override.h"

#include <charconv>
#include <fmt/format.h>
#include <string>

#include "shapegauge/core/error.h"

namespace shapegauge {

namespace {

nlohmann::json& element(nlohmann::json& array, std::string_view index, std::string_view assignment) {
  std::size_t position = 0;
  const auto [end, failure] = std::from_chars(index.data(), index.data() + index.size(), position);
  if (failure != std::errc() || end != index.data() + index.size() || position >= array.size()) {
    throw InputError(fmt::format("--set {}: \"{}\" is not an index of an array of {} values (the first is 0)",
                                 assignment, index, array.size()));
  }
  return array[position];
}

nlohmann::json& child(nlohmann::json& parent, std::string_view key, std::string_view assignment) {
  if (parent.is_array()) return element(parent, key, assignment);
  if (parent.is_null()) parent = nlohmann::json::object();
  if (!parent.is_object()) {
    throw InputError(fmt::format("--set {}: there is no \"{}\" in {}, which is a {}", assignment, key, parent.dump(),
                                 parent.type_name()));
  }
  return parent[std::string(key)];
}

}  // namespace

void apply_override(nlohmann::json& document, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos || equals == 0) {
    throw InputError(
        fmt::format("--set {}: expected dotted.key=value, for example signatures.0.histogram.bins=40", assignment));
  }
  nlohmann::json* target = &document;
  std::string_view keys = assignment.substr(0, equals);
  while (true) {
    const std::size_t dot = keys.find('.');
    const std::string_view key = keys.substr(0, dot);
    if (key.empty()) throw InputError(fmt::format("--set {}: a key between the dots is empty", assignment));
    target = &child(*target, key, assignment);
    if (dot == std::string_view::npos) break;
    keys.remove_prefix(dot + 1);
  }
  const std::string_view value = assignment.substr(equals + 1);
  nlohmann::json parsed = nlohmann::json::parse(value, nullptr, false);
  *target = parsed.is_discarded() ? nlohmann::json(value) : std::move(parsed);
}

}  // namespace shapegauge
