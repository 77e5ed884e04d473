#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/experiments/configuration/configuration.h"

namespace shapegauge {

/// Reads the configuration file of a retrieval experiment, applies the overrides (apply_overrides()), and checks
/// everything that can be checked without looking at the data: the schema, unique names, `concatenate` that points
/// somewhere and not to itself, settings that contradict each other. Paths are relative to the file's folder,
/// `${VARIABLE}` in them is expanded. Throws InputError with the file, the path to the value, what is wrong and the
/// nearest valid word.
Configuration read_configuration(const std::filesystem::path& path, std::span<const std::string> overrides = {});

/// The document that read_configuration checks: the file's, with the overrides applied.
nlohmann::json read_configuration_document(const std::filesystem::path& path,
                                           std::span<const std::string> overrides = {});

/// Applies overrides as `--set` says them (apply_override()) to a document that was read already. Data sets that the
/// document names by files are read first, so that overrides change what the files say. A relative path in the document
/// begins at `folder`, one in an override at the working directory, and a "classification" at the root of its data set.
void apply_overrides(nlohmann::json& document, const std::string& source, const std::filesystem::path& folder,
                     std::span<const std::string> overrides);

/// Whether the document is one of a comparison of shapes (comparison.h) and not of a retrieval experiment.
bool is_comparison(const nlohmann::json& document);

/// The same for a document that was read already. `source` is what messages call it; relative paths are relative to
/// `folder`.
Configuration configuration_from_json(const nlohmann::json& document, const std::string& source,
                                      const std::filesystem::path& folder);

/// Parts that retrieval experiments and comparisons share; the schema has accepted them.
/// @{

/// The signatures of a configuration's "signatures", which the schema has accepted. Throws ConfigurationError for two
/// of the same name, `concatenate` that points nowhere or to itself, and settings that contradict each other.
std::vector<SignatureConfiguration> read_signatures(const nlohmann::json& settings);

/// The options of a configuration's "preparation".
PreparationOptions read_preparation(const nlohmann::json& settings);

/// The shapes that a configuration's "dataset" has the program generate. Throws ConfigurationError for other settings
/// beside them.
GeneratorOptions read_generator(const nlohmann::json& dataset);

/// The place of a data set on disk, from a configuration's "dataset". Relative paths begin at the folder. Throws
/// ConfigurationError for settings that the layout does not have.
DatasetLocation read_location(const nlohmann::json& dataset, const std::filesystem::path& folder);

/// The setting "on_error" of an experiment.
OnError read_on_error(const nlohmann::json& experiment);

/// The setting "seed" of an experiment.
std::uint64_t read_seed(const nlohmann::json& experiment);

/// @}

}  // namespace shapegauge
