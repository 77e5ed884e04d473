#include <gmock/gmock.h>

#include "shapegauge/experiments/runner/prepare_dataset.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/experiments/input_error.h"
#include "tests/experiments/text_files.h"

namespace shapegauge {
namespace {

namespace fs = std::filesystem;
using test_experiments::text_of;
using test_experiments::write_text;

Configuration generated(std::uint64_t seed) {
  Configuration configuration;
  configuration.generator = GeneratorOptions{.classes = 1, .models_per_class = 2, .faces = 1000, .seed = seed};
  return configuration;
}

/// How many models the call makes anew.
int models_made(const Configuration& configuration, const fs::path& folder) {
  int made = 0;
  RunControl control;
  control.progress = [&](std::string_view, std::size_t, std::size_t) { ++made; };
  const Dataset dataset = prepare_dataset(configuration, folder, control);
  EXPECT_EQ(dataset.models.size(), 2U);
  return made;
}

TEST(PrepareDataset, IsGeneratedOnceForTheSameSettings) {
  const test_io::TemporaryFolder folder;
  EXPECT_EQ(models_made(generated(1), folder.path() / "new"), 2);
  const std::string first = text_of(folder.path() / "new/T0.off");
  EXPECT_EQ(models_made(generated(1), folder.path() / "new"), 0);
  EXPECT_EQ(models_made(generated(2), folder.path() / "new"), 2);
  EXPECT_NE(text_of(folder.path() / "new/T0.off"), first);
}

TEST(PrepareDataset, WhatAnInterruptionLeftIsMadeAnew) {
  const test_io::TemporaryFolder folder;
  RunControl control;
  control.interrupted = [] { return true; };
  EXPECT_THROW(prepare_dataset(generated(1), folder.path() / "new", control), Interrupted);
  EXPECT_EQ(models_made(generated(1), folder.path() / "new"), 2);
}

TEST(PrepareDataset, AnotherDataSetIsNotReplaced) {
  const test_io::TemporaryFolder folder;
  write_text(folder.path() / "T0.off", "mine");
  EXPECT_NE(input_error_of([&] { prepare_dataset(generated(1), folder.path(), {}); }), "no error");
  EXPECT_EQ(text_of(folder.path() / "T0.off"), "mine");
}

}  // namespace
}  // namespace shapegauge
