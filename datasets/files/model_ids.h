#pragma once

#include <filesystem>
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

/// Returns the shortest distinguishing suffixes of paths, without extensions if possible: "x" and "y" for a/x.off and
/// b/y.off, "x.off" and "x.obj" for a/x.off and b/x.obj. Equal paths have equal suffixes.
std::vector<std::string> distinguishing_ends(const std::vector<std::filesystem::path>& paths);

}  // namespace shapegauge
