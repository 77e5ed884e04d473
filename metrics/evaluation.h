#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/metrics/protocol.h"

namespace shapegauge {

/// Settings of an evaluation.
struct EvaluationOptions {
  Protocol protocol = Protocol::psb;
  int minimum_class_size = 2;  ///< models of smaller classes are never queries (psbTable: 3)
};

/// Precision at fixed levels of recall, averaged over queries.
struct PrecisionRecallCurve {
  std::vector<double> recall;
  std::vector<double> precision;
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

/// Row-major square matrix of distances: entry (i, j) is the distance from query i to model j.
using DistanceTable = Eigen::Ref<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

/// Evaluates a distance matrix against the models' classes (the design, section 4). labels[i] is the class of model i.
/// Parallel over queries, the same bytes for any number of threads. Throws std::invalid_argument: matrix not square or
/// of another size than labels, a distance that is NaN, no class large enough.
Evaluation evaluate(const DistanceTable& distances, std::span<const int> labels, const EvaluationOptions& options);

}  // namespace shapegauge
