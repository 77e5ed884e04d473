// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>
#include <rapidcheck/gtest.h>
#include <string>
#include <vector>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/render/image.h"
#include "tests/core/io/random_shapes.h"
#include "tests/support/test_files.h"

namespace shapegauge {
namespace {

using test::any_polygons;
using test::Polygons;
using test::shape_of;

/// Bitwise equality, including the sign of 0.
void require_identical(const Shape& actual, const Shape& expected) {
  RC_ASSERT(actual.vertices.rows() == expected.vertices.rows());
  RC_ASSERT(std::memcmp(actual.vertices.data(), expected.vertices.data(),
                        static_cast<std::size_t>(expected.vertices.size()) * sizeof(double)) == 0);
  RC_ASSERT(actual.triangles.rows() == expected.triangles.rows());
  RC_ASSERT(actual.triangles == expected.triangles);
}

RC_GTEST_PROP(RoundTrip, OfAnOffFileKeepsCoordinatesAndIndicesExactly, ()) {
  static const test::TemporaryFolder folder;
  const Shape shape = shape_of(*any_polygons(true));
  write_off(folder.path() / "t.off", shape);
  require_identical(read_shape(folder.path() / "t.off"), shape);
}

RC_GTEST_PROP(RoundTrip, OfAPlyFileKeepsCoordinatesAndIndicesExactly, ()) {
  static const test::TemporaryFolder folder;
  const Shape shape = shape_of(*any_polygons(true));
  const Eigen::Index samples = shape.vertices.rows();
  write_ply(folder.path() / "t.ply", shape, SampleSite::vertices, Eigen::VectorXd::Zero(samples),
            std::vector<std::array<std::uint8_t, 3>>(static_cast<std::size_t>(samples)));
  require_identical(read_shape(folder.path() / "t.ply"), shape);
}

RC_GTEST_PROP(RoundTrip, OfAnObjFileKeepsCoordinatesAndIndicesExactly, ()) {
  static const test::TemporaryFolder folder;
  const Shape shape = shape_of(*any_polygons(true));
  write_obj(folder.path() / "t.obj", shape);
  require_identical(read_shape(folder.path() / "t.obj"), shape);
}

/// STL preserves the order of triangle corners, and coordinates in single precision.
RC_GTEST_PROP(RoundTrip, OfAnStlFileKeepsCornersInSinglePrecision, ()) {
  static const test::TemporaryFolder folder;
  Shape shape = shape_of(*any_polygons(true));
  RC_PRE(shape.triangles.rows() > 0);
  shape.vertices = shape.vertices.unaryExpr([](double x) { return std::remainder(x, 1e30); });
  write_stl(folder.path() / "t.stl", shape);
  const Shape read = read_shape(folder.path() / "t.stl");
  RC_ASSERT(read.triangles.rows() == shape.triangles.rows());
  const auto corners = [](const Shape& s) -> Points {
    return s.vertices(s.triangles.reshaped<Eigen::RowMajor>(), Eigen::all);
  };
  RC_ASSERT(corners(read) == Points(corners(shape).cast<float>().cast<double>()));
  write_stl(folder.path() / "again.stl", read);
  RC_ASSERT(corners(read_shape(folder.path() / "again.stl")) == corners(read));
}

RC_GTEST_PROP(RoundTrip, OfAPointCloudKeepsCoordinatesAndNormalsExactly, ()) {
  static const test::TemporaryFolder folder;
  Shape cloud{(*any_polygons(true)).vertices, {}, {}};
  cloud.normals = Points::Zero(cloud.vertices.rows(), 3);
  for (Eigen::Index i = 0; i < cloud.normals.size(); ++i) cloud.normals.data()[i] = *rc::gen::inRange(-100, 101);
  cloud.normals.rowwise().normalize();
  write_off(folder.path() / "t.off", cloud);
  write_ply(folder.path() / "t.ply", cloud);
  write_obj(folder.path() / "t.obj", cloud);
  for (const char* name : {"t.off", "t.ply", "t.obj"}) {
    const Shape read = read_shape(folder.path() / name);
    require_identical(read, cloud);
    RC_ASSERT(read.normals == cloud.normals);
  }
}

/// Writes OFF with random variations of spacing, comments and keywords.
class RandomOffWriter {
 public:
  explicit RandomOffWriter(unsigned seed) : random_(seed) {}

  std::string write(const Polygons& polygons) {
    line_end_ = pick({"\n", "\r\n", "\r"});
    const std::string keyword = pick({"OFF", "COFF", "NOFF", "STOFF", "CNOFF", "STCNOFF", ""});
    text_ = pick({"", "\xEF\xBB\xBF"});
    maybe_clutter();
    text_ += keyword;
    if (keyword.empty() || coin()) {
      text_ += keyword.empty() ? "" : pick({"", " ", "\t"});  // the counts behind the keyword, perhaps glued to it
    } else {
      end_line("");
    }
    end_line(
        fmt::format("{} {}{}", polygons.vertices.rows(), polygons.faces.size(), pick({"", " 0", " 99999", " -1"})));
    const std::string vertex_extras = pick({"", " 255 0 0 255", " 0.5 1e-3 -1", " 1 2 3 4 5 6 7"});
    for (const auto& vertex : polygons.vertices.rowwise()) {
      end_line(number(vertex[0]) + space() + number(vertex[1]) + space() + number(vertex[2]) + vertex_extras);
    }
    const std::string face_extras = pick({"", " 3", " 255 0 0", " 0 0 0", " 0.1 0.2 0.3 0.4"});
    for (const auto& face : polygons.faces) {
      std::string line = fmt::format("{}", face.size());
      for (const std::int32_t vertex : face) line += space() + fmt::format("{}", vertex);
      end_line(line + face_extras);
    }
    return text_ + pick({"", "# the end", "\x1A", "some words\n"});
  }

 private:
  bool coin() { return std::uniform_int_distribution<int>(0, 1)(random_) == 1; }

  std::string pick(const std::vector<std::string>& choices) {
    return choices[std::uniform_int_distribution<std::size_t>(0, choices.size() - 1)(random_)];
  }

  std::string space() { return pick({" ", "  ", "\t", " \t "}); }

  std::string number(double x) {
    const std::string digits = pick({fmt::format("{}", x), fmt::format("{:.17e}", x), fmt::format("{:.16E}", x)});
    return digits.front() != '-' && coin() ? "+" + digits : digits;
  }

  void maybe_clutter() {
    text_ += pick({"", "", "", line_end_, "# 1 2 3" + line_end_, "  \t" + line_end_ + "#" + line_end_});
  }

  void end_line(const std::string& line) {
    text_ += pick({"", "", " "}) + line + pick({"", "", "  ", "\t# comment 1 2 3", "#"}) + line_end_;
    maybe_clutter();
  }

  std::mt19937 random_;
  std::string line_end_;
  std::string text_;
};

RC_GTEST_PROP(RoundTrip, OfAnOffFileKeepsNumbersWrittenWithAnySpacingAndNotation, (unsigned seed)) {
  const Polygons polygons = *any_polygons(false);
  const std::string text = RandomOffWriter(seed).write(polygons);
  RC_LOG(text);
  require_identical(read_off(text, "t.off"), shape_of(polygons));
}

}  // namespace
}  // namespace shapegauge
