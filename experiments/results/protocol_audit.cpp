// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/results/protocol_audit.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/evaluation/method_scores.h"
#include "shapegauge/metrics/equal_scores.h"
#include "shapegauge/metrics/evaluators.h"

namespace shapegauge {

namespace {

const std::string baseline = "shapegauge";

// An evaluator with the options of its evaluations.
struct Column {
  std::string evaluator;
  std::vector<EvaluatorScore> scores;
  EvaluationOptions options;
};

std::vector<Column> columns_of_audit() {
  const std::vector<std::string> measures{"NN", "FT", "ST", "mAP", "nDCG"};
  Column baseline_column{
      .evaluator = baseline,
      .scores = {},
      .options = {.protocol = Protocol::psb, .ties = Ties::expected, .measures = measures_of(measures)}};
  for (const std::string& measure : measures) baseline_column.scores.push_back({measure, measure});
  std::vector<Column> columns{baseline_column};
  for (const Evaluator& evaluator : evaluators()) {
    columns.push_back({evaluator.name, evaluator.scores, options_of_evaluator(evaluator.name)});
  }
  return columns;
}

std::vector<std::size_t> ranks_of_scores(const Eigen::VectorXd& values) {
  std::vector<std::size_t> ranks(static_cast<std::size_t>(values.size()));
  std::size_t better = 0;
  for (const std::vector<std::size_t>& group : groups_of_equal_scores(values)) {
    for (const std::size_t method : group) ranks[method] = better + 1;
    better += group.size();
  }
  return ranks;
}

// Evaluations of all files by one evaluator; nothing if it has no queries.
std::optional<std::vector<EvaluatedFiles>> evaluate_all(std::span<const std::filesystem::path> matrices,
                                                        EvaluationFiles files, const Column& column,
                                                        ProtocolAudit& audit) {
  std::vector<EvaluatedFiles> evaluated;
  for (const std::filesystem::path& matrix : matrices) {
    files.matrix = matrix;
    try {
      evaluated.push_back(evaluate_files(files, column.options));
    } catch (const InputError& error) {
      if (column.evaluator == baseline) throw;
      audit.warnings.push_back(fmt::format("{} is omitted: {}", column.evaluator, error.what()));
      return std::nullopt;
    }
  }
  return evaluated;
}

// Returns the scores of the files.
std::vector<MethodScores> scores_of(std::span<const std::filesystem::path> matrices,
                                    const std::vector<EvaluatedFiles>& evaluated) {
  std::vector<MethodScores> scores;
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    const EvaluatedFiles& one = evaluated[i];
    scores.push_back(
        method_scores(method_name(matrices[i], one.data), matrices[i].string(), one.data.task, one.evaluation));
  }
  return scores;
}

void add_scores(const Column& column, const std::vector<EvaluatedFiles>& evaluated, ProtocolAudit& audit) {
  for (std::size_t i = 0; i < column.scores.size(); ++i) {
    AuditedScore score{.evaluator = column.evaluator,
                       .quantity = column.scores[i].quantity,
                       .measure = column.scores[i].measure,
                       .values = Eigen::VectorXd(std::ssize(evaluated))};
    for (std::size_t method = 0; method < evaluated.size(); ++method) {
      score.values[static_cast<Eigen::Index>(method)] =
          evaluated[method].evaluation.micro[static_cast<Eigen::Index>(i)];
    }
    score.ranks = ranks_of_scores(score.values);
    audit.scores.push_back(std::move(score));
  }
}

std::vector<const AuditedScore*> scores_of_quantity(const ProtocolAudit& audit, const std::string& quantity) {
  std::vector<const AuditedScore*> scores;
  for (const AuditedScore& score : audit.scores) {
    if (score.quantity == quantity) scores.push_back(&score);
  }
  return scores;
}

// Kendall's tau-b of two scores: 1 for the same ranking, -1 for the reverse.
double rank_correlation(const AuditedScore& a, const AuditedScore& b) {
  double agreement = 0;
  double untied_a = 0;
  double untied_b = 0;
  for (std::size_t i = 0; i < a.ranks.size(); ++i) {
    for (std::size_t j = i + 1; j < a.ranks.size(); ++j) {
      const auto sign = [&](const AuditedScore& score) {
        return score.ranks[i] < score.ranks[j] ? 1 : score.ranks[i] > score.ranks[j] ? -1 : 0;
      };
      agreement += sign(a) * sign(b);
      untied_a += std::abs(sign(a));
      untied_b += std::abs(sign(b));
    }
  }
  return untied_a > 0 && untied_b > 0 ? agreement / std::sqrt(untied_a * untied_b) : 1;
}

std::string heading(const AuditedScore& score) {
  return score.measure == score.quantity ? score.evaluator : fmt::format("{} {}", score.evaluator, score.measure);
}

bool are_equal(const AuditedScore& a, const AuditedScore& b) { return score_differences(a.values, b.values).isZero(0); }

// Scores of evaluators that are equal for all methods.
struct SharedColumn {
  std::string heading;
  const AuditedScore* score = nullptr;
};

// Returns the columns that differ from the first score.
std::vector<SharedColumn> differing_columns(const std::vector<const AuditedScore*>& scores) {
  std::vector<SharedColumn> columns;
  for (const AuditedScore* score : scores) {
    if (are_equal(*score, *scores.front())) continue;
    const auto same =
        std::ranges::find_if(columns, [&](const auto& column) { return are_equal(*score, *column.score); });
    if (same == columns.end()) {
      columns.push_back({heading(*score), score});
    } else {
      same->heading += ", " + heading(*score);
    }
  }
  return columns;
}

std::size_t index_of_baseline(const ProtocolAudit& audit, const std::string& quantity) {
  const auto found = std::ranges::find(audit.scores, quantity, &AuditedScore::quantity);
  return static_cast<std::size_t>(found - audit.scores.begin());
}

}  // namespace

ProtocolAudit audit_protocols(std::span<const std::filesystem::path> matrices, const EvaluationFiles& files,
                              const StandingOptions& standings, const AuditProgress& progress) {
  ProtocolAudit audit;
  const std::vector<Column> columns = columns_of_audit();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (progress) progress(columns[i].evaluator, i, columns.size());
    const auto evaluated = evaluate_all(matrices, files, columns[i], audit);
    if (!evaluated) continue;
    if (i == 0) {
      std::vector<FileWarning> warnings;
      for (std::size_t method = 0; method < matrices.size(); ++method) {
        for (const std::string& text : (*evaluated)[method].warnings) {
          warnings.push_back({matrices[method].string(), text});
        }
      }
      audit.warnings = merged_warnings(warnings, "files");
      const AlignedMethods aligned = align_methods(scores_of(matrices, *evaluated), {});
      audit.methods = aligned.methods;
      for (const EvaluatedFiles& one : *evaluated) audit.queries_with_ties.push_back(one.evaluation.queries_with_ties);
      for (const Eigen::MatrixXd& values : aligned.values) {
        audit.standings.push_back(standings_of(values, aligned.classes, standings));
      }
    }
    add_scores(columns[i], *evaluated, audit);
  }
  return audit;
}

std::vector<std::string> audited_quantities(const ProtocolAudit& audit) {
  std::vector<std::string> quantities;
  for (const AuditedScore& score : audit.scores) {
    if (score.evaluator == baseline) quantities.push_back(score.quantity);
  }
  std::erase_if(quantities,
                [&](const std::string& quantity) { return scores_of_quantity(audit, quantity).size() < 2; });
  return quantities;
}

TextTable audit_table(const ProtocolAudit& audit, const std::string& quantity, const ScoreStyle& style) {
  const std::vector<const AuditedScore*> scores = scores_of_quantity(audit, quantity);
  const std::vector<MethodStanding>& standings = audit.standings[index_of_baseline(audit, quantity)];
  const std::vector<SharedColumn> columns = differing_columns(scores);
  TextTable table{.header = {"method", "tied", baseline, "low", "high", "ranks"}, .rows = {}};
  for (const SharedColumn& column : columns) {
    table.header.push_back(column.heading);
    table.header.emplace_back("rank");
  }
  for (const std::vector<std::size_t>& group : groups_of_equal_scores(scores.front()->values)) {
    for (const std::size_t method : group) {
      const MethodStanding& standing = standings[method];
      const auto value = [&](const AuditedScore& score) { return score.values[static_cast<Eigen::Index>(method)]; };
      std::vector<std::string> row{audit.methods[method],
                                   fmt::format("{}", audit.queries_with_ties[method]),
                                   score_text(value(*scores.front()), style),
                                   standing.interval ? score_text(standing.interval->low, style) : "",
                                   standing.interval ? score_text(standing.interval->high, style) : "",
                                   fmt::format("{} ({}-{})", standing.rank, standing.best_rank, standing.worst_rank)};
      for (const SharedColumn& column : columns) {
        row.push_back(score_text(value(*column.score), style));
        row.push_back(fmt::format("{}", column.score->ranks[method]));
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

TextTable audit_summary(const ProtocolAudit& audit, const ScoreStyle& style) {
  TextTable table{
      .header = {"score", "evaluator", "definition", "minimum change", "maximum change", "other ranks", "tau"},
      .text_columns = 3};
  for (const std::string& quantity : audited_quantities(audit)) {
    const std::vector<const AuditedScore*> scores = scores_of_quantity(audit, quantity);
    for (std::size_t k = 1; k < scores.size(); ++k) {
      const Eigen::VectorXd change = score_differences(scores[k]->values, scores.front()->values);
      std::size_t moved = 0;
      for (std::size_t method = 0; method < audit.methods.size(); ++method) {
        if (scores[k]->ranks[method] != scores.front()->ranks[method]) ++moved;
      }
      table.rows.push_back({quantity, scores[k]->evaluator, scores[k]->measure, score_text(change.minCoeff(), style),
                            score_text(change.maxCoeff(), style), fmt::format("{}", moved),
                            decimal_text(rank_correlation(*scores.front(), *scores[k]), 3)});
    }
  }
  return table;
}

TextTable audit_csv_table(const ProtocolAudit& audit) {
  TextTable table{.header = {"score", "evaluator", "definition", "method", "value", "rank", "low", "high", "best_rank",
                             "worst_rank"},
                  .rows = {},
                  .text_columns = 4};
  for (std::size_t i = 0; i < audit.scores.size(); ++i) {
    const AuditedScore& score = audit.scores[i];
    for (std::size_t method = 0; method < audit.methods.size(); ++method) {
      std::vector<std::string> row{score.quantity,
                                   score.evaluator,
                                   score.measure,
                                   audit.methods[method],
                                   score_text(score.values[static_cast<Eigen::Index>(method)], csv_style),
                                   fmt::format("{}", score.ranks[method])};
      if (i < audit.standings.size()) {
        const auto& [average, interval, rank, best_rank, worst_rank, letters] = audit.standings[i][method];
        row.push_back(interval ? score_text(interval->low, csv_style) : "");
        row.push_back(interval ? score_text(interval->high, csv_style) : "");
        row.push_back(fmt::format("{}", best_rank));
        row.push_back(fmt::format("{}", worst_rank));
      }
      row.resize(table.header.size());
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

nlohmann::ordered_json audit_json(const ProtocolAudit& audit) {
  nlohmann::ordered_json json{{"methods", audit.methods},
                              {"queries_with_ties", audit.queries_with_ties},
                              {"scores", nlohmann::ordered_json::array()}};
  for (std::size_t i = 0; i < audit.scores.size(); ++i) {
    const AuditedScore& score = audit.scores[i];
    json["scores"].push_back({{"score", score.quantity},
                              {"evaluator", score.evaluator},
                              {"definition", score.measure},
                              {"values", std::vector<double>(score.values.begin(), score.values.end())},
                              {"ranks", score.ranks}});
    if (i >= audit.standings.size()) continue;
    for (const MethodStanding& standing : audit.standings[i]) {
      if (standing.interval) {
        json["scores"].back()["intervals"].push_back({standing.interval->low, standing.interval->high});
      }
      json["scores"].back()["possible_ranks"].push_back({standing.best_rank, standing.worst_rank});
    }
  }
  return json;
}

}  // namespace shapegauge
