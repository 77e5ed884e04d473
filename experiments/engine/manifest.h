// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/engine/run_control.h"

namespace shapegauge {

/// Returns the processor type with those instruction sets for which libraries have special code, such as "x86-64 sse4.2
/// avx2 fma avx512f". The last bits of values may depend on them.
std::string processor();

/// Returns the description of the program and its platform in manifests: version, commit, compiler, build type,
/// libraries, processor.
nlohmann::ordered_json program_json();

/// Returns the list "failed_models" of a manifest: the id of each omitted shape and the reason.
nlohmann::ordered_json failures_json(std::span<const LeftOutShape> failures);

/// Formats the numbers of results found in the cache and computed, per kind of cache entry, as JSON; JSON null for a
/// disabled cache.
nlohmann::ordered_json cache_json(const CacheReport& cache);

/// Returns the SHA-256 of each result file in the folder, by file name. Omits files with run times, which vary between
/// runs.
nlohmann::ordered_json outputs_json(const std::filesystem::path& folder, std::span<const std::string> files);

}  // namespace shapegauge
