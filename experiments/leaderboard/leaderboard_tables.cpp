// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/leaderboard/leaderboard_tables.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "shapegauge/core/base/text.h"
#include "shapegauge/core/version.h"
#include "shapegauge/metrics/significance_tests.h"

namespace shapegauge {

namespace {

using BoardJson = nlohmann::ordered_json;

std::vector<std::string> interval_cells(const MethodStanding& standing, const ScoreStyle& style) {
  if (!standing.interval) return {"", ""};
  return {score_text(standing.interval->low, style), score_text(standing.interval->high, style)};
}

// Returns " ± " and the standard deviation over repetitions of a measure, if there is one.
std::string deviation_suffix(const Eigen::VectorXd& deviations, std::size_t measure, const ScoreStyle& style) {
  if (deviations.size() == 0) return "";
  return fmt::format(" ± {}", score_text(deviations[static_cast<Eigen::Index>(measure)], style));
}

bool has_repetitions(const Leaderboard& board) {
  return std::ranges::any_of(board.submissions,
                             [](const EvaluatedSubmission& one) { return !one.repetitions.empty(); });
}

BoardJson standing_json(const MethodStanding& standing, const Eigen::VectorXd& deviations, std::size_t measure) {
  BoardJson json{{"average", standing.average},
                 {"rank", standing.rank},
                 {"possible_ranks", {standing.best_rank, standing.worst_rank}},
                 {"group", standing.letters}};
  if (standing.interval) json["interval"] = {standing.interval->low, standing.interval->high};
  if (deviations.size() > 0) json["deviation"] = deviations[static_cast<Eigen::Index>(measure)];
  return json;
}

BoardJson submission_json(const Leaderboard& board, std::size_t index, const EvaluationFiles& files) {
  const EvaluatedSubmission& judged = board.submissions[index];
  BoardJson json{{"name", judged.submission.name},
                 {"file", judged.submission.file.filename().string()},
                 {"sha256", judged.sha256}};
  if (!judged.submission.authors.empty()) json["authors"] = judged.submission.authors;
  if (!judged.submission.paper.empty()) json["paper"] = judged.submission.paper;
  if (!judged.submission.url.empty()) json["url"] = judged.submission.url;
  if (judged.files.similarity) json["similarity"] = true;
  if (!judged.files.distance.empty()) json["distance"] = judged.files.distance;
  for (std::size_t k = 0; k < board.measures.size(); ++k) {
    json["micro"][board.measures[k]] = standing_json(board.micro[k][index], judged.micro_deviation, k);
    json["macro"][board.measures[k]] = standing_json(board.macro[k][index], judged.macro_deviation, k);
  }
  for (const RepetitionFile& one : judged.repetitions) {
    json["repetitions"].push_back({{"file", one.file.filename().string()}, {"sha256", one.sha256}});
  }
  json["warnings"] = BoardJson::array();
  for (const std::string& warning : judged.warnings) {
    json["warnings"].push_back(without_folders(warning, judged.submission.file, files));
  }
  return json;
}

}  // namespace

TextTable leaderboard_table(const Leaderboard& board, const ScoreStyle& style) {
  TextTable table{.header = {"rank", "method"}, .rows = {}, .text_columns = 2};
  table.header.insert(table.header.end(), board.measures.begin(), board.measures.end());
  for (std::size_t i = 0; i < board.submissions.size(); ++i) {
    std::vector<std::string> row{fmt::format("{}", board.micro[board.rank_by][i].rank),
                                 board.submissions[i].submission.name};
    for (std::size_t k = 0; k < board.measures.size(); ++k) {
      const MethodStanding& standing = board.micro[k][i];
      row.push_back(score_text(standing.average, style) +
                    deviation_suffix(board.submissions[i].micro_deviation, k, style));
      const std::string mark = standing.letters + " " + board.macro[k][i].letters;
      table.emphases.push_back({.row = i, .column = 2 + k, .bold = false, .mark = mark});
    }
    table.rows.push_back(std::move(row));
  }
  embolden_best(table, table.text_columns);
  return table;
}

TextTable leaderboard_csv_table(const Leaderboard& board, const ScoreStyle& style) {
  TextTable table{.header = {"rank", "method", "authors", "paper", "file", "average"}, .rows = {}, .text_columns = 6};
  const bool repeated = has_repetitions(board);
  for (const std::string& measure : board.measures) {
    for (const char* end : {"", "_low", "_high", "_group"}) table.header.push_back(measure + end);
    if (repeated) table.header.push_back(measure + "_deviation");
  }
  for (std::size_t i = 0; i < board.submissions.size(); ++i) {
    const Submission& submission = board.submissions[i].submission;
    for (const auto& [average, standings] : {std::pair{"micro", &board.micro}, std::pair{"macro", &board.macro}}) {
      std::vector<std::string> row{fmt::format("{}", (*standings)[board.rank_by][i].rank),
                                   submission.name,
                                   submission.authors,
                                   submission.paper,
                                   submission.file.filename().string(),
                                   average};
      const Eigen::VectorXd& deviations =
          standings == &board.micro ? board.submissions[i].micro_deviation : board.submissions[i].macro_deviation;
      for (std::size_t k = 0; k < standings->size(); ++k) {
        const MethodStanding& standing = (*standings)[k][i];
        const std::vector<std::string> ends = interval_cells(standing, style);
        row.insert(row.end(), {score_text(standing.average, style), ends[0], ends[1], standing.letters});
        if (!repeated) continue;
        row.push_back(deviations.size() == 0 ? "" : score_text(deviations[static_cast<Eigen::Index>(k)], style));
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

std::string explain_letters(const StandingOptions& options) {
  return fmt::format(
      "Methods that share a small letter do not differ significantly on {} (test over {}), those that share a capital "
      "on "
      "classes like these (test over classes).",
      options.blocks == ResamplingUnit::queries ? "these classes" : "classes like these", name_of(options.blocks));
}

std::string explain_significance(const Leaderboard& board, const StandingOptions& options) {
  std::string words = fmt::format(
      "{:g} % bootstrap intervals. {} Randomised Tukey HSD, p > {:.3g}: it compares all methods at once, and one that "
      "is "
      "far worse than the others can hide differences between these.",
      100 * options.confidence, explain_letters(options), significance_level(options.confidence));
  if (const auto few = few_classes_warning(board, options)) words += fmt::format(" {}.", *few);
  return words;
}

std::optional<std::string> few_classes_warning(const Leaderboard& board, const StandingOptions& options) {
  const Eigen::Index classes = std::ssize(board.submissions.front().evaluation.classes);
  const Eigen::Index methods = std::ssize(board.submissions);
  const double smallest = min_attainable_tukey_p_value(methods, classes, options.resampling);
  if (methods < 2 || smallest <= significance_level(options.confidence)) return std::nullopt;
  return fmt::format(
      "{} of {} cannot differ significantly on classes like these: no p-value of the test over classes is below {:.3g}",
      count_text(methods, "method", "methods"), count_text(classes, "class", "classes"), smallest);
}

std::string without_folders(std::string text, const std::filesystem::path& submission, const EvaluationFiles& files) {
  std::set<std::string, std::greater<>> folders;  // of two with the same beginning, the longer comes first
  for (const std::filesystem::path& file : {submission, files.labels, files.targets, files.qrels, files.ids}) {
    if (file.has_parent_path()) folders.insert((file.parent_path() / "").string());
  }
  for (const std::string& folder : folders) {
    for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder, at))
      text.erase(at, folder.size());
  }
  return text;
}

BoardJson leaderboard_json(const Leaderboard& board, const JudgingOptions& options) {
  const Evaluation& evaluation = board.submissions.front().evaluation;
  BoardJson json{{"version", version()},
                 {"protocol", name_of(evaluation.protocol)},
                 {"ties", name_of(evaluation.ties)},
                 {"queries", evaluation.queries.size()},
                 {"rank_by", board.measures[board.rank_by]},
                 {"confidence", options.standings.confidence},
                 {"blocks", name_of(options.standings.blocks)},
                 {"macro_blocks", name_of(ResamplingUnit::classes)},
                 {"resamples", options.standings.resampling.resamples},
                 {"seed", options.standings.resampling.seed},
                 {"submissions", BoardJson::array()},
                 {"refused", BoardJson::array()}};
  for (std::size_t i = 0; i < board.submissions.size(); ++i) {
    json["submissions"].push_back(submission_json(board, i, options.files));
  }
  for (const RefusedSubmission& refused : board.refused) {
    json["refused"].push_back({{"file", refused.file.filename().string()},
                               {"reason", without_folders(refused.reason, refused.file, options.files)}});
  }
  return json;
}

}  // namespace shapegauge
