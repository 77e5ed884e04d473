#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// Keys of models, equal for ids of the same model: canonical_model_id(), but the whole id where several of the known
/// ids differ in the extension of the shape file only, such as m0.off and m0.obj.
class ModelKeys {
 public:
  ModelKeys() = default;
  explicit ModelKeys(const std::vector<std::string>& known_ids);

  /// Also distinguishes the models that the other keys distinguish.
  void add(const ModelKeys& other) { ambiguous_.insert(other.ambiguous_.begin(), other.ambiguous_.end()); }

  [[nodiscard]] std::string of(std::string_view id) const;

  bool operator==(const ModelKeys&) const = default;

 private:
  std::set<std::string, std::less<>> ambiguous_;  ///< canonical ids of several models
};

}  // namespace shapegauge
