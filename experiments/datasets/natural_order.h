#pragma once

#include <string_view>

namespace shapegauge {

/// Whether a comes before b in natural order: runs of decimal digits compare by their value, so T2 comes before T10,
/// and all else byte by byte. Names that differ only in leading zeros come in byte order. A strict total order; usable
/// with std::ranges::sort.
bool natural_less(std::string_view a, std::string_view b);

}  // namespace shapegauge
