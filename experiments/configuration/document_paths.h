// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace shapegauge {

/// Positions of relative paths in the documents of one kind of experiment, as patterns of JSON pointers. `*` matches
/// every index of an array: "/shapes/*/file".
struct DocumentPaths {
  std::vector<std::string> files = {};     ///< positions of the paths of files and folders
  std::vector<std::string> datasets = {};  ///< positions of data sets, each an object or the name of a description file
};

/// Function that returns the DocumentPaths of a document, which depend on its kind of experiment.
using PathsOfDocument = std::function<DocumentPaths(const nlohmann::json& document)>;

/// Returns the JSON pointers to all values of the document that match one of the patterns.
std::vector<nlohmann::json_pointer<std::string>> matching_pointers(const nlohmann::json& document,
                                                                   const std::vector<std::string>& patterns);

}  // namespace shapegauge
