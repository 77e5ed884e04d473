#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/fields/field.h"
#include "shapegauge/experiments/fields/sample_plan.h"
#include "shapegauge/retrieval/distance_matrix.h"

/// Keys of the cache: SHA-256 of all that a result depends on, which is the keys of what it is made of, the parameters
/// of the step, the version of its algorithm, and the program that computes it: its release, compiler, libraries and
/// kind of processor, with another of which the last bits may differ.
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

/// Of the distance matrix of the signatures.
std::string distances_key(const Signatures& signatures, const std::string& distance);

}  // namespace shapegauge
