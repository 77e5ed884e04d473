// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/files/ranked_answers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <set>
#include <span>
#include <system_error>
#include <unordered_map>
#include <unordered_set>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/datasets/files/compressed_files.h"
#include "shapegauge/datasets/files/model_ids.h"

namespace shapegauge {

namespace {

std::vector<std::string_view> words_in(std::string_view line, std::string_view separators) {
  std::vector<std::string_view> words;
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(separators), line.size()));
    if (line.empty()) return words;
    words.push_back(line.substr(0, line.find_first_of(separators)));
    line.remove_prefix(words.back().size());
  }
}

// Words of a non-blank line with their position.
struct WordLine {
  std::vector<std::string_view> words;
  std::string where;
};

// Returns the lines with words. Lines that begin with # and have not `columns` words are comments.
std::vector<WordLine> word_lines(std::string_view text, const std::string& source, std::string_view separators,
                                 std::size_t columns = 0) {
  std::vector<WordLine> lines;
  std::size_t number = 0;
  for (const std::string_view line : split_lines(text)) {
    ++number;
    std::vector<std::string_view> words = words_in(line, separators);
    const bool comment = columns > 0 && line.starts_with('#') && (words.size() != columns || line.starts_with("# "));
    if (!words.empty() && !comment) lines.push_back({std::move(words), fmt::format("{}:{}", source, number)});
  }
  if (lines.empty()) throw InputError(fmt::format("{}: the file has no lines", source));
  return lines;
}

void expect_words(const WordLine& line, std::size_t count, std::string_view form) {
  if (line.words.size() == count) return;
  throw InputError(fmt::format("{}: found {} words; a line must be \"{}\"", line.where, line.words.size(), form));
}

// Returns true if the first line is "query Q0 model rank score tag"; a line of numbers has no Q0.
bool begins_like_a_run(std::string_view text) {
  while (text.starts_with('#')) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  const std::vector<std::string_view> words = words_in(text.substr(0, text.find('\n')), " \t\r");
  return words.size() == 6 && (words[1] == "Q0" || words[1] == "q0");
}

// Assigns an index to each query, and rejects repeated models of a query.
class Queries {
 public:
  // Returns the index of the query; the next free one for a new query.
  std::size_t index_of(std::string_view query) {
    return indices_.emplace(std::string(query), indices_.size()).first->second;
  }

  void add_model(std::size_t index, std::string_view model, const std::string& where) {
    if (index >= models_.size()) models_.resize(index + 1);
    if (models_[index].emplace(model).second) return;
    throw InputError(fmt::format("{}: repeated model {} for this query", where, quoted_word(model)));
  }

 private:
  std::unordered_map<std::string, std::size_t> indices_;
  std::vector<std::unordered_set<std::string>> models_;
};

// Returns true if distances fall with the rank, and not all are equal. `ranks` are those of the models in the file.
bool is_reversed(const RankedAnswers::Answer& answer, std::span<const double> ranks) {
  std::vector<std::pair<double, double>> by_rank;
  for (std::size_t i = 0; i < ranks.size(); ++i) by_rank.emplace_back(ranks[i], answer.models[i].second);
  std::ranges::sort(by_rank);
  constexpr auto distance = &std::pair<double, double>::second;
  return by_rank.front().second > by_rank.back().second && std::ranges::is_sorted(by_rank, std::greater(), distance);
}

RankedAnswers read_folder_of_lists(const std::filesystem::path& folder) {
  RankedAnswers result;
  for (const std::filesystem::path& file : ranked_list_files(folder)) {
    result.answers.push_back(parse_ranked_list(read_plain_text(file), file.filename().string(), file.string()));
  }
  return result;
}

}  // namespace

std::vector<std::filesystem::path> ranked_list_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().filename().string().starts_with(".")) continue;
    if (entry.is_directory(error)) {
      throw InputError(fmt::format("{}: expected a file for each query with its ranked list, found the folder {}",
                                   folder.string(), quoted_word(entry.path().filename().string())));
    }
    files.push_back(entry.path());
  }
  if (error) throw InputError(fmt::format("{}: cannot read the folder: {}", folder.string(), error.message()));
  if (files.empty()) throw InputError(fmt::format("{}: no ranked lists in this folder", folder.string()));
  std::ranges::sort(files, natural_less, [](const std::filesystem::path& file) { return file.filename().string(); });
  return files;
}

RankedAnswers parse_trec_run(std::string_view text, const std::string& source) {
  RankedAnswers result;
  Queries queries;
  std::set<std::string> tags;
  std::vector<std::vector<double>> ranks;
  for (const WordLine& line : word_lines(text, source, " \t", 6)) {
    expect_words(line, 6, "query Q0 model rank score tag");
    const auto score = parse_number(line.words[4]);
    if (!score || !std::isfinite(*score)) {
      throw InputError(fmt::format("{}: the score {} is not a finite number", line.where, quoted_word(line.words[4])));
    }
    const std::size_t index = queries.index_of(line.words[0]);
    queries.add_model(index, line.words[2], line.where);
    if (index == result.answers.size()) result.answers.push_back({std::string(line.words[0]), {}});
    result.answers[index].models.emplace_back(line.words[2], -*score);
    ranks.resize(result.answers.size());
    ranks[index].push_back(parse_number(line.words[3]).value_or(0));
    tags.emplace(line.words[5]);
  }
  if (tags.size() == 1) result.name = *tags.begin();
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    if (is_reversed(result.answers[i], ranks[i])) ++result.reversed;
  }
  return result;
}

RankedAnswers parse_ranked_lists(std::string_view text, const std::string& source) {
  RankedAnswers result;
  Queries queries;
  for (const WordLine& line : word_lines(text, source, " \t,")) {
    if (line.words.size() < 2) throw InputError(fmt::format("{}: the query has no models", line.where));
    const std::size_t index = queries.index_of(line.words[0]);
    if (index < result.answers.size()) {
      throw InputError(fmt::format("{}: repeated query {}", line.where, quoted_word(line.words[0])));
    }
    result.answers.push_back({std::string(line.words[0]), {}});
    for (std::size_t rank = 1; rank < line.words.size(); ++rank) {
      queries.add_model(index, line.words[rank], line.where);
      result.answers[index].models.emplace_back(line.words[rank], static_cast<double>(rank));
    }
  }
  return result;
}

RankedAnswers::Answer parse_ranked_list(std::string_view text, const std::string& query, const std::string& source) {
  RankedAnswers::Answer answer{.query = query, .models = {}};
  Queries queries;
  for (const WordLine& line : word_lines(text, source, " \t,")) {
    queries.add_model(0, line.words[0], line.where);
    answer.models.emplace_back(line.words[0], static_cast<double>(answer.models.size() + 1));
  }
  return answer;
}

Judgements parse_qrels(std::string_view text, const std::string& source) {
  Judgements result;
  Queries queries;
  for (const WordLine& line : word_lines(text, source, " \t", 4)) {
    expect_words(line, 4, "query iteration model grade");
    int grade = 0;
    const std::string_view digits = line.words[3];
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), grade);
    if (error != std::errc() || stop != digits.data() + digits.size()) {
      throw InputError(fmt::format("{}: the grade {} is not an integer", line.where, quoted_word(digits)));
    }
    const std::size_t index = queries.index_of(line.words[0]);
    queries.add_model(index, line.words[2], line.where);
    if (index == result.queries.size()) result.queries.push_back({std::string(line.words[0]), {}, {}, {}});
    Judgements::Judged& judged = result.queries[index];
    if (grade > 0) {
      judged.relevant.emplace_back(line.words[2]);
      judged.grades.push_back(grade);
    } else if (grade == 0) {
      judged.irrelevant.emplace_back(line.words[2]);
    }
    result.graded = result.graded || grade > 1;
  }
  return result;
}

bool is_ranked_answers_file(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return true;
  const std::string extension = format_extension(path);
  if (std::ranges::find(ranked_answers_extensions, extension) != ranked_answers_extensions.end()) return true;
  return extension == ".txt" && begins_like_a_run(read_plain_text(path));
}

RankedAnswers read_ranked_answers(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return read_folder_of_lists(path);
  const std::string text = read_plain_text(path);
  return format_extension(path) == ".lists" ? parse_ranked_lists(text, path.string())
                                            : parse_trec_run(text, path.string());
}

Judgements read_qrels(const std::filesystem::path& path) { return parse_qrels(read_plain_text(path), path.string()); }

}  // namespace shapegauge
