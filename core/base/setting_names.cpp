#include "shapegauge/core/base/setting_names.h"

#include <algorithm>
#include <fmt/format.h>

namespace shapegauge {

std::string setting_name(Audience audience, std::string_view name) {
  if (audience == Audience::python) return std::string(name);
  std::string option = fmt::format("--{}", name);
  std::ranges::replace(option, '_', '-');
  return option;
}

std::string setting_with_word(Audience audience, std::string_view name, std::string_view word) {
  const bool python = audience == Audience::python;
  return fmt::format("{}{}", setting_name(audience, name),
                     python ? fmt::format("='{}'", word) : fmt::format(" {}", word));
}

std::string setting_with_number(Audience audience, std::string_view name, double number) {
  return fmt::format("{}{}{:.2g}", setting_name(audience, name), audience == Audience::python ? '=' : ' ', number);
}

std::string setting_on(Audience audience, std::string_view name) {
  return setting_name(audience, name) + (audience == Audience::python ? "=True" : "");
}

}  // namespace shapegauge
