// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/small_dataset.h"

#include <array>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge::test {

namespace fs = std::filesystem;

Shape small_shape(const std::string& name, int number) {
  const double more = 1 + 0.05 * number;
  if (name == "sphere") return test::sphere(more, 2);
  if (name == "box") return test::box({more, 1, 0.3}, 4);
  return test::capsule(0.2, 2 * more, 16, 6);
}

void write_small_dataset(const fs::path& folder) {
  fs::create_directories(folder);
  const std::array<std::string, 3> names{"sphere", "box", "capsule"};
  for (int i = 0; i < 9; ++i) {
    const std::string& name = names.at(static_cast<std::size_t>(i % 3));
    write_off(folder / ("T" + std::to_string(i) + ".off"), small_shape(name, i / 3));
  }
  write_text(folder / "test.cla", small_classification());
}

void replace_by_cloud(const std::filesystem::path& model) { write_off(model, {read_shape(model).vertices, {}, {}}); }

std::string small_classification() {
  return "PSB 1\n3 9\n\nsphere 0 3\n0\n3\n6\n\nbox 0 3\n1\n4\n7\n\ncapsule 0 3\n2\n5\n8\n";
}

nlohmann::json small_configuration(const fs::path& folder) {
  const nlohmann::json field{{"type", "cone_sdf"}};
  return {{"name", "small"},
          {"dataset", {{"layout", "shrec11"}, {"root", folder.string()}}},
          {"protocol", {"psb", "paper"}},
          {"signatures",
           {{{"name", "fixed"}, {"field", field}, {"histogram", {{"bins", 20}, {"range", {{"fixed", {0, 0.6}}}}}}},
            {{"name", "per shape"}, {"field", field}, {"histogram", {{"bins", 20}, {"range", "per-shape"}}}},
            {{"name", "data set"}, {"field", field}, {"histogram", {{"bins", 20}, {"range", "dataset"}}}},
            {{"name", "both"}, {"concatenate", {"fixed", "per shape"}}}}}};
}

}  // namespace shapegauge::test
