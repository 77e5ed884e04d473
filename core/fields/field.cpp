#include "shapegauge/core/fields/field.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <stdexcept>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/fields/bilateral.h"
#include "shapegauge/core/fields/centricity.h"
#include "shapegauge/core/fields/heat_kernel.h"
#include "shapegauge/core/fields/inscribed_ball.h"
#include "shapegauge/core/fields/laplacian.h"
#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"

namespace shapegauge {

namespace {

/// The SDF of the offset surface (offset_sdf.h).
FieldComputation offset_sdf_field(const ParameterValues& values, const SamplePlan& /*samples*/) {
  const auto* const given = std::get_if<double>(&values.value("offset"));
  const std::optional<double> offset = given != nullptr ? std::optional(*given) : std::nullopt;  // else "auto"
  const auto word = std::ranges::find(OffsetSdfOptions::accuracy_words, values.word("accuracy"));
  const auto accuracy = static_cast<OffsetAccuracy>(word - OffsetSdfOptions::accuracy_words.begin());
  AlgorithmVersions versions{{"offset_sdf", offset_sdf_version}};
  if (!offset) versions["automatic_offset"] = automatic_offset_version;
  return {.versions = std::move(versions),
          .compute = [offset, accuracy](FieldSource& source, const Samples& samples, bool parallel) {
            OffsetSdfOptions options{.accuracy = accuracy, .parallel = parallel};
            options.offset = offset ? *offset : automatic_offset(source.shape()).offset;
            const OffsetSdfSolver& solver = source.offset_sdf_solver();
            OffsetSdfResult result = solver.solve(samples, options);
            const OffsetSdfOutcomes& outcomes = result.outcomes;
            return FieldValues{.values = std::move(result.values),
                               .normals = std::move(result.normals),
                               .outcomes = {{"total", outcomes.total},
                                            {"direct", outcomes.direct},
                                            {"searched", outcomes.searched},
                                            {"undecided", outcomes.undecided},
                                            {"missing", outcomes.missing},
                                            {"enlarged", outcomes.enlarged}},
                               .offset = offset ? std::nullopt : std::optional(options.offset),
                               .build_seconds = solver.build_seconds() + result.build_seconds,
                               .query_seconds = result.query_seconds};
          }};
}

constexpr std::array<std::string_view, 1> automatic{"auto"};

std::vector<Parameter> offset_sdf_parameters() {
  return {{.name = "offset",
           .bounds = OffsetSdfOptions::offset_bounds,
           .choices = automatic,
           .description = "Offset distance as a fraction of the bounding box's diagonal; auto: chosen for each shape "
                          "between 1 and 5 % by its gaps and its noise."},
          {.name = "accuracy",
           .kind = ParameterKind::choice,
           .default_value = OffsetSdfOptions::accuracy_words[static_cast<std::size_t>(OffsetSdfOptions{}.accuracy)],
           .choices = OffsetSdfOptions::accuracy_words,
           .description = "How fine the grid of the computation is: its cells are the offset over 2.5, 3 or 5."}};
}

constexpr std::array<std::string_view, 2> engines{"embree", "cgal"};

/// The conventional SDF (cone_sdf.h).
FieldComputation cone_sdf_field(const ParameterValues& values, const SamplePlan& samples) {
  const bool cgal = values.word("engine") == "cgal";
  const ConeSdfOptions options{.engine = cgal ? ConeSdfEngine::cgal : ConeSdfEngine::embree,
                               .opening_angle_degrees = values.number("opening_angle_degrees"),
                               .rays = static_cast<int>(values.integer("rays")),
                               .postprocess = values.boolean("postprocess")};
  if (options.postprocess && !cgal) {
    throw InputError(R"("postprocess" needs "engine": "cgal"; the embree engine gives raw values only)");
  }
  if (cgal && samples.site != SampleSite::faces) {
    throw InputError(R"("engine": "cgal" answers at faces only; use "embree" for other sites)");
  }
  // CGAL's post-processing scales to [0, 1].
  return {.versions = {{"cone_sdf", cone_sdf_version}},
          .dimension = options.postprocess ? FieldDimension::none : FieldDimension::length,
          .compute = [options](const FieldSource& source, const Samples& sites, bool parallel) {
            ConeSdfOptions now = options;
            now.parallel = parallel;
            ConeSdfResult result = cone_sdf(source.shape(), sites, now);
            return FieldValues{.values = std::move(result.values),
                               .build_seconds = result.build_seconds,
                               .query_seconds = result.query_seconds};
          }};
}

std::vector<Parameter> cone_sdf_parameters() {
  const ConeSdfOptions usual;
  return {{.name = "engine",
           .kind = ParameterKind::choice,
           .default_value = engines[0],
           .choices = engines,
           .description = "Who casts the rays: embree is fast; cgal is CGAL's own, the reference, at faces only."},
          {.name = "opening_angle_degrees",
           .default_value = usual.opening_angle_degrees,
           .bounds = ConeSdfOptions::opening_angle_degrees_bounds,
           .description = "Full opening angle of the cone."},
          {.name = "rays",
           .kind = ParameterKind::integer,
           .default_value = std::int64_t{usual.rays},
           .bounds = ConeSdfOptions::rays_bounds,
           .description = "Number of rays."},
          {.name = "postprocess",
           .kind = ParameterKind::boolean,
           .default_value = usual.postprocess,
           .description = "CGAL's post-processing: smoothed and scaled to [0, 1] shape by shape; engine cgal only."}};
}

/// The largest ball inside (inscribed_ball.h).
FieldComputation inscribed_ball_field(const ParameterValues& values, const SamplePlan& /*samples*/) {
  const double angle = values.number("separation_angle_degrees");
  return {.versions = {{"inscribed_ball", inscribed_ball_version}},
          .compute = [angle](const FieldSource& source, const Samples& samples, bool parallel) {
            const InscribedBallOptions options{.separation_angle_degrees = angle, .parallel = parallel};
            return FieldValues{.values = inscribed_ball(source.shape(), samples, options)};
          }};
}

std::vector<Parameter> inscribed_ball_parameters() {
  return {
      {.name = "separation_angle_degrees",
       .default_value = InscribedBallOptions{}.separation_angle_degrees,
       .bounds = InscribedBallOptions::separation_angle_degrees_bounds,
       .description = "Least angle, at the ball's centre, between the sample and the contact that stops the ball."}};
}

constexpr std::array<std::string_view, 2> surfaces{"mesh", "proxy"};

/// Where a field along the surface is computed.
Parameter on_parameter() {
  return {.name = "on",
          .kind = ParameterKind::choice,
          .default_value = surfaces[0],
          .choices = surfaces,
          .description =
              "mesh: the shape's own edges and triangles; proxy: evenly spread points of the surface, for "
              "damaged meshes and clouds too."};
}

bool is_on_proxy(const ParameterValues& values) { return values.word("on") == "proxy"; }

constexpr std::array<std::string_view, 2> centricity_measures{"mean", "eccentricity"};
constexpr std::array<std::string_view, 3> geodesic_methods{"graph", "heat", "exact"};

GeodesicMethod geodesic_method(std::string_view word) {
  if (word == "heat") return GeodesicMethod::heat;
  return word == "exact" ? GeodesicMethod::exact : GeodesicMethod::graph;
}

/// Geodesic distances to all of the surface (centricity.h).
FieldComputation centricity_field(const ParameterValues& values, const SamplePlan& /*samples*/) {
  const CentricityOptions options{
      .measure = values.word("measure") == "mean" ? Centricity::mean : Centricity::eccentricity,
      .geodesics = {.method = geodesic_method(values.word("method")),
                    .neighbours = static_cast<int>(values.integer("neighbours"))},
      .sources = static_cast<int>(values.integer("sources"))};
  if (is_on_proxy(values)) {
    if (options.geodesics.method != GeodesicMethod::graph) {
      throw InputError(R"("method": "heat" and "exact" need "on": "mesh")");
    }
    return {.versions = {{"centricity", centricity_version}, {"surface_proxy", surface_proxy_version}},
            .compute = [measure = options.measure](FieldSource& source, const Samples& samples, bool /*parallel*/) {
              ProxySource& proxy = source.proxy();
              return FieldValues{.values = proxy.at_samples(samples, centricity(proxy.geodesics(), measure))};
            }};
  }
  return {.versions = {{"centricity", centricity_version}},
          .compute = [options](const FieldSource& source, const Samples& samples, bool /*parallel*/) {
            return FieldValues{.values = centricity(source.shape(), samples, options)};
          }};
}

std::vector<Parameter> centricity_parameters() {
  return {{.name = "measure",
           .kind = ParameterKind::choice,
           .default_value = centricity_measures[0],
           .choices = centricity_measures,
           .description = "Of the distances to all places the mean, by area, or the largest."},
          {.name = "method",
           .kind = ParameterKind::choice,
           .default_value = geodesic_methods[0],
           .choices = geodesic_methods,
           .description = "graph: shortest paths, on every shape, a few percent too long; heat and exact: CGAL's, on "
                          "connected manifold meshes."},
          {.name = "neighbours",
           .kind = ParameterKind::integer,
           .default_value = std::int64_t{GeodesicOptions{}.neighbours},
           .bounds = {.low = 1, .high = 64},
           .description = "Nearest points that are joined in a point cloud, and across the gaps between components."},
          {.name = "sources",
           .kind = ParameterKind::integer,
           .default_value = std::int64_t{CentricityOptions{}.sources},
           .bounds = {.low = 1, .high = 1000},
           .description = "Landmarks, spread over the surface, to which distances are taken; of the proxy always 500."},
          on_parameter()};
}

/// How many eigenvalues heat kernels and their like are summed over.
Parameter eigenvalues_parameter() {
  return {.name = "eigenvalues",
          .kind = ParameterKind::integer,
          .default_value = std::int64_t{100},
          .bounds = {.low = 2, .high = 1000},
          .description = "Eigenvalues of the Laplacian, from the least on."};
}

/// A field that a spectrum's function of vertices, one column of it, gives (heat_kernel.h).
/// - `column`: from a spectrum and the shape's area to values at the vertices.
FieldComputation spectral_field(const ParameterValues& values,
                                std::function<Eigen::VectorXd(const Spectrum&, double area)> column) {
  if (is_on_proxy(values)) {
    return {.versions = {{"heat_kernel", heat_kernel_version}, {"surface_proxy", surface_proxy_version}},
            .dimension = FieldDimension::none,
            .compute = [column = std::move(column), count = static_cast<int>(values.integer("eigenvalues"))](
                           FieldSource& source, const Samples& samples, bool /*parallel*/) {
              ProxySource& proxy = source.proxy();
              const Eigen::VectorXd at_points = column(proxy.spectrum(count), proxy.proxy().areas.sum());
              return FieldValues{.values = proxy.at_samples(samples, at_points)};
            }};
  }
  return {.versions = {{"heat_kernel", heat_kernel_version}},
          .dimension = FieldDimension::none,  // all are relative to the area, or to their neighbours in time
          .compute = [column = std::move(column), count = static_cast<int>(values.integer("eigenvalues"))](
                         FieldSource& source, const Samples& samples, bool /*parallel*/) {
            const Eigen::VectorXd at_vertices = column(source.spectrum(count), surface_area(source.shape()));
            return FieldValues{.values = at_samples(source.shape(), samples, at_vertices)};
          }};
}

FieldComputation heat_kernel_field(const ParameterValues& values, const SamplePlan& /*samples*/) {
  return spectral_field(values, [time = values.number("time")](const Spectrum& spectrum, double area) {
    return heat_kernel_signature_at(spectrum, area, time);
  });
}

std::vector<Parameter> heat_kernel_parameters() {
  return {{.name = "time",
           .default_value = 0.02,
           .bounds = {.low = 1e-6, .high = 100},
           .description = "How long heat spreads, in units of the surface's area: about the square of a "
                          "neighbourhood's size."},
          eigenvalues_parameter(),
          on_parameter()};
}

FieldComputation scale_invariant_field(const ParameterValues& values, const SamplePlan& /*samples*/) {
  const auto frequency = static_cast<Eigen::Index>(values.integer("frequency"));
  return spectral_field(values, [frequency](const Spectrum& spectrum, double area) {
    const ScaleInvariantOptions options{.frequencies = static_cast<int>(frequency) + 1};
    return Eigen::VectorXd(scale_invariant_heat_kernel_signature(spectrum, area, options).col(frequency));
  });
}

std::vector<Parameter> scale_invariant_parameters() {
  return {{.name = "frequency",
           .kind = ParameterKind::integer,
           .default_value = std::int64_t{0},
           .bounds = {.low = 0, .high = 63},
           .description = "Which of the Fourier coefficients over the logarithm of time."},
          eigenvalues_parameter(),
          on_parameter()};
}

FieldComputation wave_kernel_field(const ParameterValues& values, const SamplePlan& /*samples*/) {
  const auto energy = static_cast<Eigen::Index>(values.integer("energy"));
  const WaveKernelOptions options{.energies = static_cast<int>(values.integer("energies")),
                                  .width_steps = values.number("width_steps")};
  if (energy >= options.energies) {
    throw InputError(fmt::format("energy is {}; it must be less than energies, {}", energy, options.energies));
  }
  return spectral_field(values, [energy, options](const Spectrum& spectrum, double area) {
    return Eigen::VectorXd(wave_kernel_signature(spectrum, area, options).col(energy));
  });
}

std::vector<Parameter> wave_kernel_parameters() {
  const WaveKernelOptions usual;
  return {{.name = "energy",
           .kind = ParameterKind::integer,
           .default_value = std::int64_t{0},
           .bounds = {.low = 0, .high = 999},
           .description = "Which of the energies, from the least on."},
          {.name = "energies",
           .kind = ParameterKind::integer,
           .default_value = std::int64_t{usual.energies},
           .bounds = {.low = 2, .high = 1000},
           .description = "How many there are, evenly spaced by their logarithm."},
          {.name = "width_steps",
           .default_value = usual.width_steps,
           .bounds = {.low = 0.1, .high = 100},
           .description = "Standard deviation of a filter, in hundredths of the range of energies."},
          eigenvalues_parameter(),
          on_parameter()};
}

constexpr std::array bilateral_table = {
    option_of<&BilateralOptions::iterations>("iterations", {.low = 0, .high = 100}, "How many times."),
    option_of<&BilateralOptions::spatial_width>(
        "spatial_width", {.low = 0, .high = 1, .low_open = true},
        "Standard deviation by distance along the surface, in square roots of the area."),
    option_of<&BilateralOptions::value_width>("value_width", {.low = 0, .high = 1e6, .low_open = true},
                                              "Standard deviation by value, in standard deviations of the field."),
};

/// The field, smoothed.
FieldComputation smoothed(FieldComputation field, const BilateralOptions& options) {
  field.versions["bilateral"] = bilateral_version;
  field.compute = [compute = std::move(field.compute), options](FieldSource& source, const Samples& samples,
                                                                bool parallel) {
    FieldValues computed = compute(source, samples, parallel);
    const Stopwatch stopwatch;
    ScalarField values{.values = std::move(computed.values), .weights = samples.weights};
    computed.values = bilateral_smoothing(source.shape(), samples, std::move(values), options).values;
    computed.query_seconds += stopwatch.seconds();
    return computed;
  };
  return field;
}

std::vector<FieldType> own_fields() {
  return {
      {"offset_sdf", "Shape diameter function of the offset surface.", offset_sdf_parameters(), offset_sdf_field},
      {"cone_sdf", "Conventional shape diameter function: a cone of rays about the inward normal.",
       cone_sdf_parameters(), cone_sdf_field},
      {"inscribed_ball", "Diameter of the largest ball inside the shape that touches its surface at the sample.",
       inscribed_ball_parameters(), inscribed_ball_field},
      {"centricity", "Geodesic distance from a place to all others: small in a shape's middle, large at its ends.",
       centricity_parameters(), centricity_field},
      {"heat_kernel", "Heat kernel signature at one time: the heat left at a place, over its share when it is even.",
       heat_kernel_parameters(), heat_kernel_field},
      {"scale_invariant_heat_kernel", "Scale-invariant heat kernel signature: one of its coefficients.",
       scale_invariant_parameters(), scale_invariant_field},
      {"wave_kernel", "Wave kernel signature at one energy.", wave_kernel_parameters(), wave_kernel_field},
  };
}

void check_field_type(const FieldType& type) {
  const auto reserved = [](const Parameter& parameter) {
    return parameter.name == "type" || parameter.name == "at" || parameter.name == "bilateral";
  };
  if (!type.make || std::ranges::any_of(type.parameters, reserved)) {
    throw ArgumentError(fmt::format(
        "a field needs a function, and parameters that are not called type, at or bilateral: \"{}\"", type.name));
  }
}

/// The function, with what every field tells: its own outcomes and seconds, or those that can be counted.
FieldFunction with_outcomes(FieldFunction compute) {
  return [compute = std::move(compute)](FieldSource& source, const Samples& samples, bool parallel) {
    const Stopwatch stopwatch;
    FieldValues computed = compute(source, samples, parallel);
    if (computed.build_seconds == 0) computed.query_seconds = stopwatch.seconds();
    if (computed.values.size() != samples.points.rows()) {
      throw std::logic_error(
          fmt::format("a field gives {} values for {} samples", computed.values.size(), samples.points.rows()));
    }
    if (computed.outcomes.empty()) {
      computed.outcomes = {{"total", static_cast<std::size_t>(computed.values.size())},
                           {"missing", static_cast<std::size_t>(computed.values.array().isNaN().count())}};
    }
    return computed;
  };
}

}  // namespace

FieldSource::FieldSource(const Shape& shape) : shape_(&shape), proxy_(shape) {}

FieldSource::~FieldSource() = default;

const OffsetSdfSolver& FieldSource::offset_sdf_solver() {
  if (!offset_sdf_solver_) offset_sdf_solver_ = std::make_unique<OffsetSdfSolver>(*shape_);
  return *offset_sdf_solver_;
}

const Spectrum& FieldSource::spectrum(int eigenvalues) {
  std::unique_ptr<Spectrum>& spectrum = spectra_[eigenvalues];
  if (!spectrum) spectrum = std::make_unique<Spectrum>(laplacian_spectrum(*shape_, eigenvalues));
  return *spectrum;
}

std::vector<std::string> outcome_warnings(const FieldOutcomes& outcomes) {
  constexpr std::array<std::pair<const char*, const char*>, 3> warned{
      {{"undecided", "undecided"},
       {"missing", "missing"},
       {"enlarged", "answered at a larger offset: the grid of the one asked for would not fit into memory"}}};
  std::vector<std::string> warnings;
  for (const auto& [outcome, words] : warned) {
    const auto count = outcomes.find(outcome);
    if (count == outcomes.end() || count->second == 0) continue;
    warnings.push_back(fmt::format("{} of {} samples {}", count->second, outcomes.at("total"), words));
  }
  return warnings;
}

double unit_of(FieldDimension dimension, double length) {
  switch (dimension) {
    case FieldDimension::none:
      return 1;
    case FieldDimension::length:
      return length;
    case FieldDimension::area:
      break;
  }
  return length * length;
}

Samples take_samples(const Shape& shape, const SamplePlan& plan) {
  return plan.site == SampleSite::surface ? sample_surface_of(shape, plan.count) : sample_shape(shape, plan.site);
}

Registry<FieldType>& field_types() {
  static Registry<FieldType> all("field", own_fields(), check_field_type);
  return all;
}

std::span<const Parameter> bilateral_parameters() {
  static constexpr auto parameters = parameters_of(bilateral_table);
  return parameters;
}

FieldSettings field_settings(std::string_view type) {
  return {.type = std::string(type), .values = ParameterValues(field_types().at(type).parameters)};
}

Field make_field(FieldSettings settings) {
  const FieldType& type = field_types().at(settings.type);
  settings.values.require_complete();
  FieldComputation computation = type.make(settings.values, settings.samples);
  if (settings.smoothing) {
    computation = smoothed(std::move(computation), options_from(bilateral_table, *settings.smoothing));
  }
  return {.settings = std::move(settings),
          .versions = std::move(computation.versions),
          .dimension = computation.dimension,
          .compute = with_outcomes(std::move(computation.compute))};
}

}  // namespace shapegauge
