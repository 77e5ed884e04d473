// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace shapegauge {

/// Replaces data sets given by a description file, as in "dataset": "datasets/psb.json" or in the list "datasets", by
/// the contents of the file: layout, root and the like, or "generate". `datasets` are the patterns of their places
/// (DocumentPaths::datasets). In a list, adds the file's "name" or its stem. Files are relative to `folder`, their
/// roots to the file. Returns the files. Throws InputError for a file that cannot be read or is not a description;
/// `source` prefixes the message.
std::vector<std::filesystem::path> read_dataset_files(nlohmann::json& document, const std::string& source,
                                                      const std::filesystem::path& folder,
                                                      const std::vector<std::string>& datasets);

}  // namespace shapegauge
