// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/shape_files.h"
#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/configuration/chosen_offset.h"
#include "shapegauge/retrieval/histogram.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// Options shared by several commands.

namespace shapegauge {

/// Adds the option --threads, the number of threads for with_threads().
void add_threads_option(CLI::App& command, int& threads);

/// Adds the option --part, K/N for share K of a run distributed over N processes (parse_part()), with `description` as
/// its help text. Returns the option.
CLI::Option* add_part_option(CLI::App& command, std::string& part, const std::string& description);

/// Adds the switch --replace, which permits overwriting existing outputs (check_output_files()).
void add_replace_option(CLI::App& command, bool& replace);

/// Adds the option --format of printed tables: "table", "csv", "markdown", "latex" (TableFormat) or "json".
void add_format_option(CLI::App& command, std::string& format, const std::string& description);

/// Adds the option --at, which places samples at faces or vertices (words of SampleSite).
void add_site_option(CLI::App& command, std::string& site);

/// Adds the option --up, the vertical axis of the shapes (a word of UpAxis).
void add_up_option(CLI::App& command, std::string& up);

/// Adds the option --seed, a non-negative integer that initialises random numbers.
void add_seed_option(CLI::App& command, std::uint64_t& seed);

/// Requested preprocessing of a shape before it is measured (cleaned()).
struct CleaningArguments {
  bool denoise = false;          ///< true to smooth a clearly noisy mesh
  bool remove_outliers = false;  ///< true to remove isolated points of a point cloud
};

/// Adds the switches --denoise and --remove-outliers.
void add_cleaning_options(CLI::App& command, CleaningArguments& arguments);

/// Adds the option --unit, the unit of the files' coordinates.
void add_unit_option(CLI::App& command, std::string& unit);

/// Values of the options --offset and --unit, as text (parse_offset()).
struct OffsetArguments {
  std::string offset = "auto";  ///< "auto", a fraction such as 0.03 or 3%, or a length such as 0.5mm
  std::string unit = {};        ///< unit of the files' coordinates; empty if unknown
  bool unit_of_files = false;   ///< true if the unit comes from the file format, not from --unit
};

/// Sets an empty unit to metres if all files are glTF, whose coordinates are in metres. Returns true if it set the
/// unit. Throws InputError if a file is glTF and the unit is neither empty nor metres.
bool set_unit_from_format(std::string& unit, const std::vector<std::filesystem::path>& files);

/// Adds the options --offset and --unit, for parse_offset(). Returns the option --offset.
CLI::Option* add_offset_option(CLI::App& command, OffsetArguments& arguments);

/// Parsed value of --offset: a fraction of the bounding-box diagonal, a length, or neither for "auto".
struct RequestedOffset {
  std::optional<double> fraction = {};  ///< offset as a fraction of the bounding-box diagonal; absent otherwise
  std::optional<double> length = {};    ///< offset as a length in the files' units; absent otherwise

  /// Returns true for "auto".
  [[nodiscard]] bool is_automatic() const { return !fraction && !length; }

  /// Returns the offset as a fraction of the shape's diagonal; nothing for "auto". Throws InputError if the offset is
  /// out of the range of offset_sdf fields, or the shape has no extent.
  [[nodiscard]] std::optional<double> fraction_of(const Shape& shape) const;
};

/// Folder of the cache as requested by the user.
struct CacheOption {
  std::filesystem::path named;  ///< value of --cache; empty for default_cache_folder()
  bool none = false;            ///< true to compute without a cache
};

/// Adds the option --cache, the folder of the cache.
void add_cache_option(CLI::App& command, CacheOption& option);

/// Returns the folder of the cache; empty for no cache.
std::filesystem::path requested_cache_folder(const CacheOption& option);

/// Parses the value of --offset. Throws InputError for an invalid text, for a fraction out of the range of offset_sdf
/// fields, for a length with a unit if the files' unit is unknown, and for a number without a unit if --unit is given.
RequestedOffset parse_offset(const OffsetArguments& arguments);

/// Parses the length given for the option `name` and returns it in the files' units. Accepts "2" and, if the files'
/// `unit` is known, "2mm". Throws InputError for any other text.
double parse_length_option(std::string_view name, const std::string& text, const std::string& unit);

/// Values of the options --range, --scale and --below, which map values to colours.
struct ColourArguments {
  std::string range = {};        ///< lengths "LOW,HIGH" at the ends of the colour map; empty: chosen from the values
  std::string scale = "linear";  ///< colour scale: "linear" or "log"
  std::string below = {};        ///< length below which thickness is shown in red; empty for none
};

/// Adds the colour options --range, --scale and --below.
void add_colour_options(CLI::App& command, ColourArguments& arguments);

/// Parsed values of --range, --scale and --below, in the files' units.
struct ColourChoice {
  std::optional<Interval> range = {};    ///< values at the ends of the colour map; absent: chosen from the values
  bool logarithmic = false;              ///< true for a logarithmic colour map
  std::optional<double> threshold = {};  ///< thickness below which the surface is shown in red; absent for none
};

/// Parses the values of --range, --scale and --below. Throws InputError for an invalid length and for a range that is
/// empty or, with a logarithmic scale, not above 0.
ColourChoice parse_colours(const ColourArguments& arguments, const std::string& unit);

/// Adds a remark if the shape is a hollow body. With `measures_hull`, this is a warning that the offset SDF measures
/// the hull, without the cavity; otherwise a note that values are thicknesses of the wall.
void remark_on_cavities(const Shape& shape, bool measures_hull, Remarks& remarks);

/// Adds a note about an automatically chosen offset, and a warning if the offset is smaller than the shape's gaps.
void remark_on(const ChosenOffset& chosen, Remarks& remarks);

/// Adds the warnings of outcome_warnings() about the samples of a field.
void remark_on(const FieldOutcomes& outcomes, Remarks& remarks);

/// Encodes how an offset was chosen as JSON for the file of `--timings`, with the keys `offset`, `automatic`,
/// `gap_fraction`; for "auto" also `noise_fraction`, `sufficient`.
nlohmann::ordered_json to_json(const ChosenOffset& chosen);

/// Removes outliers (without_outliers()) and smooths noise (denoised()) as requested, always removes stray normals
/// (remove_stray_normals()), and adds remarks about all three. With `automatic` (--offset auto), always removes
/// outliers; otherwise adds a warning about outliers that stay.
Shape cleaned(Shape shape, const CleaningArguments& arguments, bool automatic, Remarks& remarks);

}  // namespace shapegauge
