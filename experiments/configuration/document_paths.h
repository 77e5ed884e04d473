// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace shapegauge {

/// Relative paths in the documents of a kind of experiment, as patterns of JSON pointers. `*` matches every index of an
/// array: "/shapes/*/file".
struct DocumentPaths {
  std::vector<std::string> files = {};     ///< paths of files and folders
  std::vector<std::string> datasets = {};  ///< data sets: objects with a "root", or files of them
};

/// Returns the paths of a document, which depend on its kind.
using PathsOfDocument = std::function<DocumentPaths(const nlohmann::json& document)>;

/// Returns the positions in the document that match one of the patterns.
std::vector<nlohmann::json_pointer<std::string>> matching_places(const nlohmann::json& document,
                                                                 const std::vector<std::string>& patterns);

}  // namespace shapegauge
