#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "app/shape_files.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/configuration/chosen_offset.h"
#include "shapegauge/retrieval/histogram.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// The options that several commands share, and what they stand for.

namespace shapegauge {

/// Adds --threads, for with_threads().
void add_threads_option(CLI::App& command, int& threads);

/// Adds --seed: 0 or more.
void add_seed_option(CLI::App& command, std::uint64_t& seed);

/// Adds --denoise.
void add_denoise_option(CLI::App& command, bool& denoise);

/// The options --offset and --unit. `offset` holds the default.
struct OffsetArguments {
  std::string offset = "auto";
  std::string unit = {};  ///< of the files' coordinates; empty: not known
};

/// Adds --offset and --unit, for parse_offset(). Returns --offset.
CLI::Option* add_offset_option(CLI::App& command, OffsetArguments& arguments);

/// The value of --offset: a fraction of the bounding box's diagonal, a length, or neither for "auto".
struct GivenOffset {
  std::optional<double> fraction = {};
  std::optional<double> length = {};  ///< in the files' units

  /// As a fraction of the shape's diagonal; nothing for "auto". Throws InputError where that is no offset of fields
  /// offset_sdf, or the shape has no extent.
  [[nodiscard]] std::optional<double> fraction_of(const Shape& shape) const;
};

/// The cache folder that the user asks for.
struct CacheOption {
  std::filesystem::path named;  ///< empty: default_cache_folder()
  bool none = false;
};

/// Adds --cache.
void add_cache_option(CLI::App& command, CacheOption& option);

/// The cache folder; empty for no cache.
std::filesystem::path chosen_cache(const CacheOption& option);

/// The value of --offset. Throws InputError for text that is none, for a fraction that offset_sdf fields do not take,
/// and for a length in a unit where --unit is not given.
GivenOffset parse_offset(const OffsetArguments& arguments);

/// The value of an option that takes a length, in the files' units: 2, or 2mm where `unit`, that of the files, is
/// known. Throws InputError for anything else.
double parse_length_option(std::string_view name, const std::string& text, const std::string& unit);

/// The options that say how values become colours.
struct ColourArguments {
  std::string range = {};  ///< LOW,HIGH; empty: by the values
  std::string scale = "linear";
  std::string below = {};  ///< a threshold; empty: none
};

/// Adds --range, --scale and --below.
void add_colour_options(CLI::App& command, ColourArguments& arguments);

/// What the options say, in the files' units.
struct ColourChoice {
  std::optional<Interval> range = {};
  bool logarithmic = false;
  std::optional<double> threshold = {};
};

/// Throws InputError for wrong values: lengths that are none, a range that is empty or, with a logarithmic scale, not
/// above 0.
ColourChoice parse_colours(const ColourArguments& arguments, const std::string& unit);

/// Warns where values of the offset SDF are those of the hull of a hollow body, and notes that other thicknesses are of
/// its wall.
void remark_on_cavities(const Shape& shape, bool measures_hull, Remarks& remarks);

/// Remarks on an offset that was chosen automatically, and warns of one below the gaps of the shape.
void remark_on(const ChosenOffset& chosen, Remarks& remarks);

/// The offset for `--timings`: `offset`, `automatic`, `gap_fraction`; for "auto" also `noise_fraction`, `sufficient`.
nlohmann::ordered_json to_json(const ChosenOffset& chosen);

/// The option --denoise: denoised(), with a remark on what it found.
Shape denoised_with_remark(Shape shape, Remarks& remarks);

}  // namespace shapegauge
