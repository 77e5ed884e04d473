// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/shape_files.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/fields/field.h"
#include "shapegauge/experiments/results/field_files.h"

namespace shapegauge {

namespace {

struct NormalsArguments {
  ShapeFiles files{.output_format = "csv"};
  std::string site{word_of(SampleSite::vertices)};
  OffsetArguments offset;
  CleaningArguments cleaning;
};

void write_normals(const NormalsArguments& arguments, const NormalFileWriter& write, const RequestedOffset& offset,
                   const Shape& input_shape, const ShapeJob& job, Remarks& remarks) {
  const Shape shape = cleaned(input_shape, arguments.cleaning, offset.is_automatic(), remarks);
  const Samples samples = sample_shape(shape, value_of_word<SampleSite>(arguments.site).value());
  const ChosenOffset chosen = choose_offset(offset.fraction_of(shape), shape);
  FieldSettings settings = field_settings("offset_sdf");
  settings.values.set("offset", chosen.offset);
  FieldSource source(shape);
  const FieldValues result = make_field(std::move(settings)).compute(source, samples, true);
  write(job.output, shape, samples, result.normals);
  remark_on_polygons(shape, samples.site, remarks);
  remark_on(chosen, remarks);
  remark_on(result.outcomes, remarks);
}

}  // namespace

void add_normals_command(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("normals", "Estimate outward normals, robust to noise, cracks and orientation");
  command->footer("Example: shapegauge normals scan.xyz -o scan.ply");
  const auto arguments = std::make_shared<NormalsArguments>();
  add_shape_inputs(*command, arguments->files);
  add_shape_outputs(
      *command, arguments->files,
      ".csv (index, nx, ny, nz, area weight), .npy, .ply (shape with normals) or .xyz (points with normals)");
  begin_option_group(*command, "Method");
  add_site_option(*command, arguments->site);
  add_offset_option(*command, arguments->offset);
  add_cleaning_options(*command, arguments->cleaning);
  command->callback([arguments, &status] {
    arguments->offset.unit_of_files = set_unit_from_format(arguments->offset.unit, arguments->files.inputs);
    const RequestedOffset offset = parse_offset(arguments->offset);
    const NormalFileWriter write = normal_file_writer(output_name(arguments->files));
    status = for_each_shape(arguments->files, [&](const Shape& shape, const ShapeJob& job, Remarks& remarks) {
      write_normals(*arguments, write, offset, shape, job, remarks);
    });
  });
}

}  // namespace shapegauge
