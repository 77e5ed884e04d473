// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/io/file_bytes.h"
#include "tests/core/io/largest_allocation.h"
#include "tests/fuzz/fuzz_targets.h"

namespace shapegauge::fuzz {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

struct Target {
  std::string_view name;  // name of the folders in seeds and regressions
  bool (*run)(std::string_view bytes);
};

constexpr std::array targets = {Target{"read_off", read_off},
                                Target{"read_obj", read_obj},
                                Target{"read_ply", read_ply},
                                Target{"read_stl", read_stl},
                                Target{"read_gltf", read_gltf},
                                Target{"shape_sdf", shape_sdf},
                                Target{"classification", classification},
                                Target{"npy", npy},
                                Target{"text_matrix", text_matrix},
                                Target{"csv_matrix", csv_matrix},
                                Target{"psb_matrix", psb_matrix},
                                Target{"npy_table", npy_table},
                                Target{"npy_strings", npy_strings},
                                Target{"csv_table", csv_table},
                                Target{"trec_run", trec_run},
                                Target{"ranked_lists", ranked_lists},
                                Target{"qrels", qrels},
                                Target{"seg", seg},
                                Target{"configuration", configuration}};

class FuzzCorpus : public ::testing::TestWithParam<Target> {
 protected:
  static std::vector<fs::path> files(const char* kind) {
    return files_in(fs::path(SHAPEGAUGE_SOURCE_FOLDER "/tests/fuzz") / kind / GetParam().name);
  }

  /// Whether the target accepts the file. Memory is bounded here, time by CTest.
  static bool run(const fs::path& file) {
    SCOPED_TRACE(file);
    const std::string bytes = read_file_bytes(file);
    bool accepted = false;
    test::reset_largest_allocation();
    EXPECT_NO_THROW(accepted = GetParam().run(bytes));
    // The offset SDF has a fixed bound; readers one proportional to the file.
    const std::size_t limit = GetParam().run == shape_sdf ? 200'000'000 : 200'000 + 100 * bytes.size();
    EXPECT_LT(test::largest_allocation(), limit);
    return accepted;
  }
};

TEST_P(FuzzCorpus, SeedsAreReadWithoutError) {
  const std::vector<fs::path> seeds = files("seeds");
  ASSERT_FALSE(seeds.empty());
  for (const fs::path& file : seeds) EXPECT_TRUE(run(file)) << file;
}

TEST_P(FuzzCorpus, RegressionInputsGiveResultsOrInputErrors) {
  for (const fs::path& file : files("regressions")) run(file);
}

INSTANTIATE_TEST_SUITE_P(Targets, FuzzCorpus, ::testing::ValuesIn(targets),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace shapegauge::fuzz
