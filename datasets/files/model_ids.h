#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// Whether a comes before b in natural order: runs of decimal digits compare by their value, so T2 comes before T10,
/// and all else byte by byte. Names that differ only in leading zeros come in byte order. A strict total order; usable
/// with std::ranges::sort.
bool natural_less(std::string_view a, std::string_view b);

/// The one form of a model's id, by which ids from different files are compared: the extension of a shape file
/// (without_shape_extension()) and a `T` before a whole number are dropped, so that `12`, `T12` and `T12.off` are all
/// "12". Other ids stay as they are.
std::string canonical_model_id(std::string_view id);

/// The shortest ends of paths that distinguish them, without extensions where these are not needed: "x" and "y" for
/// a/x.off and b/y.off, "x.off" and "x.obj" for a/x.off and b/x.obj. Equal paths have equal ends.
std::vector<std::string> distinguishing_ends(const std::vector<std::filesystem::path>& paths);

}  // namespace shapegauge
