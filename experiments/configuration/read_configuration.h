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
/// the file, the path to the value, the fault and the most similar valid word.
Configuration read_configuration(const std::filesystem::path& path, std::span<const std::string> overrides = {});

/// Reads the configuration file of a retrieval experiment and applies the overrides (apply_overrides()). Returns the
/// document, which is not validated.
nlohmann::json read_retrieval_document(const std::filesystem::path& path, std::span<const std::string> overrides = {});

/// Returns the positions of relative paths in the configurations of retrieval experiments.
const DocumentPaths& retrieval_paths();

/// Applies overrides of the option `--set` (apply_override()) to a document, whose name in messages is `source`. First
/// replaces names of description files of data sets by the files' contents (read_dataset_files()), which overrides can
/// then change. `paths_of` returns the positions of paths in the document. Paths in the document are relative to
/// `folder`; those in an override are relative to the working directory and become absolute. Returns the paths of the
/// description files.
std::vector<std::filesystem::path> apply_overrides(nlohmann::json& document, const std::string& source,
                                                   const std::filesystem::path& folder,
                                                   std::span<const std::string> overrides,
                                                   const PathsOfDocument& paths_of);

/// Reads and validates a retrieval experiment from a document. `source` is its name in messages; relative paths are
/// relative to `folder`. Throws InputError as read_configuration() does.
Configuration configuration_from_json(const nlohmann::json& document, const std::string& source,
                                      const std::filesystem::path& folder);

/// Read sections of a configuration that several kinds of experiments share. The schema must have accepted them.
/// @{

/// Returns the value of "name" of each object in a JSON list. Throws ConfigurationError for a repeated name. `list` is
/// the key of the list in messages.
std::vector<std::string> unique_names(const nlohmann::json& entries, std::string_view list);

/// Returns the index of `name` in `names`. If it is absent, throws ConfigurationError at `path`, with the most similar
/// name; `noun` says what the names stand for, such as "signature".
std::size_t index_of_name(const std::string& name, const std::vector<std::string>& names, std::string_view noun,
                          const std::string& path);

/// Reads the list "signatures" of a configuration. Throws ConfigurationError for a repeated name, unknown or cyclic
/// parts of `concatenate`, and settings that contradict each other.
std::vector<SignatureConfiguration> read_signatures(const nlohmann::json& settings);

/// Reads the settings of ExperimentSettings from the root of a document into `settings`.
void read_shared_settings(const nlohmann::json& document, ExperimentSettings& settings);

/// Reads the options of the data-set generator from a configuration's "dataset". Throws ConfigurationError for settings
/// other than "generate".
GeneratorOptions read_generator(const nlohmann::json& dataset);

/// Reads the location of a data set on disk from a configuration's "dataset". Relative paths are relative to `folder`.
/// Throws ConfigurationError for settings that the layout does not have.
DatasetLocation read_location(const nlohmann::json& dataset, const std::filesystem::path& folder);

/// @}

}  // namespace shapegauge
