#include "shapegauge/experiments/leaderboard/submissions.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/nearest_word.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/matrix_files.h"
#include "shapegauge/datasets/files/model_ids.h"
#include "shapegauge/datasets/files/ranked_answers.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

/// Returns the extensions of matrices, followed by those of ranked lists.
std::vector<std::string_view> submission_extensions() {
  const std::span<const std::string_view> matrices = matrix_extensions();
  std::vector<std::string_view> all(matrices.begin(), matrices.end());
  all.insert(all.end(), ranked_answers_extensions.begin(), ranked_answers_extensions.end());
  return all;
}

const std::vector<std::string> description_keys{"name", "authors", "paper", "url", "similarity", "distance", "ids"};

fs::path uncompressed_name(const fs::path& path) {
  return lower_case(path.extension().string()) == ".gz" ? fs::path(path).replace_extension() : path;
}

std::string text_at(const nlohmann::json& value, const std::string& key) {
  if (!value.is_string()) throw InputError(fmt::format("\"{}\" must be a text", key));
  return value.get<std::string>();
}

std::string authors_of(const nlohmann::json& value) {
  if (!value.is_array()) return text_at(value, "authors");
  std::vector<std::string> names;
  for (const nlohmann::json& name : value) names.push_back(text_at(name, "authors"));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string checked_url(const std::string& url) {
  if (url.starts_with("https://") || url.starts_with("http://")) return url;
  throw InputError("\"url\" must begin with https:// or http://");
}

std::string checked_distance(const std::string& distance) {
  const std::vector<std::string> known = feature_distance_names();
  if (std::ranges::find(known, distance) != known.end()) return distance;
  throw InputError(fmt::format("there is no distance {}{}", quoted_word(distance), suggestion(distance, known)));
}

void set_described(const std::string& key, const nlohmann::json& value, Submission& submission) {
  if (key == "name") submission.name = text_at(value, key);
  if (key == "authors") submission.authors = authors_of(value);
  if (key == "paper") submission.paper = text_at(value, key);
  if (key == "url") submission.url = checked_url(text_at(value, key));
  if (key == "distance") submission.distance = checked_distance(text_at(value, key));
  if (key == "ids") submission.ids = submission.file.parent_path() / text_at(value, key);
  if (key == "similarity") {
    if (!value.is_boolean()) throw InputError("\"similarity\" must be true or false");
    submission.similarity = value.get<bool>();
  }
}

// Reads the JSON file beside the submission. Throws InputError without the file's name.
void read_description(const fs::path& file, Submission& submission) {
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(read_file_bytes(file));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("this is not JSON: {}", error.what()));
  }
  if (!json.is_object()) throw InputError("expected an object with name, authors, paper and similarity");
  for (const auto& [key, value] : json.items()) {
    if (std::ranges::find(description_keys, key) == description_keys.end()) {
      throw InputError(fmt::format("there is no key {}{}", quoted_word(key), suggestion(key, description_keys)));
    }
    set_described(key, value, submission);
  }
  if (submission.similarity.value_or(false) && !submission.distance.empty()) {
    throw InputError(
        "\"distance\" applies to features, which are not similarities; remove \"distance\" or \"similarity\"");
  }
}

// Adds a file; refuses it if its description is invalid.
void add_submission(const fs::path& file, FoundSubmissions& found) {
  Submission submission{.file = file};
  const fs::path description = description_of(file);
  std::error_code unknown;
  if (fs::exists(description, unknown)) {
    try {
      read_description(description, submission);
    } catch (const InputError& error) {
      found.refused.push_back({.file = file, .reason = fmt::format("{}: {}", description.string(), error.what())});
      return;
    }
  }
  found.submissions.push_back(std::move(submission));
}

bool is_one_of(const fs::path& file, std::span<const fs::path> others) {
  return std::ranges::any_of(others, [&](const fs::path& other) {
    std::error_code unknown;
    return !other.empty() && fs::equivalent(file, other, unknown);
  });
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure); !failure && entry != fs::directory_iterator();
       entry.increment(failure)) {
    const bool hidden = entry->path().filename().string().starts_with('.');
    if (!hidden && !is_folder(entry->path())) files.push_back(entry->path());
  }
  if (failure) throw InputError(fmt::format("cannot read {}: {}", folder.string(), failure.message()));
  std::ranges::sort(files, natural_less, [](const fs::path& file) { return file.filename().string(); });
  return files;
}

void add_folder(const fs::path& folder, std::span<const fs::path> others, FoundSubmissions& found) {
  const std::size_t before = found.submissions.size() + found.refused.size();
  std::set<fs::path> described;
  for (const fs::path& file : files_in(folder)) {
    if (!is_submission_file(file) || is_one_of(file, others)) continue;
    described.insert(description_of(file));
    add_submission(file, found);
  }
  if (found.submissions.size() + found.refused.size() == before) {
    throw InputError(fmt::format("{}: no submissions in this folder; expected files {}, optionally with .gz",
                                 folder.string(), fmt::join(submission_extensions(), ", ")));
  }
  for (const fs::path& file : files_in(folder)) {
    if (is_submission_file(file) || described.contains(file) || is_one_of(file, others)) continue;
    if (lower_case(file.extension().string()) == ".json") {
      found.refused.push_back(
          {.file = file, .reason = "describes no submission: no matrix or list beside it has that name"});
    } else {
      found.skipped.push_back(file);
    }
  }
}

// Removes id files named by descriptions, which may look like submissions.
void remove_ids(FoundSubmissions& found) {
  std::vector<fs::path> ids;
  for (const Submission& submission : found.submissions) {
    if (!submission.ids.empty()) ids.push_back(submission.ids);
  }
  std::erase_if(found.submissions, [&](const Submission& submission) { return is_one_of(submission.file, ids); });
}

}  // namespace

fs::path description_of(const fs::path& submission) { return uncompressed_name(submission).replace_extension(".json"); }

bool is_submission_file(const fs::path& path) {
  const std::string extension = lower_case(uncompressed_name(path).extension().string());
  const std::vector<std::string_view> known = submission_extensions();
  return std::ranges::find(known, extension) != known.end();
}

FoundSubmissions find_submissions(std::span<const fs::path> paths, std::span<const fs::path> others) {
  FoundSubmissions found;
  for (const fs::path& path : paths) {
    std::error_code unknown;
    if (is_folder(path)) {
      add_folder(path, others, found);
    } else if (fs::exists(path, unknown)) {
      add_submission(path, found);
    } else {
      found.refused.push_back({.file = path, .reason = "no such file or folder"});
    }
  }
  remove_ids(found);
  return found;
}

}  // namespace shapegauge
