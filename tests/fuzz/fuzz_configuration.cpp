// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/configuration/segmentation_experiment.h"
#include "shapegauge/experiments/configuration/shape_comparison.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/promises.h"

namespace shapegauge::fuzz {

namespace {

constexpr std::string_view set = "\n--set ";

/// Removes and returns the text before the next override, and removes its introduction.
std::string_view next_part(std::string_view& text) {
  const std::size_t end = text.find(set);
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + set.size());
  return part;
}

/// Whether the document can be read as a configuration.
template <typename Read>
bool complete(const nlohmann::json& document, const Read& from_json) {
  decltype(from_json(document, "", "")) read;
  if (!is_accepted("run.json: ", [&] { read = from_json(document, "run.json", "folder"); })) return false;
  const auto read_again = [&] { from_json(to_json(read), "complete", ""); };
  promise(is_accepted("complete: ", read_again), "a configuration with all defaults filled in is a configuration");
  return true;
}

}  // namespace

bool configuration(std::string_view bytes) {
  nlohmann::json document;
  if (!is_accepted("run.json:", [&] { document = parse_json(next_part(bytes), "run.json"); })) return false;
  while (!bytes.empty()) {
    const std::string_view assignment = next_part(bytes);
    if (!is_accepted("setting ", [&] { apply_override(document, assignment); })) return false;
  }
  if (document.contains("shapes")) return complete(document, comparison_from_json);
  if (document.contains("segmentation")) return complete(document, segmentation_from_json);
  return complete(document, configuration_from_json);
}

}  // namespace shapegauge::fuzz
