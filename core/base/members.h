// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tuple>

/// Defines members(), which returns a tuple of references to all members of a structure, for codecs
/// (experiments/cache/codec.h). All members are listed in order; if one is missing, the code does not
/// compile:
///
///     SHAPEGAUGE_MEMBERS(Interval, low, high)
#define SHAPEGAUGE_MEMBERS(Structure, ...) \
  inline auto members(Structure& whole) {  \
    auto& [__VA_ARGS__] = whole;           \
    return std::tie(__VA_ARGS__);          \
  }
