// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

namespace shapegauge {

/// Scores of two equally good methods on a random data set, with a random difficulty of each class per method
/// and noise per query.
struct SimulatedMethods {
  Eigen::MatrixXd per_query;  ///< queries x 2
  std::vector<int> classes;
};

/// Classes of `queries_per_class` queries each; the expected score is 0.6 for both methods.
inline SimulatedMethods simulated_methods(int classes, int queries_per_class, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> of_class(0.6, 0.1);
  std::normal_distribution<double> of_query(0.0, 0.1);
  SimulatedMethods simulated;
  simulated.per_query.resize(Eigen::Index{classes} * queries_per_class, 2);
  for (int label = 0; label < classes; ++label) {
    for (int method = 0; method < 2; ++method) {
      const double difficulty = of_class(random);
      for (int i = 0; i < queries_per_class; ++i) {
        simulated.per_query(Eigen::Index{label} * queries_per_class + i, method) = difficulty + of_query(random);
      }
    }
    simulated.classes.insert(simulated.classes.end(), static_cast<std::size_t>(queries_per_class), label);
  }
  return simulated;
}

}  // namespace shapegauge
