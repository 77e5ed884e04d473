// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/engine/manifest.h"

#include <nlohmann/json.hpp>

#include "shapegauge/core/version.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/engine/build_information.h"
#include "shapegauge/experiments/engine/result_folder.h"

namespace shapegauge {

using OrderedJson = nlohmann::ordered_json;

std::string processor() {
#if defined(__x86_64__)
  std::string text = "x86-64";
  // __builtin_cpu_supports() needs literals.
  if (__builtin_cpu_supports("sse4.2")) text += " sse4.2";
  if (__builtin_cpu_supports("avx")) text += " avx";
  if (__builtin_cpu_supports("avx2")) text += " avx2";
  if (__builtin_cpu_supports("fma")) text += " fma";
  if (__builtin_cpu_supports("avx512f")) text += " avx512f";
  if (__builtin_cpu_supports("avx512dq")) text += " avx512dq";
  if (__builtin_cpu_supports("avx512vl")) text += " avx512vl";
  return text;
#elif defined(__aarch64__)
  return "aarch64";
#else
  return "other";
#endif
}

OrderedJson program_json() {
  return {{"shapegauge", version()},
          {"commit", commit()},
          {"compiler", compiler()},
          {"build_type", build_type()},
          {"libraries", OrderedJson::parse(library_versions())},
          {"processor", processor()}};
}

OrderedJson failures_json(std::span<const LeftOutShape> failures) {
  OrderedJson list = OrderedJson::array();
  for (const LeftOutShape& failure : failures) list.push_back({{"model", failure.id}, {"error", failure.message}});
  return list;
}

OrderedJson cache_json(const CacheReport& cache) {
  if (cache.folder.empty()) return nullptr;
  OrderedJson json = OrderedJson::object();
  for (std::size_t kind = 0; kind < number_of_entry_kinds; ++kind) {
    const CacheUse& use = cache.uses.at(kind);
    if (use.hits + use.computed == 0) continue;
    json[std::string(entry_kind_names.at(kind))] = {{"from_cache", use.hits}, {"computed", use.computed}};
  }
  return json;
}

OrderedJson outputs_json(const std::filesystem::path& folder, std::span<const std::string> files) {
  OrderedJson hashes = OrderedJson::object();
  for (const std::string& file : files) {
    if (!holds_timings(file)) hashes[file] = sha256_of_file(folder / file);
  }
  return {{"algorithm", "SHA-256"}, {"files", std::move(hashes)}};
}

}  // namespace shapegauge
