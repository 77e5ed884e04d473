// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/output_files.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CheckedOutputFiles : public test::FolderTest {
 protected:
  /// Returns the message of the check, with in.off and other.off as inputs; empty if it passes.
  [[nodiscard]] std::string refusal(const std::vector<OutputFile>& outputs, bool replace = false) const {
    try {
      check_output_files(std::vector{in_, other_}, outputs, replace);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }
  fs::path in_ = folder_.file("in.off", "OFF\n");
  fs::path other_ = folder_.file("other.off", "OFF\n");
};

TEST_F(CheckedOutputFiles, AreAcceptedIfTheyDoNotExist) {
  EXPECT_EQ(refusal({{.path = at("new.csv"), .what = "--output", .extensions = {".csv"}},
                     {.path = {}, .what = "--plot"},
                     {.path = at("absent/new.csv"), .what = "--table"}}),
            "");
  EXPECT_EQ(refusal({}), "");
}

TEST_F(CheckedOutputFiles, DoNotOverwriteFilesCreatedAfterTheCheck) {
  for (const bool replace : {false, true}) {
    const fs::path path = at(replace ? "replaced" : "new");
    ASSERT_EQ(refusal({{.path = path, .what = "--output"}}, replace), "");
    test::write_text(path, "theirs");
    const std::string error = test::input_error_of([&] { write_file_atomically(path, "ours"); });
    EXPECT_THAT(error, HasSubstr(replace ? "no error" : "exists"));
    EXPECT_EQ(test::text_of(path), replace ? "ours" : "theirs");
  }
}

TEST_F(CheckedOutputFiles, AreRejectedIfTheyWouldOverwriteAnotherInput) {
  for (const bool replace : {false, true}) {
    const std::string message = refusal({{.path = other_, .what = "--output"}}, replace);
    EXPECT_THAT(message, HasSubstr("--output would overwrite the input " + other_.string()));
    EXPECT_THAT(message, testing::Not(HasSubstr("`replace=true`")));
  }
}

TEST_F(CheckedOutputFiles, AreRecognisedAsAnInputBehindLinksAndOtherPaths) {
  fs::create_directory(at("folder"));
  fs::create_symlink("in.off", at("link.off"));
  fs::create_symlink("link.off", at("link_of_link.off"));
  fs::create_hard_link(in_, at("hard.off"));
  fs::create_directory_symlink(folder_.path(), at("folder/back"));
  for (const char* name :
       {"./in.off", "folder/../in.off", "link.off", "link_of_link.off", "hard.off", "folder/back/in.off"}) {
    EXPECT_THAT(refusal({{.path = at(name), .what = "--output"}}, true),
                HasSubstr("overwrite the input " + in_.string()))
        << name;
  }
}

TEST_F(CheckedOutputFiles, ReplaceTheirInputOnlyWithTheReplaceOption) {
  const OutputFile output{.path = in_, .what = "--output", .may_be_input = true};
  EXPECT_THAT(refusal({output}), HasSubstr("give it another name, or use `replace=true`"));
  EXPECT_EQ(refusal({output}, true), "");
}

TEST_F(CheckedOutputFiles, MustHaveDifferentPaths) {
  fs::create_directory(at("folder"));
  fs::create_symlink("new.csv", at("link.csv"));  // whose file does not exist yet
  for (const char* name : {"new.csv", "./new.csv", "folder/../new.csv", "link.csv"}) {
    EXPECT_THAT(refusal({{.path = at("new.csv"), .what = "--table"}, {.path = at(name), .what = "--plot"}}, true),
                HasSubstr("--table and --plot would both be written to"))
        << name;
  }
  EXPECT_EQ(refusal({{.path = at("new.csv"), .what = "--table"}, {.path = at("newer.csv"), .what = "--plot"}}), "");
}

TEST_F(CheckedOutputFiles, ReplaceExistingFilesOnlyOnRequest) {
  const fs::path old = folder_.file("old.csv", "1\n");
  EXPECT_THAT(refusal({{.path = old, .what = "--output"}}), HasSubstr("old.csv exists; give another name"));
  EXPECT_EQ(refusal({{.path = old, .what = "--output"}}, true), "");
  EXPECT_EQ(refusal({{.path = old, .what = "--index", .is_updated = true}}), "");
  EXPECT_THAT(refusal({{.path = folder_.path(), .what = "--output"}}), HasSubstr("is a folder; name a file"));
}

TEST_F(CheckedOutputFiles, MustHaveTheExtensionOfTheirFormat) {
  const auto named = [&](const char* name) {
    return refusal({{.path = at(name), .what = "--output", .extensions = {".csv", ".npy"}}});
  };
  EXPECT_THAT(named("new.txt"), HasSubstr("the name must end in .csv or .npy"));
  for (const char* name : {"new.npy", "new.CSV", "new"}) EXPECT_EQ(named(name), "") << name;
}

TEST_F(CheckedOutputFiles, UseEachStandardStreamAtMostOnce) {
  const OutputFile stream{.path = "-", .what = "--output", .takes_stream = true};
  EXPECT_EQ(refusal({stream}), "");
  EXPECT_THAT(refusal({{.path = "-", .what = "--plot"}}), HasSubstr("--plot must be a file, not standard output"));
  EXPECT_THAT(refusal({stream, {.path = "-", .what = "--table", .takes_stream = true}}),
              HasSubstr("--output and --table would both be written to standard output"));
  const std::vector<fs::path> twice{"-", "-"};
  EXPECT_THROW(check_output_files(twice, {}, false), InputError);
  EXPECT_EQ(refusal({{.path = "/dev/null", .what = "--output"}, {.path = "/dev/null", .what = "--plot"}}), "");
}

TEST(IsPage, IgnoresTheCaseOfTheHtmlExtension) {
  for (const char* page : {"a.html", "b.HTM"}) EXPECT_TRUE(is_page(page)) << page;
  for (const char* other : {"a.css", "html"}) EXPECT_FALSE(is_page(other)) << other;
}

}  // namespace

}  // namespace shapegauge
