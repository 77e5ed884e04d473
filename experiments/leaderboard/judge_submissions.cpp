// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/leaderboard/judge_submissions.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/members.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/datasets/files/ranked_answers.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/datasets/layouts/labels.h"
#include "shapegauge/experiments/engine/manifest.h"
#include "shapegauge/experiments/evaluation/evaluation_warnings.h"
#include "shapegauge/experiments/leaderboard/repetitions.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

/// Cache version of evaluations; see docs/manual/cache.md.
constexpr int judged_version = 4;

// Evaluation of one submission, independent of its JSON file.
struct JudgedFile {
  std::string name;  ///< see method_name()
  Evaluation evaluation;
  std::vector<std::string> query_ids;
  std::vector<std::string> class_names;
  std::vector<int> labels;
  bool fit_for_report = false;
  std::string wrong_kind;  ///< why it appears to mix up similarities and distances; otherwise empty
  std::vector<std::string> warnings;
};

SHAPEGAUGE_MEMBERS(JudgedFile, name, evaluation, query_ids, class_names, labels, fit_for_report, wrong_kind, warnings)

// Keys of evaluations. They name every member of the inputs: a new member does not compile until its key has it.

Json key_of(const ModelLabels& labels) {
  const auto& [classification, queries, targets, models, subclasses, separate_sets, split, listed, without_ids, source,
               keys] = labels;  // keys follow from the models
  Json classes = Json::array();
  for (const auto& [name, parent, members] : classification.classes) classes.push_back({name, members});
  return {std::move(classes), queries, targets, models,      std::map(subclasses.begin(), subclasses.end()),
          separate_sets,      split,   listed,  without_ids, source};
}

Json key_of(const TaskLabels& labels) {
  const auto& [queries, targets] = labels;
  return {key_of(queries), targets ? key_of(*targets) : Json()};
}

Json key_of(const EvaluationOptions& options) {
  const auto& [protocol, ties, measures, curve, minimum_class_size, finds_itself] = options;
  Json names = Json::array();
  for (const Measure& measure : measures) names.push_back(measure.name);
  return {name_of(protocol),  name_of(ties), std::move(names),         curve ? name_of(*curve) : "",
          minimum_class_size, finds_itself,  measure_versions(options)};
}

Json key_of_file(const std::filesystem::path& path) {
  return path.empty() ? Json() : Json{path.string(), sha256_of_file(path)};
}

// Returns the inputs shared by the evaluations of all submissions.
Json common_key(const JudgingOptions& options) {
  const EvaluationFiles& files = options.files;
  return {judged_version, program_json(), key_of(options.evaluation),
          files.labels.empty() ? Json() : key_of(read_task_labels(files))};
}

std::string key_of(const Json& common, const EvaluationFiles& files, const std::string& sha256_of_submission) {
  const auto& [matrix, variable, labels, targets, qrels, ids, order, unanswered, level, shared_ids, similarity,
               distance] = files;
  const Json key{common,
                 sha256_of_submission,
                 matrix.filename().string(),  // its extension is the format
                 variable,
                 labels.string(),
                 targets.string(),
                 key_of_file(qrels),
                 key_of_file(ids),
                 static_cast<int>(order),
                 static_cast<int>(unanswered),
                 level,
                 shared_ids,
                 similarity,
                 distance};
  return sha256(json_text(key));
}

// Returns the files of a submission.
EvaluationFiles files_of(const Submission& submission, const EvaluationFiles& common) {
  EvaluationFiles files = common;
  files.matrix = submission.file;
  if (is_ranked_answers_file(submission.file)) {  // the common settings are those of the matrices among submissions
    files.variable.clear();
    files.ids.clear();
    files.distance.clear();
    files.order = RowOrder::automatic;
    files.similarity = false;
  }
  files.unanswered = Unanswered::count;
  if (!submission.distance.empty()) files.distance = submission.distance;
  if (!submission.ids.empty()) files.ids = submission.ids;
  if (submission.similarity) files.similarity = *submission.similarity;
  if (!files.distance.empty()) files.similarity = false;
  return files;
}

std::string wrong_kind_of(const EvaluatedFiles& evaluated, bool similarity) {
  const Eigen::Index rows = evaluated.data.distances.rows;
  const Eigen::Index odd = evaluated.findings.rows_nearest_to_others;
  if (2 * odd <= rows) return "";
  return fmt::format("in {} of {} rows the query is {} model: these look like {} given as {}", odd, rows,
                     similarity ? "the least similar" : "the farthest", similarity ? "distances" : "similarities",
                     similarity ? "similarities" : "distances");
}

JudgedFile judge_file(const EvaluationFiles& files, const EvaluationOptions& options) {
  EvaluatedFiles evaluated = evaluate_files(files, options);
  const EvaluationTask& task = evaluated.data.task;
  JudgedFile judged{.name = method_name(files.matrix, evaluated.data),
                    .evaluation = std::move(evaluated.evaluation),
                    .query_ids = task.query_ids,
                    .class_names = task.class_names,
                    .labels = task.retrieval.target_classes,
                    .fit_for_report = is_fit_for_report(task),
                    .wrong_kind = wrong_kind_of(evaluated, files.similarity),
                    .warnings = evaluated.warnings};
  if (const auto tied = ties_warning(judged.evaluation, evaluated.findings)) judged.warnings.push_back(*tied);
  return judged;
}

// Removes the file's name from the beginning of a message.
std::string reason_of(const InputError& error, const std::filesystem::path& file) {
  const std::string message = error.what();
  const std::string prefix = file.string() + ": ";
  return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
}

// Sequential evaluation of submissions.
class Judging {
 public:
  Judging(const JudgingOptions& options, Cache& cache, Leaderboard& board)
      : options_(&options), cache_(&cache), board_(&board), common_(common_key(options)) {}

  // Adds the submission to the evaluated or to the refused ones.
  void judge(const Submission& submission) {
    try {
      add(submission);
    } catch (const InputError& error) {
      board_->refused.push_back({.file = submission.file, .reason = reason_of(error, submission.file)});
    }
  }

  [[nodiscard]] std::vector<MethodScores>& scores() { return scores_; }

 private:
  void add(const Submission& submission) {
    const EvaluationFiles files = files_of(submission, options_->files);
    const std::string bytes = sha256_of_file(files.matrix);
    const std::string key = key_of(common_, files, bytes);
    JudgedFile judged =
        cache_->get(EntryKind::evaluation, key, [&] { return judge_file(files, options_->evaluation); });
    if (!judged.wrong_kind.empty() && !submission.similarity) {
      throw InputError(fmt::format("{}: {}; set \"similarity\": true or false in {}", submission.file.string(),
                                   judged.wrong_kind, description_of(submission.file).filename().string()));
    }
    warn_of_same_bytes(bytes, judged.warnings);
    EvaluatedSubmission one{.submission = submission,
                            .files = files,
                            .sha256 = bytes,
                            .key = key,
                            .evaluation = std::move(judged.evaluation),
                            .query_ids = std::move(judged.query_ids),
                            .fit_for_report = judged.fit_for_report,
                            .warnings = std::move(judged.warnings)};
    if (one.submission.name.empty()) one.submission.name = judged.name;
    MethodScores scores = scores_of(one, judged.class_names);
    if (!scores_.empty()) align_methods(std::vector{scores_.front(), scores}, {});
    scores_.push_back(std::move(scores));
    if (board_->submissions.empty()) {
      board_->class_names = judged.class_names;
      board_->labels = judged.labels;
    }
    board_->submissions.push_back(std::move(one));
  }

  void warn_of_same_bytes(const std::string& bytes, std::vector<std::string>& warnings) const {
    const auto same = std::ranges::find(board_->submissions, bytes, &EvaluatedSubmission::sha256);
    if (same == board_->submissions.end()) return;
    warnings.push_back(fmt::format("the file has the same bytes as {}", same->submission.file.string()));
  }

  const JudgingOptions* options_;
  Cache* cache_;
  Leaderboard* board_;
  Json common_;
  std::vector<MethodScores> scores_;
};

std::size_t index_of_measure(const std::string& measure, const std::vector<std::string>& measures) {
  const auto found = std::ranges::find(measures, measure.empty() ? "mAP" : measure);
  if (found != measures.end()) return static_cast<std::size_t>(found - measures.begin());
  if (measure.empty()) return 0;
  throw InputError(fmt::format("`rank_by`: {} is not among the measures ({})", measure, fmt::join(measures, ", ")));
}

std::vector<std::string> measure_names(const EvaluationOptions& options) {
  std::vector<std::string> names;
  for (const Measure& measure : evaluated_measures(options)) names.push_back(measure.name);
  return names;
}

// Returns standings by the means of classes, which are also the units of the tests. Letters are capitals.
std::vector<MethodStanding> class_standings(const Eigen::MatrixXd& values, std::span<const int> classes,
                                            StandingOptions options) {
  options.average = Average::macro;
  options.blocks = ResamplingUnit::classes;
  std::vector<MethodStanding> standings = standings_of(values, classes, options);
  for (MethodStanding& standing : standings) {
    std::ranges::transform(standing.letters, standing.letters.begin(),
                           [](char c) { return c == '-' ? c : static_cast<char>(c - 'a' + 'A'); });
  }
  return standings;
}

void add_standings(const AlignedMethods& methods, const StandingOptions& options, Leaderboard& board) {
  for (const Eigen::MatrixXd& values : methods.values) {
    board.micro.push_back(standings_of(values, methods.classes, options));
    board.macro.push_back(class_standings(values, methods.classes, options));
  }
}

// Sorts the submissions and their standings by rank.
void order_by_rank(Leaderboard& board) {
  const std::vector<MethodStanding>& by = board.micro[board.rank_by];
  std::vector<std::size_t> order(board.submissions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return by[i].rank; });
  const auto ordered = [&](auto& items) {
    auto before = std::move(items);
    items.clear();
    for (const std::size_t i : order) items.push_back(std::move(before[i]));
  };
  ordered(board.submissions);
  for (auto* standings : {&board.macro, &board.micro}) std::ranges::for_each(*standings, ordered);
}

std::string all_refused(const std::vector<RefusedSubmission>& refused) {
  std::string message = fmt::format("none of {} submissions can be evaluated", refused.size());
  for (const RefusedSubmission& one : refused) message += fmt::format("; {}: {}", one.file.string(), one.reason);
  return message;
}

}  // namespace

MethodScores scores_of(const EvaluatedSubmission& judged, const std::vector<std::string>& class_names) {
  EvaluationTask named;
  named.query_ids = judged.query_ids;
  named.class_names = class_names;
  return method_scores(judged.submission.name, judged.submission.file.string(), named, judged.evaluation);
}

Leaderboard judge_submissions(const FoundSubmissions& found, const JudgingOptions& options, Cache& cache,
                              const JudgingProgress& progress) {
  Leaderboard board;
  board.refused = found.refused;
  board.measures = measure_names(options.evaluation);
  board.rank_by = index_of_measure(options.rank_by, board.measures);
  Judging judging(options, cache, board);
  for (std::size_t i = 0; i < found.submissions.size(); ++i) {
    const Submission& submission = found.submissions[i];
    if (progress) progress(submission.file.filename().string(), i, found.submissions.size());
    judging.judge(submission);
  }
  if (board.submissions.empty()) throw InputError(all_refused(board.refused));
  combine_repetitions(board.submissions, judging.scores());
  const AlignedMethods methods = align_methods(judging.scores(), {});
  for (std::size_t i = 0; i < methods.methods.size(); ++i) {
    board.submissions[i].submission.name = methods.methods[i];
  }
  add_standings(methods, options.standings, board);
  order_by_rank(board);
  return board;
}

}  // namespace shapegauge
