#include "shapegauge/experiments/fields/offset_sdf_field.h"

#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/sdf/offset_sdf.h"

namespace shapegauge {

Field offset_sdf_field(const nlohmann::json& settings) {
  const nlohmann::json& offset = settings.at("offset");
  const bool automatic = offset.is_string();  // "auto", as the schema says
  const double given = automatic ? 0 : offset.get<double>();
  const SamplePlan samples_wanted = sample_plan_of(settings);
  nlohmann::json versions{{"offset_sdf", offset_sdf_version}};
  if (automatic) versions["automatic_offset"] = automatic_offset_version;
  return {.settings = {{"type", "offset_sdf"}, {"offset", offset}, {"at", to_json(samples_wanted)}},
          .versions = versions,
          .samples = samples_wanted,
          .compute = [automatic, given](FieldSource& source, const Samples& samples, bool parallel) {
            const double r = automatic ? automatic_offset(source.shape()).offset : given;
            const OffsetSdfOptions now{.offset = r, .parallel = parallel};
            const OffsetSdfSolver& solver = source.offset_sdf_solver();
            OffsetSdfResult result = solver.solve(samples, now);
            const OffsetSdfOutcomes& outcomes = result.outcomes;
            return FieldValues{.values = std::move(result.values),
                               .normals = std::move(result.normals),
                               .outcomes = {{"total", outcomes.total},
                                            {"direct", outcomes.direct},
                                            {"searched", outcomes.searched},
                                            {"undecided", outcomes.undecided},
                                            {"missing", outcomes.missing}},
                               .offset = automatic ? std::optional(r) : std::nullopt,
                               .build_seconds = solver.build_seconds() + result.build_seconds,
                               .query_seconds = result.query_seconds};
          }};
}

}  // namespace shapegauge
