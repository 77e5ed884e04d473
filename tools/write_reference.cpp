// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the generated files of the repository: configs/experiment.schema.json, docs/reference/commands.md and the
// lists of docs/reference/configuration.md. Run by the target update_reference.
//
//     write_reference REPOSITORY
//     write_reference REPOSITORY --check    says which of the files are not up to date, and fails
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/configuration/schema.h"
#include "shapegauge/experiments/kinds/experiment_kinds.h"
#include "tools/command_reference.h"

int main(int count, char** arguments) try {
  if (count < 2) throw shapegauge::InputError("usage: write_reference REPOSITORY [--check]");
  const std::filesystem::path repository = arguments[1];
  const std::filesystem::path page = repository / "docs/reference/configuration.md";
  CLI::App program;
  int status = shapegauge::exit_success;
  shapegauge::add_commands(program, status);
  const std::vector<std::pair<std::filesystem::path, std::string>> files{
      {repository / "docs/reference/commands.md", shapegauge::command_reference(program)},
      {repository / "configs/experiment.schema.json", shapegauge::experiment_schema()},
      {page, shapegauge::with_reference_lists(shapegauge::read_file_bytes(page))}};
  int outdated = 0;
  for (const auto& [path, text] : files) {
    if (count == 2) {
      shapegauge::write_file_atomically(path, text);
    } else if (!std::filesystem::exists(path) || shapegauge::read_file_bytes(path) != text) {
      std::fprintf(stderr, "%s: out of date; build the target update_reference\n", path.c_str());
      ++outdated;
    }
  }
  return outdated > 0 ? 1 : 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "write_reference: error: %s\n", error.what());
  return 1;
}
