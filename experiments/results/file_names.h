#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// The name with everything but letters, digits, `.`, `-` and `_` of ASCII replaced by one `_` each run, none at the
/// ends, at most 100 characters; never empty, hidden, `.` or `..`. For "Our SDF (d = 1%)": "Our_SDF_d_1".
std::string file_safe_name(std::string_view name);

/// A file-safe name for each name, no two alike even where upper and lower case are one: later ones get _2, _3, ...
std::vector<std::string> file_safe_names(std::span<const std::string> names);

}  // namespace shapegauge
