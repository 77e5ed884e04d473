// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/evaluation_arguments.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/terminal.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/results/protocol_audit.h"

namespace shapegauge {

namespace {

struct AuditArguments {
  std::vector<std::filesystem::path> matrices;
  EvaluationArguments evaluation;
  ResamplingArguments resampling{.blocks = "queries", .confidence = 0.95, .resampling = {}};
  ScoreFormat printed;
};

StandingOptions standing_options(const ResamplingArguments& arguments) {
  return {.blocks = value_of_word<ResamplingUnit>(arguments.blocks).value(),
          .average = Average::micro,
          .confidence = arguments.confidence,
          .resampling = arguments.resampling};
}

std::string formatted_audit(const ProtocolAudit& audit, const ScoreFormat& printed) {
  if (printed.format == "json") return json_text(audit_json(audit), 2) + "\n";
  const auto format = value_of_word<TableFormat>(printed.format).value();
  if (format == TableFormat::csv) return to_csv(audit_csv_table(audit));
  const ScoreStyle style = style_of(printed);
  std::string text;
  for (const std::string& quantity : audited_quantities(audit)) {
    text += quantity + "\n" + table_text(audit_table(audit, quantity, style), format) + "\n";
  }
  return text + table_text(audit_summary(audit, style), format);
}

int run_audit(const AuditArguments& arguments) {
  ProtocolAudit audit;
  {
    ProgressLine line;
    audit = audit_protocols(arguments.matrices, evaluation_files(arguments.evaluation),
                            standing_options(arguments.resampling), line.receiver());
  }
  print_output("{}", formatted_audit(audit, arguments.printed));
  print_warnings(audit.warnings);
  return exit_success;
}

}  // namespace

void add_audit_command(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("audit", "Evaluate files like several evaluation programs, and compare the ranks");
  command->footer("Example: shapegauge audit ours.npy theirs.npy --labels test.cla");
  const auto arguments = std::make_shared<AuditArguments>();
  command
      ->add_option("matrices", arguments->matrices,
                   "Distances, features or ranked lists for the same queries, one file per method")
      ->required();
  add_file_options(*command, arguments->evaluation);
  add_threads_option(*command, arguments->evaluation.threads);
  add_resampling_options(*command, arguments->resampling);
  begin_option_group(*command, output_options);
  add_score_format_options(*command, arguments->printed, "Format of the printed result");
  command->callback(
      [arguments, &status] { with_threads(arguments->evaluation.threads, [&] { status = run_audit(*arguments); }); });
}

}  // namespace shapegauge
