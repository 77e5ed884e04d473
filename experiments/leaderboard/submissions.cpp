// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/leaderboard/submissions.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <set>
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
#include "shapegauge/experiments/configuration/json_document.h"
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

// Returns true for a file name that ends in .seed or .fold and a number.
bool is_repetition(const fs::path& name) {
  static constexpr std::size_t mark_size = 5;
  const std::string extension = name.extension().string();
  return extension.size() > mark_size && (extension.starts_with(".seed") || extension.starts_with(".fold")) &&
         std::all_of(extension.begin() + mark_size, extension.end(), is_digit);
}

// Returns true for a text about the submissions, such as README.txt.
bool is_about_submissions(const fs::path& file) {
  static constexpr std::array<std::string_view, 5> names{"readme", "license", "licence", "copying", "changelog"};
  return std::ranges::find(names, lower_case(uncompressed_name(file).stem().string())) != names.end();
}

// Returns true for a file of the folder or of its subfolders, with links followed.
bool is_within(const fs::path& file, const fs::path& folder) {
  std::error_code failure;
  const fs::path root = fs::weakly_canonical(fs::absolute(folder), failure);
  const fs::path below = fs::weakly_canonical(fs::absolute(file), failure).lexically_relative(root);
  return !below.empty() && *below.begin() != "..";
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

// Pages are public: a submission cannot name files of the machine that makes them.
fs::path checked_ids(const fs::path& submission, const std::string& ids) {
  fs::path file = submission.parent_path() / ids;
  if (is_within(file, folder_of(submission))) return file;
  throw InputError(fmt::format("\"ids\" names {}, which is outside of the folder of the submission; put the file there",
                               quoted_word(ids)));
}

std::string text_at(const nlohmann::json& value, const std::string& key) {
  if (!value.is_string()) throw InputError(fmt::format("\"{}\" must be a string", key));
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
  if (key == "ids") submission.ids = checked_ids(submission.file, text_at(value, key));
  if (key == "similarity") {
    if (!value.is_boolean()) throw InputError("\"similarity\" must be true or false");
    submission.similarity = value.get<bool>();
  }
}

void set_all_described(const nlohmann::json& json, Submission& submission) {
  if (!json.is_object()) throw InputError("expected an object with name, authors, paper and similarity");
  for (const auto& [key, value] : json.items()) {
    if (std::ranges::find(description_keys, key) == description_keys.end()) {
      throw InputError(fmt::format("there is no key {}{}", quoted_word(key), suggestion(key, description_keys)));
    }
    set_described(key, value, submission);
  }
  if (submission.similarity.value_or(false) && !submission.distance.empty()) {
    throw InputError(
        R"("distance" applies to features, which are not similarities; remove "distance" or "similarity")");
  }
}

// Reads the JSON file next to the submission.
void read_description(const fs::path& file, Submission& submission) {
  if (!is_within(file, folder_of(file))) {
    throw InputError(fmt::format("{}: the link leads out of the folder of the submission", file.string()));
  }
  const nlohmann::json json = parse_json(read_file_bytes(file), file.string());
  with_source(file.string(), [&] { set_all_described(json, submission); });
}

// Adds a file; refuses it if its description is invalid.
void add_submission(const fs::path& file, FoundSubmissions& found) {
  Submission submission{.file = file};
  const fs::path description = description_of(file);
  if (is_repetition(uncompressed_name(file).replace_extension())) {
    submission.repetition_of = fs::path(description).replace_extension();
    submission.name = submission.repetition_of.filename().string();
  }
  std::error_code unknown;
  if (fs::exists(description, unknown)) {
    try {
      read_description(description, submission);
    } catch (const InputError& error) {
      found.refused.push_back({.file = file, .reason = error.what()});
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

void add_folder(const fs::path& folder, std::span<const fs::path> others, FoundSubmissions& found) {
  const std::size_t before = found.submissions.size() + found.refused.size();
  const std::vector<fs::path> files = visible_entries(folder, [](const fs::path& path) { return !is_folder(path); });
  std::set<fs::path> described;
  for (const fs::path& file : files) {
    if (!is_submission_file(file) || is_about_submissions(file) || is_one_of(file, others)) continue;
    described.insert(description_of(file));
    if (is_within(file, folder)) {
      add_submission(file, found);
    } else {
      found.refused.push_back({.file = file, .reason = "the link leads out of the folder; replace it by the file"});
    }
  }
  if (found.submissions.size() + found.refused.size() == before) {
    throw InputError(fmt::format("{}: no submissions in this folder; expected files {}, optionally with .gz",
                                 folder.string(), fmt::join(submission_extensions(), ", ")));
  }
  for (const fs::path& file : files) {
    if (described.contains(file) || is_one_of(file, others)) continue;
    if (is_submission_file(file) && !is_about_submissions(file)) continue;
    if (lower_case(file.extension().string()) == ".json") {
      found.refused.push_back(
          {.file = file, .reason = "describes no submission: no matrix or list in its folder has that name"});
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

fs::path description_of(const fs::path& submission) {
  fs::path name = uncompressed_name(submission).replace_extension();
  if (is_repetition(name)) name.replace_extension();
  return name += ".json";
}

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
