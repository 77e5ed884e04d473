// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <vector>

#include "tests/app/program.h"
#include "tests/support/test_files.h"

namespace shapegauge::test_command_line {

namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

class Program : public SmallRun {
 protected:
  /// Runs the executable with standard output to the file.
  [[nodiscard]] Outcome run_into(const std::string& file, const std::string& arguments) const {
    const std::string command =
        fmt::format("SHAPEGAUGE_CACHE= {} {} > {} 2> {}", executable_for_shell(), arguments, file, quoted("errors"));
    const int status = std::system(command.c_str());
    return {.status = WEXITSTATUS(status), .output = {}, .errors = test::text_of(at("errors"))};
  }
};

TEST_F(Program, HelpAndVersionGoToStandardOutput) {
  for (const std::string arguments : {"--help", "run --help", "sdf --help", "evaluate --help", "dataset --help",
                                      "dataset info --help", "dataset validate --help", "dataset generate --help"}) {
    const Outcome outcome = run_executable(arguments);
    EXPECT_EQ(outcome.status, 0) << arguments;
    EXPECT_THAT(outcome.output, HasSubstr("Example: shapegauge ")) << arguments;
    EXPECT_EQ(outcome.errors, "") << arguments;
  }
  EXPECT_EQ(run_executable("-V").output, run_executable("--version").output);
  EXPECT_THAT(run_executable("--version").output, MatchesRegex("shapegauge [0-9.]+ \\([0-9a-z-]+\\)\n"));
}

const std::vector<std::string> all_commands{"",
                                            "run",
                                            "sdf",
                                            "check",
                                            "normals",
                                            "info",
                                            "perturb",
                                            "convert",
                                            "segment",
                                            "view",
                                            "search",
                                            "describe",
                                            "distances",
                                            "rerank",
                                            "evaluate",
                                            "compare",
                                            "audit",
                                            "leaderboard",
                                            "evaluate-segmentation",
                                            "measures",
                                            "dataset info",
                                            "dataset validate",
                                            "dataset labels",
                                            "dataset generate",
                                            "cache",
                                            "completion"};

TEST_F(Program, HelpLinesFitTheTerminalAndShortHelpOmitsSomeOptions) {
  setenv("COLUMNS", "72", 1);
  for (const std::string& command : all_commands) {
    const std::string full = run_executable(command + " --help").output;
    std::istringstream help(full);
    for (std::string line; std::getline(help, line);) EXPECT_LE(line.size(), 72U) << line;
    const Outcome brief = run_executable(command + " -h");
    EXPECT_EQ(brief.status, 0) << command << brief.errors;
    EXPECT_LE(brief.output.size(), full.size()) << command;
  }
  unsetenv("COLUMNS");
  const std::string brief = run_executable("sdf -h").output;
  EXPECT_THAT(brief, testing::AllOf(HasSubstr("--offset"), testing::Not(HasSubstr("--opening-angle-degrees")),
                                    HasSubstr("All options: shapegauge sdf --help")));
}

TEST_F(Program, ShowsTheShortHelpIfTheCommandIsMissing) {
  for (const std::string command : {"", "dataset", "-q dataset"}) {
    const Outcome outcome = run_executable(command);
    EXPECT_EQ(outcome.status, 2) << command;
    EXPECT_EQ(outcome.output, run_executable(command + " -h").output);
    EXPECT_EQ(outcome.errors, "") << command;
  }
}

TEST_F(Program, NamesUnknownCommandsAndOptions) {
  expect_error_lines({{"--versoin", "there is no option --versoin; did you mean --version?"},
                      {"run --outptu x y.json", "there is no option --outptu; did you mean --output?"},
                      {"dataset info --clasification x y", "did you mean --classification?"},
                      {"sdf x.off --methd=cone", "did you mean --method?"},
                      {"--set name=1 run x.json", "--set must follow the command"},
                      {"run -x", "there is no option -x"},
                      {"rum", "there is no command \"rum\"; did you mean \"run\"?"},
                      {"dataset list x", "there is no command \"list\"; known here: \"info\""},
                      {"evaluate x.npy --ties exepcted", "there is no choice \"exepcted\"; did you mean \"expected\"?"},
                      {"-q rum", "there is no command \"rum\""}});
}

TEST_F(Program, OptionWithAListDoesNotConsumeTheNextArgument) {
  test::write_text(at("d.csv"), "0,1,2,3\n1,0,3,2\n2,3,0,1\n3,2,1,0\n");
  test::write_text(at("c.cla"), "PSB 1\n2 4\na 0 2\n0\n1\nb 0 2\n2\n3\n");
  const Outcome outcome =
      succeeded(run_executable("evaluate --labels " + quoted("c.cla") + " --measures NN,FT " + quoted("d.csv")));
  EXPECT_THAT(outcome.output, HasSubstr("FT"));
}

TEST_F(Program, HelpCommandPrintsTheHelpOfAnyCommand) {
  for (const std::string command : {"", "run", "dataset", "dataset info"}) {
    EXPECT_EQ(run_executable("help " + command).output, run_executable(command + " --help").output) << command;
  }
  EXPECT_THAT(run_executable("help").output, HasSubstr("143"));
}

TEST_F(Program, QuietOptionSuppressesNotesAndVerboseOptionAddsTheRunTime) {
  const std::string normals = "normals " + quoted("data/T0.off") + " --replace -o " + quoted("x.npy");
  EXPECT_THAT(run_executable(normals).errors, HasSubstr("offset: 1 % of the diagonal"));
  EXPECT_EQ(run_executable("-q " + normals).errors, "");
  EXPECT_EQ(run_executable(normals + " --quiet").errors, "");
  EXPECT_THAT(run_executable(normals + " -v").errors, MatchesRegex("(.|\n)*shapegauge normals took [0-9.]+ s\n"));
  EXPECT_EQ(run_executable(normals + " -v -q").status, 2);
}

TEST_F(Program, CompletionOffersCommandsOptionsAndChoices) {
  const auto complete = [&](const std::string& words, int position) {
    const std::string script = fmt::format(
        "bash -c 'source <({} completion bash); COMP_WORDS=({}); COMP_CWORD={}; _shapegauge; echo ${{COMPREPLY[@]}}' > "
        "{}",
        executable_for_shell(), words, position, quoted("completed"));
    EXPECT_EQ(std::system(script.c_str()), 0);
    return test::text_of(at("completed"));
  };
  EXPECT_EQ(complete("shapegauge norm", 1), "normals\n");
  EXPECT_EQ(complete("shapegauge dataset inf", 2), "info\n");
  EXPECT_EQ(complete("shapegauge run --rep", 2), "--replace --replay\n");
  EXPECT_EQ(complete("shapegauge sdf --method c", 3), "cone_sdf\n");
  EXPECT_THAT(run_executable("completion fish").output,
              HasSubstr("-n '__shapegauge_at sdf' -l method -x -a 'offset_sdf cone_sdf inscribed_ball' -d "));
  EXPECT_THAT(run_executable("completion zsh").output, HasSubstr("'*--method[offset"));
}

TEST_F(Program, WritesResultsIfTheErrorStreamIsClosed) {
  test::write_text(at("d.csv"), "0,1,1\n1,0,1\n1,1,0\n");  // ties cause a warning
  test::write_text(at("l.txt"), "a\na\nb\n");
  const auto status_with = [&](const std::string& arguments, const std::string& streams) {
    const std::string command = fmt::format("SHAPEGAUGE_CACHE= {} {} {}", executable_for_shell(), arguments, streams);
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  };
  struct Call {
    std::string arguments;
    int status;
    bool prints;  ///< on standard output
  };
  const std::vector<Call> calls = {
      {"evaluate " + quoted("d.csv") + " --labels " + quoted("l.txt"), 0, true},
      {"normals " + quoted("data/T0.off") + " -o " + quoted("x.npy") + " --replace", 0, false},
      {"sdf " + quoted("data/T0.off") + " " + quoted("absent.off") + " --method cone_sdf -o " + quoted("sdfs/") +
           " --replace",
       1, false},
      {"dataset info " + quoted("data"), 0, true},
      {"run " + quoted("absent.json"), 2, false},
      {"runn", 2, false},
      {"--help", 0, true}};
  for (const Call& call : calls) {
    for (const char* errors : {"2> /dev/full", "2>&-"}) {
      EXPECT_EQ(status_with(call.arguments, std::string("> /dev/null ") + errors), call.status) << call.arguments;
    }
    const int status = call.prints ? 2 : call.status;
    EXPECT_EQ(status_with(call.arguments, "> /dev/full 2> /dev/full"), status) << call.arguments;
    EXPECT_EQ(status_with(call.arguments, "<&- >&- 2>&-"), status) << call.arguments;
  }
}

TEST_F(Program, FailsButWritesResultFilesIfStandardOutputIsUnusable) {
  // If all streams are closed, the first files opened get their numbers, and would receive the messages.
  const std::string run = "run " + quoted("small.json") + " --set signatures.0.histogram.bins=1 --output ";
  ASSERT_EQ(run_executable(run + quoted("out")).status, 0);
  for (const char* streams : {">&- 2>&-", "<&- >&- 2>&-", "> /dev/full 2>&-"}) {
    const std::string command =
        fmt::format("SHAPEGAUGE_CACHE= {} {} {} {}", executable_for_shell(), run, quoted("again"), streams);
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 2) << streams;
    EXPECT_EQ(test::results_in(at("again")), test::results_in(at("out"))) << streams;
  }
}

TEST_F(Program, CompletesARunAfterABrokenPipe) {
  // Warnings about ties are written after the reader has closed the pipe.
  const std::string command = fmt::format(
      "bash -c \"SHAPEGAUGE_CACHE= {} run {} --set signatures.0.histogram.bins=1 --output {} 2>&1 > "
      "/dev/null | true; exit \\${{PIPESTATUS[0]}}\"",
      executable_for_shell(), quoted("small.json"), quoted("out"));
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_TRUE(std::filesystem::exists(at("out/manifest.json")));
}

TEST_F(Program, ShortOptionsHaveOneMeaningInAllCommands) {
  std::map<std::string, std::string> meanings;
  for (const std::string& command : all_commands) {
    const std::string help = run_executable(command + " --help").output;
    const std::regex names("(-[a-zA-Z]),(--[a-z-]+)");
    for (auto match = std::sregex_iterator(help.begin(), help.end(), names); match != std::sregex_iterator(); ++match) {
      const auto [known, is_new] = meanings.emplace((*match)[1], (*match)[2]);
      EXPECT_EQ(known->second, (*match)[2]) << command;
    }
  }
  EXPECT_EQ(meanings.at("-q"), "--quiet");
  EXPECT_EQ(meanings.at("-o"), "--output");
}

TEST_F(Program, ReportsAnErrorIfTheOutputDeviceIsFull) {
  test::write_text(at("d.csv"), "0,1,2,3\n1,0,3,2\n2,3,0,1\n3,2,1,0\n");
  test::write_text(at("c.cla"), "PSB 1\n2 4\na 0 2\n0\n1\nb 0 2\n2\n3\n");
  const std::string evaluate = " " + quoted("d.csv") + " --labels " + quoted("c.cla");
  for (const std::string& arguments : std::vector<std::string>{
           "--help", "--version", "measures", "info " + quoted("data/T0.off"),
           "convert " + quoted("data/T0.off") + " -o -", "completion bash", "dataset info " + quoted("data"),
           "dataset validate " + quoted("data"), "cache info --cache " + quoted("cache"), "evaluate" + evaluate,
           "compare" + evaluate + " " + quoted("d.csv"),
           "run " + quoted("small.json") + " --output " + quoted("out")}) {
    EXPECT_EQ(run_into("/dev/null", arguments).status, 0) << arguments;
    const Outcome outcome = run_into("/dev/full", arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_THAT(outcome.errors, HasSubstr("No space left on device")) << arguments;
  }
}

}  // namespace

}  // namespace shapegauge::test_command_line
