#include "app/options.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/preparation/denoise.h"
#include "shapegauge/core/preparation/gap_size.h"
#include "shapegauge/experiments/cache/cache_folder.h"

namespace shapegauge {

void add_cache_option(CLI::App& command, CacheOption& option) {
  command.add_option("--cache", option.named,
                     "Folder of the cache (default: $SHAPEGAUGE_CACHE, or shapegauge in $XDG_CACHE_HOME or ~/.cache)");
}

std::filesystem::path chosen_cache(const CacheOption& option) {
  if (option.none) return {};
  return option.named.empty() ? default_cache_folder() : option.named;
}

Shape denoised_with_report(Shape shape) {
  DenoisedShape result = denoised(std::move(shape));
  if (result.pass_band > 0) {
    fmt::print(stderr, "shapegauge: noise of {:.2f} edge lengths, smoothed with a pass band of {:.3f}\n",
               result.noise.relative(), result.pass_band);
  } else {
    fmt::print(stderr, "shapegauge: no noise beyond doubt, the shape stays as it is\n");
  }
  return std::move(result.shape);
}

namespace {

/// Two digits, rounded up, so that what is printed closes the gaps as well.
double rounded_up(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit) * unit;
}

void warn_of_gaps(const ChosenOffset& chosen) {
  const double enough = rounded_up(1.1 * chosen.gap);
  const bool automatic_is_enough = !chosen.automatic && enough <= AutomaticOffsetOptions{}.most;
  fmt::print(stderr,
             "shapegauge: warning: the offset is smaller than the gaps of the shape ({:.2g} % of the diagonal): the "
             "offset surface leaks into it; use --offset {:.2g}{}\n",
             100 * chosen.gap, enough, automatic_is_enough ? " or auto" : "");
}

}  // namespace

std::optional<double> parse_offset(const std::string& text) {
  if (text == "auto") return std::nullopt;
  const std::optional<double> number = parse_number(text);
  if (number && *number > 0 && *number <= 1) return number;
  throw InputError(fmt::format("--offset is {}: it must be a fraction of the diagonal, above 0 and at most 1, or auto",
                               quoted_word(text)));
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

void report(const ChosenOffset& chosen) {
  if (chosen.automatic) {
    fmt::print(stderr,
               "shapegauge: offset {:.4g} chosen (fractions of the diagonal: {:.4g} closes the gaps, {:.4g} levels "
               "the noise)\n",
               chosen.offset, chosen.automatic->gap, chosen.automatic->noise);
  }
  if (chosen.offset < chosen.gap) warn_of_gaps(chosen);
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

void add_shape_argument(CLI::App& command, std::filesystem::path& input) {
  command.add_option("input", input, "Mesh or point cloud: OFF, OBJ, PLY, STL, XYZ, PWN, PTS or TXT")->required();
}

void add_threads_option(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "Number of threads (default: all)")->check(CLI::Range(1, 1024));
}

}  // namespace shapegauge
