// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <gmock/gmock.h>
#include <string>
#include <vector>

#include "shapegauge/core/io/formats.h"
#include "tests/app/program.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge::test_command_line {

namespace {

namespace fs = std::filesystem;
using test::text_of;
using test::write_text;
using testing::HasSubstr;

/// A command that writes a file. Words that begin with @ are paths in the folder.
struct WriterOfFiles {
  std::string call;     ///< without the output, which comes last
  std::string input;    ///< one of the files that are read
  std::string output;   ///< a name with the extension of its format
  bool shapes = false;  ///< --replace lets the output take the place of its input
};

/// All outputs of all commands whose file name is given by users.
std::vector<WriterOfFiles> writers() {
  const std::string evaluate = "evaluate @d.csv --labels @classes.csv ";
  return {{.call = evaluate + "--pr", .input = "d.csv", .output = "x.csv"},
          {.call = evaluate + "--pr", .input = "classes.csv", .output = "x.plot"},
          {.call = evaluate + "--pr-per-class", .input = "d.csv", .output = "x.csv"},
          {.call = evaluate + "--per-query", .input = "d.csv", .output = "x.csv"},
          {.call = evaluate + "--per-class", .input = "classes.csv", .output = "x.csv"},
          {.call = evaluate + "--report", .input = "d.csv", .output = "x.html"},
          {.call = "rerank @d.csv -o", .input = "d.csv", .output = "x.csv"},
          {.call = "rerank @d.csv -o", .input = "d.csv", .output = "x.npy"},
          {.call = "describe @box.off --descriptor d2 --set points=64 -o", .input = "box.off", .output = "x.csv"},
          {.call = "view @box.off --no-parts --field cone_sdf -o", .input = "box.off", .output = "x.html"},
          {.call = "sdf @box.off --method cone_sdf -o @y.csv --timings", .input = "box.off", .output = "x.json"},
          {.call = "sdf @box.off --method cone_sdf -o", .input = "box.off", .output = "x.csv", .shapes = true},
          {.call = "normals @box.off --offset 0.1 -o", .input = "box.off", .output = "x.csv", .shapes = true},
          {.call = "perturb @box.off --noise 0.01 -o", .input = "box.off", .output = "x.off", .shapes = true},
          {.call = "convert @box.off -o", .input = "box.off", .output = "x.ply", .shapes = true},
          {.call = "segment @box.off --parts 1 -o", .input = "box.off", .output = "x.seg", .shapes = true},
          {.call = "evaluate-segmentation @mine --benchmark @psb --per-mesh", .input = "", .output = "x.csv"}};
}

class OutputFiles : public CommandTest {
 protected:
  void SetUp() override {
    write_off(at("box.off"), test::box({1, 2, 3}, 1));
    write_text(at("d.csv"), "id,p,q,r,s\np,0,1,2,3\nq,1,0,3,2\nr,2,3,0,1\ns,3,2,1,0\n");
    write_text(at("classes.csv"), "id,class\np,a\nq,a\nr,b\ns,b\n");
    for (const char* folder : {"psb/off", "psb/seg/1", "mine"}) fs::create_directories(at(folder));
    fs::copy_file(at("box.off"), at("psb/off/1.off"));
    for (const char* file : {"psb/seg/1/1_0.seg", "mine/1.seg"}) {
      std::string labels;
      for (int i = 0; i < 12; ++i) labels += "0\n";
      write_text(at(file), labels);
    }
  }
  void remove_outputs() const {
    for (const char* name : {"x.csv", "x.plot", "x.html", "x.npy", "x.json", "x.off", "x.ply", "x.seg", "y.csv"}) {
      fs::remove(at(name));
    }
  }
};

TEST_F(OutputFiles, MustHaveANonEmptyName) {
  const std::string evaluate = "evaluate @d.csv --labels @classes.csv ";
  for (const char* option : {"--report", "--pr", "--per-query", "--ids", "--targets"}) {
    expect_error_line(run(evaluate + option + " ''"), std::string(option) + ": must not be empty");
    expect_error_line(run(evaluate + option + "="), option);
  }
  expect_error_line(run("run @d.csv -o ''"), "--output: must not be empty");
  expect_error_line(run("search @box.off ''"), "paths: must not be empty");
  expect_error_line(run("rerank '' -o @x.npy"), "distances: must not be empty");
}

TEST_F(OutputFiles, ReplaceExistingFilesOnlyOnRequest) {
  for (const WriterOfFiles& writer : writers()) {
    SCOPED_TRACE(writer.call);
    remove_outputs();
    const std::string call = writer.call + " @" + writer.output;
    write_text(at(writer.output), "mine");
    expect_error_line(run(call), "--replace");
    EXPECT_EQ(text_of(at(writer.output)), "mine");
    EXPECT_FALSE(fs::exists(at("y.csv"))) << "done before any work";
    succeeded(run(call + " --replace"));
    EXPECT_NE(text_of(at(writer.output)), "mine");
  }
}

TEST_F(OutputFiles, AreRejectedIfTheyAreLinksToInputs) {
  for (const WriterOfFiles& writer : writers()) {
    if (writer.input.empty()) continue;
    SCOPED_TRACE(writer.call);
    remove_outputs();
    const std::string before = text_of(at(writer.input));
    const std::string replace = writer.shapes ? "" : " --replace";
    fs::create_symlink(at(writer.input), at(writer.output));
    expect_error_line(run(writer.call + " @" + writer.output + replace), "would overwrite the input");
    fs::remove(at(writer.output));
    fs::create_hard_link(at(writer.input), at(writer.output));
    expect_error_line(run(writer.call + " @mine/../" + writer.output + replace), "would overwrite the input");
    EXPECT_EQ(text_of(at(writer.input)), before);
  }
}

TEST_F(OutputFiles, MustHaveDifferentPaths) {
  const std::string evaluate = "evaluate @d.csv --labels @classes.csv ";
  expect_error_line(run(evaluate + "--per-query @x.csv --per-class @mine/../x.csv"), "would both be written to");
  fs::create_symlink(at("x.csv"), at("link.csv"));  // to a file that does not exist yet
  expect_error_line(run(evaluate + "--pr @x.csv --pr-per-class @link.csv --replace"), "would both be written to");
  fs::create_symlink(at("z.json"), at("z.csv"));
  expect_error_line(run("sdf @box.off --method cone_sdf -o @z.csv --timings @z.json"), "would both be written to");
  EXPECT_FALSE(fs::exists(at("x.csv")));
  EXPECT_FALSE(fs::exists(at("z.json")));
}

TEST_F(OutputFiles, MustHaveTheExtensionOfTheirFormat) {
  const std::string evaluate = "evaluate @d.csv --labels @classes.csv ";
  for (const auto& [call, possible] : std::vector<std::pair<std::string, std::string>>{
           {evaluate + "--pr @curve.pdf", ".csv or .plot"},
           {evaluate + "--pr-per-class @x.plot", ".csv"},
           {evaluate + "--per-query @x.xlsx", ".csv"},
           {evaluate + "--per-class @x.json", ".csv"},
           {evaluate + "--report @x.pdf", ".html"},
           {"rerank @d.csv -o @x.pdf", ".npy"},
           {"describe @box.off --descriptor d2 -o @x.pdf", ".npy"},
           {"view @box.off -o @x.pdf", ".html"},
           {"sdf @box.off --method cone_sdf -o @x.pdf", ".csv"},
           {"sdf @box.off --method cone_sdf -o @x.csv --timings @x.pdf", ".json"},
           {"normals @box.off -o @x.pdf", ".csv"},
           {"perturb @box.off --noise 0.01 -o @x.pdf", ".off"},
           {"convert @box.off -o @x.pdf", ".off"},
           {"segment @box.off -o @x.pdf", ".seg"},
           {"evaluate-segmentation @mine --benchmark @psb --per-mesh @x.pdf", ".csv"}}) {
    SCOPED_TRACE(call);
    expect_error_line(run(call), possible);
  }
  for (const auto& entry : fs::directory_iterator(at(""))) {
    EXPECT_NE(entry.path().extension(), ".pdf");
  }
  EXPECT_EQ(run(evaluate + "--pr @X.PLOT --per-query @scores").status, 0);
  EXPECT_THAT(text_of(at("X.PLOT")), HasSubstr("0.050000\t"));
}

TEST_F(OutputFiles, UseEachStandardStreamAtMostOnce) {
  const std::string evaluate = "evaluate @d.csv --labels @classes.csv --measures NN ";
  expect_error_line(run(evaluate + "--per-query -"), "not standard output");
  expect_error_line(run("evaluate - --labels - < @d.csv"), "once only");
  const Outcome to_device =
      succeeded(run(evaluate + "--per-query /dev/stdout --pr /dev/null --pr-per-class /dev/null"));
  EXPECT_THAT(to_device.output, HasSubstr("d,psb,p,a,100\n"));
}

}  // namespace

}  // namespace shapegauge::test_command_line
