// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/retrieval/diffusion.h"

namespace shapegauge {

/// Method of a search: a signature of a configuration with everything that it depends on.
struct SearchMethod {
  std::string name;                ///< of the signature
  Configuration configuration;     ///< its preparation and the compared signatures; the rest is ignored
  std::vector<std::size_t> terms;  ///< indices of the compared signatures: one, or the terms of a sum
  SumSettings sum;                 ///< of the terms
  DiffusionOptions diffusion;      ///< for re-ranked answers

  /// Returns a key of the method and the program; an index with another key cannot be used.
  [[nodiscard]] std::string key() const;
};

/// Makes the search method of a retrieval experiment's configuration. `signature` is its name; if empty, the last
/// suitable one. Diffusion has the settings of the signature that re-ranks it, if any. Settings of the data set,
/// perturbations, evaluation and report are ignored. Throws InputError for an unknown signature, and for one that is
/// neither computed from each shape nor a sum of such.
SearchMethod search_method(nlohmann::json configuration, const std::string& source, const std::string& signature = {});

/// Reads the method of a file with overrides of `--set` (apply_override()). Throws InputError as search_method() does.
SearchMethod read_search_method(const std::filesystem::path& file, std::span<const std::string> overrides = {},
                                const std::string& signature = {});

/// Recommended methods: for any collection, and for one where poses do not count.
enum class RecommendedMethod { any, articulated };

/// Returns the file name of the method's configuration in configs/.
std::string recommended_file(RecommendedMethod method);

/// Returns the text of that file.
std::string_view recommended_configuration(RecommendedMethod method);

SearchMethod recommended_search_method(RecommendedMethod method = RecommendedMethod::any);

}  // namespace shapegauge
