// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/evaluators.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace {

double number_of_relevant(const RankedList& list) { return static_cast<double>(list.relevant); }

double first_tier_plus_one(const RankedList& list) {
  return (hits_among_first(list, list.relevant) + 1) / number_of_relevant(list);
}

// 1 if all relevant models are before rank 2R: the program stops there.
double second_tier_plus_one(const RankedList& list) {
  if (hits_among_first(list, 2 * list.relevant - 1) == number_of_relevant(list)) return 1;
  return (hits_among_first(list, 2 * list.relevant) + 1) / (2 * number_of_relevant(list));
}

double average_precision_at_r(const RankedList& list) {
  return sum_of_precisions(list, list.relevant) / number_of_relevant(list);
}

constexpr std::size_t longest_contest_list = 1000;

double average_precision_of_found(const RankedList& list) {
  const std::size_t ranks = std::min(list.length, longest_contest_list);
  const double found = hits_among_first(list, ranks);
  return found > 0 ? sum_of_precisions(list, ranks) / found : 0;
}

double discount(std::size_t rank) { return rank == 1 ? 1.0 : 1.0 / std::log2(static_cast<double>(rank)); }

// The ideal list has the models that were found, the largest grades first.
double gain_of_found(const RankedList& list) {
  const std::size_t ranks = std::min(list.length, longest_contest_list);
  std::vector<double> grades;
  std::size_t rank = 0;
  for (const RankRun& run : list.runs) {
    const std::size_t considered = std::min(run.size, ranks - std::min(rank, ranks));
    const std::size_t hits = run.hits == run.size ? considered : std::min(run.hits, considered);
    grades.insert(grades.end(), hits, run.grade);
    rank += run.size;
  }
  std::ranges::sort(grades, std::greater<>());
  double ideal = 0;
  for (std::size_t i = 0; i < grades.size(); ++i) ideal += grades[i] * discount(i + 1);
  return ideal > 0 ? graded_gain_of_hits(list, discount, ranks) / ideal : 0;
}

// Definitions of programs that are no measures of the library.
std::span<const MeasureDefinition> definitions_of_programs() {
  static const std::array definitions{
      MeasureDefinition{.name = "shrec21.FT",
                        .definition = "(hits among the first R, plus 1) / R: above 1 for a perfect list.",
                        .value = first_tier_plus_one},
      MeasureDefinition{.name = "shrec21.ST",
                        .definition = "(hits among the first 2R, plus 1) / (2R); 1 if all relevant models are before "
                                      "rank 2R.",
                        .value = second_tier_plus_one},
      MeasureDefinition{.name = "shapenet16.mAP",
                        .definition = "The mean precision at the hits of the list: divided by their number, not by R.",
                        .value = average_precision_of_found},
      MeasureDefinition{.name = "shapenet16.nDCG",
                        .definition = "As nDCG@N, but divided by the gain of the best order of the models in the list.",
                        .value = gain_of_found},
      MeasureDefinition{.name = "pytorch_metric_learning.MAP@R",
                        .definition = "The sum of the precisions at the hits among the first R, divided by R.",
                        .value = average_precision_at_r}};
  return definitions;
}

Evaluator psb_table() {
  return {.name = "psb_table",
          .program = "psbTable of the Princeton Shape Benchmark",
          .deviations =
              "Classes of fewer than three models are no queries. Equal distances rank in the order of models. Sums "
              "are in single precision, and the logarithm is that of ten divided by 0.3010299957: the third decimal "
              "place that it prints may be rounded otherwise.",
          .protocol = Protocol::psb,
          .curve = CurveKind::psb,
          .minimum_class_size = 3,
          .scores = {{"NN", "NN"}, {"FT", "FT"}, {"ST", "ST"}, {"E", "E"}, {"DCG", "DCG"}}};
}

Evaluator shrec21() {
  return {.name = "shrec21",
          .program = "experiments.py of SHREC'21, retrieval of cultural heritage objects",
          .deviations =
              "Tiers count one hit too many: FT = (hits + 1) / R exceeds 1 for a perfect list. ST is a precision, "
              "(hits + 1) / (2R), but 1 if all relevant models are before rank 2R. Queries and targets are two sets.",
          .protocol = Protocol::psb,
          .curve = CurveKind::trec,
          .scores = {{"NN", "NN"}, {"FT", "shrec21.FT"}, {"ST", "shrec21.ST"}, {"mAP", "mAP"}, {"nDCG", "nDCG"}}};
}

Evaluator shapenet16() {
  return {
      .name = "shapenet16",
      .program = "evaluate.js of SHREC'16 on ShapeNetCore, of 1 March 2016",
      .deviations =
          "The query counts as a relevant model, found at the rank where its list has it, if it has. Lists end after "
          "1000 models. The average precision is divided by the number of hits in the list, and nDCG by the best order "
          "of the models in it, so that short lists score higher; the program of 2017 divides by all relevant models, "
          "as mAP@N and nDCG@N do. Queries without a list do not count. F1 and nDCG of a list without a hit are 0; the "
          "program prints NaN. Its curve, by rank, is not reproduced.",
      .protocol = Protocol::psb,
      .curve = CurveKind::trec,
      .finds_itself = true,
      .scores = {
          {"P@N", "P@N"}, {"R@N", "R@N"}, {"F1@N", "F1@N"}, {"mAP", "shapenet16.mAP"}, {"nDCG", "shapenet16.nDCG"}}};
}

Evaluator trec_eval() {
  return {.name = "trec_eval",
          .program = "trec_eval 10 of NIST",
          .deviations =
              "Equal scores of a run rank in descending order of document names, equal distances of a matrix in the "
              "order of models. Queries without a list do not count; judged queries without a relevant model do, with "
              "0. Precision is interpolated at recall levels that are rounded to the nearest number of documents: a "
              "level of 0.8 with R = 3 takes two documents; version 9 adds 0.9 and rounds down. Scores of a run are in "
              "double precision; releases of trec_eval with single precision have more ties.",
          .protocol = Protocol::trec,
          .curve = CurveKind::trec_eval,
          .minimum_class_size = 1,
          .scores = {{"mAP", "mAP"},
                     {"FT", "R-prec"},
                     {"P@10", "P@10"},
                     {"R@10", "R@10"},
                     {"MRR", "MRR"},
                     {"nDCG", "nDCG"},
                     {"bpref", "bpref"}}};
}

Evaluator pytorch_metric_learning() {
  return {
      .name = "pytorch_metric_learning",
      .program = "AccuracyCalculator of pytorch-metric-learning",
      .deviations =
          "precision_at_1, r_precision, mean_average_precision and mean_average_precision_at_r. The latter counts only "
          "hits among the first R. Queries without a relevant model do not count. Its order of equal distances is not "
          "defined; here it is that of the models.",
      .protocol = Protocol::psb,
      .curve = CurveKind::raw,
      .scores = {
          {"NN", "NN"}, {"FT", "R-prec"}, {"mAP", "pytorch_metric_learning.MAP@R"}, {"mAP", "mAP"}, {"MRR", "MRR"}}};
}

Measure measure_of_score(const EvaluatorScore& score) {
  const auto definitions = definitions_of_programs();
  const auto found = std::ranges::find(definitions, score.measure, &MeasureDefinition::name);
  return found == definitions.end() ? measure_of(score.measure) : Measure{.name = found->name, .definition = &*found};
}

}  // namespace

std::span<const Evaluator> evaluators() {
  static const std::vector<Evaluator> all{psb_table(), shrec21(), shapenet16(), trec_eval(), pytorch_metric_learning()};
  return all;
}

std::vector<std::string> evaluator_names() {
  std::vector<std::string> names;
  for (const Evaluator& evaluator : evaluators()) names.push_back(evaluator.name);
  return names;
}

EvaluationOptions options_of_evaluator(std::string_view name) {
  const auto found = std::ranges::find(evaluators(), name, &Evaluator::name);
  if (found == evaluators().end()) throw ArgumentError(unknown_word_message("evaluator", name, evaluator_names()));
  EvaluationOptions options{.protocol = found->protocol,
                            .ties = Ties::index,
                            .curve = found->curve,
                            .minimum_class_size = found->minimum_class_size,
                            .finds_itself = found->finds_itself};
  for (const EvaluatorScore& score : found->scores) options.measures.push_back(measure_of_score(score));
  return options;
}

}  // namespace shapegauge
