// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/commands.h"
#include "app/evaluation_arguments.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/output_files.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/leaderboard/dataset_leaderboards.h"
#include "shapegauge/experiments/leaderboard/judge_submissions.h"
#include "shapegauge/experiments/leaderboard/leaderboard_tables.h"
#include "shapegauge/experiments/leaderboard/submissions.h"
#include "shapegauge/experiments/leaderboard/write_leaderboard.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

struct LeaderboardArguments {
  std::vector<fs::path> submissions;
  EvaluationArguments evaluation;
  ResamplingArguments resampling{.blocks = "queries", .confidence = 0.95, .resampling = {}};
  CacheOption cache;
  fs::path output;
  std::string title = "Leaderboard";
  std::string rank_by;
  bool hide_classes = false;
  ScoreFormat printed;
  bool replace = false;
};

// Throws InputError for unusable output files, before any work. `inputs` are files of labels.
void check_leaderboard_output(const LeaderboardArguments& arguments, std::vector<fs::path> inputs) {
  if (arguments.output.empty()) return;
  inputs.insert(inputs.end(), arguments.submissions.begin(), arguments.submissions.end());
  if (is_page(arguments.output)) {
    const std::vector<OutputFile> outputs{{.path = arguments.output, .what = "--output", .extensions = {}}};
    check_output_files(inputs, outputs, arguments.replace);
    return;
  }
  check_site_folder(arguments.output);
  for (const fs::path& submission : arguments.submissions) {
    std::error_code unknown;
    if (fs::equivalent(submission, arguments.output, unknown)) {
      throw InputError(fmt::format("--output: the site cannot be in the folder of submissions, {}; name another folder",
                                   submission.string()));
    }
  }
}

JudgingOptions judging_options(const LeaderboardArguments& arguments) {
  JudgingOptions options;
  options.files = evaluation_files(arguments.evaluation);
  options.evaluation = evaluation_options(arguments.evaluation);
  options.standings = {.blocks = value_of_word<ResamplingUnit>(arguments.resampling.blocks).value(),
                       .average = Average::micro,
                       .confidence = arguments.resampling.confidence,
                       .resampling = arguments.resampling.resampling};
  options.rank_by = arguments.rank_by;
  options.hide_classes = arguments.hide_classes;
  return options;
}

std::string formatted_leaderboard(const Leaderboard& board, const JudgingOptions& options,
                                  const LeaderboardArguments& arguments) {
  const ScoreStyle style = style_of(arguments.printed);
  if (arguments.printed.format == "json") return json_text(leaderboard_json(board, options), 2) + "\n";
  const auto format = value_of_word<TableFormat>(arguments.printed.format).value();
  if (format == TableFormat::csv) return to_csv(leaderboard_csv_table(board, style));
  const std::string table = table_text(leaderboard_table(board, style), format, output_has_colours());
  return format == TableFormat::latex ? table : table + "\n" + explain_letters(options.standings) + "\n";
}

void note_site(const fs::path& folder, const SiteUpdate& update) {
  note(fmt::format("site {}: {} pages of methods written, {} unchanged, {} removed", folder.string(), update.written,
                   update.unchanged, update.removed));
}

void write_outputs(const Leaderboard& board, const JudgingOptions& options, const LeaderboardArguments& arguments) {
  if (arguments.output.empty()) return;
  if (is_page(arguments.output)) {
    write_file_atomically(arguments.output, leaderboard_html(arguments.title, board, options));
    return;
  }
  const BusyLine line("writing the site");
  note_site(arguments.output, write_site(arguments.output, arguments.title, board, options));
}

// Prints each warning once, with the submissions that it concerns.
void print_remarks(std::span<const Leaderboard> boards) {
  std::vector<FileWarning> warnings;
  for (const Leaderboard& board : boards) {
    for (const EvaluatedSubmission& judged : board.submissions) {
      for (const std::string& text : judged.warnings) warnings.push_back({judged.submission.file.string(), text});
    }
  }
  print_warnings(merged_warnings(warnings, "submissions"));
}

// Prints warnings, skipped files and the reasons for refused submissions; returns the exit status.
int report_submissions(std::span<const Leaderboard> boards, std::span<const fs::path> skipped,
                       std::span<const RefusedSubmission> refused, const Cache& cache) {
  for (const std::string& warning : cache.warnings()) warn(warning);
  print_remarks(boards);
  if (!skipped.empty()) {
    note(fmt::format("{} other files in the folders are not submissions (first: {})", skipped.size(),
                     skipped.front().string()));
  }
  for (const auto& [file, reason] : refused) warn(fmt::format("refused {}: {}", file.string(), reason));
  return refused.empty() ? exit_success : exit_with_failures;
}

int run_on_one(const LeaderboardArguments& arguments) {
  check_leaderboard_output(arguments, label_files(arguments.evaluation));
  const JudgingOptions options = judging_options(arguments);
  const FoundSubmissions found = find_submissions(arguments.submissions, label_files(arguments.evaluation));
  Cache cache(requested_cache_folder(arguments.cache));
  Leaderboard board;
  {
    ProgressLine line;
    board = judge_submissions(found, options, cache, line.receiver());
  }
  write_outputs(board, options, arguments);
  if (const auto few = few_classes_warning(board, options.standings)) warn(*few);
  print_output("{}", formatted_leaderboard(board, options, arguments));
  return report_submissions(std::span(&board, 1), found.skipped, board.refused, cache);
}

std::string formatted_datasets(const DatasetLeaderboards& all, const JudgingOptions& options,
                               const LeaderboardArguments& arguments) {
  const ScoreStyle style = style_of(arguments.printed);
  if (arguments.printed.format == "json") return json_text(dataset_leaderboards_json(all, options), 2) + "\n";
  const auto format = value_of_word<TableFormat>(arguments.printed.format).value();
  if (format == TableFormat::csv) return to_csv(multi_dataset_csv_table(all.results, style));
  const MultiDatasetTable& main = main_table(all.results);
  std::string table = table_text(multi_dataset_summary(all.results, main, style), format, output_has_colours());
  if (format == TableFormat::latex) return table;
  return fmt::format("{}\n{} ({}, mean over queries). {}\n", table, main.measure, main.protocol,
                     test_words(all.results, main));
}

void write_outputs_of_datasets(const DatasetLeaderboards& all, const JudgingOptions& options,
                               const LeaderboardArguments& arguments) {
  if (arguments.output.empty()) return;
  if (is_page(arguments.output)) {
    write_file_atomically(arguments.output, dataset_leaderboards_html(arguments.title, all));
    return;
  }
  const BusyLine line("writing the site");
  note_site(arguments.output, write_dataset_site(arguments.output, arguments.title, all, options));
}

int run_on_datasets(const LeaderboardArguments& arguments, const std::vector<SubmittedDataset>& datasets) {
  std::vector<fs::path> labels;
  for (const SubmittedDataset& dataset : datasets) {
    labels.insert(labels.end(), {dataset.files.labels, dataset.files.targets, dataset.files.qrels, dataset.files.ids});
  }
  check_leaderboard_output(arguments, std::move(labels));
  JudgingOptions options = judging_options(arguments);
  options.standings.tested = !arguments.output.empty() && !is_page(arguments.output);  // only a site has each data set
  Cache cache(requested_cache_folder(arguments.cache));
  DatasetLeaderboards all;
  {
    ProgressLine line;
    all = evaluate_datasets(datasets, options, cache, line.receiver());
  }
  write_outputs_of_datasets(all, options, arguments);
  print_output("{}", formatted_datasets(all, options, arguments));
  return report_submissions(all.boards, all.skipped, all.refused, cache);
}

// Without labels, each argument is a data set with its own.
int run_leaderboard(LeaderboardArguments arguments) {
  EvaluationFiles& files = arguments.evaluation.files;
  if (!files.labels.empty() || !files.qrels.empty()) return run_on_one(arguments);
  const std::vector<SubmittedDataset> datasets =
      find_submitted_datasets(arguments.submissions, evaluation_files(arguments.evaluation));
  files = datasets.front().files;
  return datasets.size() == 1 ? run_on_one(arguments) : run_on_datasets(arguments, datasets);
}

void add_leaderboard_options(CLI::App& command, LeaderboardArguments& arguments) {
  begin_option_group(command, output_options);
  command.add_option("-o,--output", arguments.output,
                     "Output page (.html), or folder for a site with one page per method");
  command.add_option("--title", arguments.title, "Page title")->capture_default_str();
  command.add_option("--rank-by", arguments.rank_by,
                     "Measure to rank by (default: mAP if computed, otherwise the first measure)");
  command.add_flag("--hide-classes", arguments.hide_classes,
                   "Omit scores per class and pages of methods, to keep classes secret");
  add_score_format_options(command, arguments.printed, "Format of the printed result");
  add_cache_option(command, arguments.cache);
  add_replace_option(command, arguments.replace);
}

}  // namespace

void add_leaderboard_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("leaderboard", "Check, evaluate and rank submissions");
  command->footer(
      "Example: shapegauge leaderboard submissions/ --labels test.cla -o leaderboard.html\n"
      "         shapegauge leaderboard shrec11/ psb/ tosca/ -o all.html\n"
      "foo.json describes foo.npy: name, authors, paper, url, similarity, distance, ids. foo.seed1.npy, foo.seed2.npy, "
      "... (or fold) are repetitions of foo.");
  const auto arguments = std::make_shared<LeaderboardArguments>();
  command
      ->add_option(
          "submissions", arguments->submissions,
          "Distances, features or ranked lists, or folders of them; without --labels and --qrels: one folder per "
          "data set, which also contains labels.* or qrels.*")
      ->required();
  add_evaluation_options(*command, arguments->evaluation, {std::string(word_of(Unanswered::count))});
  command->get_option("--missing-queries")->description("Queries without a ranked list score 0");
  add_resampling_options(*command, arguments->resampling);
  add_leaderboard_options(*command, *arguments);
  command->callback([arguments, &status] {
    with_threads(arguments->evaluation.threads, [&] { status = run_leaderboard(*arguments); });
  });
}

}  // namespace shapegauge
