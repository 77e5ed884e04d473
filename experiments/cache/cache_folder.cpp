#include "shapegauge/experiments/cache/cache_folder.h"

#include <charconv>
#include <cstdlib>
#include <fmt/format.h>
#include <limits>

#include "shapegauge/core/error.h"
#include "shapegauge/core/printable.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

/// The value of an environment variable; nullptr where it is not set.
const char* variable(const char* name) {
  return std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing here changes the environment
}

/// An absolute path in an environment variable; empty where there is none. The XDG specification has relative ones
/// ignored.
fs::path folder_in(const char* name) {
  const char* value = variable(name);
  const fs::path path = value == nullptr ? "" : value;
  return path.is_absolute() ? path : fs::path();
}

}  // namespace

fs::path default_cache_folder() {
  if (const char* named = variable("SHAPEGAUGE_CACHE")) return named;
  if (const fs::path caches = folder_in("XDG_CACHE_HOME"); !caches.empty()) return caches / "shapegauge";
  const fs::path home = folder_in("HOME");
  return home.empty() ? fs::path() : home / ".cache" / "shapegauge";
}

std::uintmax_t parse_size(std::string_view text, std::string_view name) {
  std::uintmax_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  constexpr std::string_view units = "KMGT";
  std::uintmax_t factor = 1;
  if (unit.size() == 1 && units.find(unit.front()) != std::string_view::npos) {
    for (std::size_t i = 0; i <= units.find(unit.front()); ++i) factor *= 1000;
  }
  const bool known_unit = unit.empty() || factor > 1;
  if (error != std::errc() || !known_unit || number > std::numeric_limits<std::uintmax_t>::max() / factor) {
    throw InputError(fmt::format("{} must be a size such as 500M or 10G, not \"{}\"", name, printable(text, 100)));
  }
  return number * factor;
}

std::uintmax_t cache_limit() {
  const char* given = variable("SHAPEGAUGE_CACHE_LIMIT");
  return parse_size(given == nullptr ? "10G" : given, "SHAPEGAUGE_CACHE_LIMIT");
}

}  // namespace shapegauge
