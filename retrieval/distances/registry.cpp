#include "shapegauge/retrieval/distances/registry.h"

#include <array>

#include "shapegauge/retrieval/distances/l1.h"

namespace shapegauge {

std::span<const NamedDistance> distances() {
  static constexpr std::array registered = {
      NamedDistance{"l1", l1_distance, l1_distances},
  };
  return registered;
}

}  // namespace shapegauge
