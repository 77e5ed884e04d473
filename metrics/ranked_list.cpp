// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/ranked_list.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

namespace shapegauge {

namespace {

constexpr double unreachable_distance = std::numeric_limits<double>::infinity();
constexpr double negligible = 1e-18;  // of the largest term: less than the rounding of the sum

// Sums term(probability, t) over the positions t that the j-th of `hits` hits may have among `size` unordered
// positions, divided by the sum of probabilities. Probabilities are relative to the most likely position, from which
// they decrease to both sides. This avoids overflow and underflow for all sizes.
template <typename Term>
double mean_over_positions(std::size_t size, std::size_t hits, std::size_t j, const Term& term) {
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
    precisions.push_back(k * mean_over_positions(size, hits, j, reciprocal_rank));
  }
}

struct Hit {
  double distance = 0;
  Eigen::Index column = 0;
  double grade = 1;
};

// Model that is not relevant, at the distance of a relevant one.
struct TiedMiss {
  std::size_t group = 0;
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

// Partially sorted answer: the relevant models in order, in groups of equal distance, and the numbers of other models
// between the groups.
struct Answer {
  std::vector<Hit> hits;               // by distance and column
  std::vector<double> distances;       // of the groups, ascending
  std::vector<std::size_t> first_hit;  // per group, and the number of hits
  std::vector<Misses> before;          // per group, and those behind the last
  std::vector<TiedMiss> tied;          // by group and column
};

// Models tied with each other, at least one of them relevant.
struct Tied {
  std::span<const Hit> hits;
  std::span<const TiedMiss> misses;
};

// Returns the number of values below x. Without branches, which nobody could predict here.
std::size_t count_below(std::span<const double> ascending, double x) {
  const double* first = ascending.data();
  std::size_t size = ascending.size();
  while (size > 1) {
    const std::size_t half = size / 2;
    first += first[half - 1] < x ? half : 0;
    size -= half;
  }
  const bool is_last_below = size == 1 && *first < x;
  return static_cast<std::size_t>(first - ascending.data()) + (is_last_below ? 1 : 0);
}

// Buckets of equal width between the least and the largest finite distance of hits, one for each hit. Their order is
// that of the distances.
class Buckets {
 public:
  explicit Buckets(std::span<const Hit> hits) : last_(static_cast<double>(std::max<std::size_t>(hits.size(), 1) - 1)) {
    double high = -unreachable_distance;
    double low = unreachable_distance;
    for (const Hit& hit : hits) {
      if (!std::isfinite(hit.distance)) continue;
      low = std::min(low, hit.distance);
      high = std::max(high, hit.distance);
    }
    const double per_unit = static_cast<double>(hits.size()) / (high - low);
    if (!(low < high) || !std::isfinite(per_unit)) return;  // one bucket has all
    low_ = low;
    per_unit_ = per_unit;
  }

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(last_) + 1; }

  [[nodiscard]] std::size_t of(double distance) const {
    const double position = (distance - low_) * per_unit_;
    return position > 0 ? static_cast<std::size_t>(std::min(position, last_)) : 0;
  }

  // Returns the index of the first of these values in each bucket, and their number. Values are in any order.
  template <typename Values, typename Distance>
  [[nodiscard]] std::vector<std::size_t> first_of(const Values& values, const Distance& distance) const {
    std::vector<std::size_t> first(size() + 1);
    for (const auto& value : values) ++first[of(std::invoke(distance, value)) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    return first;
  }

 private:
  double last_;
  double low_ = 0;
  double per_unit_ = 0;
};

// Sorts hits by distance and column.
void sort_hits(std::vector<Hit>& hits, const Buckets& buckets) {
  const std::vector<std::size_t> first = buckets.first_of(hits, &Hit::distance);
  std::vector<std::size_t> next = first;
  std::vector<Hit> sorted(hits.size());
  for (const Hit& hit : hits) sorted[next[buckets.of(hit.distance)]++] = hit;
  for (std::size_t bucket = 0; bucket < buckets.size(); ++bucket) {
    const auto of_bucket = std::span(sorted).subspan(first[bucket], first[bucket + 1] - first[bucket]);
    std::ranges::sort(of_bucket, [](const Hit& a, const Hit& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.column < b.column;
    });
  }
  hits = std::move(sorted);
}

void group_hits(Answer& answer) {
  for (std::size_t i = 0; i < answer.hits.size(); ++i) {
    if (i > 0 && answer.hits[i - 1].distance == answer.hits[i].distance) continue;
    answer.distances.push_back(answer.hits[i].distance);
    answer.first_hit.push_back(i);
  }
  answer.first_hit.push_back(answer.hits.size());
  answer.before.resize(answer.distances.size() + 1);
}

// Sorts an answer partially. for_each(f) calls f(column, distance) for each model of it.
template <typename ForEach>
Answer answer_of(const ForEach& for_each, const Relevance& relevance, Eigen::Index row) {
  Answer answer;
  const auto for_targets = [&](bool relevant, const auto& f) {
    for_each([&](Eigen::Index column, double distance) {
      if (relevance.is_target(row, column) && relevance.is_relevant(row, column) == relevant) f(column, distance);
    });
  };
  for_targets(true, [&](Eigen::Index column, double distance) {
    answer.hits.push_back({distance, column, relevance.grade(row, column)});
  });
  const Buckets buckets(answer.hits);
  sort_hits(answer.hits, buckets);
  group_hits(answer);
  const std::vector<std::size_t> first_group = buckets.first_of(answer.distances, std::identity());
  for_targets(false, [&](Eigen::Index column, double distance) {
    const bool judged = relevance.is_judged_irrelevant(row, column);
    const std::size_t bucket = buckets.of(distance);
    const std::size_t first = first_group[bucket];
    const std::span<const double> nearby(answer.distances.data() + first, first_group[bucket + 1] - first);
    const std::size_t group = first + count_below(nearby, distance);
    if (group < answer.distances.size() && answer.distances[group] == distance) {
      answer.tied.push_back({group, column, judged});
    } else {
      answer.before[group].add(judged);
    }
  });
  std::ranges::sort(answer.tied, [](const TiedMiss& a, const TiedMiss& b) {
    return a.group != b.group ? a.group < b.group : a.column < b.column;
  });
  return answer;
}

// Calls f with each group of tied models, in order.
template <typename F>
void for_each_tied(const Answer& answer, const F& f) {
  auto miss = answer.tied.begin();
  for (std::size_t group = 0; group < answer.distances.size(); ++group) {
    const auto first = miss;
    while (miss != answer.tied.end() && miss->group == group) ++miss;
    const std::size_t hit = answer.first_hit[group];
    f(group, Tied{.hits = {answer.hits.data() + hit, answer.first_hit[group + 1] - hit}, .misses = {first, miss}});
  }
}

using Runs = std::vector<RankRun>;

void append(Runs& runs, const Misses& misses) {
  runs.push_back({.size = misses.count, .hits = 0, .misses = misses.judged});
}

void append(Runs& runs, const Hit& hit) { runs.push_back({.size = 1, .hits = 1, .misses = 0, .grade = hit.grade}); }

void append_by_index(Runs& runs, const Tied& tied) {
  auto hit = tied.hits.begin();
  for (const TiedMiss& miss : tied.misses) {
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
  if (tied.misses.empty() && tied.hits.size() == 1) return append(runs, tied.hits.front());
  if (ties == Ties::index) return append_by_index(runs, tied);
  Misses misses;
  for (const TiedMiss& miss : tied.misses) misses.add(miss.judged);
  std::vector<Hit> hits(tied.hits.begin(), tied.hits.end());
  std::ranges::stable_sort(hits, std::greater<>(), &Hit::grade);
  double grades = 0;
  switch (ties) {
    case Ties::optimistic:
      for (const Hit& hit : hits) append(runs, hit);
      append(runs, misses);
      break;
    case Ties::pessimistic:
      append(runs, misses);
      std::for_each(hits.rbegin(), hits.rend(), [&](const Hit& hit) { append(runs, hit); });
      break;
    default:
      for (const Hit& hit : hits) grades += hit.grade;
      runs.push_back({.size = hits.size() + misses.count,
                      .hits = hits.size(),
                      .misses = misses.judged,
                      .grade = grades / static_cast<double>(hits.size())});
      break;
  }
}

// Returns all grades, the largest first. A query in its own list has the largest of them, or that of its subclass.
std::vector<double> sorted_grades(const Relevance& relevance, Eigen::Index row, bool counts_query) {
  std::vector<double> grades = relevance.grades(row);
  if (counts_query && !relevance.task().query_subclasses.empty()) {
    grades.push_back(subclass_grade(0, 0));
  } else if (counts_query && !grades.empty()) {
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

// Builds the list of a partially sorted answer.
RankedList list_of_answer(const Answer& answer, bool is_empty, const Relevance& relevance, Eigen::Index row,
                          const ListConventions& conventions) {
  const bool counts_query = conventions.protocol == Protocol::paper;
  const bool starts_with_query = counts_query && !is_empty;
  std::vector<double> grades = sorted_grades(relevance, row, counts_query);
  Runs runs;
  runs.reserve(2 * answer.distances.size() + 2);
  if (starts_with_query) append(runs, Hit{.grade = grades.empty() ? 1 : grades.front()});
  bool tied = false;
  for_each_tied(answer, [&](std::size_t group, const Tied& models) {
    append(runs, answer.before[group]);
    append_tied(runs, models, conventions.ties);
    tied = tied || order_matters(models);
  });
  append(runs, answer.before.back());
  const std::size_t relevant = relevance.relevant(row) + (counts_query ? 1 : 0);
  const std::size_t found = answer.hits.size() + (starts_with_query ? 1 : 0);
  RankedList list = list_of_runs(runs, starts_with_query, relevant - found);
  list.grades = std::move(grades);
  list.tied = tied;
  list.judged_misses = relevance.judged_irrelevant(row);
  return list;
}

// Builds the list of an answer, and those of the extreme orders of ties if requested. for_each(f) calls
// f(column, distance) for each of its models.
template <typename ForEach>
RankedList list_of_models(const ForEach& for_each, bool is_empty, const Relevance& relevance, Eigen::Index row,
                          const ListConventions& conventions, std::optional<TieExtremes>* extremes) {
  const Answer answer = answer_of(for_each, relevance, row);
  const auto list_with = [&](Ties ties) {
    return list_of_answer(answer, is_empty, relevance, row, {.protocol = conventions.protocol, .ties = ties});
  };
  RankedList list = list_with(conventions.ties);
  if (extremes != nullptr && list.tied)
    *extremes = TieExtremes{list_with(Ties::pessimistic), list_with(Ties::optimistic)};
  return list;
}

}  // namespace

std::vector<Eigen::Index> first_ranked(std::span<const double> distances, Eigen::Index query, Eigen::Index count) {
  std::vector<Eigen::Index> models(distances.size());
  std::iota(models.begin(), models.end(), Eigen::Index{0});
  models.erase(models.begin() + query);
  const auto list_size = std::min(count, std::ssize(models));
  const auto sort_key = [&](Eigen::Index model) {
    return std::pair(distances[static_cast<std::size_t>(model)], model);
  };
  std::ranges::partial_sort(models, models.begin() + list_size, {}, sort_key);
  models.resize(static_cast<std::size_t>(list_size));
  return models;
}

RankedList ranked_list(std::span<const ListedModel> answer, const Relevance& relevance, Eigen::Index row,
                       const ListConventions& conventions, std::optional<TieExtremes>* extremes) {
  const auto for_each = [&](const auto& f) {
    for (const ListedModel& model : answer) f(model.column, model.distance);
  };
  return list_of_models(for_each, answer.empty(), relevance, row, conventions, extremes);
}

RankedList ranked_list(std::span<const double> distances, const Relevance& relevance, Eigen::Index row,
                       const ListConventions& conventions, std::optional<TieExtremes>* extremes) {
  const auto for_each = [&](const auto& f) {
    for (std::size_t column = 0; column < distances.size(); ++column) {
      f(static_cast<Eigen::Index>(column), distances[column]);
    }
  };
  bool is_empty = true;
  for_each([&](Eigen::Index column, double distance) {
    if (relevance.is_target(row, column) && distance < unreachable_distance) is_empty = false;
  });
  if (is_empty) return ranked_list(std::span<const ListedModel>(), relevance, row, conventions);
  return list_of_models(for_each, false, relevance, row, conventions, extremes);
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

double sum_of_precisions(const RankedList& list, std::size_t count) {
  double sum = 0;
  std::size_t rank = 0;
  double hits_before = 0;
  for (const RankRun& run : list.runs) {
    if (rank >= count) break;
    const std::size_t looked_at = std::min(count - rank, run.size);
    const auto hits = static_cast<double>(run.hits);
    const auto size = static_cast<double>(run.size);
    // Given a hit at the i-th position of the run, each position before it is a hit with the same probability.
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
        return probability * static_cast<double>(most - std::min(before + t - j, most));
      };
    };
    for (std::size_t j = 1; j <= run.hits; ++j) {
      const double short_of_most = mean_over_positions(run.hits + run.misses, run.hits, j, term(j));
      misses.push_back(static_cast<double>(most) - short_of_most);  // exactly `most` if all positions reach it
    }
    before += run.misses;
  }
  return misses;
}

}  // namespace shapegauge
