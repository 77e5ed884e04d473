// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shapegauge {

/// Ranked lists of models, one per query; a list need not contain all models.
struct RankedAnswers {
  /// Ranked list of one query.
  struct Answer {
    std::string query;                                   ///< id of the query
    std::vector<std::pair<std::string, double>> models;  ///< ids of models, with the rank or the negated score
  };
  std::vector<Answer> answers;  ///< ranked lists, one per query, in order of first appearance
  std::string name;             ///< tag of a TREC run; empty unless all lines have the same tag
  std::size_t reversed = 0;     ///< number of queries of a TREC run whose scores increase with the rank in the file
};

/// Relevance judgements of models for queries (qrels).
struct Judgements {
  /// Judged models of one query.
  struct Judged {
    std::string query;                    ///< id of the query
    std::vector<std::string> relevant;    ///< ids of the relevant models
    std::vector<int> grades;              ///< relevance grades, positive, one per relevant model
    std::vector<std::string> irrelevant;  ///< ids of the models judged as not relevant
  };
  std::vector<Judged> queries;  ///< judgements per query, in order of first appearance
  bool graded = false;          ///< true if any relevance grade is above 1
};

/// Parses a TREC run: lines `query Q0 model rank score tag`. As in trec_eval, the order is by descending score and the
/// rank is ignored. Lines that begin with "# ", or with # and have other than 6 words, are comments. Throws InputError,
/// with the line, for a wrong number of words, a score that is not finite, a repeated model of a query, and no lines.
RankedAnswers parse_trec_run(std::string_view text, const std::string& source);

/// Parses ranked lists: one line per query with its id and then the models' ids, best first, separated by blanks or
/// commas. Throws InputError, with the line, for a query without models or with two lines, a repeated model, and no
/// lines.
RankedAnswers parse_ranked_lists(std::string_view text, const std::string& source);

/// Parses the ranked list of one query: one line per model, best first, of its id and optionally a distance, which is
/// ignored. Throws InputError, with the line, for a repeated model and no lines.
RankedAnswers::Answer parse_ranked_list(std::string_view text, const std::string& query, const std::string& source);

/// Parses TREC judgements (qrels): lines `query iteration model grade`; positive grades are relevant, and negative ones
/// mean not judged. Lines that begin with "# ", or with # and have other than 4 words, are comments. Throws InputError,
/// with the line, for a wrong number of words, a grade that is not an integer, a model judged twice for a query, and no
/// lines.
Judgements parse_qrels(std::string_view text, const std::string& source);

/// File extensions of TREC runs (.run, .trec) and ranked lists (.lists).
inline constexpr std::array<std::string_view, 3> ranked_answers_extensions{".run", ".trec", ".lists"};

/// Returns true for a TREC run (.run, .trec, or .txt with a matching first line) or ranked lists (.lists), also
/// compressed with `.gz`, and for a folder, which has a list for each query.
bool is_ranked_answers_file(const std::filesystem::path& path);

/// Returns the files of a folder with a ranked list for each query, in natural order of names, without hidden ones.
/// Throws InputError for a folder without files, or with subfolders.
std::vector<std::filesystem::path> ranked_list_files(const std::filesystem::path& folder);

/// Reads a TREC run or ranked lists, selected by the file's extension, or a folder with one file per query. Such a file
/// is named by the query's id and has the format of parse_ranked_list(). Throws InputError also as ranked_list_files().
RankedAnswers read_ranked_answers(const std::filesystem::path& path);

/// Reads TREC judgements (qrels); the file may be compressed with `.gz`.
Judgements read_qrels(const std::filesystem::path& path);

}  // namespace shapegauge
