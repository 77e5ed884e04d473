#include "shapegauge/experiments/fields/offset_sdf_field.h"

#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/experiments/fields/field_registry.h"

namespace shapegauge {

Field offset_sdf_field(const nlohmann::json& settings) {
  OffsetSdfOptions options;
  options.offset = settings.at("offset");
  const SampleSite site = site_of(settings);
  return {.settings = {{"type", "offset_sdf"}, {"offset", options.offset}, {"at", name_of(site)}},
          .site = site,
          .compute = [options](const Shape& shape, const Samples& samples, bool parallel) {
            OffsetSdfOptions now = options;
            now.parallel = parallel;
            OffsetSdfResult result = offset_sdf(shape, samples, now);
            const OffsetSdfOutcomes& outcomes = result.outcomes;
            return FieldValues{.values = std::move(result.values),
                               .normals = std::move(result.normals),
                               .outcomes = {{"total", outcomes.total},
                                            {"direct", outcomes.direct},
                                            {"searched", outcomes.searched},
                                            {"undecided", outcomes.undecided}},
                               .build_seconds = result.build_seconds,
                               .query_seconds = result.query_seconds};
          }};
}

}  // namespace shapegauge
