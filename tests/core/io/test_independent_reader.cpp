// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/io/shape_file.h"
#include "tests/core/io/encoded_shapes.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

/// CGAL reads the same shape from the file.
namespace shapegauge {
namespace {

Shape read_by_cgal(const std::filesystem::path& path) {
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> triangles;
  EXPECT_TRUE(CGAL::IO::read_polygon_soup(path.string(), points, triangles));
  Shape shape{Points(static_cast<Eigen::Index>(points.size()), 3),
              Triangles(static_cast<Eigen::Index>(triangles.size()), 3)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    shape.vertices.row(static_cast<Eigen::Index>(i)) << points[i].x(), points[i].y(), points[i].z();
  }
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    EXPECT_EQ(triangles[f].size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) {
      shape.triangles(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>(k)) =
          static_cast<std::int32_t>(triangles[f].at(k));
    }
  }
  return shape;
}

void expect_as_cgal_reads(const std::filesystem::path& path) {
  SCOPED_TRACE(path);
  test::expect_same(read_shape(path), read_by_cgal(path));
}

TEST(CgalReader, ReadsTheSameMeshAsTheLibraryFromEveryFormat) {
  const test::TemporaryFolder folder;
  const Shape shape = test::torus(3, 1, 20, 30);
  for (const auto& [name, bytes, optional] : test::encoded_in_every_format(shape)) {
    if (name != "binary.off") expect_as_cgal_reads(folder.file(name, bytes));  // not supported by CGAL 5.5
  }
}

TEST(CgalReader, ReadsTheFilesWrittenByTheLibrary) {
  const test::TemporaryFolder folder;
  const Shape shape = test::torus(3, 1, 20, 30);
  for (const std::string_view extension : written_shape_extensions()) {
    const auto path = folder.path() / ("torus" + std::string(extension));
    shape_writer(path)(path, shape, {});
    expect_as_cgal_reads(path);
  }
}

TEST(CgalReader, ReadsTheSameMeshesAsTheLibraryFromBenchmarkFiles) {
  const char* const data = std::getenv("SHAPEGAUGE_DATA");
  if (data == nullptr) GTEST_SKIP() << "SHAPEGAUGE_DATA names no folder with real meshes";
  for (const int i : {0, 100, 200, 300, 400, 599}) {
    expect_as_cgal_reads(std::filesystem::path(data) / "shrec11_nonrigid" / ("T" + std::to_string(i) + ".off"));
  }
}

}  // namespace
}  // namespace shapegauge
