#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/configuration/segmentation_experiment.h"
#include "shapegauge/experiments/signatures/describe_model.h"
#include "shapegauge/experiments/signatures/model_picture.h"
#include "shapegauge/experiments/signatures/model_view.h"
#include "shapegauge/retrieval/distance_matrix.h"

/// Keys of the cache: SHA-256 of all that a result depends on, which is the keys of what it is made of, the parameters
/// of the step, the version of its algorithm, and the program that computes it: its release, compiler, libraries and
/// kind of processor, with another of which the last bits may differ.

/// What the entries of the cache hold, as JSON with the numbers of arrays as binary values. Read back, everything is
/// the same bit by bit. The functions that read throw nlohmann::json::exception where a record is not of that form.

namespace shapegauge {

/// What the prepared shape of a model depends on besides the configuration.
struct ModelSource {
  std::string_view sha256;     ///< of the file's bytes
  std::filesystem::path file;  ///< its extension tells the format
  std::string_view id;         ///< matters to perturbations only
  std::size_t index = 0;       ///< in the data set; so does this
};

/// Of a model's shape, perturbed and prepared. Where it is, and without perturbations its id, do not matter.
std::string shape_key(const ModelSource& source, const Configuration& configuration);

/// Of the samples of that shape.
std::string samples_key(const std::string& shape, const SamplePlan& plan);

/// Of a field on that shape.
std::string field_key(const std::string& shape, const Field& field);

/// Of a histogram of that field over a range that depends on no other shape.
std::string histogram_key(const std::string& field, const HistogramConfiguration& histogram);

/// Of the features of a descriptor on that shape. `fields`: the keys of its fields there; `learnt`: that of what it has
/// learnt, empty where it has not.
std::string features_key(const std::string& shape, const DescriptorChoice& choice,
                         const std::vector<std::string>& fields, const std::string& learnt);

/// Of what a descriptor learns from all shapes of a data set. `fields`: the keys of its fields on each of them.
std::string learnt_key(const DescriptorChoice& choice, const std::vector<std::vector<std::string>>& fields);

/// Of the picture of a shape that is coloured by that field.
std::string picture_key(const std::string& field, const PictureOptions& options);

/// Of the view of a shape with those fields, of at most so many faces.
std::string view_key(const std::vector<std::string>& fields, Eigen::Index faces);

/// Of the distance matrix of the signatures. `distance`: its name.
std::string distances_key(const Signatures& signatures, const std::string& distance);

/// The name, with its version, by which distances_key() knows a descriptor's own distance.
std::string distance_of(const Descriptor& descriptor);

/// Of the parts of a shape by a method; `versions` are those of its algorithms, `seed` that of its perturbations.
std::string segmentation_key(const ModelSource& source, const SegmentationMethod& method,
                             const nlohmann::json& versions, std::uint64_t seed);

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

/// What one process tells another of a model: all but values, histograms and features.
/// @{
std::string described_bytes(const ModelDescription& model);
ModelDescription read_described(std::string_view bytes);
/// @}

/// The features of a descriptor.
nlohmann::json features_record(const FeatureDescription& features);
FeatureDescription read_features(const nlohmann::json& record);

/// What a descriptor has learnt.
nlohmann::json learnt_record(const LearntFeatures& learnt);
LearntFeatures read_learnt(const nlohmann::json& record);

/// A picture: the bytes of its file.
nlohmann::json picture_record(std::string_view png);
std::string read_picture(const nlohmann::json& record);

/// A view: its text.
nlohmann::json view_record(const std::string& view);
std::string read_view(const nlohmann::json& record);

/// A distance matrix.
nlohmann::json distances_record(const DistanceMatrix& distances);
DistanceMatrix read_distances(const nlohmann::json& record);

}  // namespace shapegauge
