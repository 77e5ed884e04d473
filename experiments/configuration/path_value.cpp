#include "shapegauge/experiments/configuration/path_value.h"

#include "shapegauge/experiments/configuration/expand_variables.h"
#include "shapegauge/experiments/configuration/misplaced_value.h"

namespace shapegauge {

std::filesystem::path path_value(const nlohmann::json& object, const std::string& key,
                                 const std::filesystem::path& folder) {
  const std::string expanded = at(key, [&] { return expand_variables(object.at(key).get<std::string>()); });
  return (folder / expanded).lexically_normal();
}

}  // namespace shapegauge
