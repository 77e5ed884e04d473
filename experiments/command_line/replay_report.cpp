#include "shapegauge/experiments/command_line/replay_report.h"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>

#include "shapegauge/experiments/command_line/exit_status.h"
#include "shapegauge/experiments/configuration/parse_json.h"
#include "shapegauge/experiments/results/replay.h"
#include "shapegauge/experiments/results/result_folder.h"

namespace shapegauge {

namespace {

constexpr std::size_t most_by_name = 10;

void print_lines(const std::vector<std::string>& names, std::string_view verdict) {
  for (const std::string& name : names) fmt::print("{:<14}{}\n", verdict, name);
}

}  // namespace

void warn_of_changed_inputs(const std::vector<std::string>& changes) {
  const std::size_t named = std::min(changes.size(), most_by_name);
  for (std::size_t i = 0; i < named; ++i) fmt::print(stderr, "shapegauge: warning: input: {}\n", changes[i]);
  if (named < changes.size()) {
    fmt::print(stderr, "shapegauge: warning: {} more inputs are not those recorded\n", changes.size() - named);
  }
}

int report_replay(const nlohmann::json& recorded, const std::filesystem::path& results) {
  const nlohmann::json now = read_json(results / manifest_name);
  const ComparedOutputs outputs = compare_outputs(recorded, now);
  fmt::print("\n");
  print_lines(outputs.same, "same");
  print_lines(outputs.different, "DIFFERENT");
  print_lines(outputs.timings, "not compared");
  print_lines(changed_program(recorded), "program");
  const std::vector<std::string> inputs = changed_inputs(recorded.at("inputs"), now.at("inputs"));
  const std::size_t named = std::min(inputs.size(), most_by_name);
  print_lines({inputs.begin(), inputs.begin() + static_cast<std::ptrdiff_t>(named)}, "input");
  if (named < inputs.size()) fmt::print("{:<14}and {} more\n", "input", inputs.size() - named);
  const std::size_t all = outputs.same.size() + outputs.different.size();
  if (outputs.different.empty()) {
    fmt::print("All {} outputs are the same bytes as recorded.\n", all);
    return exit_success;
  }
  fmt::print("{} of {} outputs are not the same bytes as recorded{}.\n", outputs.different.size(), all,
             inputs.empty() ? "" : fmt::format("; {} of its inputs are not those recorded", inputs.size()));
  return exit_with_failures;
}

}  // namespace shapegauge
