// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "shapegauge/core/base/registry.h"
#include "shapegauge/experiments/configuration/document_paths.h"
#include "shapegauge/experiments/engine/experiment.h"

namespace shapegauge {

/// Returns the registry of kinds of experiments: those of the library, followed by those added. Each kind must
/// have `keys`, `schema` and `read`; its patterns of paths begin with a slash, and its schema has no definitions.
Registry<ExperimentKind>& experiment_kinds();

/// Reads an experiment from a document: replaces names of description files of data sets by their contents
/// (read_dataset_files()), validates the document by the schema of its kind, and reads it. If no kind recognises the
/// document, the first kind reports what is missing. Throws InputError for a document of several kinds, and the errors
/// of these steps.
Experiment read_experiment(const nlohmann::json& document, const std::string& source,
                           const std::filesystem::path& folder);

/// Returns the positions of relative paths in a document, by its kind of experiment (ExperimentKind::paths). Uses
/// the first kind that recognises the document or, if none does, the first kind of the registry.
DocumentPaths experiment_paths(const nlohmann::json& document);

/// Returns the JSON Schema (draft 7) of configurations of all kinds. configs/experiment.schema.json is this text, for
/// editors.
std::string experiment_schema();

}  // namespace shapegauge
