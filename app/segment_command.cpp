#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/shape_files.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/ply.h"
#include "shapegauge/core/render/image.h"
#include "shapegauge/core/render/render_shape.h"
#include "shapegauge/core/shape/polygons.h"
#include "shapegauge/experiments/segmentation/run_segmentation.h"
#include "shapegauge/segmentation/seg_file.h"
#include "shapegauge/segmentation/segment_labels.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

using Labels = std::vector<std::int32_t>;

struct SegmentArguments {
  ShapeFiles files{.output_format = "seg"};
  std::string method = "best";
  int parts = 0;
  std::string field = "offset";
  OffsetArguments offset{.offset = "0.05"};
  bool denoise = false;
};

/// Writes the parts of a shape to a file.
using LabelWriter = void (*)(const fs::path&, const Shape&, const Labels&);

SampleSite site_of(const Shape& shape) { return is_cloud(shape) ? SampleSite::vertices : SampleSite::faces; }

void write_labels(const fs::path& path, const Shape& shape, const Labels& labels) { write_seg(path, shape, labels); }

void write_coloured(const fs::path& path, const Shape& shape, const Labels& labels) {
  const Eigen::VectorXd numbers =
      Eigen::Map<const Eigen::VectorXi>(labels.data(), static_cast<Eigen::Index>(labels.size())).cast<double>();
  write_ply(path, shape, site_of(shape), numbers, label_colours(surface_graph(shape), labels), "part");
}

void write_picture(const fs::path& path, const Shape& shape, const Labels& labels) {
  const std::vector<Colour> colours = label_colours(surface_graph(shape), labels);
  write_png(path, render_shape(shape, colours, site_of(shape), principal_view(shape)));
}

LabelWriter label_writer(const fs::path& name) {
  static const std::map<std::string, LabelWriter> writers = {
      {".seg", write_labels}, {".ply", write_coloured}, {".png", write_picture}};
  const auto found = writers.find(name.extension().string());
  if (found != writers.end()) return found->second;
  throw InputError(fmt::format("cannot write {}: parts are written as .seg, .ply or .png", name.string()));
}

SegmentationMethod method_for(const Shape& shape, const SegmentArguments& arguments, Remarks& remarks) {
  SegmentationMethod method;
  method.paper = arguments.method == "paper";
  method.parts = arguments.parts;
  method.offset_field = arguments.field == "offset";
  if (method.paper && method.offset_field) {
    const ChosenOffset chosen = choose_offset(parse_offset(arguments.offset).fraction_of(shape), shape);
    method.offset = chosen.offset;
    remark_on(chosen, remarks);
  }
  return method;
}

void segment(const SegmentArguments& arguments, LabelWriter write, const Shape& given, const ShapeJob& job,
             Remarks& remarks) {
  try {
    const Shape shape = arguments.denoise ? denoised_with_remark(given, remarks) : given;
    const Labels labels = segment_by_method(shape, method_for(shape, arguments, remarks));
    write(job.output, shape, labels);
    if (const auto polygons = polygon_note(shape)) {
      remarks.notes.push_back(
          *polygons + "; .seg files have one line per face of the file, with the part that covers most of its area");
    }
    remarks.notes.push_back(fmt::format("{} parts", *std::ranges::max_element(labels) + 1));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", job.input, error.what()));
  }
}

}  // namespace

void add_segment_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("segment", "Segment shapes into parts");
  command->footer(
      "Example: shapegauge segment hand.off -o hand.png\n"
      "         shapegauge segment models/*.off -o segments/");
  const auto arguments = std::make_shared<SegmentArguments>();
  add_shape_inputs(*command, arguments->files);
  add_shape_outputs(*command, arguments->files,
                    ".seg (one part number per line, by face), .ply or .png (coloured parts)");
  begin_option_group(*command, "Method");
  command
      ->add_option("--method", arguments->method,
                   "best: parts as people choose them; paper: clusters of patches by their SDF")
      ->check(CLI::IsMember({"best", "paper"}))
      ->capture_default_str();
  command->add_option("--parts", arguments->parts, "Number of parts (paper: of clusters, 5 for 0); 0 for automatic")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  CLI::Option* field =
      command->add_option("--field", arguments->field, "paper: SDF of the offset surface, or conventional SDF")
          ->check(CLI::IsMember({"offset", "cone"}))
          ->capture_default_str();
  CLI::Option* offset = add_offset_option(*command, arguments->offset);
  add_denoise_option(*command, arguments->denoise);
  command->callback([arguments, &status, field, offset] {
    for (const CLI::Option* option : {field, offset}) {
      if (arguments->method != "paper" && option->count() > 0) {
        throw InputError(option->get_name() + " requires --method paper");
      }
    }
    const LabelWriter write = label_writer(output_name(arguments->files));
    status = for_each_shape(arguments->files, [&](const Shape& shape, const ShapeJob& job, Remarks& remarks) {
      segment(*arguments, write, shape, job, remarks);
    });
  });
}

}  // namespace shapegauge
