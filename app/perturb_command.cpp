// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <deque>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/parameter_options.h"
#include "app/shape_files.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/io/up_axis.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/experiments/configuration/perturbation_steps.h"

namespace shapegauge {

namespace {

/// Options of a kind of perturbation. The option of the first parameter enables it; a kind without parameters has a
/// flag.
struct StepOptions {
  std::string_view type;
  std::vector<std::string_view>
      names;  ///< option names of the parameters; missing ones are made from the names of type and parameter
};

/// Order of the perturbations, and of their options in the help. Other types follow.
const std::vector<StepOptions> first_steps{{"decimate", {"--decimate"}},
                                           {"vertex_noise", {"--noise", "--noise-distribution"}},
                                           {"remove_faces", {"--remove-faces"}},
                                           {"holes", {"--holes", "--hole-radius"}},
                                           {"sample_points", {"--points", "--with-normals"}},
                                           {"vertex_cloud", {}},
                                           {"flip_orientation", {"--flip"}},
                                           {"motion", {"--motion"}}};

std::vector<StepOptions> all_steps() {
  std::vector<StepOptions> steps = first_steps;
  for (const std::string_view type : shape_perturbations().names()) {
    if (std::ranges::find(steps, type, &StepOptions::type) == steps.end()) steps.push_back({.type = type, .names = {}});
  }
  return steps;
}

/// Arguments for one kind of perturbation.
struct StepArguments {
  const ShapePerturbation* kind;
  bool requested = false;
  ParameterTexts settings = {};
};

struct PerturbArguments {
  ShapeFiles files{.output_format = "off"};
  std::uint64_t seed = 1;
  std::deque<StepArguments> steps = {};  ///< filled by the options
};

/// Help text of the first option of a kind of perturbation: "Cut round holes: number of holes (0 to 100000)".
std::string first_option_text(const ShapePerturbation& kind) {
  const std::string value = parameter_help_text(kind.parameters.front(), false);
  return fmt::format("{}: {}{}", without_full_stop(kind.description), lower_case(value.substr(0, 1)), value.substr(1));
}

/// Adds the options of one kind of perturbation.
void add_step_options(CLI::App& command, const StepOptions& options, StepArguments& step) {
  const std::string type_option = option_name(options.type);
  const auto parameters = step.kind->parameters;
  if (parameters.empty()) {
    command.add_flag(type_option, step.requested, without_full_stop(step.kind->description));
    return;
  }
  CLI::Option* first = nullptr;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& parameter = parameters[i];
    const std::string made = i == 0 ? type_option : option_name(fmt::format("{}_{}", options.type, parameter.name));
    const std::string name = i < options.names.size() ? std::string(options.names[i]) : made;
    const std::string meaning = i == 0 ? first_option_text(*step.kind) : "";
    CLI::Option* const option =
        add_parameter_option(command, parameter, step.settings[std::string(parameter.name)], name, meaning);
    if (first == nullptr)
      first = option->each([&step](const std::string& /*text*/) { step.requested = true; });
    else
      option->needs(first);
  }
}

/// Returns the requested steps.
std::vector<Perturbation> steps_of(const PerturbArguments& arguments) {
  std::vector<Perturbation> steps;
  for (const StepArguments& step : arguments.steps) {
    if (!step.requested) continue;
    steps.push_back(
        {.type = step.kind, .values = parameter_values(step.kind->parameters, step.settings, step.kind->name)});
  }
  return steps;
}

/// Writes the result of a job, with the comment of the input on its axis (up_axis.h).
void write_result(ShapeWriter write, const ShapeJob& job, const Shape& shape, Remarks& remarks) {
  write(job.output, shape, read_up_comment(job.input));
  if (const auto warning = precision_warning(job.output, shape)) remarks.warnings.push_back(*warning);
}

int run(const PerturbArguments& arguments) {
  const ShapeWriter write = shape_writer(output_name(arguments.files));
  const std::vector<Perturbation> steps = steps_of(arguments);
  if (steps.empty()) throw InputError("no perturbation given; see 'shapegauge perturb --help'");
  return for_each_shape(arguments.files, [&](const Shape& shape, const ShapeJob& job, Remarks& remarks) {
    PerturbedShape perturbed = perturb_model(shape, steps, arguments.seed, "", 0);
    std::ranges::move(perturbed.remarks, std::back_inserter(remarks.warnings));
    write_result(write, job, perturbed.shape, remarks);
  });
}

}  // namespace

void add_perturb_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("perturb", "Perturb shapes at random, in the order of the options below");
  command->footer("Example: shapegauge perturb bunny.off -o worse.off --noise 0.005 --remove-faces 0.15 --seed 7");
  const auto arguments = std::make_shared<PerturbArguments>();
  add_shape_inputs(*command, arguments->files);
  add_shape_outputs(*command, arguments->files, fmt::format("{}", fmt::join(written_shape_extensions(), ", ")));
  begin_option_group(*command, "Perturbations");
  add_seed_option(*command, arguments->seed);
  for (const StepOptions& options : all_steps()) {
    StepArguments& step = arguments->steps.emplace_back(StepArguments{.kind = &shape_perturbations().at(options.type)});
    add_step_options(*command, options, step);
  }
  command->callback([arguments, &status] { status = run(*arguments); });
}

void add_convert_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("convert", "Convert shapes to another format");
  command->footer(
      "Example: shapegauge convert bunny.stl -o bunny.off\n         shapegauge convert scans/*.obj --output-format ply "
      "-o ply/\nPolygons become triangles; colours and textures are dropped.");
  const auto files = std::make_shared<ShapeFiles>(ShapeFiles{.output_format = "off"});
  add_shape_inputs(*command, *files);
  add_shape_outputs(*command, *files, fmt::format("{}", fmt::join(written_shape_extensions(), ", ")));
  command->callback([files, &status] {
    const ShapeWriter write = shape_writer(output_name(*files));
    status = for_each_shape(*files, [&](const Shape& shape, const ShapeJob& job, Remarks& remarks) {
      write_result(write, job, shape, remarks);
    });
  });
}

}  // namespace shapegauge
