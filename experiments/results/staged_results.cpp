#include "shapegauge/experiments/results/staged_results.h"

#include <fmt/format.h>
#include <system_error>
#include <utility>

#include "shapegauge/core/error.h"
#include "shapegauge/experiments/results/result_folder.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

void move_file(const fs::path& from, const fs::path& to) {
  make_folder(to.parent_path());
  std::error_code failure;
  fs::rename(from, to, failure);
  if (failure) throw InputError(fmt::format("cannot write {}: {}", to.string(), failure.message()));
}

}  // namespace

StagedResults::StagedResults(fs::path destination)
    : destination_(std::move(destination)), folder_(destination_ / ".shapegauge-new") {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);  // of a run that was killed
  make_folder(folder_);
}

StagedResults::~StagedResults() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void StagedResults::publish(const std::vector<std::string>& files) {
  const std::vector<std::string> earlier = earlier_results(destination_);
  for (const std::string& file : files) move_file(folder_ / file, destination_ / file);
  move_file(folder_ / manifest_name, destination_ / manifest_name);
  remove_superseded(destination_, earlier, files);
}

}  // namespace shapegauge
