// Writes what the registries say into the files of the repository: configs/experiment.schema.json and the tables of
// docs/configuration.md. Run by the target update_reference.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/configuration/schema.h"

int main(int /*count*/, char** arguments) try {
  const std::filesystem::path repository = arguments[1];
  const std::filesystem::path page = repository / "docs/configuration.md";
  shapegauge::write_file_atomically(repository / "configs/experiment.schema.json", shapegauge::experiment_schema());
  shapegauge::write_file_atomically(page, shapegauge::with_reference_tables(shapegauge::read_file_bytes(page)));
  return 0;
} catch (const std::exception& error) {
  std::fputs(error.what(), stderr);
  return 1;
}
