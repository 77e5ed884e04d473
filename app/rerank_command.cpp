// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <chrono>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/parameter_options.h"
#include "app/terminal.h"
#include "shapegauge/core/base/cancellation.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/little_endian.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/output_files.h"
#include "shapegauge/datasets/files/matrix_files.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/datasets/files/open_matrix.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/evaluation/evaluation_warnings.h"
#include "shapegauge/retrieval/diffusion.h"
#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

struct RerankArguments {
  fs::path distances;
  fs::path output;
  std::string method = "diffusion";
  ParameterTexts settings;
  bool sparse = false;
  bool replace = false;
  int threads = 0;
};

/// Number of models above which the sparse solver is used, and the matrix need not be in memory.
constexpr Eigen::Index max_dense = 5000;

/// Runs the work until Ctrl-C, after catch_interruption(). Throws Interrupted.
void run_until_interrupted(const std::function<void()>& work) {
  Cancellation cancellation;
  const std::jthread watch([&](const std::stop_token& done) {
    while (!done.stop_requested() && !interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (!done.stop_requested()) cancellation.cancel();
  });
  cancellation.run(work);
}

/// Diffuses a matrix of any size into a .npy file in blocks of rows. Throws Interrupted.
void diffuse_file(const OpenMatrix& matrix, const DiffusionOptions& options, const fs::path& output) {
  const auto size = static_cast<std::size_t>(matrix.rows);
  catch_interruption();  // an interruption from now on leaves no unfinished file
  AtomicFile file(output);
  file.write(npy_header_of_matrix(size, size));
  const RowSource rows = [&](Eigen::Index first, Eigen::Index count) {
    return matrix.read({.first_row = first, .rows = count, .first_column = 0, .columns = matrix.columns});
  };
  run_until_interrupted([&] {
    diffuse(matrix.rows, rows, options, [&](Eigen::Index /*first*/, const DistanceMatrix& block) {
      std::string bytes;
      for (const double distance : block.reshaped<Eigen::RowMajor>()) append_little_endian(bytes, distance);
      file.write(bytes);
    });
  });
  file.publish();
}

int run(const RerankArguments& arguments) {
  const std::string format = lower_case(arguments.output.extension().string());
  if (format != ".npy" && format != ".csv") {
    throw InputError(fmt::format("distances are written as .npy or .csv, not to \"{}\"", arguments.output.string()));
  }
  const OutputFile output{.path = arguments.output, .what = "--output"};
  check_output_files({&arguments.distances, 1}, {&output, 1}, arguments.replace);
  const RerankMethod& method = rerank_methods().at(arguments.method);
  const ParameterValues values =
      parameter_values(method.parameters, arguments.settings, fmt::format("--method {}", method.name));
  const OpenMatrix matrix = open_matrix(arguments.distances, TableShape::square);
  const bool by_rows = arguments.sparse || (matrix.rows > max_dense && method.name == "diffusion" && format == ".npy");
  if (arguments.sparse && (method.name != "diffusion" || format != ".npy")) {
    throw InputError("--sparse requires --method diffusion and a .npy output");
  }
  try {
    if (by_rows) {
      diffuse_file(matrix, diffusion_options(values), arguments.output);
    } else {
      write_distance_matrix(arguments.output, method.rerank(whole_matrix(matrix), values), matrix.row_ids);
    }
  } catch (const ArgumentError& error) {
    throw InputError(fmt::format("{}: {}", arguments.distances.string(), error.what()));
  }
  for (const std::string& warning : rerank_warnings(matrix)) warn(warning);
  return exit_success;
}

/// Adds an option for each parameter of all methods.
void add_settings(CLI::App& command, RerankArguments& arguments) {
  std::map<std::string_view, std::pair<const Parameter*, std::string>> options;
  for (const RerankMethod& method : rerank_methods().entries()) {
    for (const Parameter& parameter : method.parameters) {
      auto& [any, meanings] = options[parameter.name];
      const bool has_same_values = any != nullptr && legal_values(*any) == legal_values(parameter);
      any = &parameter;
      const std::string meaning = has_same_values
                                      ? fmt::format("{} (default: {})", without_full_stop(parameter.description),
                                                    to_string(parameter.default_value))
                                      : parameter_help_text(parameter);
      meanings += fmt::format("{}{}: {}", meanings.empty() ? "" : "; ", method.name, meaning);
    }
  }
  for (const auto& [name, option] : options) {
    add_parameter_option(command, *option.first, arguments.settings[std::string(name)], "", option.second);
  }
}

}  // namespace

void add_rerank_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("rerank", "Re-rank distances, unsupervised, using the whole collection");
  command->footer(
      "Example: shapegauge rerank distances.npy -o better.npy --neighbours auto\nThe sparse solver reads .npy (C "
      "order) and .matrix files that do not fit into memory.");
  const auto arguments = std::make_shared<RerankArguments>();
  command
      ->add_option("distances", arguments->distances,
                   fmt::format("Square distance matrix: {}", fmt::join(matrix_extensions(), ", ")))
      ->required();
  begin_option_group(*command, output_options);
  command->add_option("-o,--output", arguments->output, "Output file: .npy, or .csv (with ids)")->required();
  add_replace_option(*command, arguments->replace);
  begin_option_group(*command, "Method");
  command
      ->add_option("--method", arguments->method,
                   "Method. diffusion: random walks between neighbours; k_reciprocal: overlap of mutual neighbours; "
                   "query_expansion: distances averaged over the nearest models")
      ->check(one_of(rerank_methods().names()))
      ->capture_default_str();
  add_settings(*command, *arguments);
  command->add_flag(
      "--sparse", arguments->sparse,
      "diffusion: Use the sparse solver, which needs less memory and writes .npy only (default for .npy above "
      "5,000 models)");
  add_threads_option(*command, arguments->threads);
  command->callback([arguments, &status] { with_threads(arguments->threads, [&] { status = run(*arguments); }); });
}

}  // namespace shapegauge
