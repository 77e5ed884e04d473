// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <string>

#include "shapegauge/core/io/shape_file.h"
#include "tests/app/program.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge::test_command_line {

namespace {

namespace fs = std::filesystem;
using test::write_text;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A box of six quadrilaterals, and a mesh of triangles.
class FileMessages : public CommandTest {
 protected:
  void SetUp() override {
    write_text(at("quads.off"),
               "OFF\n8 6 0\n0 0 0\n1 0 0\n1 2 0\n0 2 0\n0 0 9\n1 0 9\n1 2 9\n0 2 9\n"
               "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
    for (const char* const name : {"ball.off", "ball.obj", "ball.ply", "ball.stl"}) {
      shape_writer(at(name))(at(name), test::sphere(1, 1), {});
    }
  }
};

TEST_F(FileMessages, StateTheNumbersOfPolygonsAndOfTheirTriangles) {
  const Outcome sdf =
      succeeded(run_executable(fmt::format("sdf {} --method cone_sdf -o {}", quoted("quads.off"), quoted("q.csv"))));
  EXPECT_THAT(sdf.errors, AllOf(HasSubstr("6 faces"), HasSubstr("12 triangles")));
  EXPECT_THAT(test::text_of(at("q.csv")), StartsWith("index,sdf,weight,polygon\n"));
  EXPECT_THAT(test::text_of(at("q.csv")), HasSubstr("\n11,"));

  const Outcome parts =
      succeeded(run_executable(fmt::format("segment {} -o {}", quoted("quads.off"), quoted("q.seg"))));
  EXPECT_THAT(parts.errors, HasSubstr("6 faces"));
  const std::string rows = test::text_of(at("q.seg"));
  EXPECT_EQ(std::ranges::count(rows, '\n'), 6) << "as many as the file has faces";

  EXPECT_THAT(run("info @quads.off").output, testing::ContainsRegex("polygons +6\n"));
}

TEST_F(FileMessages, ReportALinkToItselfInOneLine) {
  fs::create_directory(at("data"));
  for (const char* const name : {"data/test.cla", "loop.npy", "loop.json"}) {
    fs::create_symlink(fs::path(name).filename(), at(name));
  }
  expect_error_lines(
      {{"dataset info " + quoted("data"), "cannot read " + at("data/test.cla").string() + ": Too many levels"},
       {"rerank " + quoted("loop.npy") + " -o " + quoted("x.npy"),
        "cannot read " + at("loop.npy").string() + ": Too many levels"},
       {"run " + quoted("loop.json"), at("loop.json").string() + ": no such file, or it cannot be read"}});
}

TEST_F(FileMessages, DoNotMentionPolygonsForTriangleMeshes) {
  const Outcome sdf =
      run_executable(fmt::format("sdf {} --method cone_sdf -o {}", quoted("ball.off"), quoted("b.csv")));
  EXPECT_THAT(sdf.errors, Not(HasSubstr("polygon")));
  EXPECT_THAT(test::text_of(at("b.csv")), StartsWith("index,sdf,weight\n"));
  EXPECT_THAT(run("info @ball.off").output, Not(HasSubstr("polygon")));
}

TEST_F(FileMessages, StandardInputFormatIsRecognisedFromItsContent) {
  for (const char* const name : {"ball.off", "ball.obj", "ball.ply", "ball.stl"}) {
    const Outcome outcome = run_executable("info - < " + quoted(name));
    EXPECT_EQ(outcome.status, 0) << name << outcome.errors;
    EXPECT_EQ(outcome.output, run_executable("info " + quoted(name)).output) << name;
  }
  write_text(at("cloud"), "0 0 0 1\n1 0.5 0 1\n0 1 0 1\n0 0 1 1\n");
  EXPECT_EQ(run("info - < @cloud").status, 0);
  EXPECT_EQ(run("info @cloud").status, 0) << "so is a file without an extension";
}

TEST_F(FileMessages, SuggestTheFormatOptionForUnrecognisedStandardInput) {
  write_text(at("bare"), "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");  // OFF without its keyword
  expect_error_line(run("info - < @bare"), "--input-format");
  EXPECT_EQ(run("info - --input-format off < @bare").status, 0);
}

TEST_F(FileMessages, EscapeControlCharactersOfFileNames) {
  const std::string name =
      "a\x1b[31m\xC2\x9B"
      "7m.off";
  write_text(at(name), "OFF\n3 1 0\n0 0 0\n");
  write_text(at("classes/cl\x1b[31mass/1.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  write_text(at("classes/cl\x1b[31mass/2.off"), "");
  for (const std::string& arguments : {"info " + quoted(name), "info " + quoted(name) + " " + quoted("absent\x1b.off"),
                                       "dataset info " + quoted("classes"), "dataset validate " + quoted("classes")}) {
    const Outcome outcome = run_executable(arguments);
    EXPECT_NE(outcome.status, 0);
    for (const std::string& text : {outcome.output, outcome.errors}) {
      EXPECT_THAT(text, AllOf(Not(HasSubstr("\x1b")), Not(HasSubstr("\xC2\x9B")))) << arguments;
    }
    EXPECT_THAT(outcome.output + outcome.errors, HasSubstr("?[31m")) << arguments;
  }
}

TEST_F(FileMessages, NameCircularLinksWhileOtherFilesAreProcessed) {
  for (const char* const name : {"ant/1.off", "ant/2.off", "bee/1.off", "bee/2.off"}) {
    fs::create_directories(at("data") / fs::path(name).parent_path());
    fs::copy_file(at("ball.off"), at("data") / name);
  }
  fs::create_symlink("loop.off", at("data/ant/loop.off"));
  fs::create_symlink("gone", at("data/gone"));
  const Outcome info = run("dataset info @data");
  EXPECT_EQ(info.status, 1);
  EXPECT_THAT(info.output, HasSubstr("6 models in 3 classes, 2 of them unusable"));
  EXPECT_THAT(info.errors, AllOf(HasSubstr("ant/loop.off"), HasSubstr("data/gone")));

  write_text(at("run.json"), R"({"name": "x", "dataset": {"layout": "folders", "root": "data"}, "on_error": "skip",
    "signatures": [{"name": "s", "field": {"type": "cone_sdf"}, "histogram": {"range": "per-shape"}}]})");
  const Outcome run = run_executable(fmt::format("run {} --no-cache --output {}", quoted("run.json"), quoted("out")));
  EXPECT_EQ(run.status, 1) << run.errors;
  EXPECT_THAT(run.errors, AllOf(HasSubstr("ant/loop"), HasSubstr("gone"), HasSubstr("2 of 6 models")));
}

}  // namespace

}  // namespace shapegauge::test_command_line
