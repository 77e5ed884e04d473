#include <gmock/gmock.h>

#include "shapegauge/experiments/results/result_folder.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/experiments/input_error.h"
#include "tests/experiments/text_files.h"

namespace shapegauge {
namespace {

using test_experiments::write_text;
using testing::HasSubstr;

const nlohmann::json mine{{"name", "mine"}};

std::string error_for(const std::filesystem::path& folder, bool replace = false) {
  return input_error_of([&] { prepare_result_folder(folder, mine, replace); });
}

TEST(ResultFolder, IsMadeWithThoseAbove) {
  const test_io::TemporaryFolder folder;
  EXPECT_EQ(error_for(folder.path() / "a/b"), "no error");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path() / "a/b"));
}

TEST(ResultFolder, OtherFilesDoNotMatter) {
  const test_io::TemporaryFolder folder;
  write_text(folder.path() / "notes.txt", "x");
  EXPECT_EQ(error_for(folder.path()), "no error");
}

TEST(ResultFolder, TheSameConfigurationMayRunAgain) {
  const test_io::TemporaryFolder folder;
  write_text(folder.path() / "manifest.json", R"({"configuration": {"name": "mine"}})");
  EXPECT_EQ(error_for(folder.path()), "no error");
}

TEST(ResultFolder, ResultsOfAnotherConfigurationAreKeptUnlessForced) {
  for (const std::string manifest : {R"({"configuration": {"name": "other"}})", "[]", "{"}) {
    const test_io::TemporaryFolder folder;
    write_text(folder.path() / "manifest.json", manifest);
    EXPECT_THAT(error_for(folder.path()), HasSubstr("holds the results of another configuration")) << manifest;
    EXPECT_EQ(error_for(folder.path(), true), "no error");
  }
  const test_io::TemporaryFolder folder;
  write_text(folder.path() / "summary.csv", "method\n");
  EXPECT_THAT(error_for(folder.path()), HasSubstr("--replace"));
}

TEST(ResultFolder, WhereNothingCanBeWrittenIsAnError) {
  const test_io::TemporaryFolder folder;
  write_text(folder.path() / "x", "a file");
  EXPECT_THAT(error_for(folder.path() / "x"), HasSubstr("cannot make the folder"));
  EXPECT_THAT(error_for(folder.path() / "x/y"), HasSubstr("cannot make the folder"));
  EXPECT_THAT(error_for("/proc/results"), HasSubstr("cannot"));
}

}  // namespace
}  // namespace shapegauge
