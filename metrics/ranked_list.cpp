#include "shapegauge/metrics/ranked_list.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace shapegauge {

namespace {

constexpr double negligible = 1e-18;  // of the largest term: less than the rounding of the sum

// Sums term(probability, t) over the positions t that the j-th of `hits` hits may have among `size` unordered
// positions, divided by the sum of probabilities. Probabilities are relative to the most likely position, from which
// they decrease to both sides. This avoids overflow and underflow for all sizes.
template <typename Term>
double mean_over_places(std::size_t size, std::size_t hits, std::size_t j, const Term& term) {
  const std::size_t first = j;
  const std::size_t last = size - hits + j;
  const std::size_t likeliest = hits == 1 ? first : std::clamp(1 + (j - 1) * size / (hits - 1), first, last);
  // P(t + 1) / P(t)
  const auto ratio = [&](std::size_t t) {
    return static_cast<double>(t) * static_cast<double>(last - t) /
           (static_cast<double>(t - j + 1) * static_cast<double>(size - t));
  };
  double total = 1;
  double sum = term(1.0, likeliest);
  double probability = 1;
  for (std::size_t t = likeliest; t < last && probability > negligible; ++t) {
    probability *= ratio(t);
    total += probability;
    sum += term(probability, t + 1);
  }
  probability = 1;
  for (std::size_t t = likeliest; t > first && probability > negligible; --t) {
    probability /= ratio(t - 1);
    total += probability;
    sum += term(probability, t - 1);
  }
  return sum / total;
}

// Appends, for each of `hits` relevant models among `size` consecutive unordered ranks, the mean of k / rank of the
// k-th hit of the list. k continues from the existing precisions, ranks from `ranks_before`.
//
// Over all orders of n ranks with m hits, the j-th hit is at position t with the probability C(t-1, j-1) C(n-t, m-j) /
// C(n, m) (negative hypergeometric). The mean is the sum over t, ignoring terms below 1e-18 of the largest one.
void append_precisions(std::vector<double>& precisions, std::size_t size, std::size_t hits, std::size_t ranks_before) {
  const std::size_t hits_before = precisions.size();
  for (std::size_t j = 1; j <= hits; ++j) {
    const auto k = static_cast<double>(hits_before + j);
    if (hits == size) {
      precisions.push_back(k / static_cast<double>(ranks_before + j));
      continue;
    }
    const auto reciprocal_rank = [&](double probability, std::size_t t) {
      return probability / static_cast<double>(ranks_before + t);
    };
    precisions.push_back(k * mean_over_places(size, hits, j, reciprocal_rank));
  }
}

struct RankedColumn {
  double distance;
  Eigen::Index column;
};

void sort_by_distance(std::vector<RankedColumn>& models) {
  std::ranges::sort(models, [](const RankedColumn& a, const RankedColumn& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.column < b.column;
  });
}

struct Hit {
  Eigen::Index column = 0;
  double grade = 1;
};

struct Miss {
  Eigen::Index column = 0;
  bool judged = true;
};

// Number of models that are not relevant, and how many of them are judged.
struct Misses {
  std::size_t count = 0;
  std::size_t judged = 0;

  void add(bool is_judged) {
    ++count;
    judged += is_judged ? 1 : 0;
  }
};

// Models at one distance, at least one of them relevant, and the irrelevant models nearer than these but farther than
// the previous relevant ones. Hits and misses are in the order of their columns.
struct Tied {
  double distance = 0;
  Misses before;
  std::vector<Hit> hits;
  std::vector<Miss> misses;
};

// Partially sorted answer: the relevant models in order, and the numbers of other models between them.
struct Answer {
  std::vector<Tied> tied;
  Misses behind;                  // farther than the last relevant model
  std::vector<double> not_found;  // grades of relevant models that have no distance
  std::size_t judged_not_found = 0;
};

// Query of a row, with its task.
class Query {
 public:
  Query(const RetrievalTask& task, Eigen::Index row) : task_(task), row_(row), i_(static_cast<std::size_t>(row)) {}

  [[nodiscard]] bool is_target(Eigen::Index column) const {
    return task_.target_classes[static_cast<std::size_t>(column)] != no_class && task_.own_column[i_] != column;
  }

  [[nodiscard]] bool is_relevant(Eigen::Index column) const { return shapegauge::is_relevant(task_, row_, column); }

  [[nodiscard]] double grade(Eigen::Index column) const { return grade_of(task_, row_, column); }

  // Returns true for a judged column that is not relevant.
  [[nodiscard]] bool is_judged(Eigen::Index column) const {
    return task_.judged_irrelevant.empty() || std::ranges::binary_search(task_.judged_irrelevant[i_], column);
  }

 private:
  const RetrievalTask& task_;
  Eigen::Index row_;
  std::size_t i_;
};

// Returns true if all targets are infinitely far: the query has no answer.
bool finds_nothing(const DistanceTable& distances, const Query& query, Eigen::Index row) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (Eigen::Index column = 0; column < distances.cols(); ++column) {
    if (query.is_target(column) && distances(row, column) < infinity) return false;
  }
  return true;
}

void collect_hits(const DistanceTable& distances, const Query& query, Eigen::Index row, bool is_empty, Answer& answer) {
  std::vector<RankedColumn> hits;
  for (Eigen::Index column = 0; column < distances.cols(); ++column) {
    if (!query.is_target(column) || !query.is_relevant(column)) continue;
    if (is_empty || std::isnan(distances(row, column))) {
      answer.not_found.push_back(query.grade(column));
    } else {
      hits.push_back({distances(row, column), column});
    }
  }
  sort_by_distance(hits);
  for (const RankedColumn& hit : hits) {
    if (answer.tied.empty() || answer.tied.back().distance != hit.distance) {
      answer.tied.push_back({.distance = hit.distance, .before = {}, .hits = {}, .misses = {}});
    }
    answer.tied.back().hits.push_back({hit.column, query.grade(hit.column)});
  }
}

void collect_misses(const DistanceTable& distances, const Query& query, Eigen::Index row, bool is_empty,
                    Answer& answer) {
  for (Eigen::Index column = 0; column < distances.cols(); ++column) {
    if (!query.is_target(column) || query.is_relevant(column)) continue;
    const double distance = distances(row, column);
    const bool judged = query.is_judged(column);
    if (is_empty || std::isnan(distance)) {
      answer.judged_not_found += judged ? 1 : 0;
      continue;
    }
    const auto place = std::ranges::lower_bound(answer.tied, distance, {}, &Tied::distance);
    if (place == answer.tied.end()) {
      answer.behind.add(judged);
    } else if (place->distance == distance) {
      place->misses.push_back({column, judged});
    } else {
      place->before.add(judged);
    }
  }
}

using Runs = std::vector<RankRun>;

void append(Runs& runs, const Misses& misses) {
  runs.push_back({.size = misses.count, .hits = 0, .misses = misses.judged});
}

void append(Runs& runs, const Hit& hit) { runs.push_back({.size = 1, .hits = 1, .misses = 0, .grade = hit.grade}); }

void append_by_index(Runs& runs, const Tied& tied) {
  auto hit = tied.hits.begin();
  for (const Miss& miss : tied.misses) {
    for (; hit != tied.hits.end() && hit->column < miss.column; ++hit) append(runs, *hit);
    append(runs, Misses{.count = 1, .judged = miss.judged ? 1U : 0U});
  }
  for (; hit != tied.hits.end(); ++hit) append(runs, *hit);
}

// Returns true if the order of tied models may matter: relevant and other models, or different grades.
bool order_matters(const Tied& tied) {
  const auto differs = [&](const Hit& hit) { return hit.grade != tied.hits.front().grade; };
  return !tied.misses.empty() || std::ranges::any_of(tied.hits, differs);
}

// Appends tied models in the order, or the open order, of `ties`. Among the hits, optimistic ranks the largest grades
// first and pessimistic the smallest.
void append_tied(Runs& runs, const Tied& tied, Ties ties) {
  Misses misses;
  for (const Miss& miss : tied.misses) misses.add(miss.judged);
  std::vector<Hit> hits = tied.hits;
  std::ranges::stable_sort(hits, std::greater<>(), &Hit::grade);
  double grades = 0;
  switch (ties) {
    case Ties::index:
      append_by_index(runs, tied);
      break;
    case Ties::optimistic:
      for (const Hit& hit : hits) append(runs, hit);
      append(runs, misses);
      break;
    case Ties::pessimistic:
      append(runs, misses);
      std::for_each(hits.rbegin(), hits.rend(), [&](const Hit& hit) { append(runs, hit); });
      break;
    case Ties::expected:
      for (const Hit& hit : hits) grades += hit.grade;
      runs.push_back({.size = hits.size() + misses.count,
                      .hits = hits.size(),
                      .misses = misses.judged,
                      .grade = grades / static_cast<double>(hits.size())});
      break;
  }
}

// Returns all grades, the largest first. A query in its own list has the largest of them, or that of its subclass.
std::vector<double> grades_of(const Answer& answer, const RetrievalTask& task, bool starts_with_query) {
  std::vector<double> grades = answer.not_found;
  for (const Tied& tied : answer.tied) {
    for (const Hit& hit : tied.hits) grades.push_back(hit.grade);
  }
  if (starts_with_query && !task.query_subclasses.empty()) {
    grades.push_back(subclass_grade(0, 0));
  } else if (starts_with_query && !grades.empty()) {
    grades.push_back(*std::ranges::max_element(grades));
  }
  std::ranges::sort(grades, std::greater<>());
  return grades;
}

// Appends a run, joined with the one before if both consist of hits of one grade or of misses.
void append(RankedList& list, const RankRun& run) {
  if (run.size == 0) return;
  list.length += run.size;
  if (!list.runs.empty()) {
    RankRun& last = list.runs.back();
    const bool both_misses = run.hits == 0 && last.hits == 0;
    const bool both_hits = run.hits == run.size && last.hits == last.size && run.grade == last.grade;
    if (both_misses || both_hits) {
      last.size += run.size;
      last.hits += run.hits;
      last.misses += run.misses;
      return;
    }
  }
  list.runs.push_back(run);
}

}  // namespace

std::vector<Eigen::Index> first_ranked(std::span<const double> distances, Eigen::Index query, Eigen::Index count) {
  std::vector<Eigen::Index> models(distances.size());
  std::iota(models.begin(), models.end(), Eigen::Index{0});
  models.erase(models.begin() + query);
  const auto kept = std::min(count, std::ssize(models));
  const auto place = [&](Eigen::Index model) { return std::pair(distances[static_cast<std::size_t>(model)], model); };
  std::ranges::partial_sort(models, models.begin() + kept, {}, place);
  models.resize(static_cast<std::size_t>(kept));
  return models;
}

RankedList ranked_list(const DistanceTable& distances, const RetrievalTask& task, Eigen::Index row, Protocol protocol,
                       Ties ties) {
  const bool starts_with_query = protocol == Protocol::paper;
  const Query query(task, row);
  Answer answer;
  const bool is_empty = finds_nothing(distances, query, row);
  collect_hits(distances, query, row, is_empty, answer);
  collect_misses(distances, query, row, is_empty, answer);
  std::vector<double> grades;
  if (has_grades(task)) grades = grades_of(answer, task, starts_with_query);
  Runs runs;
  if (starts_with_query) append(runs, Hit{.column = -1, .grade = grades.empty() ? 1 : grades.front()});
  for (const Tied& tied : answer.tied) {
    append(runs, tied.before);
    append_tied(runs, tied, ties);
  }
  append(runs, answer.behind);
  RankedList list = list_of_runs(runs, starts_with_query, answer.not_found.size());
  list.grades = std::move(grades);
  list.tied = std::ranges::any_of(answer.tied, order_matters);
  list.judged_misses += answer.judged_not_found;
  return list;
}

RankedList list_of_runs(const std::vector<RankRun>& runs, bool starts_with_query, std::size_t not_in_list) {
  RankedList list;
  list.starts_with_query = starts_with_query;
  for (const RankRun& run : runs) append(list, run);
  std::size_t ranks_before = 0;
  for (const RankRun& run : list.runs) {
    append_precisions(list.precision_at_hit, run.size, run.hits, ranks_before);
    ranks_before += run.size;
    list.judged_misses += run.misses;
  }
  list.relevant = list.precision_at_hit.size() + not_in_list;
  list.precision_at_hit.resize(list.relevant, 0.0);
  return list;
}

double hits_among_first(const RankedList& list, std::size_t count) {
  double hits = 0;
  for (const RankRun& run : list.runs) {
    const std::size_t looked_at = std::min(count, run.size);
    hits += static_cast<double>(run.hits) * static_cast<double>(looked_at) / static_cast<double>(run.size);
    count -= looked_at;
    if (count == 0) break;
  }
  return hits;
}

double gain_of_hits(const RankedList& list, double (*gain)(std::size_t rank)) {
  double sum = 0;
  std::size_t rank = 0;
  for (const RankRun& run : list.runs) {
    if (run.hits > 0) {
      const double fraction = static_cast<double>(run.hits) / static_cast<double>(run.size);
      for (std::size_t i = 1; i <= run.size; ++i) sum += fraction * gain(rank + i);
    }
    rank += run.size;
  }
  return sum;
}

double graded_gain_of_hits(const RankedList& list, double (*gain)(std::size_t rank), std::size_t count) {
  double sum = 0;
  std::size_t rank = 0;
  for (const RankRun& run : list.runs) {
    if (rank >= count) break;
    const std::size_t looked_at = std::min(count - rank, run.size);
    if (run.hits > 0) {
      const double grade = run.grade * static_cast<double>(run.hits) / static_cast<double>(run.size);
      for (std::size_t i = 1; i <= looked_at; ++i) sum += grade * gain(rank + i);
    }
    rank += run.size;
  }
  return sum;
}

double precisions_at_hits(const RankedList& list, std::size_t count) {
  double sum = 0;
  std::size_t rank = 0;
  double hits_before = 0;
  for (const RankRun& run : list.runs) {
    if (rank >= count) break;
    const std::size_t looked_at = std::min(count - rank, run.size);
    const auto hits = static_cast<double>(run.hits);
    const auto size = static_cast<double>(run.size);
    // Given a hit at the i-th place of the run, each place before it is a hit with the same probability.
    const double others = run.size > 1 ? (hits - 1) / (size - 1) : 0;
    if (run.hits > 0) {
      for (std::size_t i = 1; i <= looked_at; ++i) {
        const double hits_there = hits_before + 1 + static_cast<double>(i - 1) * others;
        sum += hits / size * hits_there / static_cast<double>(rank + i);
      }
    }
    hits_before += hits;
    rank += run.size;
  }
  return sum;
}

std::vector<double> misses_before_hits(const RankedList& list, std::size_t most) {
  std::vector<double> misses;
  std::size_t before = 0;
  for (const RankRun& run : list.runs) {
    const auto term = [&](std::size_t j) {
      return [&, j](double probability, std::size_t t) {
        return probability * static_cast<double>(std::min(before + t - j, most));
      };
    };
    for (std::size_t j = 1; j <= run.hits; ++j) {
      misses.push_back(mean_over_places(run.hits + run.misses, run.hits, j, term(j)));
    }
    before += run.misses;
  }
  return misses;
}

}  // namespace shapegauge
