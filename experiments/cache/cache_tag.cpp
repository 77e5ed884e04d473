#include "shapegauge/experiments/cache/cache_tag.h"

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/atomic_file.h"
#include "shapegauge/core/io/file_bytes.h"

namespace shapegauge {

namespace {

constexpr std::string_view tag =
    "Signature: 8a477f597d28d172789f06886806bc55\n"
    "# This folder is a cache of shapegauge; see `shapegauge cache --help`. It can be removed at any time.\n";

}  // namespace

void write_cache_tag(const std::filesystem::path& cache) {
  if (!std::filesystem::exists(cache / cache_tag_name)) write_file_atomically(cache / cache_tag_name, tag);
}

bool has_cache_tag(const std::filesystem::path& cache) {
  try {
    return read_file_bytes(cache / cache_tag_name, tag.size() + 1) == tag;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace shapegauge
