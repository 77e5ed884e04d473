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

/// Method that ranks shapes in a search: one signature of a configuration, with the settings of everything that it
/// depends on.
struct SearchMethod {
  std::string name;                ///< name of the signature
  Configuration configuration;     ///< preparation and compared signatures; other settings are ignored
  std::vector<std::size_t> terms;  ///< indices in configuration.signatures of the compared ones: one, or those summed
  SumSettings sum;                 ///< settings of the sum of the distances of all `terms`
  DiffusionOptions diffusion;      ///< options of the diffusion that re-ranks answers

  /// Returns a key that identifies the settings and the program; an index with another key cannot be used.
  [[nodiscard]] std::string key() const;
};

/// Makes the search method of a retrieval experiment's configuration. `signature` is the name of the signature to
/// compare; if empty, the last suitable one is used. Diffusion has the settings of the signature that re-ranks it, if
/// any. Settings of the data set, perturbations, evaluation and report are ignored. Throws InputError for an unknown
/// signature, and for one that is neither computed from each shape nor a sum of signatures that are.
SearchMethod search_method(nlohmann::json configuration, const std::string& source, const std::string& signature = {});

/// Reads a search method from a configuration file with overrides of the option `--set` (apply_override()). Throws
/// InputError as search_method() does.
SearchMethod read_search_method(const std::filesystem::path& file, std::span<const std::string> overrides = {},
                                const std::string& signature = {});

/// Recommended search methods: for any collection, and for articulated shapes, whose poses are ignored.
enum class RecommendedMethod { any, articulated };

/// Returns the name of the configuration file of a recommended search method in configs/.
std::string recommended_file(RecommendedMethod method);

/// Returns the text of the configuration file of a recommended search method.
std::string_view recommended_configuration(RecommendedMethod method);

/// Returns a recommended search method, as its configuration file defines it.
SearchMethod recommended_search_method(RecommendedMethod method = RecommendedMethod::any);

}  // namespace shapegauge
