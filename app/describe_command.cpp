// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/parameter_options.h"
#include "app/shape_files.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/datasets/files/model_ids.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/configuration/descriptor_choice.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/parameter_json.h"
#include "shapegauge/experiments/configuration/schema.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct DescribeArguments {
  ShapeFiles files;
  std::string descriptor;
  std::vector<std::string> settings;
  fs::path output;
  CleaningArguments cleaning;
  bool list = false;
};

/// Description of one shape. Fields are stored only if features depend on all shapes.
struct Described {
  std::vector<ScalarField> fields;
  Eigen::VectorXf features;
};

void add_settings(std::string_view of, std::span<const Parameter> parameters, const std::string& prefix,
                  TextTable& table) {
  const Json defaults = to_json(ParameterValues(parameters));
  for (const Parameter& parameter : parameters) {
    table.rows.push_back({std::string(of), prefix + std::string(parameter.name),
                          defaults.at(std::string(parameter.name)).dump(), parameter_help_text(parameter, false)});
  }
}

/// Lists all descriptors and their settings, for --list.
std::string list_of_descriptors() {
  TextTable table{.header = {"descriptor", "setting", "default", "meaning"}, .rows = {}, .text_columns = 4};
  for (const Descriptor& one : descriptors().entries()) {
    table.rows.push_back({std::string(one.name), "", "", std::string(one.description)});
    if (one.max_fields > 0) {
      table.rows.push_back(
          {std::string(one.name), "fields", "",
           fmt::format("Scalar fields to describe, {} to {} of them.", one.min_fields, one.max_fields)});
    }
    add_settings(one.name, one.parameters, "", table);
    add_settings(one.name, one.axis_parameters, "axes.N.", table);
  }
  return to_plain_text(table);
}

DescriptorChoice choice_of(const DescribeArguments& arguments) {
  if (arguments.descriptor.empty()) throw InputError("--descriptor is required; see --list");
  Json settings{{"type", arguments.descriptor}};
  for (const std::string& assignment : arguments.settings) apply_override(settings, assignment);
  check_against_schema(settings, "descriptor", "--set");
  return with_source("--set", [&] { return make_descriptor(settings); });
}

/// Computes the fields of a shape and, unless the descriptor learns first, its features.
Described described(const DescriptorChoice& choice, const Shape& input_shape, const CleaningArguments& cleaning,
                    Remarks& remarks) {
  const Shape shape = prepare_shape(cleaned(input_shape, cleaning, false, remarks), {}).shape;
  Described result;
  FieldSource source(shape);
  DescriptorFields computed = compute_fields(choice, source);
  result.fields = std::move(computed.fields);
  std::ranges::move(computed.warnings, std::back_inserter(remarks.warnings));
  if (needs_learning(choice.descriptor, choice.values)) return result;
  const DescriptorInput input{.shape = shape, .fields = result.fields, .proxy = &source.proxy()};
  result.features = compute_features(choice.descriptor, input, {}, choice.values);
  result.fields.clear();
  return result;
}

/// Describes the shapes by features learnt from all of them.
void learn_and_describe(const DescriptorChoice& choice, const ShapeFiles& files,
                        std::vector<std::optional<Described>>& shapes) {
  const Shape none;
  std::vector<DescriptorInput> inputs;
  for (const auto& shape : shapes) {
    if (shape) inputs.push_back({.shape = none, .fields = shape->fields});
  }
  const LearntFeatures learnt = choice.descriptor.learn(inputs, choice.values);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (!shapes[i]) continue;
    const DescriptorInput input{.shape = none, .fields = shapes[i]->fields};
    shapes[i]->features = with_source(
        files.inputs[i].string(), [&] { return compute_features(choice.descriptor, input, learnt, choice.values); });
  }
}

/// Returns the ids of the rows: the shortest distinguishing suffixes of the files' paths.
std::vector<std::string> ids_of(const std::vector<fs::path>& inputs) {
  std::vector<fs::path> paths;
  std::set<fs::path> known;
  for (const fs::path& input : inputs) {
    paths.push_back(input.lexically_normal());
    if (known.insert(paths.back()).second) continue;
    throw InputError(fmt::format("{} is repeated, and two rows would have the same id; omit one", input.string()));
  }
  return distinguishing_suffixes(paths);
}

void write_features(const DescribeArguments& arguments, const std::vector<std::string>& ids,
                    const std::vector<std::optional<Described>>& shapes) {
  DistanceMatrix rows;
  TextTable table{.header = {"id"}, .rows = {}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (!shapes[i]) continue;
    const Eigen::VectorXf& features = shapes[i]->features;
    rows.conservativeResize(rows.rows() + 1, features.size());
    rows.bottomRows<1>() = features.transpose().cast<double>();
    auto& row = table.rows.emplace_back(std::vector{ids[i]});
    for (const float feature : features) row.push_back(fmt::format("{}", feature));
  }
  if (lower_case(arguments.output.extension().string()) == ".npy") return write_npy(arguments.output, rows);
  for (Eigen::Index k = 0; k < rows.cols(); ++k) table.header.push_back(fmt::format("{}", k));
  write_file_atomically(arguments.output, to_csv(table));
}

int run(DescribeArguments& arguments) {
  if (arguments.list) {
    print_output("{}", list_of_descriptors());
    return exit_success;
  }
  if (arguments.files.inputs.empty()) throw InputError("no shapes given; see --help, or --list for the descriptors");
  const std::string format = lower_case(arguments.output.extension().string());
  if (format != ".npy" && format != ".csv") {
    throw InputError(fmt::format("features are written as .npy or .csv, not to \"{}\"", arguments.output.string()));
  }
  const DescriptorChoice choice = choice_of(arguments);
  const std::vector<std::string> ids = ids_of(arguments.files.inputs);
  arguments.files.others = {{.path = arguments.output, .what = "--output"}};
  std::vector<std::optional<Described>> shapes(arguments.files.inputs.size());
  const int status = for_each_shape(arguments.files, [&](const Shape& shape, const ShapeJob& job, Remarks& remarks) {
    shapes[job.index] = described(choice, shape, arguments.cleaning, remarks);
  });
  const auto none_left = std::ranges::none_of(shapes, [](const auto& shape) { return shape.has_value(); });
  if (none_left) return exit_unusable_input;
  if (needs_learning(choice.descriptor, choice.values)) learn_and_describe(choice, arguments.files, shapes);
  write_features(arguments, ids, shapes);
  if (status != exit_success)
    warn(fmt::format("{} has no rows for the shapes that could not be used", arguments.output.string()));
  return status;
}

}  // namespace

void add_describe_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("describe", "Compute features of shapes, one row per shape");
  command->footer(
      "Example: shapegauge describe models/*.off --descriptor light_field -o features.npy\n"
      "         shapegauge describe a.off b.off --descriptor bag_of_features \\\n"
      "           --set 'fields=[{\"type\": \"cone_sdf\"}]' -o features.csv\n"
      "Shapes are scaled to unit area first. Codebooks are learnt from all inputs.");
  const auto arguments = std::make_shared<DescribeArguments>();
  add_shape_inputs(*command, arguments->files);
  command->get_option("input")->required(false);
  begin_option_group(*command, "Descriptor");
  command->add_option("--descriptor", arguments->descriptor, "Shape descriptor to compute (required); see --list");
  command->add_option("--set", arguments->settings,
                      "Descriptor setting: key=value; --list prints the keys; repeatable");
  begin_option_group(*command, output_options);
  command->add_option("-o,--output", arguments->output, "Output file (required): .npy, or .csv (with ids)");
  add_replace_option(*command, arguments->files.replace);
  add_cleaning_options(*command, arguments->cleaning);
  begin_option_group(*command, "Descriptor");
  command->add_flag("--list", arguments->list, "List descriptors and their settings, then exit");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace shapegauge
