#include "shapegauge/experiments/configuration/expand_variables.h"

#include <cstdlib>
#include <fmt/format.h>

#include "shapegauge/core/error.h"

namespace shapegauge {

namespace {

std::string value_of_variable(const std::string& name) {
  const char* value = std::getenv(name.c_str());
  if (value == nullptr || *value == '\0') {
    throw InputError(fmt::format(
        "the environment variable {0} is not set; set it, for example with 'export {0}=/path/to/folder'", name));
  }
  return value;
}

}  // namespace

std::string expand_variables(std::string_view text) {
  std::string expanded;
  for (std::size_t begin = text.find("${"); begin != std::string_view::npos; begin = text.find("${")) {
    const std::size_t end = text.find('}', begin);
    if (end == std::string_view::npos) throw InputError(fmt::format("\"{}\" has a ${{ without its }}", text));
    expanded += text.substr(0, begin);
    expanded += value_of_variable(std::string(text.substr(begin + 2, end - begin - 2)));
    text.remove_prefix(end + 1);
  }
  return expanded.append(text);
}

}  // namespace shapegauge
