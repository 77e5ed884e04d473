// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tuple>

/// Defines members(), which returns references to all members of a structure, for codecs (experiments/cache/codec.h).
/// Does not compile when the structure gets another member:
///
///     SHAPEGAUGE_MEMBERS(Interval, low, high)
#define SHAPEGAUGE_MEMBERS(Structure, ...) \
  inline auto members(Structure& whole) {  \
    auto& [__VA_ARGS__] = whole;           \
    return std::tie(__VA_ARGS__);          \
  }
