#include "shapegauge/core/sdf/offset_sdf.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <tbb/parallel_for.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/exposed_direction.h"
#include "shapegauge/core/spatial/exterior_entry.h"
#include "shapegauge/core/spatial/morton_order.h"
#include "shapegauge/core/spatial/nearest_exterior.h"
#include "shapegauge/core/spatial/offset_exterior.h"
#include "shapegauge/core/spatial/offset_tolerance.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

void require_extent(const Shape& shape) {
  const double diagonal = bounding_box_diagonal(shape);
  if (diagonal > 0 && std::isfinite(diagonal)) return;
  throw InputError(
      fmt::format("the shape has no usable extent (the diagonal of its bounding box is {}): an offset SDF needs "
                  "triangles or points "
                  "that span some space",
                  diagonal));
}

enum class Outcome : std::uint8_t { direct, searched, undecided, missing };

struct Answer {
  double value;  ///< |qq'| - 2r
  Eigen::Vector3d normal;
  Outcome outcome;
};

/// q = p + r n, or p - r n where only that is exterior; nothing where another part of the offset solid covers both. Of
/// a cloud, where every point of the exposed part of the ball about p is as near, the middle of that part.
std::optional<ExteriorPoint> direct_point(const OffsetExterior& exterior, bool of_cloud, const Eigen::Vector3d& p,
                                          const Eigen::Vector3d& normal) {
  if (normal.isZero()) return std::nullopt;
  const double r = exterior.r();
  for (const double side : {1.0, -1.0}) {
    if (of_cloud) {
      if (const auto u = middle_of_exposed(exterior, p, side * normal)) return ExteriorPoint{p + r * *u};
      continue;
    }
    const Eigen::Vector3d q = p + side * r * normal;
    if (exterior.tree().any_within(q, r * (1 - offset_slack))) continue;
    if (exterior.contains(q) == true) return ExteriorPoint{q};
  }
  return std::nullopt;
}

/// What remembers the samples before.
struct Searches {
  NearestExteriorSearch nearest;
  ExteriorEntrySearch entry;
};

Answer answer_at(const OffsetExterior& exterior, bool of_cloud, const Eigen::Vector3d& p, const Eigen::Vector3d& normal,
                 Searches& searches) {
  const double r = exterior.r();
  const double on_surface = std::max(1e-3 * r, 1e-6);  // what rounding may have moved a sample by
  if (!p.allFinite() || !normal.allFinite() || !exterior.tree().any_within(p, on_surface)) {
    return {std::numeric_limits<double>::quiet_NaN(), Eigen::Vector3d::Zero(), Outcome::missing};
  }
  Outcome outcome = Outcome::direct;
  double distance = r;
  auto q = direct_point(exterior, of_cloud, p, normal);
  if (!q) {
    outcome = Outcome::searched;
    q = searches.nearest.find(p, normal);
    distance = (q->point - p).norm();
  }
  Eigen::Vector3d outward = (q->point - p).normalized();
  if (of_cloud && outcome == Outcome::searched && distance <= r * (1 + 2 * offset_slack)) {
    outward = middle_of_exposed(exterior, p, outward).value_or(outward);
  }
  const ExteriorEntry entry = searches.entry.find(p, -outward);
  if (!q->decided || !entry.decided) outcome = Outcome::undecided;
  return {(distance - r) + (entry.distance - r), outward, outcome};
}

void check(const OffsetSdfOptions& options) {
  require_in_bounds("the offset, a fraction of the bounding-box diagonal,", options.offset,
                    OffsetSdfOptions::offset_bounds);
}

UnitFrame unit_frame_of(const Shape& shape) {
  require_usable(shape);
  require_extent(shape);
  return unit_frame(shape);
}

/// What a search remembers of the samples before it ends with a block of them, so that threads do not change the
/// answers.
constexpr Eigen::Index block_size = 1024;

void count(OffsetSdfOutcomes& outcomes, Outcome outcome) {
  ++outcomes.total;
  outcomes.direct += outcome == Outcome::direct ? 1 : 0;
  outcomes.searched += outcome == Outcome::searched ? 1 : 0;
  outcomes.undecided += outcome == Outcome::undecided ? 1 : 0;
  outcomes.missing += outcome == Outcome::missing ? 1 : 0;
}

}  // namespace

OffsetSdfSolver::OffsetSdfSolver(const Shape& shape)
    : frame_(unit_frame_of(shape)), tree_(Shape{}), is_cloud_(is_cloud(shape)) {
  const Clock::time_point start = Clock::now();
  const Shape unit_shape = in_unit_frame(shape, frame_);
  bounds_ = bounding_box(unit_shape);
  tree_ = TriangleBVH(unit_shape);
  is_watertight_ = is_watertight_and_oriented(shape);
  build_seconds_ = seconds_since(start);
}

OffsetSdfResult OffsetSdfSolver::solve(const Samples& samples, const OffsetSdfOptions& options) const {
  check(options);
  const Clock::time_point start = Clock::now();
  const OffsetExterior exterior(tree_, bounds_, options.offset, is_watertight_);
  OffsetSdfResult result;
  result.build_seconds = seconds_since(start);
  const Clock::time_point built = Clock::now();
  const Eigen::Index n = samples.points.rows();
  result.values.resize(n);
  result.normals.resize(n, 3);
  std::vector<Outcome> outcomes(static_cast<std::size_t>(n));
  const std::vector<std::int32_t> order = morton_order(samples.points);
  const auto answer_block = [&](Eigen::Index block) {
    Searches searches{NearestExteriorSearch(exterior), ExteriorEntrySearch(exterior)};
    const Eigen::Index end = std::min(n, (block + 1) * block_size);
    for (Eigen::Index k = block * block_size; k < end; ++k) {
      const Eigen::Index i = order[static_cast<std::size_t>(k)];
      const Answer answer = answer_at(exterior, is_cloud_, frame_.to_unit(samples.points.row(i).transpose()),
                                      samples.normals.row(i).transpose(), searches);
      result.values[i] = answer.value * frame_.diagonal;
      result.normals.row(i) = answer.normal;
      outcomes[static_cast<std::size_t>(i)] = answer.outcome;
    }
  };
  const Eigen::Index blocks = (n + block_size - 1) / block_size;
  if (options.parallel) {
    tbb::parallel_for(Eigen::Index{0}, blocks, answer_block);
  } else {
    for (Eigen::Index block = 0; block < blocks; ++block) answer_block(block);
  }
  for (const Outcome outcome : outcomes) count(result.outcomes, outcome);
  result.query_seconds = seconds_since(built);
  return result;
}

OffsetSdfResult offset_sdf(const Shape& shape, const Samples& samples, const OffsetSdfOptions& options) {
  check(options);
  const OffsetSdfSolver solver(shape);
  OffsetSdfResult result = solver.solve(samples, options);
  result.build_seconds += solver.build_seconds();
  return result;
}

}  // namespace shapegauge
