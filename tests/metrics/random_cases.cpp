// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/metrics/random_cases.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

namespace shapegauge {
namespace {

// The smaller of two draws favours the first classes.
std::vector<int> random_labels(std::size_t models, std::mt19937& random) {
  std::uniform_int_distribution<int> draw(0, static_cast<int>(models / 2));
  std::vector<int> labels(models);
  for (int& label : labels) label = 7 * std::min(draw(random), draw(random)) - 3;
  labels.at(1) = labels.at(0);
  std::ranges::shuffle(labels, random);
  return labels;
}

EvaluationCase case_with_ties(std::size_t models, unsigned seed, Protocol protocol) {
  std::mt19937 random(seed);
  const auto count = static_cast<Eigen::Index>(models);
  std::uniform_int_distribution<int> values(0, std::uniform_int_distribution<int>(0, 30)(random));
  EvaluationCase result{naive::Matrix(count, count), random_labels(models, random), protocol};
  const bool symmetric = std::bernoulli_distribution(0.5)(random);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      const int value = values(random);
      result.distances(i, j) = value == 30 ? std::numeric_limits<double>::infinity() : value / 4.0;
      if (symmetric && j < i) result.distances(i, j) = result.distances(j, i);
    }
  }
  // Sometimes one query finds nothing.
  if (std::bernoulli_distribution(0.25)(random)) {
    const auto row = std::uniform_int_distribution<Eigen::Index>(0, count - 1)(random);
    result.distances.row(row).setConstant(std::numeric_limits<double>::infinity());
  }
  return result;
}

EvaluationCase case_without_ties(std::size_t models, unsigned seed, Protocol protocol) {
  std::mt19937 random(seed);
  const auto count = static_cast<Eigen::Index>(models);
  EvaluationCase result{naive::Matrix(count, count), random_labels(models, random), protocol};
  std::vector<double> values(models * models);
  std::iota(values.begin(), values.end(), 0.5);
  std::ranges::shuffle(values, random);
  result.distances = Eigen::Map<const naive::Matrix>(values.data(), count, count);
  return result;
}

rc::Gen<EvaluationCase> cases(EvaluationCase (*make)(std::size_t, unsigned, Protocol), std::size_t max_models) {
  return rc::gen::apply(make, rc::gen::inRange<std::size_t>(2, max_models + 1), rc::gen::arbitrary<unsigned>(),
                        rc::gen::element(Protocol::psb, Protocol::paper, Protocol::trec));
}

}  // namespace

rc::Gen<EvaluationCase> cases_with_ties(std::size_t max_models) { return cases(case_with_ties, max_models); }

rc::Gen<EvaluationCase> cases_without_ties() { return cases(case_without_ties, 60); }

}  // namespace shapegauge
