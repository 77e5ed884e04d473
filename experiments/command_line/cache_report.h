#pragma once

#include <string>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/command_line/progress_line.h"

namespace shapegauge {

/// A line that says what a run took from the cache, "From the cache: 600 of 600 fields, ..."; empty where that is
/// nothing.
std::string cache_text(const CacheReport& cache);

/// At the end of its scope, however a run ends, it says on standard error what the cache could not do.
class CacheWarnings {
 public:
  CacheWarnings(const Cache& cache, ProgressLine& progress) : cache_(&cache), progress_(&progress) {}
  CacheWarnings(const CacheWarnings&) = delete;
  CacheWarnings& operator=(const CacheWarnings&) = delete;
  CacheWarnings(CacheWarnings&&) = delete;
  CacheWarnings& operator=(CacheWarnings&&) = delete;
  ~CacheWarnings();

 private:
  const Cache* cache_;
  ProgressLine* progress_;
};

}  // namespace shapegauge
