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
#include "shapegauge/core/preparation/gap_size.h"
#include "shapegauge/experiments/cache/cache_folder.h"
#include "shapegauge/experiments/configuration/fields.h"

namespace shapegauge {

namespace {

/// Two digits, rounded up, so that what is printed closes the gaps as well.
double rounded_up(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit) * unit;
}

/// What an offset below the gaps of the shape should be instead.
std::string advice(const ChosenOffset& chosen) {
  const double enough = rounded_up(1.1 * chosen.gap);
  if (enough > 1) return "no offset closes them";
  const bool automatic_is_enough = !chosen.automatic && enough <= AutomaticOffsetOptions{}.most;
  return fmt::format("use --offset {:.2g}{}", enough, automatic_is_enough ? " or auto" : "");
}

}  // namespace

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
  try {
    make_field({{"type", "offset_sdf"}, {"offset", *number}});
  } catch (const InputError& error) {
    throw InputError(fmt::format("--offset: {}", error.what()));
  }
  return number;
}

ChosenOffset choose_offset(std::optional<double> given, const Shape& shape) {
  ChosenOffset chosen;
  if (given) {
    chosen.offset = *given;
  } else {
    chosen.automatic = automatic_offset(shape);
    chosen.offset = chosen.automatic->offset;
  }
  const double gap = gap_size(shape);
  if (gap > 0) chosen.gap = gap / bounding_box_diagonal(shape);
  return chosen;
}

void remark_on(const ChosenOffset& chosen, Remarks& remarks) {
  // Openings too wide for any offset that is chosen automatically are left open.
  const bool leaves_gaps_open = chosen.automatic && chosen.gap > chosen.automatic->gap;
  if (chosen.automatic) {
    remarks.notes.push_back(fmt::format(
        "offset {:.4g} chosen (fractions of the diagonal: {:.4g} closes the gaps{}, {:.4g} levels the noise)",
        chosen.offset, chosen.automatic->gap,
        leaves_gaps_open ? fmt::format(" that at most {:.4g} can close", AutomaticOffsetOptions{}.most) : "",
        chosen.automatic->noise));
  }
  if (chosen.offset >= chosen.gap) return;
  remarks.warnings.push_back(
      fmt::format("the {} ({:.2g} % of the diagonal){}: the offset surface leaks into it; {}",
                  leaves_gaps_open ? "widest gap of the shape" : "offset is smaller than the gaps of the shape",
                  100 * chosen.gap, leaves_gaps_open ? " stays open" : "", advice(chosen)));
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
