#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace shapegauge {

/// Changes one value of a document as `--set` says it: `dotted.key=value`, where a key of an array is an index
/// (`signatures.0.histogram.bins=40`). The value is JSON where it parses as JSON, else a string. Objects that are
/// absent on the way are made. Throws InputError for an assignment without key or `=`, an index beyond the array, a key
/// that leads into something that is neither object nor array, bytes that are not UTF-8, or a value in JSON that
/// parse_json would refuse.
void apply_override(nlohmann::json& document, std::string_view assignment);

}  // namespace shapegauge
