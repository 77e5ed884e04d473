// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/parameter_options.h"
#include "app/shape_files.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/up_axis.h"
#include "shapegauge/core/render/image.h"
#include "shapegauge/core/render/render_shape.h"
#include "shapegauge/core/shape/polygons.h"
#include "shapegauge/segmentation/seg_file.h"
#include "shapegauge/segmentation/segment_labels.h"
#include "shapegauge/segmentation/segment_shape.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

using Labels = std::vector<std::int32_t>;

struct SegmentArguments {
  ShapeFiles files{.output_format = "seg"};
  std::string method{word_of(SegmentationOptions{}.method)};
  ParameterTexts settings;  ///< of segmentation_table, without the method and the offset
  OffsetArguments offset{.offset = fmt::format("{:g}%", 100 * SegmentationOptions{}.offset)};
  CleaningArguments cleaning;
  std::string up = "auto";
};

/// Writes the parts of a shape to a file.
using LabelWriter = void (*)(const fs::path&, const Shape&, const Labels&, const Eigen::Vector3d& up);

SampleSite site_of(const Shape& shape) { return is_cloud(shape) ? SampleSite::vertices : SampleSite::faces; }

void write_labels(const fs::path& path, const Shape& shape, const Labels& labels, const Eigen::Vector3d& /*up*/) {
  write_seg(path, shape, labels);
}

void write_coloured(const fs::path& path, const Shape& shape, const Labels& labels, const Eigen::Vector3d& /*up*/) {
  const Eigen::VectorXd numbers =
      Eigen::Map<const Eigen::VectorXi>(labels.data(), static_cast<Eigen::Index>(labels.size())).cast<double>();
  write_ply(path, shape, site_of(shape), numbers, label_colours(surface_graph(shape), labels), "part");
}

void write_picture(const fs::path& path, const Shape& shape, const Labels& labels, const Eigen::Vector3d& up) {
  const std::vector<Colour> colours = label_colours(surface_graph(shape), labels);
  write_png(path, render_shape(shape, colours, site_of(shape), upright_view(shape, {.up = up})));
}

LabelWriter label_writer(const fs::path& name) {
  static const std::map<std::string, LabelWriter> writers = {
      {".seg", write_labels}, {".ply", write_coloured}, {".png", write_picture}};
  const auto found = writers.find(lower_case(name.extension().string()));
  if (found != writers.end()) return found->second;
  throw InputError(fmt::format("cannot write {}: parts are written as .seg, .ply or .png", name.string()));
}

constexpr auto parameters = parameters_of(segmentation_table);

/// Returns the options without the offset. Throws InputError for a setting of the other method.
SegmentationOptions options_of(const SegmentArguments& arguments) {
  for (const auto& [name, value] : arguments.settings) {
    const std::optional<SegmentationAlgorithm> only = algorithm_with(name);
    if (value.text.empty() || !only || word_of(*only) == arguments.method) continue;
    throw InputError(fmt::format("{} requires --method {}", value.option, word_of(*only)));
  }
  SegmentationOptions options =
      options_from(segmentation_table, parameter_values(parameters, arguments.settings, "segment"));
  options.method = value_of_word<SegmentationAlgorithm>(arguments.method).value();
  return options;
}

bool uses_offset(const SegmentationOptions& options) {
  return options.method == SegmentationAlgorithm::paper && options.field == SegmentedSdf::offset;
}

void segment(const SegmentArguments& arguments, SegmentationOptions options, LabelWriter write,
             const Shape& input_shape, const ShapeJob& job, Remarks& remarks) {
  const RequestedOffset offset = parse_offset(arguments.offset);
  const Shape shape = cleaned(input_shape, arguments.cleaning, uses_offset(options) && offset.is_automatic(), remarks);
  if (uses_offset(options)) {
    const ChosenOffset chosen = choose_offset(offset.fraction_of(shape), shape);
    options.offset = chosen.offset;
    remark_on(chosen, remarks);
  }
  OffsetSdfOutcomes outcomes;
  const Labels labels = segment_shape(shape, options, &outcomes);
  remark_on(field_outcomes(outcomes), remarks);
  write(job.output, shape, labels, up_direction(value_of_word<UpAxis>(arguments.up).value(), job.input));
  if (const auto polygons = polygon_note(shape)) {
    remarks.notes.push_back(
        *polygons + "; .seg files have one line per face of the file, with the part that covers most of its area");
  }
  const std::int32_t count = *std::ranges::max_element(labels) + 1;
  if (options.best.parts > 0 && count > options.best.parts && options.method == SegmentationAlgorithm::best) {
    remarks.warnings.push_back(
        fmt::format("{} parts instead of {}: unconnected components are different parts", count, options.best.parts));
  }
  const std::string parts = count_text(count, "part", "parts");
  const bool is_streamed = is_standard_stream(arguments.files.output);
  remarks.notes.push_back(is_streamed ? parts : fmt::format("{} in {}", parts, job.output.lexically_normal().string()));
}

}  // namespace

void add_segment_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("segment", "Segment shapes into parts");
  command->footer(
      "Example: shapegauge segment hand.off -o hand.png\n"
      "         shapegauge segment models/ -o segments/\n"
      "Without -o, the result is hand.seg in the working folder.");
  const auto arguments = std::make_shared<SegmentArguments>();
  add_shape_inputs(*command, arguments->files);
  add_shape_outputs(*command, arguments->files,
                    ".seg (part number per face or point, one per line), .ply or .png (coloured parts)")
      ->required(false);
  add_up_option(*command, arguments->up);
  begin_option_group(*command, "Method");
  command
      ->add_option(
          "--method", arguments->method,
          "Algorithm. best: semantic parts, such as limbs; paper: patches clustered by thickness (Chen et al. 2018)")
      ->check(one_of(list_of_words<SegmentationAlgorithm>()))
      ->capture_default_str();
  for (const Parameter& parameter : parameters) {
    if (parameter.name == "method" || parameter.name == "offset") continue;
    add_parameter_option(*command, parameter, arguments->settings[std::string(parameter.name)]);
  }
  CLI::Option* offset = add_offset_option(*command, arguments->offset);
  add_cleaning_options(*command, arguments->cleaning);
  command->callback([arguments, &status, offset] {
    const SegmentationOptions options = options_of(*arguments);
    if (arguments->files.output.empty()) {
      arguments->files.output = is_standard_stream(arguments->files.inputs.front()) ? "-" : ".";
    }
    if (options.method != SegmentationAlgorithm::paper && offset->count() > 0) {
      throw InputError("--offset requires --method paper");
    }
    arguments->offset.unit_of_files = set_unit_from_format(arguments->offset.unit, arguments->files.inputs);
    const LabelWriter write = label_writer(output_name(arguments->files));
    status = for_each_shape(arguments->files, [&](const Shape& shape, const ShapeJob& job, Remarks& remarks) {
      segment(*arguments, options, write, shape, job, remarks);
    });
  });
}

}  // namespace shapegauge
