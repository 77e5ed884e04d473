#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/metrics/distance_table.h"
#include "shapegauge/metrics/precision_recall.h"
#include "shapegauge/metrics/protocol.h"

namespace shapegauge {

/// Settings of an evaluation.
struct EvaluationOptions {
  Protocol protocol = Protocol::psb;
  int minimum_class_size = 2;  ///< models of smaller classes are never queries (psbTable: 3); at least 2
};

/// What a distance matrix is worth under one protocol. Fractions from 0 to 1. Column j of every table is measures[j].
struct Evaluation {
  Protocol protocol = Protocol::psb;
  std::vector<std::string> measures;  ///< "NN", "FT", "ST", "E", "DCG", "mAP"
  std::vector<Eigen::Index> queries;  ///< row of the matrix of each query
  Eigen::MatrixXd per_query;          ///< queries x measures
  std::vector<int> classes;           ///< labels that have queries, ascending
  Eigen::MatrixXd per_class;          ///< classes x measures
  Eigen::VectorXd micro;              ///< mean over queries
  Eigen::VectorXd macro;              ///< mean over classes
  PrecisionRecallCurve micro_curve;
  PrecisionRecallCurve macro_curve;
  Eigen::Index models_left_out = 0;  ///< models that are no queries because their class is too small
};

/// Evaluates a distance matrix against the models' classes (the design, section 4). labels[i] is the class of model i.
/// Distances need not be symmetric and may be infinite, the diagonal plays no part. Models that are no queries stay in
/// the others' lists. Parallel over queries, the same bytes for any number of threads. Throws std::invalid_argument:
/// matrix empty, not square or of another size than labels, a distance that is NaN (naming row and column, counted from
/// 0), a minimum class size below 2, no class large enough.
Evaluation evaluate(const DistanceTable& distances, std::span<const int> labels, const EvaluationOptions& options);

}  // namespace shapegauge
