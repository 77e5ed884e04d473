// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/parameter_options.h"
#include "app/shape_files.h"
#include "app/standard_streams.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/output_files.h"
#include "shapegauge/core/io/up_axis.h"
#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/schema.h"
#include "shapegauge/experiments/results/field_files.h"
#include "shapegauge/pages/coarse_view.h"
#include "shapegauge/pages/shape_view.h"
#include "shapegauge/segmentation/part_segmentation.h"
#include "shapegauge/segmentation/segment_labels.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct ViewArguments {
  ShapeFiles files;
  fs::path output;
  std::vector<std::string> fields;
  OffsetArguments offset;
  ColourArguments colours;
  int parts = 0;
  bool no_parts = false;
  Eigen::Index max_faces = 200'000;
  std::string title;
  std::string up = "auto";
  CleaningArguments cleaning;
};

/// Requested field.
struct RequestedField {
  std::string name;  ///< name on the page
  FieldSettings settings;
  bool chooses_offset = false;  ///< uses --offset
};

/// Parses the type and settings of a field: "offset_sdf,offset=0.03", or JSON as in a configuration.
Json field_settings_of(const std::string& text, const std::string& source) {
  if (text.starts_with('{')) return parse_json(text, source);
  std::istringstream words(text);
  std::string type;
  std::getline(words, type, ',');
  Json settings{{"type", type}};
  for (std::string assignment; std::getline(words, assignment, ',');) apply_override(settings, assignment);
  return settings;
}

RequestedField parse_field(const std::string& text) {
  const std::string source = fmt::format("--field {}", text);
  Json settings = field_settings_of(text, source);
  const bool chooses_offset =
      settings.contains("type") && settings["type"] == "offset_sdf" && !settings.contains("offset");
  if (chooses_offset) settings["offset"] = "auto";
  check_against_schema(settings, "field", source);
  if (settings.contains("at")) {
    throw InputError(
        fmt::format("{}: views support values at the faces of a mesh and the points of a cloud only", source));
  }
  const Field field = read_field(settings);  // reports wrong settings before any file is read
  const std::string type = settings.at("type");
  std::string name = type;
  if (type == "offset_sdf") name = "SDF of the offset surface";
  if (type == "cone_sdf") name = "Conventional SDF";
  for (const auto& [key, value] : settings.items()) {
    if (key == "type" || (key == "offset" && chooses_offset)) continue;
    name += fmt::format(", {} {}", key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  return {.name = std::move(name), .settings = field.settings, .chooses_offset = chooses_offset};
}

/// Returns the fields of --field or, without any, the two SDFs.
std::vector<RequestedField> requested_fields(const ViewArguments& arguments, bool has_offset) {
  if (arguments.fields.empty()) return {parse_field("offset_sdf"), parse_field("cone_sdf")};
  std::vector<RequestedField> fields;
  for (const std::string& text : arguments.fields) {
    RequestedField field = parse_field(text);
    if (std::ranges::find(fields, field.settings, &RequestedField::settings) != fields.end()) {
      throw InputError(fmt::format("--field {} is repeated; omit one", text));
    }
    fields.push_back(std::move(field));
  }
  if (has_offset && std::ranges::none_of(fields, &RequestedField::chooses_offset)) {
    throw InputError("--offset requires a --field offset_sdf without its own offset");
  }
  return fields;
}

/// Adds a field to the view, with the normals of the first one that estimates them.
void add_field(const RequestedField& request, const RequestedOffset& offset, const ColourChoice& colours,
               FieldSource& source, const Samples& samples, ShapeView& view, Remarks& remarks) {
  FieldSettings settings = request.settings;
  if (request.chooses_offset) {
    const ChosenOffset chosen = choose_offset(offset.fraction_of(source.shape()), source.shape());
    settings.values.set("offset", chosen.offset);
    remark_on(chosen, remarks);
    view.note = fmt::format("offset {:.3g} % of the diagonal", 100 * chosen.offset);
  }
  const Field field = make_field(std::move(settings));
  FieldValues computed = field.compute(source, samples, true);
  // Thresholds and ranges are lengths.
  const bool is_length = field.dimension == FieldDimension::length;
  const ColourScale scale = colour_scale_of({.values = computed.values, .weights = samples.weights},
                                            {.range = is_length ? colours.range : std::nullopt,
                                             .logarithmic = colours.logarithmic,
                                             .threshold = is_length ? colours.threshold : std::nullopt});
  for (const std::string& warning : outcome_warnings(computed.outcomes)) {
    remarks.warnings.push_back(fmt::format("{}: {}", request.name, warning));
  }
  view.fields.push_back({.name = request.name,
                         .values = std::move(computed.values),
                         .colours = {scale.low, scale.high},
                         .set_range = is_length && colours.range.has_value(),
                         .logarithmic = scale.logarithmic,
                         .threshold = scale.threshold,
                         .measured_by = is_length ? measured_by(request.settings.type) : ""});
  if (view.normals.rows() == 0) view.normals = std::move(computed.normals);
}

/// Adds parts as `shapegauge segment` computes them; remarks on shapes that cannot be segmented.
void add_parts(int count, ShapeView& view, Remarks& remarks) {
  try {
    const std::vector<std::int32_t> labels = part_segmentation(view.shape, {.parts = count});
    const std::vector<Colour> colours = colour_of_each_label(surface_graph(view.shape), labels);
    view.parts = {{.name = "Parts", .labels = labels, .colours = colours}};
  } catch (const InputError& error) {
    remarks.warnings.push_back(fmt::format("shown without parts: {}", error.what()));
  }
}

ShapeView measured(const ViewArguments& arguments, const std::vector<RequestedField>& fields,
                   const RequestedOffset& offset, const ColourChoice& colours, const Shape& input_shape,
                   const ShapeJob& job, Remarks& remarks) {
  const bool automatic = offset.is_automatic() && std::ranges::any_of(fields, &RequestedField::chooses_offset);
  ShapeView view{.name = fs::path(job.input).filename().string(),
                 .shape = cleaned(input_shape, arguments.cleaning, automatic, remarks)};
  const bool cloud = is_cloud(view.shape);
  view.up = up_direction(value_of_word<UpAxis>(arguments.up).value(), job.input);
  view.site = cloud ? SampleSite::vertices : SampleSite::faces;
  if (!(bounding_box_diagonal(view.shape) > 0))
    throw InputError("nothing to show: the points of the shape all coincide");
  const Samples samples = sample_shape(view.shape, view.site);
  FieldSource source(view.shape);
  for (const RequestedField& field : fields) {
    // Silently skips a default field that clouds do not have.
    if (cloud && arguments.fields.empty() && field.settings.type == "cone_sdf") continue;
    add_field(field, offset, colours, source, samples, view, remarks);
  }
  const bool measures_hull =
      std::ranges::any_of(fields, [](const RequestedField& field) { return field.settings.type == "offset_sdf"; });
  remark_on_cavities(view.shape, measures_hull, remarks);
  if (view.normals.rows() == 0) view.normals = samples.normals;
  const Eigen::Index count = samples.points.rows();
  view = coarse_view(std::move(view), samples, arguments.max_faces);
  if (!arguments.no_parts) add_parts(arguments.parts, view, remarks);  // of what is shown: they would take longest
  const Eigen::Index shown = cloud ? view.shape.vertices.rows() : view.shape.triangles.rows();
  const std::string counts = fmt::format("{} {}", count, cloud ? "points" : "faces");
  view.note = fmt::format("{}{}{}", shown < count ? fmt::format("{} of which {} are shown", counts, shown) : counts,
                          view.note.empty() ? "" : ", ", view.note);
  return view;
}

std::string title_of(const ViewArguments& arguments, const std::vector<ShapeView>& shapes) {
  if (!arguments.title.empty()) return arguments.title;
  if (shapes.size() > 3) return fmt::format("{} and {} more", shapes.front().name, shapes.size() - 1);
  std::vector<std::string> names;
  for (const ShapeView& shape : shapes) names.push_back(shape.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Returns the page to write: by default, for a single shape, that of its name.
fs::path page_of(const ViewArguments& arguments) {
  const fs::path& output = arguments.output;
  const std::vector<fs::path>& inputs = arguments.files.inputs;
  if (output.empty() && inputs.size() > 1) throw InputError("--output is required for several shapes");
  if (output.empty()) return is_standard_stream(inputs[0]) ? inputs[0] : fs::path(inputs[0].stem().string() + ".html");
  if (is_standard_stream(output) || is_page(output)) return output;
  throw InputError(fmt::format("cannot write {}: the name of a page must end in .html", output.string()));
}

int run(ViewArguments& arguments, bool has_offset) {
  const bool is_named = !arguments.output.empty();
  arguments.output = page_of(arguments);
  const std::vector<RequestedField> fields = requested_fields(arguments, has_offset);
  arguments.offset.unit_of_files = set_unit_from_format(arguments.offset.unit, arguments.files.inputs);
  const RequestedOffset offset = parse_offset(arguments.offset);
  const ColourChoice colours = parse_colours(arguments.colours, arguments.offset.unit);
  arguments.files.others = {{.path = arguments.output, .what = "--output", .takes_stream = true}};
  std::vector<std::optional<ShapeView>> views(arguments.files.inputs.size());
  std::vector<std::vector<std::string>> warnings(views.size());
  const int status = for_each_shape(arguments.files, [&](const Shape& shape, const ShapeJob& job, Remarks& remarks) {
    views[job.index] = measured(arguments, fields, offset, colours, shape, job, remarks);
    warnings[job.index] = remarks.warnings;
  });
  ViewPage page{.title = {}, .shapes = {}, .missing = {}, .warnings = {}, .unit = arguments.offset.unit};
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (const std::string& warning : warnings[i]) {
      page.warnings.push_back(
          fmt::format("{}: {}", arguments.files.inputs[i].filename().string(), with_options(warning)));
    }
    if (views[i])
      page.shapes.push_back(std::move(*views[i]));
    else
      page.missing.push_back(arguments.files.inputs[i].filename().string());
  }
  if (page.shapes.empty()) return exit_unusable_input;
  page.title = title_of(arguments, page.shapes);
  const std::string html = view_page(page);
  if (is_standard_stream(arguments.output))
    write_standard_output(html);
  else
    write_file_atomically(arguments.output, html);
  if (!is_named) note(fmt::format("page: {}", arguments.output.string()));
  if (status != exit_success)
    warn(fmt::format("{} does not show the shapes that could not be used", arguments.output.string()));
  return status;
}

}  // namespace

void add_view_command(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("view", "Write a page with interactive 3D views of shapes, coloured by fields");
  command->footer(
      "Example: shapegauge view hand.off\n"
      "The page is one file. Values are in file units.");
  const auto arguments = std::make_shared<ViewArguments>();
  add_shape_inputs(*command, arguments->files);
  begin_option_group(*command, output_options);
  command->add_option("-o,--output", arguments->output,
                      "Output file: .html; - for standard output; required for several shapes (default: ./hand.html "
                      "for models/hand.off)");
  add_replace_option(*command, arguments->files.replace);
  begin_option_group(*command, "Method");
  command
      ->add_option("--field", arguments->fields,
                   "Scalar field for the colours, with settings as in a configuration, such as offset_sdf,offset=0.03; "
                   "repeatable (default: offset_sdf and, for meshes, cone_sdf)")
      ->type_name(fmt::format("{{{}}}", fmt::join(field_types().names(), ",")));
  const CLI::Option* offset = add_offset_option(*command, arguments->offset);
  CLI::Option* parts = command->add_option("--parts", arguments->parts, "Number of parts per shape; 0: automatic")
                           ->check(within<int>(parameter_named("parts", part_segmentation_table).bounds))
                           ->capture_default_str();
  command->add_flag("--no-parts", arguments->no_parts, "Do not segment the shapes")->excludes(parts);
  begin_option_group(*command, "Display");
  command
      ->add_option("--max-faces", arguments->max_faces,
                   "Maximum number of faces or points shown; larger shapes are simplified after measurement")
      ->check(CLI::Range(Eigen::Index{100}, Eigen::Index{10'000'000}))
      ->capture_default_str();
  add_colour_options(*command, arguments->colours);
  add_up_option(*command, arguments->up);
  command->add_option("--title", arguments->title, "Page title (default: shape names)");
  add_cleaning_options(*command, arguments->cleaning);
  command->callback([arguments, &status, offset] { status = run(*arguments, offset->count() > 0); });
}

}  // namespace shapegauge
