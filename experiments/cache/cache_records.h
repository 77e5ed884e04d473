#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/runner/describe_model.h"
#include "shapegauge/retrieval/distance_matrix.h"

/// What the entries of the cache hold, as JSON with the numbers of arrays as binary values. Read back, everything is
/// the same bit by bit. The functions that read throw nlohmann::json::exception where a record is not of that form.
namespace shapegauge {

/// The numbers of an array.
nlohmann::json numbers_record(const Eigen::VectorXd& numbers);
Eigen::VectorXd read_numbers(const nlohmann::json& record);

/// What is known of a model without its fields.
nlohmann::json shape_record(const ModelDescription& model);
ModelDescription read_shape_record(const nlohmann::json& record);

/// A field on a model with its values, in double precision as the histograms want them.
struct CachedField {
  FieldDescription facts;  ///< without values
  Eigen::VectorXd values;
};
nlohmann::json field_record(const CachedField& field);
CachedField read_field_record(const nlohmann::json& record);

/// A histogram with what is known of its field, whose values need not be read then.
struct CachedHistogram {
  FieldDescription facts;  ///< without values
  Eigen::VectorXf bins;
};
nlohmann::json histogram_record(const CachedHistogram& histogram);
CachedHistogram read_histogram_record(const nlohmann::json& record);

/// A distance matrix.
nlohmann::json distances_record(const DistanceMatrix& distances);
DistanceMatrix read_distances(const nlohmann::json& record);

}  // namespace shapegauge
