#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "app/shape_files.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/configuration/chosen_offset.h"

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

/// Adds --offset, for parse_offset(); `text` holds its default.
CLI::Option* add_offset_option(CLI::App& command, std::string& text);

/// The cache folder that the user asks for.
struct CacheOption {
  std::filesystem::path named;  ///< empty: default_cache_folder()
  bool none = false;
};

/// Adds --cache.
void add_cache_option(CLI::App& command, CacheOption& option);

/// The cache folder; empty for no cache.
std::filesystem::path chosen_cache(const CacheOption& option);

/// The value of --offset, a fraction of the bounding-box diagonal; nothing for "auto". Throws InputError for other text
/// and for an offset that offset_sdf fields do not take.
std::optional<double> parse_offset(const std::string& text);

/// Remarks on an offset that was chosen automatically, and warns of one below the gaps of the shape.
void remark_on(const ChosenOffset& chosen, Remarks& remarks);

/// The offset for `--timings`: `offset`, `automatic`, `gap_fraction`; for "auto" also `noise_fraction`, `sufficient`.
nlohmann::ordered_json to_json(const ChosenOffset& chosen);

/// The option --denoise: denoised(), with a remark on what it found.
Shape denoised_with_remark(Shape shape, Remarks& remarks);

}  // namespace shapegauge
