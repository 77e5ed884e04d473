#include "shapegauge/retrieval/distances/registry.h"

#include <array>

#include "shapegauge/retrieval/distances/chi2.h"
#include "shapegauge/retrieval/distances/cosine.h"
#include "shapegauge/retrieval/distances/emd.h"
#include "shapegauge/retrieval/distances/hellinger.h"
#include "shapegauge/retrieval/distances/jensen_shannon.h"
#include "shapegauge/retrieval/distances/l1.h"
#include "shapegauge/retrieval/distances/l2.h"

namespace shapegauge {

std::span<const NamedDistance> distances() {
  static constexpr std::array registered = {
      NamedDistance{"l1", l1_distance, DistanceDomain::any, l1_distances},
      NamedDistance{"l2", l2_distance, DistanceDomain::any},
      NamedDistance{"cosine", cosine_distance, DistanceDomain::not_zero},
      NamedDistance{"chi2", chi2_distance, DistanceDomain::not_negative},
      NamedDistance{"hellinger", hellinger_distance, DistanceDomain::histograms},
      NamedDistance{"jensen-shannon", jensen_shannon_distance, DistanceDomain::histograms},
      NamedDistance{"emd", earth_movers_distance, DistanceDomain::histograms},
  };
  return registered;
}

}  // namespace shapegauge
