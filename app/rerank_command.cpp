#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/options.h"
#include "app/output_files.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/matrix_files.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/configuration/parameter_json.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/retrieval/diffusion.h"
#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

struct RerankArguments {
  fs::path distances;
  fs::path output;
  std::string method = "diffusion";
  std::map<std::string, std::string> settings;  ///< by parameter; empty: not given
  bool sparse = false;
  bool replace = false;
  int threads = 0;
};

std::string option_name(std::string_view parameter) {
  std::string name = "--" + std::string(parameter);
  std::ranges::replace(name, '_', '-');
  return name;
}

/// A number, a word, or numbers between commas, as a configuration has them.
nlohmann::json setting_value(const Parameter& parameter, const std::string& text) {
  if (std::ranges::find(parameter.choices, text) != parameter.choices.end()) return text;
  nlohmann::json list = nlohmann::json::parse(fmt::format("[{}]", text), nullptr, false);
  const bool numbers = list.is_array() && !list.empty() &&
                       std::ranges::all_of(list, [](const nlohmann::json& value) { return value.is_number(); });
  const bool takes_lists = parameter.kind == ParameterKind::integers;
  if (!numbers || (list.size() > 1 && !takes_lists)) {
    throw InputError(fmt::format("{} is \"{}\"; it must be {}", option_name(parameter.name), text,
                                 takes_lists ? "a number, numbers between commas, or auto" : "a number"));
  }
  return list.size() == 1 ? list.front() : list;
}

/// The settings of the method. Throws InputError for one that is another method's.
ParameterValues values_of(const RerankArguments& arguments, const RerankMethod& method) {
  nlohmann::json given = nlohmann::json::object();
  for (const auto& [name, text] : arguments.settings) {
    if (text.empty()) continue;
    const auto parameter = std::ranges::find(method.parameters, name, &Parameter::name);
    if (parameter == method.parameters.end()) {
      throw InputError(fmt::format("{} does not go with --method {}", option_name(name), method.name));
    }
    given[name] = setting_value(*parameter, text);
  }
  return read_parameters(method.parameters, given);
}

/// Above so many models the whole matrix need not be in memory.
constexpr Eigen::Index most_dense = 5000;

/// Diffusion of a matrix of any size to a .npy file, some rows at a time.
void diffuse_file(const OpenMatrix& matrix, const DiffusionOptions& options, const fs::path& output) {
  const fs::path unfinished = output.string() + ".part";
  const auto size = static_cast<std::size_t>(matrix.rows);
  std::ofstream file(unfinished, std::ios::binary);
  file << npy_header_of_matrix(size, size);
  const RowSource rows = [&](Eigen::Index first, Eigen::Index count) {
    return matrix.read({.first_row = first, .rows = count, .first_column = 0, .columns = matrix.columns});
  };
  std::error_code failure;
  try {
    diffuse(matrix.rows, rows, options, [&](Eigen::Index /*first*/, const DistanceMatrix& block) {
      std::string bytes;
      for (const double distance : block.reshaped<Eigen::RowMajor>()) append_number(bytes, distance);
      file << bytes;
    });
  } catch (...) {
    fs::remove(unfinished, failure);
    throw;
  }
  file.close();
  if (file) fs::rename(unfinished, output, failure);
  if (file && !failure) return;
  fs::remove(unfinished, failure);
  throw InputError(fmt::format("cannot write {}", output.string()));
}

/// Warns of an asymmetric matrix.
void warn_of_asymmetry(const OpenMatrix& matrix) {
  constexpr Eigen::Index together = 256;
  MatrixChecks checks(true);
  for (Eigen::Index first = 0; first < matrix.rows; first += together) {
    const Eigen::Index count = std::min(together, matrix.rows - first);
    const auto read = [&](const MatrixBlock& block) { return matrix.read(block); };
    checks.compare(read({.first_row = first, .rows = count, .first_column = 0, .columns = matrix.columns}), first,
                   read({.first_row = first, .rows = matrix.rows - first, .first_column = first, .columns = count}));
  }
  const MatrixFindings found = checks.findings();
  if (found.asymmetric_pairs == 0) return;
  warn(fmt::format("{}; the neighbours of model i are those of row i", asymmetry_text(found)));
}

std::string csv_of(const DistanceMatrix& matrix, const std::vector<std::string>& ids) {
  Table table{.header = {"id"}, .rows = {}};
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const std::string id = ids.empty() ? std::to_string(i) : ids[static_cast<std::size_t>(i)];
    table.header.push_back(id);
    auto& row = table.rows.emplace_back(std::vector{id});
    for (const double distance : matrix.row(i)) row.push_back(fmt::format("{}", distance));
  }
  return to_csv(table);
}

void write_matrix(const fs::path& path, const DistanceMatrix& matrix, const std::vector<std::string>& ids) {
  if (path.extension() == ".npy") return write_npy(path, matrix);
  write_file_atomically(path, csv_of(matrix, ids));
}

int run(const RerankArguments& arguments) {
  const std::string format = arguments.output.extension().string();
  if (format != ".npy" && format != ".csv") {
    throw InputError(fmt::format("distances are written as .npy or .csv, not to \"{}\"", arguments.output.string()));
  }
  const OutputFile output{.path = arguments.output, .what = "--output"};
  check_output_files({&arguments.distances, 1}, {&output, 1}, arguments.replace);
  const RerankMethod& method = rerank_methods().at(arguments.method);
  const ParameterValues values = values_of(arguments, method);
  const OpenMatrix matrix = open_matrix(arguments.distances, TableShape::square);
  const bool by_rows = arguments.sparse || (matrix.rows > most_dense && method.name == "diffusion" && format == ".npy");
  if (arguments.sparse && (method.name != "diffusion" || format != ".npy")) {
    throw InputError("--sparse goes with --method diffusion and an output .npy only");
  }
  try {
    if (by_rows) {
      diffuse_file(matrix, diffusion_options(values), arguments.output);
    } else {
      write_matrix(arguments.output, method.rerank(whole_matrix(matrix), values), matrix.row_ids);
    }
  } catch (const ArgumentError& error) {
    throw InputError(fmt::format("{}: {}", arguments.distances.string(), error.what()));
  }
  warn_of_asymmetry(matrix);
  return exit_success;
}

/// Adds an option for each parameter of any method.
void add_settings(CLI::App& command, RerankArguments& arguments) {
  std::map<std::string, std::string> meanings;
  for (const RerankMethod& method : rerank_methods().entries()) {
    const nlohmann::json defaults = to_json(ParameterValues(method.parameters));
    for (const Parameter& parameter : method.parameters) {
      const std::string name(parameter.name);
      std::string& meaning = meanings[name];
      meaning += fmt::format("{}{} ({}; usually {})", meaning.empty() ? "" : " ", parameter.description, method.name,
                             defaults.at(name).dump());
    }
  }
  for (const auto& [name, meaning] : meanings) {
    command.add_option(option_name(name), arguments.settings[name], meaning);
  }
}

}  // namespace

void add_rerank_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "rerank", "Improve distances by what they say of the whole set of models, without knowing classes");
  command->footer(
      "Examples: shapegauge rerank distances.npy -o better.npy --neighbours 10\n"
      "          shapegauge rerank distances.npy -o better.npy --neighbours auto      (mean over 4, 5, 7, 10, 14, 20)\n"
      "Diffusion of more than 5,000 models takes the sparse form, for which the matrix need not fit into memory\n"
      "(.npy in C order and .matrix).");
  const auto arguments = std::make_shared<RerankArguments>();
  command
      ->add_option("distances", arguments->distances,
                   "Square matrix of distances: .npy, .npz, .mat, .matrix (PSB), .csv, .txt or .dat")
      ->required();
  command->add_option("-o,--output", arguments->output, "File for the new distances: .npy, or .csv (with ids)")
      ->required();
  add_replace_option(*command, arguments->replace);
  command->add_option("--method", arguments->method, "How")
      ->check(CLI::IsMember(rerank_methods().names()))
      ->capture_default_str();
  add_settings(*command, *arguments);
  command->add_flag("--sparse", arguments->sparse, "Take the sparse form of diffusion for any number of models");
  add_threads_option(*command, arguments->threads);
  command->callback([arguments, &status] { with_threads(arguments->threads, [&] { status = run(*arguments); }); });
}

}  // namespace shapegauge
