#include "shapegauge/core/io/write_ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <fmt/format.h>
#include <functional>
#include <string>
#include <string_view>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/atomic_file.h"
#include "shapegauge/core/io/writable_shape.h"

namespace shapegauge {

namespace {

/// What the samples at a site have besides their places.
struct SampleProperties {
  SampleSite site;
  std::string_view declaration;
  std::function<void(std::string& bytes, Eigen::Index sample)> append;
};

constexpr std::string_view normal_declaration = "property double nx\nproperty double ny\nproperty double nz\n";

std::string header_of(const Shape& shape, const SampleProperties* samples) {
  const auto properties_at = [&](SampleSite site) {
    return samples && samples->site == site ? samples->declaration : "";
  };
  std::string header = fmt::format(
      "ply\nformat binary_little_endian 1.0\n"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n{}{}",
      shape.vertices.rows(), has_cloud_normals(shape) ? normal_declaration : "", properties_at(SampleSite::vertices));
  if (!is_cloud(shape)) {
    header += fmt::format("element face {}\nproperty list uchar int vertex_indices\n{}", shape.triangles.rows(),
                          properties_at(SampleSite::faces));
  }
  return header + "end_header\n";
}

template <typename Number>
void append_little_endian(std::string& bytes, Number number) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(raw);
  bytes.append(raw.data(), raw.size());
}

void append_vector(std::string& bytes, const Eigen::RowVector3d& vector) {
  for (const double component : vector) append_little_endian(bytes, component);
}

/// The file, with samples where there are any.
void write(const std::filesystem::path& path, const Shape& shape, const SampleProperties* samples) {
  require_writable(path, shape);
  std::string bytes = header_of(shape, samples);
  const bool at_vertices = samples && samples->site == SampleSite::vertices;
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    append_vector(bytes, shape.vertices.row(i));
    if (has_cloud_normals(shape)) append_vector(bytes, shape.normals.row(i));
    if (at_vertices) samples->append(bytes, i);
  }
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    append_little_endian(bytes, std::uint8_t{3});
    for (int corner = 0; corner < 3; ++corner) append_little_endian(bytes, shape.triangles(f, corner));
    if (samples && !at_vertices) samples->append(bytes, f);
  }
  write_file_atomically(path, bytes);
}

Eigen::Index sample_count(const Shape& shape, SampleSite site) {
  return site == SampleSite::faces ? shape.triangles.rows() : shape.vertices.rows();
}

}  // namespace

void write_ply(const std::filesystem::path& path, const Shape& shape) { write(path, shape, nullptr); }

void write_ply(const std::filesystem::path& path, const Shape& shape, SampleSite site, const Eigen::VectorXd& values,
               const std::vector<Colour>& colours) {
  const Eigen::Index samples = sample_count(shape, site);
  if (values.size() != samples || colours.size() != static_cast<std::size_t>(samples)) {
    throw InputError(fmt::format("cannot write {}: {} values and {} colours for {} samples", path.string(),
                                 values.size(), colours.size(), samples));
  }
  const SampleProperties coloured{
      .site = site,
      .declaration = "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty double sdf\n",
      .append = [&](std::string& bytes, Eigen::Index i) {
        for (const std::uint8_t channel : colours[static_cast<std::size_t>(i)]) append_little_endian(bytes, channel);
        append_little_endian(bytes, values[i]);
      }};
  write(path, shape, &coloured);
}

void write_ply(const std::filesystem::path& path, Shape shape, SampleSite site, const Points& normals) {
  const Eigen::Index samples = sample_count(shape, site);
  if (normals.rows() != samples) {
    throw InputError(fmt::format("cannot write {}: {} normals for {} samples", path.string(), normals.rows(), samples));
  }
  shape.normals.resize(0, 3);
  const SampleProperties properties{
      .site = site, .declaration = normal_declaration, .append = [&](std::string& bytes, Eigen::Index i) {
        append_vector(bytes, normals.row(i));
      }};
  write(path, shape, &properties);
}

}  // namespace shapegauge
