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

/// Returns the program and its platform: version, commit, compiler, build type, libraries, processor.
nlohmann::ordered_json program_json();

/// Returns the list "failed_models" of a manifest: what the run omitted, and why.
nlohmann::ordered_json failures_json(std::span<const LeftOutShape> failures);

/// Returns the numbers of results from the cache and computed, by kind; null if there was no cache.
nlohmann::ordered_json cache_json(const CacheReport& cache);

/// Returns SHA-256 of the result files in the folder, by name, without tables of timings, which vary between runs.
nlohmann::ordered_json outputs_json(const std::filesystem::path& folder, std::span<const std::string> files);

}  // namespace shapegauge
