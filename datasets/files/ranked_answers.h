#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shapegauge {

/// Answers to queries as lists of models, which need not have all models.
struct RankedAnswers {
  struct Answer {
    std::string query;
    std::vector<std::pair<std::string, double>> models;  ///< id and distance
  };
  std::vector<Answer> answers;  ///< in the order in which the queries come first
  std::string name;             ///< of a TREC run: its tag, if all lines have the same
};

/// Which models are relevant to which queries.
struct Judgements {
  struct Judged {
    std::string query;
    std::vector<std::string> relevant;
    std::vector<int> grades;              ///< of the relevant, above 0
    std::vector<std::string> irrelevant;  ///< judged, and not relevant
  };
  std::vector<Judged> queries;
  bool graded = false;  ///< there were grades above 1
};

/// A TREC run: lines `query Q0 model rank score tag`. The score orders, larger is better, as in trec_eval; the rank
/// plays no part. Throws InputError with the line: another number of words, a score that is no finite number, a model
/// that occurs twice for a query, no lines.
RankedAnswers parse_trec_run(std::string_view text, const std::string& source);

/// Ranked lists: a line for each query, its id and then the models', the best first, between blanks or commas. Throws
/// InputError with the line: a query without models or with two lines, a model that occurs twice, no lines.
RankedAnswers parse_ranked_lists(std::string_view text, const std::string& source);

/// TREC judgements (qrels): lines `query iteration model grade`; a grade above 0 is relevant. Throws InputError with
/// the line: another number of words, a grade that is no whole number, a model that is judged twice for a query, no
/// lines.
Judgements parse_qrels(std::string_view text, const std::string& source);

/// Whether a file holds a TREC run (.run, .trec, or .txt with a first line like one) or ranked lists (.lists); each may
/// be compressed, with `.gz` behind.
bool is_ranked_answers_file(const std::filesystem::path& path);

/// Reads a TREC run or ranked lists, as the name's extension tells.
RankedAnswers read_ranked_answers(const std::filesystem::path& path);

/// Reads TREC judgements, compressed or not.
Judgements read_qrels(const std::filesystem::path& path);

}  // namespace shapegauge
