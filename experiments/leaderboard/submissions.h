#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace shapegauge {

/// A submission: a file of distances, similarities, features or ranked lists, and what the JSON file beside it says.
struct Submission {
  std::filesystem::path file;
  std::string name{};     ///< empty: by its file, see method_name()
  std::string authors{};  ///< empty where the JSON does not say
  std::string paper{};
  std::string url{};                 ///< begins with http:// or https://
  std::optional<bool> similarity{};  ///< whether larger is nearer; nothing: not said
  std::string distance{};            ///< the file holds features: the distance to take
  std::filesystem::path ids{};       ///< ids of the rows, one a line
};

/// A submission, or a part of one, that is left out.
struct RefusedSubmission {
  std::filesystem::path file;
  std::string reason;  ///< one line that says what is wrong and what to do
};

/// Submissions that were found.
struct FoundSubmissions {
  std::vector<Submission> submissions;         ///< in the order of the paths, those of a folder in natural order
  std::vector<RefusedSubmission> refused;      ///< JSON files that cannot be used, or that stand beside no submission
  std::vector<std::filesystem::path> skipped;  ///< other files of folders, which are not hidden
};

/// The file that describes a submission: foo.json beside foo.npy or foo.csv.gz.
std::filesystem::path description_of(const std::filesystem::path& submission);

/// Whether the name has an extension of a format that evaluate_files() reads.
bool is_submission_file(const std::filesystem::path& path);

/// Finds submissions: each path is a file or a folder of files (folders within it do not count). The keys of a JSON
/// file are name, authors (a text or a list of them), paper, url, similarity, distance and ids, all of them optional.
/// `others` are files in such a folder that are no submissions, such as the labels; empty paths do not count. A path
/// that is not there is refused. Throws InputError where a folder cannot be read or has no submission.
FoundSubmissions find_submissions(std::span<const std::filesystem::path> paths,
                                  std::span<const std::filesystem::path> others = {});

}  // namespace shapegauge
