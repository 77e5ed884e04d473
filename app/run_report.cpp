// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run_report.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "app/commands.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/engine/replay.h"
#include "shapegauge/experiments/engine/result_folder.h"

namespace shapegauge {

namespace {

constexpr std::size_t max_by_name = 10;

void print_lines(const std::vector<std::string>& names, std::string_view verdict) {
  for (const std::string& name : names) print_output("{:<14}{}\n", verdict, printable(name));
}

}  // namespace

void warn_of_changed_inputs(const std::vector<std::string>& changes) {
  const std::size_t named = std::min(changes.size(), max_by_name);
  for (std::size_t i = 0; i < named; ++i) warn("input: " + changes[i]);
  if (named < changes.size()) {
    warn(fmt::format("{} more inputs differ from the recorded ones", changes.size() - named));
  }
}

int report_replay(const nlohmann::json& recorded, const std::filesystem::path& results) {
  const nlohmann::json now = read_json(results / manifest_name);
  const ComparedOutputs outputs = compare_outputs(recorded, now);
  print_output("\n");
  print_lines(outputs.same, "same");
  print_lines(outputs.different, "DIFFERENT");
  print_lines(outputs.timings, "not compared");
  print_lines(changed_program(recorded), "program");
  const std::vector<std::string> inputs = changed_inputs(recorded, now.at("inputs"));
  const std::size_t named = std::min(inputs.size(), max_by_name);
  print_lines({inputs.begin(), inputs.begin() + static_cast<std::ptrdiff_t>(named)}, "input");
  if (named < inputs.size()) print_output("{:<14}and {} more\n", "input", inputs.size() - named);
  const std::size_t all = outputs.same.size() + outputs.different.size();
  if (outputs.different.empty()) {
    print_output("All {} outputs are identical to the recorded ones.\n", all);
    return exit_success;
  }
  print_output("{} of {} outputs differ from the recorded ones{}.\n", outputs.different.size(), all,
               inputs.empty() ? "" : fmt::format("; {} of its inputs differ as well", inputs.size()));
  return exit_with_failures;
}

std::string cache_text(const CacheReport& cache) {
  constexpr std::array<std::pair<EntryKind, std::string_view>, 6> shown{{{EntryKind::shape, "shapes"},
                                                                         {EntryKind::field, "fields"},
                                                                         {EntryKind::features, "features"},
                                                                         {EntryKind::distances, "distance matrices"},
                                                                         {EntryKind::segmentation, "segmentations"},
                                                                         {EntryKind::comparison, "compared shapes"}}};
  std::vector<std::string> parts;
  bool any = false;
  for (const auto& [kind, name] : shown) {
    const CacheUse& use = cache.uses.at(static_cast<std::size_t>(kind));
    if (use.hits + use.computed == 0) continue;
    parts.push_back(fmt::format("{} of {} {}", use.hits, use.hits + use.computed, name));
    any = any || use.hits > 0;
  }
  return any ? fmt::format("From the cache: {}\n", fmt::join(parts, ", ")) : "";
}

int report_run_problems(const RunOutcome& outcome) {
  for (const std::string& text : outcome.notes) note(text);
  for (const std::string& warning : outcome.warnings) warn(warning);
  for (const LeftOutShape& one : outcome.left_out) {
    warn(fmt::format("omitted {} {}: {}", outcome.noun, one.id, one.message));
  }
  for (const std::string& sentence : outcome.incomplete) print_error(sentence);
  if (outcome.left_out.empty()) return outcome.incomplete.empty() ? exit_success : exit_with_failures;
  print_error(fmt::format("{} of {} {}s could not be used and were omitted from the results", outcome.left_out.size(),
                          outcome.left_out.size() + outcome.used, outcome.noun));
  return exit_with_failures;
}

}  // namespace shapegauge
