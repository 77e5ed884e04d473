// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// Returns true if a precedes b in natural order: runs of decimal digits compare by value (T2 before T10), all else by
/// bytes. Names that differ only in leading zeros are in byte order. A strict total order, for std::ranges::sort.
bool natural_less(std::string_view a, std::string_view b);

/// Returns the canonical form of a model's id, for comparing ids from different files: drops the extension of a shape
/// file (without_shape_extension()) and a `T` before a number. `12`, `T12` and `T12.off` are all "12". Other ids stay
/// unchanged.
std::string canonical_model_id(std::string_view id);

/// Keys for comparing model ids: ids of the same model have equal keys. The key is canonical_model_id(), but the whole
/// id if several known ids differ only in the extension of the shape file, such as m0.off and m0.obj.
class ModelKeys {
 public:
  ModelKeys() = default;
  explicit ModelKeys(const std::vector<std::string>& known_ids);  ///< keys for comparison with these ids

  /// Adds the ambiguous ids of other keys: such ids then keep their extensions in the key.
  void add(const ModelKeys& other) { ambiguous_.insert(other.ambiguous_.begin(), other.ambiguous_.end()); }

  [[nodiscard]] std::string of(std::string_view id) const;  ///< returns the key of an id

  bool operator==(const ModelKeys&) const = default;

 private:
  std::set<std::string, std::less<>> ambiguous_;  ///< canonical ids that several known models share
};

/// Returns the shortest distinguishing suffixes of paths, without extensions if possible: "x" and "y" for a/x.off and
/// b/y.off, "x.off" and "x.obj" for a/x.off and b/x.obj. Equal paths have equal suffixes.
std::vector<std::string> distinguishing_suffixes(const std::vector<std::filesystem::path>& paths);

}  // namespace shapegauge
