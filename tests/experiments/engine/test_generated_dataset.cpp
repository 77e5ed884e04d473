#include <gtest/gtest.h>
#include <string_view>

#include "shapegauge/core/base/error.h"
#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/engine/generated_dataset.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using test::text_of;

GeneratorOptions two_generated(std::uint64_t seed) {
  return {.classes = 1, .models_per_class = 2, .faces = 1000, .seed = seed};
}

/// How many models the call makes anew.
int models_made(std::uint64_t seed, const fs::path& folder) {
  int made = 0;
  RunControl control;
  control.progress = [&](std::string_view, std::size_t, std::size_t) { ++made; };
  prepare_generated(folder, two_generated(seed), control, *single_process());
  EXPECT_EQ(find_dataset({.layout = "shrec11", .root = folder, .classification = folder / "test.cla"}).models.size(),
            2U);
  return made;
}

TEST(PrepareGenerated, MakesADataSetOnceForTheSameSettings) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(models_made(1, folder.path() / "new"), 2);
  const std::string first = text_of(folder.path() / "new/T0.off");
  EXPECT_EQ(models_made(1, folder.path() / "new"), 0);
  EXPECT_EQ(models_made(2, folder.path() / "new"), 2);
  EXPECT_NE(text_of(folder.path() / "new/T0.off"), first);
}

TEST(PrepareGenerated, MakesAnewWhatAnInterruptionLeft) {
  const test::TemporaryFolder folder;
  RunControl control;
  control.interrupted = [] { return true; };
  EXPECT_THROW(prepare_generated(folder.path() / "new", two_generated(1), control, *single_process()), Interrupted);
  EXPECT_EQ(models_made(1, folder.path() / "new"), 2);
}

TEST(PrepareGenerated, DoesNotReplaceAnotherDataSet) {
  const test::TemporaryFolder folder;
  test::write_text(folder.path() / "T0.off", "mine");
  EXPECT_THROW(prepare_generated(folder.path(), two_generated(1), {}, *single_process()), InputError);
  EXPECT_EQ(text_of(folder.path() / "T0.off"), "mine");
}

}  // namespace

}  // namespace shapegauge
