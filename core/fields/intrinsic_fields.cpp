// SPDX-License-Identifier: GPL-3.0-or-later
// Fields along the surface: of geodesic distances, and of the Laplacian's spectrum.

#include <array>
#include <fmt/format.h>
#include <functional>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/fields/centricity.h"
#include "shapegauge/core/fields/field_types.h"
#include "shapegauge/core/fields/heat_kernel.h"
#include "shapegauge/core/fields/laplacian.h"
#include "shapegauge/core/fields/proxy_source.h"

namespace shapegauge {

namespace {

constexpr std::string_view meaning_of_on =
    "Surface representation. mesh: the shape's edges and triangles; proxy: graph of evenly spread surface points, also "
    "for damaged meshes and point clouds.";

struct CentricityField {
  CentricityOptions options = {};
  FieldSurface on = FieldSurface::mesh;
};

constexpr std::array centricity_field_table = {
    nested_option<&CentricityField::options, centricity_table, 0>(),
    nested_option<&CentricityField::options, centricity_table, 1>(),
    nested_option<&CentricityField::options, centricity_table, 2>(),
    nested_option<&CentricityField::options, centricity_table, 3>(),
    option_of<&CentricityField::on>("on", meaning_of_on),
};

/// Computes a field of geodesic distances to the whole surface.
FieldComputation centricity_field(const ParameterValues& values, const SamplePlan& /*samples*/) {
  const auto [options, on] = options_from(centricity_field_table, values);
  if (on == FieldSurface::proxy) {
    if (options.geodesics.method != GeodesicMethod::graph) {
      throw InputError(R"("method": "heat" and "exact" need "on": "mesh", not "proxy")");
    }
    return {
        .versions = {{"centricity", centricity_version}, {"surface_proxy", surface_proxy_version}},
        .compute = [measure = options.measure](FieldSource& source, const Samples& samples, bool /*parallel*/) {
          ProxySource& proxy = source.proxy();
          return FieldValues{.values = proxy.interpolate_to_samples(samples, centricity(proxy.geodesics(), measure))};
        }};
  }
  return {.versions = {{"centricity", centricity_version}},
          .compute = [options = options](const FieldSource& source, const Samples& samples, bool /*parallel*/) {
            return FieldValues{.values = centricity(source.shape(), samples, options)};
          }};
}

/// Spectrum for heat kernels and related signatures.
struct SpectrumChoice {
  int eigenvalues = 100;
  FieldSurface on = FieldSurface::mesh;
};

constexpr std::array spectrum_table = {
    option_of<&SpectrumChoice::eigenvalues>(
        "eigenvalues", {.low = 2, .high = 1000},
        "Number of Laplacian eigenvalues, smallest first; more resolve finer details."),
    option_of<&SpectrumChoice::on>("on", meaning_of_on),
};

/// Makes a field from one column of a spectral function (heat_kernel.h). `column` maps a spectrum and the shape's area
/// to values at the vertices.
FieldComputation spectral_field(const SpectrumChoice& choice,
                                std::function<Eigen::VectorXd(const Spectrum&, double area)> column) {
  if (choice.on == FieldSurface::proxy) {
    return {.versions = {{"heat_kernel", heat_kernel_version}, {"surface_proxy", surface_proxy_version}},
            .dimension = FieldDimension::none,
            .compute = [column = std::move(column), count = choice.eigenvalues](
                           FieldSource& source, const Samples& samples, bool /*parallel*/) {
              ProxySource& proxy = source.proxy();
              const Eigen::VectorXd at_points = column(proxy.spectrum(count), proxy.proxy().areas.sum());
              return FieldValues{.values = proxy.interpolate_to_samples(samples, at_points)};
            }};
  }
  return {.versions = {{"heat_kernel", heat_kernel_version}},
          .dimension = FieldDimension::none,  // all are relative to the area, or to their neighbours in time
          .compute = [column = std::move(column), count = choice.eigenvalues](
                         FieldSource& source, const Samples& samples, bool /*parallel*/) {
            const Eigen::VectorXd at_vertices = column(source.spectrum(count), surface_area(source.shape()));
            return FieldValues{.values = interpolate_to_samples(source.shape(), samples, at_vertices)};
          }};
}

struct HeatKernelField {
  double time = 0.02;
  SpectrumChoice spectrum = {};
};

constexpr std::array heat_kernel_table = {
    with_unit("areas of the surface",
              option_of<&HeatKernelField::time>("time", {.low = 1e-6, .high = 100},
                                                "Diffusion time; larger values describe larger neighbourhoods.")),
    nested_option<&HeatKernelField::spectrum, spectrum_table, 0>(),
    nested_option<&HeatKernelField::spectrum, spectrum_table, 1>(),
};

FieldComputation heat_kernel_field(const ParameterValues& values, const SamplePlan& /*samples*/) {
  const HeatKernelField field = options_from(heat_kernel_table, values);
  return spectral_field(field.spectrum, [time = field.time](const Spectrum& spectrum, double area) {
    return heat_kernel_signature(spectrum, area, time);
  });
}

struct ScaleInvariantField {
  int frequency = 0;
  SpectrumChoice spectrum = {};
};

constexpr std::array scale_invariant_table = {
    option_of<&ScaleInvariantField::frequency>(
        "frequency", {.low = 0, .high = 63},
        "Index of the Fourier coefficient, from 0 (lowest frequency); the transform is over the logarithm of the "
        "diffusion time."),
    nested_option<&ScaleInvariantField::spectrum, spectrum_table, 0>(),
    nested_option<&ScaleInvariantField::spectrum, spectrum_table, 1>(),
};

FieldComputation scale_invariant_field(const ParameterValues& values, const SamplePlan& /*samples*/) {
  const ScaleInvariantField field = options_from(scale_invariant_table, values);
  return spectral_field(field.spectrum, [frequency = field.frequency](const Spectrum& spectrum, double area) {
    const ScaleInvariantOptions options{.frequencies = frequency + 1};
    return Eigen::VectorXd(scale_invariant_heat_kernel_signature(spectrum, area, options).col(frequency));
  });
}

struct WaveKernelField {
  int energy = 0;
  WaveKernelOptions options = {};
  SpectrumChoice spectrum = {};
};

constexpr std::array wave_kernel_field_table = {
    option_of<&WaveKernelField::energy>("energy", {.low = 0, .high = 999},
                                        "Index of the energy to use, from 0 (lowest) to energies - 1."),
    nested_option<&WaveKernelField::options, wave_kernel_table, 0>(),
    nested_option<&WaveKernelField::options, wave_kernel_table, 1>(),
    nested_option<&WaveKernelField::spectrum, spectrum_table, 0>(),
    nested_option<&WaveKernelField::spectrum, spectrum_table, 1>(),
};

FieldComputation wave_kernel_field(const ParameterValues& values, const SamplePlan& /*samples*/) {
  const WaveKernelField field = options_from(wave_kernel_field_table, values);
  if (field.energy >= field.options.energies) {
    throw InputError(
        fmt::format("energy is {}; it must be less than energies, which is {}", field.energy, field.options.energies));
  }
  return spectral_field(field.spectrum,
                        [energy = field.energy, options = field.options](const Spectrum& spectrum, double area) {
                          return Eigen::VectorXd(wave_kernel_signature(spectrum, area, options).col(energy));
                        });
}

template <const auto& table>
std::vector<Parameter> listed() {
  constexpr auto parameters = parameters_of(table);
  return {parameters.begin(), parameters.end()};
}

}  // namespace

FieldType centricity_type() {
  return {"centricity",
          "Mean or maximum geodesic distance to all other points: small in a shape's middle, large at its ends.",
          listed<centricity_field_table>(), centricity_field};
}

FieldType heat_kernel_type() {
  return {"heat_kernel",
          "Heat kernel signature at one time: heat that remains at a point, relative to an even distribution.",
          listed<heat_kernel_table>(), heat_kernel_field};
}

FieldType scale_invariant_type() {
  return {"scale_invariant_heat_kernel", "One coefficient of the scale-invariant heat kernel signature.",
          listed<scale_invariant_table>(), scale_invariant_field};
}

FieldType wave_kernel_type() {
  return {"wave_kernel", "Wave kernel signature at one energy.", listed<wave_kernel_field_table>(), wave_kernel_field};
}

}  // namespace shapegauge
