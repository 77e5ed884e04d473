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
#include "shapegauge/experiments/configuration/document_paths.h"

namespace shapegauge {

/// Reads the configuration file of a retrieval experiment, applies the overrides (apply_overrides()), and validates
/// everything that does not depend on the data: the schema, unique names, existing and acyclic parts of `concatenate`,
/// consistent settings. Paths are relative to the file's folder, with `${VARIABLE}` expanded. Throws InputError with
/// the file, the path to the value, the fault and the nearest valid word.
Configuration read_configuration(const std::filesystem::path& path, std::span<const std::string> overrides = {});

/// Reads the file and applies the overrides: the document that read_configuration() validates.
nlohmann::json read_retrieval_document(const std::filesystem::path& path, std::span<const std::string> overrides = {});

/// Relative paths in the documents of retrieval experiments.
const DocumentPaths& retrieval_paths();

/// Applies overrides of `--set` (apply_override()) to a document. First replaces data sets given by a file by its
/// contents, which overrides can then change. `paths_of` returns the relative paths of the document. They are relative
/// to `folder`, in an override to the working directory, and a "classification" to the root of its data set. Returns
/// the files of data sets.
std::vector<std::filesystem::path> apply_overrides(nlohmann::json& document, const std::string& source,
                                                   const std::filesystem::path& folder,
                                                   std::span<const std::string> overrides,
                                                   const PathsOfDocument& paths_of);

/// Reads a retrieval experiment from a document. `source` is its name in messages; relative paths are relative to
/// `folder`.
Configuration configuration_from_json(const nlohmann::json& document, const std::string& source,
                                      const std::filesystem::path& folder);

/// Sections that several kinds of experiments share, after validation by the schema.
/// @{

/// Returns the names of the entries of a list with that key. Throws ConfigurationError for a repeated one.
std::vector<std::string> unique_names(const nlohmann::json& entries, std::string_view list);

/// Returns the index of a name. If there is none, throws ConfigurationError at the path, with the nearest name.
std::size_t index_of_name(const std::string& name, const std::vector<std::string>& names, std::string_view noun,
                          const std::string& path);

/// Reads a configuration's "signatures". Throws ConfigurationError for a repeated name, unknown or cyclic parts of
/// `concatenate`, and settings that contradict each other.
std::vector<SignatureConfiguration> read_signatures(const nlohmann::json& settings);

/// Reads the settings that experiments on shapes share.
void read_shared_settings(const nlohmann::json& document, ExperimentSettings& settings);

/// Reads the generator's options from a configuration's "dataset". Throws ConfigurationError for other settings next to
/// them.
GeneratorOptions read_generator(const nlohmann::json& dataset);

/// Reads the location of a data set on disk from a configuration's "dataset". Relative paths are relative to the
/// folder. Throws ConfigurationError for settings that the layout does not have.
DatasetLocation read_location(const nlohmann::json& dataset, const std::filesystem::path& folder);

/// @}

}  // namespace shapegauge
