#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/shape/shape.h"

namespace CLI {
class App;
}

namespace shapegauge {

/// The folder of the cache that the user wants.
struct CacheOption {
  std::filesystem::path named;  ///< empty: default_cache_folder()
  bool none = false;
};

/// Adds `--cache` to a command, which leaves what the user says in `option`.
void add_cache_option(CLI::App& command, CacheOption& option);

/// The folder; empty where there is to be no cache.
std::filesystem::path chosen_cache(const CacheOption& option);

/// What the option --denoise does: the shape without its noise (denoised()), with a line on standard error that says
/// what was found.
Shape denoised_with_report(Shape shape);

/// The offset that a shape is measured with, as fractions of the bounding-box diagonal.
struct ChosenOffset {
  double offset = 0;
  double gap = 0;                            ///< the shape's gap_size()
  std::optional<AutomaticOffset> automatic;  ///< why it was chosen, where the option says "auto"
};

/// The number that the option --offset gives, or nothing for "auto". Throws InputError for anything else, and for a
/// number that is not a fraction of the diagonal (above 0, at most 1).
std::optional<double> parse_offset(const std::string& text);

/// The offset for a shape: the one given, or automatic_offset(). Throws InputError where the shape has no extent.
ChosenOffset choose_offset(std::optional<double> given, const Shape& shape);

/// Tells on standard error which offset was chosen, and warns of one that is smaller than the shape's gaps.
void report(const ChosenOffset& chosen);

/// What `--timings` tells of it: `offset`, `gap_fraction`, and of a choice `noise_fraction` and `sufficient`.
nlohmann::ordered_json to_json(const ChosenOffset& chosen);

/// Adds the file of the shape that a command is about: whatever read_shape() reads.
void add_shape_argument(CLI::App& command, std::filesystem::path& input);

/// Adds --threads; with_threads() takes what it gives.
void add_threads_option(CLI::App& command, int& threads);

}  // namespace shapegauge
