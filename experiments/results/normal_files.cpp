#include "shapegauge/experiments/results/normal_files.h"

#include <fmt/format.h>
#include <iterator>
#include <string>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/atomic_file.h"
#include "shapegauge/core/io/write_ply.h"
#include "shapegauge/experiments/matrices/npy.h"
#include "shapegauge/experiments/text/lower_case.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

void write_csv(const fs::path& path, const Shape& /*shape*/, const Samples& samples, const Points& normals) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "index,nx,ny,nz,weight\n");
  for (Eigen::Index i = 0; i < normals.rows(); ++i) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", i, normals(i, 0), normals(i, 1), normals(i, 2),
                   samples.weights[i]);
  }
  write_file_atomically(path, {text.data(), text.size()});
}

void write_array(const fs::path& path, const Shape& /*shape*/, const Samples& /*samples*/, const Points& normals) {
  write_npy(path, normals);
}

void write_shape_with_normals(const fs::path& path, const Shape& shape, const Samples& samples, const Points& normals) {
  write_ply(path, shape, samples.site, normals);
}

void write_cloud(const fs::path& path, const Shape& /*shape*/, const Samples& samples, const Points& normals) {
  fmt::memory_buffer text;
  for (Eigen::Index i = 0; i < normals.rows(); ++i) {
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {}\n", samples.points(i, 0), samples.points(i, 1),
                   samples.points(i, 2), normals(i, 0), normals(i, 1), normals(i, 2));
  }
  write_file_atomically(path, {text.data(), text.size()});
}

}  // namespace

NormalFileWriter normal_file_writer(const fs::path& path) {
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".csv") return write_csv;
  if (extension == ".npy") return write_array;
  if (extension == ".ply") return write_shape_with_normals;
  if (extension == ".xyz") return write_cloud;
  throw InputError(fmt::format("cannot write {}: the name must end in .csv, .npy, .ply or .xyz", path.string()));
}

}  // namespace shapegauge
