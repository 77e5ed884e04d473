// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/spatial/ray_caster.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <type_traits>
#include <vector>

// Embree 4 passes the context of a ray with other arguments than Embree 3; the rest of the two interfaces is the same.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
using RayContext = RTCRayQueryContext;
static void intersect(RTCScene scene, RayContext* context, RTCRayHit* query) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = context;
  rtcIntersect1(scene, query, &arguments);
}
#else
#include <embree3/rtcore.h>
using RayContext = RTCIntersectContext;
static void rtcInitRayQueryContext(RayContext* context) { rtcInitIntersectContext(context); }
static void intersect(RTCScene scene, RayContext* context, RTCRayHit* query) { rtcIntersect1(scene, context, query); }
#endif

#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

namespace {

/// Tolerance between distances in single and double precision, in diagonals. If it is exceeded, the ray grazes the
/// triangle's plane, which does not determine the position of the hit.
constexpr double grazing_difference = 1e-5;

/// Minimum distance of a hit in diagonals. A closer triangle may contain the origin, which rounding could place on the
/// wrong side.
constexpr float nearest_hit = 0x1p-22F;

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

/// One device serves the process: it holds no scene, and creating one takes longer than building a small tree.
RTCDevice device() {
  static const std::unique_ptr<RTCDeviceTy, Release> shared(rtcNewDevice(nullptr));
  if (!shared) throw std::bad_alloc();  // Embree starts on every processor, but not without memory
  return shared.get();
}

/// Data of a ray for the filter.
struct Context {
  RayContext embree;  // the first member: Embree hands its address to the filter
  std::span<const std::int32_t> skipped;
  std::uint32_t best = RTC_INVALID_GEOMETRY_ID;
  float best_distance = std::numeric_limits<float>::infinity();
};

static_assert(std::is_standard_layout_v<Context>);

/// Rejects triangles to skip and, of several at the same distance, all but the first in the shape. Embree would report
/// the last one visited in its tree, which depends on the number of threads.
void filter(const RTCFilterFunctionNArguments* arguments) {
  auto& context = *reinterpret_cast<Context*>(arguments->context);
  const std::uint32_t triangle = RTCHitN_primID(arguments->hit, 1, 0);
  const float distance = RTCRayN_tfar(arguments->ray, 1, 0);
  const bool later_in_order = distance == context.best_distance && triangle > context.best;
  if (later_in_order ||
      std::ranges::find(context.skipped, static_cast<std::int32_t>(triangle)) != context.skipped.end()) {
    arguments->valid[0] = 0;
    return;
  }
  context.best = triangle;
  context.best_distance = distance;
}

/// Plane of a triangle: normal . x = offset; the normal is a unit vector or zero.
struct Plane {
  Eigen::Vector3d normal;
  double offset;
};

}  // namespace

struct RayCaster::Scene {
  std::unique_ptr<RTCSceneTy, Release> scene{rtcNewScene(device())};
  std::vector<Plane> planes;  // in the scene's coordinates
  UnitFrame frame;

  void add_triangles(const Shape& shape);

  /// Casts rays from one origin in the scene's coordinates: triangles, and distances in single precision.
  void cast(const Eigen::Vector3d& from, std::span<const Eigen::Vector3d> directions,
            std::span<const std::int32_t> skipped, std::span<RayHit> hits) const;

  /// Refines a hit by the plane of its triangle, and converts it to the shape's units.
  void complete(RayHit& hit, const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const;
};

void RayCaster::Scene::add_triangles(const Shape& shape) {
  const auto vertex_count = static_cast<std::size_t>(shape.vertices.rows());
  const auto triangle_count = static_cast<std::size_t>(shape.triangles.rows());
  RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertex_count));
  auto* triangles = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangle_count));
  if (vertices == nullptr || triangles == nullptr) {
    rtcReleaseGeometry(geometry);
    throw std::bad_alloc();
  }
  Points points(shape.vertices.rows(), 3);
  for (Eigen::Index v = 0; v < points.rows(); ++v) points.row(v) = frame.to_unit(shape.vertices.row(v)).transpose();
  std::ranges::copy(points.reshaped<Eigen::RowMajor>().cast<float>(), vertices);
  std::ranges::copy(shape.triangles.reshaped<Eigen::RowMajor>(), triangles);

  planes.reserve(triangle_count);
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const Eigen::Vector3d a = points.row(shape.triangles(f, 0));
    const Eigen::Vector3d b = points.row(shape.triangles(f, 1));
    const Eigen::Vector3d c = points.row(shape.triangles(f, 2));
    const Eigen::Vector3d normal = (b - a).cross(c - a).stableNormalized();
    planes.push_back({normal, normal.dot(a)});
  }
  rtcSetGeometryIntersectFilterFunction(geometry, filter);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene.get(), geometry);
  rtcReleaseGeometry(geometry);
}

void RayCaster::Scene::cast(const Eigen::Vector3d& from, std::span<const Eigen::Vector3d> directions,
                            std::span<const std::int32_t> skipped, std::span<RayHit> hits) const {
  Context context;
  rtcInitRayQueryContext(&context.embree);
  context.skipped = skipped;
  RTCRayHit query = {};
  query.ray.org_x = static_cast<float>(from.x());
  query.ray.org_y = static_cast<float>(from.y());
  query.ray.org_z = static_cast<float>(from.z());
  query.ray.tnear = nearest_hit;
  query.ray.mask = ~0U;  // Embree may be built with ray masks, and then zero hits nothing
  for (std::size_t i = 0; i < directions.size(); ++i) {
    query.ray.dir_x = static_cast<float>(directions[i].x());
    query.ray.dir_y = static_cast<float>(directions[i].y());
    query.ray.dir_z = static_cast<float>(directions[i].z());
    query.ray.tfar = std::numeric_limits<float>::infinity();
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    context.best_distance = std::numeric_limits<float>::infinity();
    intersect(scene.get(), &context.embree, &query);
    const bool hit = query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    hits[i] = {.triangle = hit ? static_cast<std::int32_t>(query.hit.primID) : -1,
               .distance = hit ? query.ray.tfar : 0,
               .leaving = false};
  }
}

void RayCaster::Scene::complete(RayHit& hit, const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const {
  const Plane& plane = planes[static_cast<std::size_t>(hit.triangle)];
  const double slope = plane.normal.dot(direction);
  const double distance = (plane.offset - plane.normal.dot(from)) / slope;
  const bool plane_tells = std::abs(distance - hit.distance) <= grazing_difference;
  hit.distance = std::max(0.0, plane_tells ? distance : hit.distance) * frame.diagonal;
  hit.leaving = slope > 0;
}

RayCaster::RayCaster(const Shape& shape, EdgeHandling edge_handling) : scene_(std::make_unique<Scene>()) {
  scene_->frame = unit_frame(shape);
  const bool robust = edge_handling == EdgeHandling::robust;
  rtcSetSceneFlags(scene_->scene.get(), robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  if (shape.triangles.rows() > 0) scene_->add_triangles(shape);
  rtcCommitScene(scene_->scene.get());
  check_interruption();  // Embree gives up a tree whose loops are cancelled
  if (rtcGetDeviceError(device()) == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
}

RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

RayHit RayCaster::first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                            std::span<const std::int32_t> skipped) const {
  RayHit hit;
  first_hits(origin, std::span(&direction, 1), skipped, std::span(&hit, 1));
  return hit;
}

void RayCaster::first_hits(const Eigen::Vector3d& origin, std::span<const Eigen::Vector3d> directions,
                           std::span<const std::int32_t> skipped, std::span<RayHit> hits) const {
  const Eigen::Vector3d from = scene_->frame.to_unit(origin);
  scene_->cast(from, directions, skipped, hits);
  // A separate loop prefetches the planes, which are scattered in memory.
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (hits[i]) scene_->complete(hits[i], from, directions[i]);
  }
}

}  // namespace shapegauge
