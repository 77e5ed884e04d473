#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace shapegauge {

/// Replaces data sets that a document names by the file that describes them, as in "dataset": "datasets/psb.json" or
/// in the list "datasets", by what the file holds: layout, root and the like, or "generate"; in the list with the
/// file's "name", or its stem. Files are relative to `folder`, their roots to the file. Throws InputError for a file
/// that cannot be read or is no such description; the message begins with `source`.
void read_dataset_files(nlohmann::json& document, const std::string& source, const std::filesystem::path& folder);

}  // namespace shapegauge
