// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/engine/generated_dataset.h"

#include <chrono>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <thread>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/version.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/engine/result_folder.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* record_name = "generated.json";

/// Returns the folder's record of its data set; null if there is none.
Json record_in(const fs::path& file) {
  try {
    const Json record = fs::exists(file) ? read_json(file) : Json();
    return record.is_object() && record.contains("complete") ? record : Json();
  } catch (const InputError&) {
    return {};
  }
}

/// Returns true if the folder has no files but the lock.
bool has_only_lock(const fs::path& folder) {
  return std::next(fs::directory_iterator(folder)) == fs::directory_iterator();
}

void generate(const fs::path& folder, const GeneratorOptions& options, Json record, const Json& earlier,
              const RunControl& control) {
  const fs::path record_file = folder / record_name;
  if (earlier.is_null() && fs::exists(record_file)) {
    throw InputError(fmt::format("cannot generate a data set in {}: {} is not the record of one; use another folder",
                                 folder.string(), record_file.string()));
  }
  // The record is written first, to recognise the folder after an interruption.
  record["complete"] = false;
  GeneratorOptions now = options;
  now.replace = earlier.is_object();
  if (now.replace || has_only_lock(folder)) write_file_atomically(record_file, record.dump(2) + "\n");
  generate_dataset(folder, now, [&](int done, int total) {
    if (control.interrupted()) throw Interrupted();
    control.progress("generating models", static_cast<std::size_t>(done), static_cast<std::size_t>(total));
  });
  record["complete"] = true;
  write_file_atomically(record_file, record.dump(2) + "\n");
}

}  // namespace

void prepare_generated(const fs::path& folder, const GeneratorOptions& options, const RunControl& control) {
  const Json record{{"generate", to_json(options)}, {"version", version()}, {"commit", commit()}, {"complete", true}};
  if (record_in(folder / record_name) == record) return;
  const FolderLock lock(folder, [&] {
    if (control.interrupted()) throw Interrupted();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  });
  const Json earlier = record_in(folder / record_name);
  if (earlier != record) generate(folder, options, record, earlier, control);
}

}  // namespace shapegauge
