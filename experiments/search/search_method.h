#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/retrieval/diffusion.h"
#include "shapegauge/retrieval/fusion.h"

namespace shapegauge {

/// How a search compares shapes: a signature of a configuration, and what it is made from.
struct SearchMethod {
  std::string name;                ///< of the signature
  Configuration configuration;     ///< its preparation, and the signatures that are compared; nothing else counts
  std::vector<std::size_t> terms;  ///< the compared signatures, by index; one, or the terms of a sum
  std::vector<double> weights;     ///< by term, as they are given
  SumWeights weight_kind = SumWeights::given;
  DistanceScale scale = DistanceScale::none;
  DiffusionOptions diffusion;  ///< with which answers are re-ranked

  /// Identifies the method and the program: an index of another key cannot be used.
  [[nodiscard]] std::string key() const;
};

/// The method of a configuration of a retrieval experiment. `signature`: its name; empty: the last one that a
/// search can compare by. Diffusion has the settings of the signature that re-ranks it, where there is one. What the
/// configuration says of a data set, perturbations, evaluation and report does not count. Throws InputError where there
/// is no such signature, and for one that is neither computed from each shape nor a sum of such.
SearchMethod search_method(nlohmann::json configuration, const std::string& source, const std::string& signature = {});

/// The method of a file, changed as `--set` says it (apply_override()). Throws InputError as above.
SearchMethod read_search_method(const std::filesystem::path& file, std::span<const std::string> overrides = {},
                                const std::string& signature = {});

/// The method of configs/recommended.json.
SearchMethod recommended_search_method();

}  // namespace shapegauge
