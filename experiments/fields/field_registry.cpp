#include "shapegauge/experiments/fields/field_registry.h"

#include <array>
#include <fmt/format.h>

#include "shapegauge/core/error.h"
#include "shapegauge/experiments/fields/cone_sdf_field.h"
#include "shapegauge/experiments/fields/offset_sdf_field.h"

namespace shapegauge {

std::span<const FieldType> field_types() {
  static constexpr std::array types{
      FieldType{"offset_sdf", offset_sdf_field},
      FieldType{"cone_sdf", cone_sdf_field},
  };
  return types;
}

Field make_field(const nlohmann::json& settings) {
  const std::string type = settings.at("type");
  for (const FieldType& known : field_types()) {
    if (known.name == type) return known.make(settings);
  }
  throw InputError(fmt::format("there is no field of type \"{}\"", type));
}

}  // namespace shapegauge
