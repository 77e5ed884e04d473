#include "app/segment_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tbb/parallel_for.h>
#include <vector>

#include "app/options.h"
#include "app/run_program.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/ply.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/render/image.h"
#include "shapegauge/core/render/render_shape.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/experiments/runner/run_control.h"
#include "shapegauge/segmentation/paper_segmentation.h"
#include "shapegauge/segmentation/part_segmentation.h"
#include "shapegauge/segmentation/seg_file.h"
#include "shapegauge/segmentation/segment_labels.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

using Labels = std::vector<std::int32_t>;

struct SegmentArguments {
  std::vector<fs::path> inputs;
  fs::path output;
  std::string method = "best";
  int parts = 0;
  std::string field = "offset";
  double offset = 0.05;
  std::string format = "seg";
  bool denoise = false;
  int threads = 0;
};

/// Writes the parts of a shape to a file.
using LabelWriter = void (*)(const fs::path&, const Shape&, const Labels&);

SampleSite site_of(const Shape& shape) { return is_cloud(shape) ? SampleSite::vertices : SampleSite::faces; }

void write_labels(const fs::path& path, const Shape& /*shape*/, const Labels& labels) { write_seg(path, labels); }

void write_coloured(const fs::path& path, const Shape& shape, const Labels& labels) {
  const auto numbers = Eigen::Map<const Eigen::VectorXi>(labels.data(), std::ssize(labels)).cast<double>();
  write_ply(path, shape, site_of(shape), numbers, label_colours(surface_graph(shape), labels), "part");
}

void write_picture(const fs::path& path, const Shape& shape, const Labels& labels) {
  const std::vector<Colour> colours = label_colours(surface_graph(shape), labels);
  write_png(path, render_shape(shape, colours, site_of(shape), principal_view(shape)));
}

LabelWriter label_writer(const std::string& extension) {
  static const std::map<std::string, LabelWriter> writers = {
      {".seg", write_labels}, {".ply", write_coloured}, {".png", write_picture}};
  const auto found = writers.find(extension);
  if (found == writers.end()) {
    throw InputError(fmt::format("--output: parts are written as .seg, .ply or .png, not \"{}\"", extension));
  }
  return found->second;
}

Labels paper_labels(const Shape& shape, const SegmentArguments& arguments) {
  const SurfaceGraph graph = surface_graph(shape);
  const std::vector<ScalarField> fields = {{arguments.field == "cone"
                                                ? cone_sdf(shape, graph.samples, {}).values
                                                : offset_sdf(shape, graph.samples, {.offset = arguments.offset}).values,
                                            graph.samples.weights}};
  PaperSegmentationOptions options;
  if (arguments.parts > 0) options.mixture.components = arguments.parts;
  return paper_segmentation(graph, fields, options);
}

/// What is wrong with a shape is told with the file's name.
std::size_t segment(const fs::path& input, const fs::path& output, LabelWriter write,
                    const SegmentArguments& arguments) {
  Shape shape = read_shape(input);
  if (arguments.denoise) shape = denoised_with_report(std::move(shape));
  try {
    const Labels labels = arguments.method == "paper" ? paper_labels(shape, arguments)
                                                      : part_segmentation(shape, {.parts = arguments.parts});
    write(output, shape, labels);
    return std::set(labels.begin(), labels.end()).size();
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", input.string(), error.what()));
  }
}

int segment_one(const SegmentArguments& arguments) {
  const LabelWriter write = label_writer(arguments.output.extension().string());
  with_threads(arguments.threads,
               [&] { fmt::print("{}\n", segment(arguments.inputs.front(), arguments.output, write, arguments)); });
  return exit_success;
}

/// Where the parts of each shape go. Throws InputError where two would go to the same file.
std::vector<fs::path> outputs_of(const SegmentArguments& arguments) {
  std::vector<fs::path> outputs;
  std::set<fs::path> taken;
  for (const fs::path& input : arguments.inputs) {
    outputs.push_back(arguments.output / (input.stem().string() + "." + arguments.format));
    if (!taken.insert(outputs.back()).second) {
      throw InputError(
          fmt::format("two of the shapes are called {}; segment them into different folders", input.stem().string()));
    }
  }
  return outputs;
}

int segment_many(const SegmentArguments& arguments) {
  const LabelWriter write = label_writer("." + arguments.format);
  const std::vector<fs::path> outputs = outputs_of(arguments);
  fs::create_directories(arguments.output);
  std::vector<std::string> errors(outputs.size());
  with_threads(arguments.threads, [&] {
    tbb::parallel_for(std::size_t{0}, outputs.size(), [&](std::size_t i) {
      try {
        segment(arguments.inputs[i], outputs[i], write, arguments);
      } catch (const std::exception& error) {
        errors[i] = error.what();
      }
    });
  });
  int status = exit_success;
  for (const std::string& error : errors) {
    if (error.empty()) continue;
    fmt::print(stderr, "shapegauge: error: {}\n", error);
    status = exit_with_failures;
  }
  return status;
}

}  // namespace

void add_segment_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("segment", "Cut shapes into parts");
  command->footer(
      "Example: shapegauge segment hand.off -o hand.png\n"
      "         shapegauge segment models/*.off -o segments/\n"
      "Of one shape the number of its parts is printed.");
  const auto arguments = std::make_shared<SegmentArguments>();
  command->add_option("shapes", arguments->inputs, "OFF, OBJ, PLY or STL meshes, or point clouds")->required();
  command
      ->add_option("-o,--output", arguments->output,
                   "Of one shape the file: .seg (the number of each face's part), .ply or .png (coloured parts); of "
                   "several the folder")
      ->required();
  command->add_option("--method", arguments->method, "best: as people cut; paper: clusters of patches by their SDF")
      ->check(CLI::IsMember({"best", "paper"}))
      ->capture_default_str();
  command
      ->add_option("--parts", arguments->parts, "Parts wanted (paper: clusters, 5 unless given); 0: as many as it has")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  std::vector<CLI::Option*> of_paper{
      command->add_option("--field", arguments->field, "paper: SDF of the offset surface, or conventional")
          ->check(CLI::IsMember({"offset", "cone"})),
      command->add_option("--offset", arguments->offset, "paper: offset as a fraction of the bounding-box diagonal")};
  for (CLI::Option* option : of_paper) option->capture_default_str();
  command->add_option("--format", arguments->format, "Of several shapes: format of the files")
      ->check(CLI::IsMember({"seg", "ply", "png"}))
      ->capture_default_str();
  command->add_flag("--denoise", arguments->denoise, "Smooth meshes first whose vertices are noisy beyond doubt");
  add_threads_option(*command, arguments->threads);
  command->callback([arguments, &status, of_paper] {
    for (const CLI::Option* option : of_paper) {
      if (arguments->method != "paper" && option->count() > 0) {
        throw InputError(option->get_name() + " goes with --method paper only");
      }
    }
    const bool one =
        arguments->inputs.size() == 1 && !fs::is_directory(arguments->output) && arguments->output.has_extension();
    status = one ? segment_one(*arguments) : segment_many(*arguments);
  });
}

}  // namespace shapegauge
