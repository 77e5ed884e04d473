#include "shapegauge/experiments/engine/generated_dataset.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/version.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/distributed/agreement.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Returns the folder's record of its data set; null if there is none.
Json record_in(const fs::path& file) {
  try {
    const Json record = fs::exists(file) ? read_json(file) : Json();
    return record.is_object() && record.contains("complete") ? record : Json();
  } catch (const InputError&) {
    return {};
  }
}

void generate(const fs::path& folder, const GeneratorOptions& options, const RunControl& control) {
  const fs::path record_file = folder / "generated.json";
  Json record{{"generate", to_json(options)}, {"version", version()}, {"commit", commit()}, {"complete", true}};
  const Json earlier = record_in(record_file);
  if (earlier == record) return;
  if (earlier.is_null() && fs::exists(record_file)) {
    throw InputError(fmt::format("cannot generate a data set in {}: {} is not the record of one; use another folder",
                                 folder.string(), record_file.string()));
  }

  // The record is written first, to recognise the folder after an interruption.
  fs::create_directories(folder);
  record["complete"] = false;
  GeneratorOptions now = options;
  now.force = earlier.is_object();
  if (now.force || fs::is_empty(folder)) write_file_atomically(record_file, record.dump(2) + "\n");
  generate_dataset(folder, now, [&](int done, int total) {
    if (control.interrupted()) throw Interrupted();
    control.progress("generating models", static_cast<std::size_t>(done), static_cast<std::size_t>(total));
  });
  record["complete"] = true;
  write_file_atomically(record_file, record.dump(2) + "\n");
}

}  // namespace

void prepare_generated(const fs::path& folder, const GeneratorOptions& options, const RunControl& control,
                       Communicator& ranks) {
  on_all_ranks(ranks, [&] {
    if (ranks.rank() == 0) generate(folder, options, control);
  });
}

}  // namespace shapegauge
