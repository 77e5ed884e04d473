#include "app/options.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/preparation/denoise.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/experiments/cache/cache_folder.h"

namespace shapegauge {

void add_threads_option(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "Number of threads (default: all)")->check(CLI::Range(1, 1024));
}

void add_seed_option(CLI::App& command, std::uint64_t& seed) {
  command.add_option("--seed", seed, "The same seed gives the same result")
      ->check([](const std::string& text) {  // else -1 is read as the largest number
        const std::optional<double> number = parse_number(text);
        const bool possible =
            number && *number == std::floor(*number) && *number >= seed_bounds.low && *number <= seed_bounds.high;
        return possible ? std::string()
                        : fmt::format("must be an integer {}, not {}", to_string(seed_bounds), quoted_word(text));
      })
      ->capture_default_str();
}

void add_denoise_option(CLI::App& command, bool& denoise) {
  command.add_flag("--denoise", denoise, "Smooth a mesh first whose vertices are noisy beyond doubt");
}

CLI::Option* add_offset_option(CLI::App& command, std::string& text) {
  return command
      .add_option("--offset", text,
                  "Offset distance as a fraction of the bounding-box diagonal, or auto: by the gaps and the noise")
      ->capture_default_str();
}

void add_cache_option(CLI::App& command, CacheOption& option) {
  command.add_option("--cache", option.named,
                     "Folder of the cache (default: $SHAPEGAUGE_CACHE, or shapegauge in $XDG_CACHE_HOME or ~/.cache)");
}

std::filesystem::path chosen_cache(const CacheOption& option) {
  if (option.none) return {};
  return option.named.empty() ? default_cache_folder() : option.named;
}

std::optional<double> parse_offset(const std::string& text) {
  if (text == "auto") return std::nullopt;
  const std::optional<double> number = parse_number(text);
  if (!number) {
    throw InputError(fmt::format("--offset is {}: it must be a fraction of the diagonal, or auto", quoted_word(text)));
  }
  require_in_bounds("--offset", *number, OffsetSdfOptions::offset_bounds);
  return number;
}

void remark_on(const ChosenOffset& chosen, Remarks& remarks) {
  if (chosen.automatic) {
    remarks.notes.push_back(fmt::format(
        "offset {:.4g} chosen (fractions of the diagonal: {:.4g} closes the gaps{}, {:.4g} levels the noise)",
        chosen.offset, chosen.automatic->gap,
        leaves_gaps_open(chosen) ? fmt::format(" that at most {:.4g} can close", AutomaticOffsetOptions{}.most) : "",
        chosen.automatic->noise));
  }
  if (const auto leak = leak_warning(chosen, Audience::command_line)) remarks.warnings.push_back(*leak);
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

Shape denoised_with_remark(Shape shape, Remarks& remarks) {
  DenoisedShape result = denoised(std::move(shape));
  remarks.notes.push_back(result.pass_band > 0
                              ? fmt::format("noise of {:.2f} edge lengths, smoothed with a pass band of {:.3f}",
                                            result.noise.relative(), result.pass_band)
                              : "no noise beyond doubt, the shape stays as it is");
  return std::move(result.shape);
}

}  // namespace shapegauge
