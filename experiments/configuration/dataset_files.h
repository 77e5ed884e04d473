// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace shapegauge {

/// Replaces names of description files of data sets, as in "dataset": "datasets/psb.json" or in the list "datasets", by
/// the contents of the files: "layout" and "root", or "generate". `datasets` are the positions of data sets in the
/// document (DocumentPaths::datasets). In a list, a data set without "name" gets the stem of its file. File names are
/// relative to `folder`, roots to the description file. Returns the paths of the files. Throws InputError for a file
/// that cannot be read or is not a description; `source` prefixes the message.
std::vector<std::filesystem::path> read_dataset_files(nlohmann::json& document, const std::string& source,
                                                      const std::filesystem::path& folder,
                                                      const std::vector<std::string>& datasets);

}  // namespace shapegauge
