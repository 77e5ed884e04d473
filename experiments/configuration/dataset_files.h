#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace shapegauge {

/// Replaces data sets given by a description file, as in "dataset": "datasets/psb.json" or in the list "datasets", by
/// the contents of the file: layout, root and the like, or "generate". In the list, adds the file's "name" or its stem.
/// Files are relative to `folder`, their roots to the file. Throws InputError for a file that cannot be read or is not
/// a description; `source` prefixes the message.
void read_dataset_files(nlohmann::json& document, const std::string& source, const std::filesystem::path& folder);

}  // namespace shapegauge
