// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace shapegauge {

/// Submission: a file of distances, similarities, features or ranked lists, with the contents of its JSON file.
struct Submission {
  std::filesystem::path file;
  std::string name{};     ///< if empty, by its file, see method_name()
  std::string authors{};  ///< empty if not given
  std::string paper{};
  std::string url{};                      ///< begins with http:// or https://
  std::optional<bool> similarity{};       ///< larger values are nearer; absent if not given
  std::string distance{};                 ///< distance between features, if the file has features
  std::filesystem::path ids{};            ///< ids of the rows, one per line
  std::filesystem::path repetition_of{};  ///< method of a repetition: foo of foo.seed1.npy or foo.fold1.npy; or empty
};

/// Refused submission or part of one.
struct RefusedSubmission {
  std::filesystem::path file;
  std::string reason;  ///< one line with the fault and the remedy
};

/// Submissions found.
struct FoundSubmissions {
  std::vector<Submission> submissions;         ///< in the order of the paths, and in natural order within a folder
  std::vector<RefusedSubmission> refused;      ///< invalid JSON files, and those without a submission
  std::vector<std::filesystem::path> skipped;  ///< other files of folders, except hidden ones
};

/// Returns the file that describes a submission: foo.json next to foo.npy, foo.csv.gz or foo.seed1.npy.
std::filesystem::path description_of(const std::filesystem::path& submission);

/// Returns true if the name has an extension of a format that evaluate_files() reads.
bool is_submission_file(const std::filesystem::path& path);

/// Finds submissions: each path is a file or a folder of files (without subfolders). The optional keys of a JSON file
/// are name, authors (a text or a list of them), paper, url, similarity, distance and ids. `others` are files in such a
/// folder that are not submissions, such as the labels; empty paths are ignored. A missing path is refused, as are
/// links of a folder, descriptions and files of ids that lead out of the submission's folder. Throws InputError for a
/// folder that cannot be read or has no submission.
FoundSubmissions find_submissions(std::span<const std::filesystem::path> paths,
                                  std::span<const std::filesystem::path> others = {});

}  // namespace shapegauge
