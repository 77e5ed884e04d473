// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/commands.h"
#include "app/parameter_options.h"
#include "app/terminal.h"
#include "shapegauge/metrics/evaluators.h"
#include "shapegauge/metrics/measures.h"
#include "shapegauge/metrics/segmentation_errors.h"

namespace shapegauge {

namespace {

constexpr std::size_t text_width = 100;

/// Wraps words to the text width, with indentation.
std::string wrapped(std::string_view words, std::size_t indent) {
  std::string text;
  std::string line(indent, ' ');
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find(' '));
    words.remove_prefix(std::min(word.size() + 1, words.size()));
    if (line.size() > indent && line.size() + 1 + word.size() > text_width) {
      text += line + '\n';
      line.assign(indent, ' ');
    }
    if (line.size() > indent) line += ' ';
    line += word;
  }
  return text + line + '\n';
}

nlohmann::ordered_json all_measures() {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const MeasureDefinition& measure : measure_definitions().entries()) {
    all.push_back({{"name", measure.name},
                   {"title", measure.title},
                   {"definition", measure.definition},
                   {"source", measure.source},
                   {"caveat", measure.caveat}});
  }
  for (const SegmentationErrorEntry& error : segmentation_error_entries()) {
    all.push_back({{"name", error.name}, {"segmentation", true}, {"definition", error.definition}});
  }
  return all;
}

int run(const std::string& format) {
  if (format == "json") {
    print_output("{}\n", all_measures().dump(2));
    return exit_success;
  }
  print_output("h(i) is 1 where the model at rank i is relevant, else 0; R is the number of relevant models.\n");
  for (const MeasureDefinition& measure : measure_definitions().entries()) {
    print_output("\n{}, {}\n{}{}{}", measure.name, measure.title, wrapped(measure.definition, 4),
                 wrapped(fmt::format("Source: {}", measure.source), 4),
                 wrapped(fmt::format("Caveat: {}", measure.caveat), 4));
  }
  print_output("\nEvaluation programs that 'evaluate --evaluator' reproduces.\n");
  for (const Evaluator& evaluator : evaluators()) {
    std::string scores;
    for (const Measure& measure : options_of_evaluator(evaluator.name).measures) {
      scores += (scores.empty() ? "" : ", ") + measure.name;
    }
    print_output("\n{}, {}\n{}{}", evaluator.name, evaluator.program, wrapped(evaluator.deviations, 4),
                 wrapped(fmt::format("Protocol {}: {}", name_of(evaluator.protocol), scores), 4));
    for (const Measure& measure : options_of_evaluator(evaluator.name).measures) {
      if (measure.name.find('.') == std::string::npos) continue;  // a measure of above
      print_output("{}", wrapped(fmt::format("{}: {}", measure.name, measure.definition->definition), 4));
    }
  }
  print_output("\nErrors of segmentations, as Chen, Golovinskiy and Funkhouser 2009 measure them; less is better.\n");
  for (const SegmentationErrorEntry& error : segmentation_error_entries()) {
    print_output("\n{}\n{}", error.name, wrapped(error.definition, 4));
  }
  return exit_success;
}

}  // namespace

void add_measures_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("measures", "Print the definitions, sources and caveats of the measures");
  command->footer("Example: shapegauge measures");
  const auto format = std::make_shared<std::string>("text");
  command->add_option("--format", *format, "Format of the definitions")
      ->check(one_of({"text", "json"}))
      ->capture_default_str();
  command->callback([format, &status] { status = run(*format); });
}

}  // namespace shapegauge
