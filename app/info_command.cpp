#include "app/info_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>

#include "app/options.h"
#include "app/run_program.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/experiments/results/shape_tables.h"

namespace shapegauge {

namespace {

struct InfoArguments {
  std::filesystem::path input;
  std::string format = "text";
};

int run(const InfoArguments& arguments) {
  const nlohmann::ordered_json found = diagnostics_json(diagnose(read_shape(arguments.input)));
  if (arguments.format == "json") {
    fmt::print("{}\n", found.dump(2));
    return exit_success;
  }
  for (const auto& [name, value] : found.items()) {
    std::string words = name;
    std::ranges::replace(words, '_', ' ');
    const std::string text = value.is_boolean() ? (value.get<bool>() ? "yes" : "no") : value.dump();
    fmt::print("{:<24}{}\n", words, text);
  }
  return exit_success;
}

}  // namespace

void add_info_command(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("info", "Tell whether a shape is closed, of how many parts, and what is wrong with it");
  command->footer("Example: shapegauge info bunny.off");
  const auto arguments = std::make_shared<InfoArguments>();
  add_shape_argument(*command, arguments->input);
  command->add_option("--format", arguments->format, "text or json; lengths and areas are in the file's units")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace shapegauge
