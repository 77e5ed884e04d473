#include "shapegauge/experiments/command_line/cache_report.h"

#include <array>
#include <cstdio>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string_view>
#include <utility>
#include <vector>

namespace shapegauge {

std::string cache_text(const CacheReport& cache) {
  constexpr std::array<std::pair<EntryKind, std::string_view>, 4> shown{{{EntryKind::shape, "shapes"},
                                                                         {EntryKind::field, "fields"},
                                                                         {EntryKind::histogram, "histograms"},
                                                                         {EntryKind::distances, "distance matrices"}}};
  std::vector<std::string> parts;
  bool any = false;
  for (const auto& [kind, name] : shown) {
    const CacheUse& use = cache.uses.at(static_cast<std::size_t>(kind));
    parts.push_back(fmt::format("{} of {} {}", use.taken, use.taken + use.computed, name));
    any = any || use.taken > 0;
  }
  return any ? fmt::format("From the cache: {}\n", fmt::join(parts, ", ")) : "";
}

CacheWarnings::~CacheWarnings() {
  const std::vector<std::string> warnings = cache_->warnings();
  if (!warnings.empty()) progress_->clear();
  for (const std::string& warning : warnings) fmt::print(stderr, "shapegauge: warning: {}\n", warning);
}

}  // namespace shapegauge
