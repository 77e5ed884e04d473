#include "shapegauge/experiments/results/field_files.h"

#include <fmt/format.h>
#include <iterator>
#include <string>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/ply.h"
#include "shapegauge/core/render/image.h"
#include "shapegauge/core/render/render_shape.h"
#include "shapegauge/core/shape/polygons.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/pages/shape_view.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

std::vector<Colour> colours(const Samples& samples, const Eigen::VectorXd& values) {
  const Interval range = central_range({.values = values, .weights = samples.weights}).value_or(Interval{});
  return colours_of(values, range.low, range.high);
}

/// Whether rows of samples name the polygons of the file that they lie on.
bool names_polygons(const Shape& shape, const Samples& samples) {
  return samples.site == SampleSite::faces && has_polygons(shape);
}

void write_csv(const fs::path& path, const Shape& shape, const Samples& samples, const Eigen::VectorXd& values) {
  const bool polygons = names_polygons(shape, samples);
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "index,sdf,weight{}\n", polygons ? ",polygon" : "");
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{},{},{}", i, values[i], samples.weights[i]);
    if (polygons) fmt::format_to(std::back_inserter(text), ",{}", polygon_of(shape, i));
    text.push_back('\n');
  }
  write_file_atomically(path, {text.data(), text.size()});
}

void write_values(const fs::path& path, const Shape& /*shape*/, const Samples& /*samples*/,
                  const Eigen::VectorXd& values) {
  write_npy_vector(path, values);
}

void write_coloured_shape(const fs::path& path, const Shape& shape, const Samples& samples,
                          const Eigen::VectorXd& values) {
  write_ply(path, shape, samples.site, values, colours(samples, values));
}

void write_normals_csv(const fs::path& path, const Shape& shape, const Samples& samples, const Points& normals) {
  const bool polygons = names_polygons(shape, samples);
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "index,nx,ny,nz,weight{}\n", polygons ? ",polygon" : "");
  for (Eigen::Index i = 0; i < normals.rows(); ++i) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{}", i, normals(i, 0), normals(i, 1), normals(i, 2),
                   samples.weights[i]);
    if (polygons) fmt::format_to(std::back_inserter(text), ",{}", polygon_of(shape, i));
    text.push_back('\n');
  }
  write_file_atomically(path, {text.data(), text.size()});
}

void write_normals_npy(const fs::path& path, const Shape& /*shape*/, const Samples& /*samples*/,
                       const Points& normals) {
  write_npy(path, normals);
}

void write_normals_ply(const fs::path& path, const Shape& shape, const Samples& samples, const Points& normals) {
  write_ply(path, shape, samples.site, normals);
}

void write_normals_xyz(const fs::path& path, const Shape& /*shape*/, const Samples& samples, const Points& normals) {
  fmt::memory_buffer text;
  for (Eigen::Index i = 0; i < normals.rows(); ++i) {
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {}\n", samples.points(i, 0), samples.points(i, 1),
                   samples.points(i, 2), normals(i, 0), normals(i, 1), normals(i, 2));
  }
  write_file_atomically(path, {text.data(), text.size()});
}

}  // namespace

FieldFileWriter field_file_writer(const fs::path& path, const FieldPicture& picture) {
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".csv") return write_csv;
  if (extension == ".npy") return write_values;
  if (extension == ".ply") return write_coloured_shape;
  if (extension == ".png") {
    return [picture](const fs::path& file, const Shape& shape, const Samples& samples, const Eigen::VectorXd& values) {
      const RenderOptions view = picture.principal ? principal_view(shape, picture.render) : picture.render;
      write_png(file, render_shape(shape, colours(samples, values), samples.site, view));
    };
  }
  throw InputError(fmt::format("cannot write {}: the name must end in .csv, .npy, .ply or .png", path.string()));
}

NormalFileWriter normal_file_writer(const fs::path& path) {
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".csv") return write_normals_csv;
  if (extension == ".npy") return write_normals_npy;
  if (extension == ".ply") return write_normals_ply;
  if (extension == ".xyz") return write_normals_xyz;
  throw InputError(fmt::format("cannot write {}: the name must end in .csv, .npy, .ply or .xyz", path.string()));
}

}  // namespace shapegauge
