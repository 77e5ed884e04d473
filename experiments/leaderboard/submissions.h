// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace shapegauge {

/// Submission to a leaderboard: a file of distances, similarities, features or ranked lists, with the contents of its
/// JSON file.
struct Submission {
  std::filesystem::path file;             ///< file of distances, similarities, features or ranked lists
  std::string name{};                     ///< name of the method; if empty, method_name() of the file
  std::string authors{};                  ///< names of the authors; empty if not specified
  std::string paper{};                    ///< title or reference of the paper; empty if not specified
  std::string url{};                      ///< web address with http:// or https://; empty if not specified
  std::optional<bool> similarity{};       ///< true if larger values mean nearer; absent if not specified
  std::string distance{};                 ///< name of the distance between features; empty for other files
  std::filesystem::path ids{};            ///< file with the model ids of the rows, one per line; empty if none
  std::filesystem::path repetition_of{};  ///< path foo for a repetition foo.seed1.npy; empty if it is none
};

/// File that is refused as a submission, or as the JSON file of a submission, with the reason.
struct RefusedSubmission {
  std::filesystem::path file;  ///< path of the refused file
  std::string reason;          ///< one line with the fault and the remedy
};

/// Result of find_submissions(): submissions, refused files and skipped files.
struct FoundSubmissions {
  std::vector<Submission> submissions;     ///< submissions in the order of the paths, in natural order within a folder
  std::vector<RefusedSubmission> refused;  ///< refused files, such as submissions with an invalid JSON file
  std::vector<std::filesystem::path> skipped;  ///< files in the folders that are no submissions, except hidden ones
};

/// Returns the path of the JSON file that describes a submission: foo.json next to foo.npy, foo.csv.gz or
/// foo.seed1.npy.
std::filesystem::path description_of(const std::filesystem::path& submission);

/// Returns true if the file's name has an extension of a format that evaluate_files() reads.
bool is_submission_file(const std::filesystem::path& path);

/// Finds the submissions of a leaderboard: each path is a file or a folder of files (without subfolders). The optional
/// keys of a JSON file are name, authors (a text or a list of them), paper, url, similarity, distance and ids. `others`
/// are files in the folders that are not submissions, such as the labels; empty paths are ignored. A missing path is
/// refused, as are links of a folder, descriptions and files of ids that lead out of the submission's folder. Throws
/// InputError for a folder that cannot be read or has no submission.
FoundSubmissions find_submissions(std::span<const std::filesystem::path> paths,
                                  std::span<const std::filesystem::path> others = {});

}  // namespace shapegauge
