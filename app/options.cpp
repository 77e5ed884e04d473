// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/help_format.h"
#include "app/parameter_options.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/length.h"
#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/up_axis.h"
#include "shapegauge/core/preparation/denoise.h"
#include "shapegauge/core/preparation/outliers.h"
#include "shapegauge/core/preparation/stray_normals.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/cache/cache_folder.h"
#include "shapegauge/experiments/engine/run_control.h"

namespace shapegauge {

void add_threads_option(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "Number of threads (default: all cores)")
      ->check(within<int>(threads_bounds))
      ->group(computation_options);
}

CLI::Option* add_part_option(CLI::App& command, std::string& part, const std::string& description) {
  return command.add_option("--part", part, description)->type_name("K/N")->group(computation_options);
}

void add_replace_option(CLI::App& command, bool& replace) {
  command.add_flag("--replace", replace, "Overwrite existing files")->group(output_options);
}

void add_format_option(CLI::App& command, std::string& format, const std::string& description) {
  std::vector<std::string> formats = list_of_words<TableFormat>();
  formats.emplace_back("json");
  command.add_option("--format", format, description)->check(one_of(formats))->capture_default_str();
}

void add_site_option(CLI::App& command, std::string& site) {
  command.add_option("--at", site, "Sample points of a mesh: centroids of faces, or vertices; clouds use their points")
      ->check(one_of({std::string(word_of(SampleSite::faces)), std::string(word_of(SampleSite::vertices))}))
      ->capture_default_str();
}

void add_up_option(CLI::App& command, std::string& up) {
  command.add_option("--up", up, without_full_stop(up_parameter().description))
      ->check(one_of(list_of_words<UpAxis>()))
      ->capture_default_str();
}

void add_seed_option(CLI::App& command, std::uint64_t& seed) {
  command.add_option("--seed", seed, "Random seed; equal seeds give equal results")
      ->check([](const std::string& text) {  // else -1 is read as the largest number
        const std::optional<double> number = parse_number(text);
        const bool possible =
            number && *number == std::floor(*number) && *number >= seed_bounds.low && *number <= seed_bounds.high;
        return possible ? std::string()
                        : fmt::format("must be an integer {}, not {}", to_string(seed_bounds), quoted_word(text));
      })
      ->capture_default_str();
}

void add_cleaning_options(CLI::App& command, CleaningArguments& arguments) {
  command.add_flag("--denoise", arguments.denoise, "Smooth clearly noisy meshes first")->group(computation_options);
  command
      .add_flag("--remove-outliers", arguments.remove_outliers,
                "Remove isolated points of clouds first (implied by --offset auto)")
      ->group(computation_options);
}

void add_unit_option(CLI::App& command, std::string& unit) {
  command.add_option("--unit", unit, "Unit of file coordinates, required for lengths such as 2mm; always m for glTF")
      ->check(one_of(length_unit_names()))
      ->group(input_options);
}

CLI::Option* add_offset_option(CLI::App& command, OffsetArguments& arguments) {
  add_unit_option(command, arguments.unit);
  return command
      .add_option("--offset", arguments.offset,
                  "Distance from shape to offset surface: fraction of the bounding-box diagonal (0.03 or 3%), length "
                  "(0.5mm; requires --unit) or auto (chosen by gaps and noise)")
      ->capture_default_str();
}

void add_colour_options(CLI::App& command, ColourArguments& arguments) {
  command
      .add_option("--range", arguments.range,
                  "Range of the colour map, such as 0,4 (file units) or 0.5mm,4mm (default: 2nd to 98th percentile, "
                  "weighted by area)")
      ->type_name("LOW,HIGH");
  command.add_option("--scale", arguments.scale, "Scale of the colour map")
      ->check(one_of({"linear", "log"}))
      ->capture_default_str();
  command
      .add_option("--below", arguments.below,
                  "Thickness below which the surface is red, such as 2 (file units) or 2mm (requires --unit)")
      ->type_name("LENGTH");
}

void add_cache_option(CLI::App& command, CacheOption& option) {
  command
      .add_option("--cache", option.named,
                  "Folder of cached results (default: $SHAPEGAUGE_CACHE, or shapegauge in $XDG_CACHE_HOME or ~/.cache)")
      ->group(computation_options);
}

std::filesystem::path requested_cache_folder(const CacheOption& option) {
  if (option.none) return {};
  return option.named.empty() ? default_cache_folder() : option.named;
}

bool set_unit_from_format(std::string& unit, const std::vector<std::filesystem::path>& files) {
  constexpr std::string_view metres = "m";
  const auto is_gltf = [](const std::filesystem::path& file) {
    const std::string extension = lower_case(file.extension().string());
    return extension == ".gltf" || extension == ".glb";
  };
  const auto found = std::ranges::find_if(files, is_gltf);
  if (found == files.end() || unit == metres) return false;
  if (!unit.empty()) {
    throw InputError(
        fmt::format("{}: coordinates of glTF files are in metres, not {}; omit --unit", found->string(), unit));
  }
  if (!std::ranges::all_of(files, is_gltf)) return false;
  unit = metres;
  return true;
}

RequestedOffset parse_offset(const OffsetArguments& arguments) {
  if (arguments.offset == "auto") return {};
  if (arguments.offset.ends_with('%')) {
    const std::optional<double> percent = parse_number(arguments.offset.substr(0, arguments.offset.size() - 1));
    if (!percent)
      throw InputError(fmt::format("--offset is {}; expected a number before %", quoted_word(arguments.offset)));
    require_in_bounds("--offset", *percent / 100, OffsetSdfOptions::offset_bounds);
    return {.fraction = *percent / 100};
  }
  const std::optional<Length> length = parse_length(arguments.offset);
  if (!length) {
    throw InputError(
        fmt::format("--offset is {}; it must be a fraction of the diagonal, a length such as 0.5mm, or auto",
                    quoted_word(arguments.offset)));
  }
  if (!length->unit.empty()) {
    const double in_units = in_file_units("--offset", *length, arguments.unit);
    if (!(in_units > 0)) throw InputError(fmt::format("--offset is {}; it must be above 0", arguments.offset));
    return {.fraction = {}, .length = in_units};
  }
  if (!arguments.unit.empty() && !arguments.unit_of_files) {
    throw InputError(
        fmt::format("--offset {0} with --unit may be a length or a fraction of the diagonal; write {0}{1} or {2:g}%",
                    arguments.offset, arguments.unit, 100 * length->value));
  }
  require_in_bounds("--offset", length->value, OffsetSdfOptions::offset_bounds);
  return {.fraction = length->value};
}

std::optional<double> RequestedOffset::fraction_of(const Shape& shape) const {
  if (!length) return fraction;
  const double diagonal = bounding_box_diagonal(shape);
  if (!(diagonal > 0)) throw InputError("the shape has no extent: its points all coincide");
  require_in_bounds("--offset, as a fraction of the shape's diagonal,", *length / diagonal,
                    OffsetSdfOptions::offset_bounds);
  return *length / diagonal;
}

double parse_length_option(std::string_view name, const std::string& text, const std::string& unit) {
  const std::optional<Length> length = parse_length(text);
  if (length) return in_file_units(name, *length, unit);
  throw InputError(fmt::format("{} has {}; it must be a length such as 2 or 2mm (units: {})", name, quoted_word(text),
                               fmt::join(length_unit_names(), ", ")));
}

ColourChoice parse_colours(const ColourArguments& arguments, const std::string& unit) {
  ColourChoice choice{.range = {}, .logarithmic = arguments.scale == "log"};
  if (!arguments.below.empty()) {
    choice.threshold = parse_length_option("--below", arguments.below, unit);
    if (!(*choice.threshold > 0)) throw InputError(fmt::format("--below is {}; it must be above 0", arguments.below));
  }
  if (arguments.range.empty()) return choice;
  const std::size_t comma = arguments.range.find(',');
  if (comma == std::string::npos) {
    throw InputError(fmt::format("--range is {}; it must be two lengths, such as 0,4", quoted_word(arguments.range)));
  }
  const Interval range{parse_length_option("--range", arguments.range.substr(0, comma), unit),
                       parse_length_option("--range", arguments.range.substr(comma + 1), unit)};
  if (!(range.low < range.high))
    throw InputError(fmt::format("--range is {}; its first length must be less than the second", arguments.range));
  if (choice.logarithmic && !(range.low > 0))
    throw InputError(fmt::format("--range is {}; with --scale log it must begin above 0", arguments.range));
  choice.range = range;
  return choice;
}

void remark_on_cavities(const Shape& shape, bool measures_hull, Remarks& remarks) {
  if (const auto remark = hollow_remark(shape, measures_hull)) {
    (measures_hull ? remarks.warnings : remarks.notes).push_back(*remark);
  }
}

void remark_on(const ChosenOffset& chosen, Remarks& remarks) {
  if (const std::string reasons = reasons_for_offset(chosen); !reasons.empty()) {
    remarks.notes.push_back(fmt::format("offset: {:.4g} % of the diagonal ({})", 100 * chosen.offset, reasons));
  }
  if (const auto leak = leak_warning(chosen)) remarks.warnings.push_back(*leak);
}

void remark_on(const FieldOutcomes& outcomes, Remarks& remarks) {
  for (std::string& warning : outcome_warnings(outcomes)) remarks.warnings.push_back(std::move(warning));
}

nlohmann::ordered_json to_json(const ChosenOffset& chosen) {
  nlohmann::ordered_json json{
      {"offset", chosen.offset}, {"automatic", chosen.automatic.has_value()}, {"gap_fraction", chosen.gap}};
  if (chosen.automatic) {
    json["noise_fraction"] = chosen.automatic->noise;
    json["sufficient"] = chosen.automatic->sufficient;
  }
  return json;
}

Shape cleaned(Shape shape, const CleaningArguments& arguments, bool automatic, Remarks& remarks) {
  if (automatic || arguments.remove_outliers) {
    const Eigen::Index points = shape.vertices.rows();
    shape = without_outliers(std::move(shape));
    if (const Eigen::Index count = points - shape.vertices.rows(); count > 0) {
      remarks.notes.push_back(outlier_text(static_cast<std::size_t>(count), points) +
                              "; results are for the other points, numbered without the outliers");
    }
  } else if (const auto warning = outlier_warning(shape)) {
    remarks.warnings.push_back(*warning);
  }
  if (remove_stray_normals(shape)) remarks.warnings.emplace_back(stray_normals_warning);
  if (!arguments.denoise) return shape;
  DenoisedShape result = denoised(std::move(shape));
  remarks.notes.push_back(result.pass_band > 0
                              ? fmt::format("noise of {:.2f} edge lengths, smoothed with a pass band of {:.3f}",
                                            result.noise.relative(), result.pass_band)
                              : "not clearly noisy; the shape stays unchanged");
  return std::move(result.shape);
}

}  // namespace shapegauge
