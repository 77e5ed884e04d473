#pragma once

#include <array>
#include <string_view>

#include "shapegauge/core/base/words.h"

namespace shapegauge {

/// Surface on which a field or descriptor is computed: the shape's own mesh, or its surface proxy (ProxySource).
enum class FieldSurface { mesh, proxy };

template <>
inline constexpr std::array<std::string_view, 2> words_of<FieldSurface>{"mesh", "proxy"};

}  // namespace shapegauge
