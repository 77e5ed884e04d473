#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace shapegauge {

/// What an entry of the cache holds.
enum class EntryKind {
  shape,      ///< what was found of a shape while it was prepared: diagnostics, scale, noise
  samples,    ///< the weights of a shape's samples
  field,      ///< the values of a field on a shape
  histogram,  ///< of one field on one shape
  distances,  ///< a distance matrix
};

inline constexpr std::size_t number_of_entry_kinds = 5;

/// The kinds' names, which are also the extensions of the entries' files.
inline constexpr std::array<std::string_view, number_of_entry_kinds> entry_kind_names{"shape", "samples", "field",
                                                                                      "histogram", "distances"};

constexpr std::string_view name_of(EntryKind kind) { return entry_kind_names.at(static_cast<std::size_t>(kind)); }

}  // namespace shapegauge
