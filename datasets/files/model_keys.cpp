#include "shapegauge/datasets/files/model_keys.h"

#include <unordered_map>

#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/datasets/files/model_ids.h"

namespace shapegauge {

ModelKeys::ModelKeys(const std::vector<std::string>& known_ids) {
  std::unordered_map<std::string_view, std::string_view> first_with_name;
  for (const std::string& id : known_ids) {
    const std::string_view name = without_shape_extension(id);
    if (name.size() == id.size()) continue;
    const auto first = first_with_name.emplace(name, id).first;
    if (first->second != id) ambiguous_.insert(canonical_model_id(id));
  }
}

std::string ModelKeys::of(std::string_view id) const {
  std::string canonical = canonical_model_id(id);
  return ambiguous_.contains(canonical) ? std::string(id) : canonical;
}

}  // namespace shapegauge
