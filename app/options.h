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

/// Adds --threads, for with_threads().
void add_threads_option(CLI::App& command, int& threads);

/// Adds --part, for parse_part(). Returns it.
CLI::Option* add_part_option(CLI::App& command, std::string& part, const std::string& description);

/// Adds --replace, for check_output_files().
void add_replace_option(CLI::App& command, bool& replace);

/// Adds --format: a TableFormat or json.
void add_format_option(CLI::App& command, std::string& format, const std::string& description);

/// Adds --at: faces or vertices, words of SampleSite.
void add_site_option(CLI::App& command, std::string& site);

/// Adds --up, a word of UpAxis.
void add_up_option(CLI::App& command, std::string& up);

/// Adds --seed, a non-negative integer.
void add_seed_option(CLI::App& command, std::uint64_t& seed);

/// What to do with a shape before it is measured.
struct CleaningArguments {
  bool denoise = false;
  bool remove_outliers = false;
};

/// Adds --denoise and --remove-outliers.
void add_cleaning_options(CLI::App& command, CleaningArguments& arguments);

/// Adds --unit.
void add_unit_option(CLI::App& command, std::string& unit);

/// Values of --offset and --unit. `offset` holds the default.
struct OffsetArguments {
  std::string offset = "auto";
  std::string unit = {};       ///< of the files' coordinates; empty if unknown
  bool unit_of_files = false;  ///< whether the unit is that of the files' format, not given
};

/// Sets the unit to metres if it is not given and all files are glTF, whose unit that is. Returns whether it did.
/// Throws InputError if another unit is given for such a file.
bool take_unit_of_files(std::string& unit, const std::vector<std::filesystem::path>& files);

/// Adds --offset and --unit, for parse_offset(). Returns --offset.
CLI::Option* add_offset_option(CLI::App& command, OffsetArguments& arguments);

/// Parsed value of --offset: a fraction of the bounding-box diagonal, a length, or neither for "auto".
struct GivenOffset {
  std::optional<double> fraction = {};
  std::optional<double> length = {};  ///< in the files' units

  [[nodiscard]] bool is_automatic() const { return !fraction && !length; }

  /// Returns the offset as a fraction of the shape's diagonal; nothing for "auto". Throws InputError if the offset is
  /// out of the range of offset_sdf fields, or the shape has no extent.
  [[nodiscard]] std::optional<double> fraction_of(const Shape& shape) const;
};

/// Cache folder requested by the user.
struct CacheOption {
  std::filesystem::path named;  ///< empty: default_cache_folder()
  bool none = false;
};

/// Adds --cache.
void add_cache_option(CLI::App& command, CacheOption& option);

/// Returns the cache folder; empty for no cache.
std::filesystem::path chosen_cache(const CacheOption& option);

/// Parses --offset. Throws InputError for an invalid text, for a fraction out of the range of offset_sdf fields, and
/// for a length with a unit if --unit is not given.
GivenOffset parse_offset(const OffsetArguments& arguments);

/// Parses an option that takes a length and returns it in the files' units: 2, or 2mm if `unit`, that of the files, is
/// known. Throws InputError for any other text.
double parse_length_option(std::string_view name, const std::string& text, const std::string& unit);

/// Options of the mapping of values to colours.
struct ColourArguments {
  std::string range = {};  ///< LOW,HIGH; empty for the range of the values
  std::string scale = "linear";
  std::string below = {};  ///< threshold; empty for none
};

/// Adds --range, --scale and --below.
void add_colour_options(CLI::App& command, ColourArguments& arguments);

/// Parsed colour options, in the files' units.
struct ColourChoice {
  std::optional<Interval> range = {};
  bool logarithmic = false;
  std::optional<double> threshold = {};
};

/// Parses the colour options. Throws InputError for an invalid length and for a range that is empty or, with a
/// logarithmic scale, not above 0.
ColourChoice parse_colours(const ColourArguments& arguments, const std::string& unit);

/// Remarks on hollow bodies: warns if offset SDF values are those of the hull, and notes that other thicknesses are
/// those of the wall.
void remark_on_cavities(const Shape& shape, bool measures_hull, Remarks& remarks);

/// Notes an automatically chosen offset, and warns of an offset smaller than the gaps of the shape.
void remark_on(const ChosenOffset& chosen, Remarks& remarks);

/// Adds the warnings about samples (outcome_warnings()).
void remark_on(const FieldOutcomes& outcomes, Remarks& remarks);

/// Returns the offset for `--timings`: `offset`, `automatic`, `gap_fraction`; for "auto" also `noise_fraction`,
/// `sufficient`.
nlohmann::ordered_json to_json(const ChosenOffset& chosen);

/// Removes outliers (without_outliers()) and smooths noise (denoised()) as requested, with remarks on both. With
/// `automatic`, outliers are removed anyway; otherwise those that stay are warned of.
Shape cleaned(Shape shape, const CleaningArguments& arguments, bool automatic, Remarks& remarks);

}  // namespace shapegauge
