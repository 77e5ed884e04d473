#include "shapegauge/experiments/runner/prepare_dataset.h"

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/atomic_file.h"
#include "shapegauge/core/version.h"
#include "shapegauge/experiments/configuration/parse_json.h"
#include "shapegauge/experiments/datasets/dataset_layouts.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

/// What the folder's own record says of the data set in it; null where there is none.
Json record_in(const fs::path& file) {
  try {
    return fs::exists(file) ? read_json(file) : Json();
  } catch (const InputError&) {
    return {};
  }
}

void generate(const fs::path& folder, const GeneratorOptions& options, const RunControl& control) {
  const fs::path record_file = folder / "generated.json";
  Json record{{"generate", to_json(options)}, {"version", version()}, {"commit", commit()}, {"complete", true}};
  const Json earlier = record_in(record_file);
  if (earlier == record) return;

  // The record comes first, to know the folder for our own again after an interruption.
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

Dataset prepare_dataset(const Configuration& configuration, const fs::path& generated_folder,
                        const RunControl& control) {
  if (!configuration.generator) return find_dataset(configuration.location.value());
  generate(generated_folder, *configuration.generator, control);
  return find_dataset({.layout = "shrec11", .root = generated_folder, .classification = generated_folder / "test.cla"});
}

}  // namespace shapegauge
