// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/measures.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "shapegauge/core/base/error.h"

namespace shapegauge {
namespace {

// Returns the gain of the relevant models with the largest grades at the ranks 1 to n.
double ideal_gain(const RankedList& list, double (*gain)(std::size_t rank), std::size_t n) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += (list.grades.empty() ? 1 : list.grades[i]) * gain(i + 1);
  return sum;
}

// Returns the precision among the first k ranks.
double precision(const RankedList& list, std::size_t k) { return hits_among_first(list, k) / static_cast<double>(k); }

// Returns the recall among the first k ranks.
double recall(const RankedList& list, std::size_t k) {
  return hits_among_first(list, k) / static_cast<double>(list.relevant);
}

constexpr const char* psb_source =
    "Shilane, Min, Kazhdan, Funkhouser, The Princeton Shape Benchmark, SMI 2004, section 4.";

MeasureDefinition nearest_neighbour() {
  return {.name = "NN",
          .title = "nearest neighbour",
          .definition = "1 where the nearest model other than the query is relevant, else 0: h(1).",
          .source = psb_source,
          .caveat =
              "One model decides, so an exact duplicate of the query in the data set makes it 1. The mean over queries "
              "is the accuracy of a nearest-neighbour classifier.",
          .value = [](const RankedList& list) {
            return list.starts_with_query ? hits_among_first(list, 2) - 1 : hits_among_first(list, 1);
          }};
}

MeasureDefinition first_tier() {
  return {.name = "FT",
          .title = "first tier",
          .definition = "The recall among the first R ranks: the sum of h(1) to h(R), divided by R.",
          .source = psb_source,
          .caveat =
              "Under psb R is C - 1 for a class of C models. Under paper R is C and the query itself is the first hit, "
              "which makes the value larger: psb = (C paper - 1) / (C - 1). Under psb and trec the same as R-prec.",
          .value = [](const RankedList& list) { return recall(list, list.relevant); }};
}

MeasureDefinition second_tier() {
  return {.name = "ST",
          .title = "second tier",
          .definition = "The recall among the first 2R ranks, or in the whole list where that is shorter.",
          .source = psb_source,
          .caveat =
              "For a class of more than half of all models it is always 1. Not the bull's eye score, which counts the "
              "query.",
          .value = [](const RankedList& list) { return recall(list, 2 * list.relevant); }};
}

constexpr std::size_t first_page = 32;  // results that a user is assumed to inspect

MeasureDefinition e_measure() {
  return {.name = "E",
          .title = "e-measure",
          .definition =
              "The harmonic mean of precision and recall among the first k ranks, k = 32 or the whole list where that "
              "is shorter: 2c / (k + R) for c hits among them.",
          .source =
              "van Rijsbergen, Information Retrieval, 1979, chapter 7; Shilane et al., The Princeton Shape Benchmark, "
              "SMI 2004, section 4.",
          .caveat =
              "A perfect method does not reach 1 unless R = k: with classes of 20 it has 0.7451 under psb and, with "
              "the query as one of the 32 results and of the 20 relevant models, 0.7692 under paper.",
          .value = [](const RankedList& list) {
            const std::size_t looked_at = std::min(first_page, list.length);
            return 2 * hits_among_first(list, looked_at) / static_cast<double>(looked_at + list.relevant);
          }};
}

double gain_by_log_of_rank(std::size_t rank) { return rank == 1 ? 1.0 : 1.0 / std::log2(static_cast<double>(rank)); }

MeasureDefinition discounted_cumulative_gain() {
  return {.name = "DCG",
          .title = "discounted cumulative gain, normalised",
          .definition =
              "A hit at rank 1 gains 1, a hit at rank i >= 2 gains 1 / log2(i), over the whole list; the sum is "
              "divided by that of a list with all R hits in front.",
          .source =
              "Jarvelin and Kekalainen, SIGIR 2000, in the form of Shilane et al., The Princeton Shape Benchmark, SMI "
              "2004, section 4.",
          .caveat =
              "Ranks 1 and 2 count the same; nDCG divides by log2(i + 1) and gives other values. Far from 0 for a "
              "random order: hits anywhere gain something.",
          .value = [](const RankedList& list) {
            double ideal = 0;  // summed in the order of the hits: a perfect list gives exactly 1
            for (std::size_t rank = 1; rank <= list.relevant; ++rank) ideal += gain_by_log_of_rank(rank);
            return gain_of_hits(list, gain_by_log_of_rank) / ideal;
          }};
}

MeasureDefinition average_precision() {
  return {.name = "mAP",
          .title = "mean average precision",
          .definition =
              "Of one query (AP): the mean over all R relevant models of the precision at the rank where each is "
              "found, 0 for one that is not in the list.",
          .source =
              "Buckley and Voorhees, Evaluating evaluation measure stability, SIGIR 2000; trec_eval, NIST's program of "
              "the TREC conferences (map).",
          .caveat =
              "No interpolation. Under paper the query is the first of R = C relevant models, found at rank 1 with "
              "precision 1, which makes the value larger.",
          .value = [](const RankedList& list) {
            double sum = 0;
            for (const double precision : list.precision_at_hit) sum += precision;
            return sum / static_cast<double>(list.relevant);
          }};
}

MeasureDefinition precision_at() {
  return {.name = "P@k",
          .title = "precision at k",
          .definition = "The fraction of hits among the first k ranks: the sum of h(1) to h(k), divided by k.",
          .source = "trec_eval, NIST's program of the TREC conferences (P_k).",
          .caveat = "Divided by k even where the list is shorter or R < k, so that a perfect method has R / k at most.",
          .value_at = [](const RankedList& list, std::size_t k) { return precision(list, k); }};
}

MeasureDefinition recall_at() {
  return {
      .name = "R@k",
      .title = "recall at k",
      .definition =
          "The fraction of the relevant models that is among the first k ranks: the sum of h(1) to h(k), divided by R.",
      .source = "trec_eval, NIST's program of the TREC conferences (recall_k).",
      .caveat =
          "A perfect method has k / R at most where k < R. In papers on metric learning R@k often means something "
          "else: whether there is a hit among the first k at all.",
      .value_at = [](const RankedList& list, std::size_t k) { return recall(list, k); }};
}

MeasureDefinition f1_at() {
  return {.name = "F1@k",
          .title = "F1 at k",
          .definition = "The harmonic mean of P@k and R@k: 2c / (k + R) for c hits among the first k ranks.",
          .source = "van Rijsbergen, Information Retrieval, 1979, chapter 7.",
          .caveat = "Does not reach 1 unless R = k. F1@32 is E where a list has 32 ranks or more.",
          .value_at = [](const RankedList& list, std::size_t k) {
            return 2 * hits_among_first(list, k) / static_cast<double>(k + list.relevant);
          }};
}

MeasureDefinition reciprocal_rank() {
  return {
      .name = "MRR",
      .title = "mean reciprocal rank",
      .definition = "Of one query: 1 / rank of the first hit, 0 where there is none.",
      .source =
          "Voorhees, The TREC-8 question answering track report, 1999; trec_eval, NIST's program of the TREC "
          "conferences (recip_rank).",
      .caveat = "Looks at one hit only. Under paper the query is that hit and the value is always 1: use psb or trec.",
      .value = [](const RankedList& list) { return list.precision_at_hit.front(); }};
}

MeasureDefinition r_precision() {
  return {.name = "R-prec",
          .title = "R-precision",
          .definition = "The precision at rank R: the sum of h(1) to h(R), divided by R.",
          .source = "trec_eval, NIST's program of the TREC conferences (Rprec).",
          .caveat =
              "The first tier (FT) under the name of text retrieval; where a list ends before rank R the missing ranks "
              "count as misses.",
          .value = [](const RankedList& list) { return recall(list, list.relevant); }};
}

double gain_by_log_of_next_rank(std::size_t rank) { return 1.0 / std::log2(static_cast<double>(rank + 1)); }

MeasureDefinition normalised_discounted_gain() {
  return {.name = "nDCG",
          .title = "normalised discounted cumulative gain of text retrieval",
          .definition =
              "A hit at rank i gains 1 / log2(i + 1), over the whole list; the sum is divided by that of a list with "
              "all R hits in front.",
          .source =
              "Jarvelin and Kekalainen, ACM Transactions on Information Systems 20, 2002; trec_eval, NIST's program of "
              "the TREC conferences (ndcg).",
          .caveat =
              "Not the DCG of shape retrieval, which divides by log2(i). With graded judgements a hit gains its grade "
              "/ log2(i + 1), as in trec_eval, and not 2^grade - 1, as others have it.",
          .value = [](const RankedList& list) {
            return graded_gain_of_hits(list, gain_by_log_of_next_rank, list.length) /
                   ideal_gain(list, gain_by_log_of_next_rank, list.relevant);
          }};
}

MeasureDefinition binary_preference() {
  return {.name = "bpref",
          .title = "binary preference",
          .definition =
              "The mean over all R relevant models of 1 - n / min(R, N), 0 for one that is not in the list: n of the N "
              "models that are judged and not relevant are before it, counted up to R.",
          .source =
              "Buckley and Voorhees, Retrieval evaluation with incomplete information, SIGIR 2004; trec_eval, NIST's "
              "program of the TREC conferences (bpref).",
          .caveat =
              "Meant for incomplete judgements: models that nobody judged play no part. With classes all models are "
              "judged.",
          .value = [](const RankedList& list) {
            const auto bound = static_cast<double>(std::min(list.relevant, list.judged_misses));
            double sum = 0;
            for (const double misses : misses_before_hits(list, list.relevant)) {
              sum += 1 - (bound > 0 ? misses / bound : 0);
            }
            return sum / static_cast<double>(list.relevant);
          }};
}

MeasureDefinition bulls_eye() {
  return {.name = "BEP",
          .title = "bull's eye score",
          .definition =
              "The fraction of the query's class, the query included, among the first 2C ranks of a list that begins "
              "with the query, C = R + 1: (1 + sum of h(1) to h(2C - 1)) / C.",
          .source =
              "Latecki, Lakamper, Eckhardt, Shape descriptors for non-rigid shapes with a single closed contour, CVPR "
              "2000 (MPEG-7 part B).",
          .caveat =
              "The query finds itself and counts, under every protocol; for classes of two it is 0.5 at least. Under "
              "paper the same as ST.",
          .value = [](const RankedList& list) {
            if (list.starts_with_query) return recall(list, 2 * list.relevant);
            const std::size_t class_size = list.relevant + 1;
            return (1 + hits_among_first(list, 2 * class_size - 1)) / static_cast<double>(class_size);
          }};
}

MeasureDefinition area_under_curve() {
  return {.name = "AUC-PR",
          .title = "area under the precision-recall curve",
          .definition =
              "The area under straight lines between the points (k / R, precision at the k-th hit), k = 1 to R, and "
              "level from recall 0 to the first point.",
          .source =
              "The curve that psbPlot draws; Davis and Goadrich, The relationship between precision-recall and ROC "
              "curves, ICML 2006.",
          .caveat =
              "Straight lines between the points are optimistic (Davis and Goadrich); mAP is the same area under "
              "steps. A model that is not in the list counts with precision 0.",
          .value = [](const RankedList& list) {
            double before = list.precision_at_hit.front();
            double sum = 0;
            for (const double precision : list.precision_at_hit) {
              sum += (before + precision) / 2;
              before = precision;
            }
            return sum / static_cast<double>(list.relevant);
          }};
}

constexpr const char* shapenet_source =
    "Savva and others, Large-scale 3D shape retrieval from ShapeNet Core55, Eurographics Workshop on 3D Object "
    "Retrieval 2016 and 2017, and the contest's evaluation program.";

// The measures of SHREC'16 and '17 on ShapeNetCore look at whole lists of at most this length.
constexpr std::size_t longest_list = 1000;

std::size_t considered_ranks(const RankedList& list) { return std::min(list.length, longest_list); }

// The number of relevant models that a list of the longest length can hold.
std::size_t findable(const RankedList& list) { return std::min(list.relevant, longest_list); }

MeasureDefinition precision_of_list() {
  return {
      .name = "P@N",
      .title = "precision of the list",
      .definition = "The fraction of hits among the first N ranks, where N is the length of the list, at most 1000.",
      .source = shapenet_source,
      .caveat =
          "The method chooses N. A list of all models has the frequency of the class as its precision: meant for lists "
          "that end. The contest's lists begin with the query: use the protocol paper.",
      .value = [](const RankedList& list) { return precision(list, considered_ranks(list)); }};
}

MeasureDefinition recall_of_list() {
  return {.name = "R@N",
          .title = "recall of the list",
          .definition = "The hits among the first N ranks, N as in P@N, divided by R or by 1000 if R is larger.",
          .source = shapenet_source,
          .caveat = "1 for a list of all models, if there are at most 1000.",
          .value = [](const RankedList& list) {
            return hits_among_first(list, considered_ranks(list)) / static_cast<double>(findable(list));
          }};
}

MeasureDefinition f1_of_list() {
  return {.name = "F1@N",
          .title = "F1 of the list",
          .definition = "The harmonic mean of P@N and R@N, by query: 2c / (N + min(R, 1000)) for c hits.",
          .source = shapenet_source,
          .caveat = "The mean over queries is not the harmonic mean of the means of P@N and R@N.",
          .value = [](const RankedList& list) {
            const std::size_t ranks = considered_ranks(list);
            return 2 * hits_among_first(list, ranks) / static_cast<double>(ranks + findable(list));
          }};
}

MeasureDefinition average_precision_of_list() {
  return {.name = "mAP@N",
          .title = "mean average precision of the list",
          .definition =
              "Of one query: the sum of the precisions at the hits among the first N ranks, N as in P@N, divided by "
              "min(R, 1000).",
          .source = shapenet_source,
          .caveat =
              "As in the evaluation program from February 2017 on. Before, in the report of 2016, the sum was divided "
              "by the number of hits in the list, so that short lists scored higher.",
          .value = [](const RankedList& list) {
            return sum_of_precisions(list, considered_ranks(list)) / static_cast<double>(findable(list));
          }};
}

MeasureDefinition graded_gain_of_list() {
  return {.name = "nDCG@N",
          .title = "normalised discounted cumulative gain of the list, graded",
          .definition =
              "A hit gains its grade at rank 1 and its grade / log2(i) at rank i >= 2, among the first N ranks, N as "
              "in P@N; the sum is divided by that of the min(R, 1000) largest grades.",
          .source = shapenet_source,
          .caveat =
              "Grades are those of the judgements or of subclasses: 3 for the query's subclass, 2 for a model of the "
              "class as such, 1 for another subclass; 1 without either. As in the program from February 2017 on; "
              "before, the ideal had the models of the list only.",
          .value = [](const RankedList& list) {
            return graded_gain_of_hits(list, gain_by_log_of_rank, considered_ranks(list)) /
                   ideal_gain(list, gain_by_log_of_rank, findable(list));
          }};
}

// Returns the library's measures, in the order of listings.
std::vector<MeasureDefinition> builtin_measures() {
  return {nearest_neighbour(),
          first_tier(),
          second_tier(),
          e_measure(),
          discounted_cumulative_gain(),
          average_precision(),
          precision_at(),
          recall_at(),
          f1_at(),
          reciprocal_rank(),
          normalised_discounted_gain(),
          r_precision(),
          binary_preference(),
          area_under_curve(),
          bulls_eye(),
          precision_of_list(),
          recall_of_list(),
          f1_of_list(),
          average_precision_of_list(),
          graded_gain_of_list()};
}

constexpr std::size_t largest_k = 1000000000;
constexpr std::string_view ranks_suffix = "@k";
constexpr std::string_view list_suffix = "@N";
constexpr std::string_view other_name_of_map = "AP";

std::size_t ranks_of(std::string_view name, std::string_view digits) {
  std::size_t k = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, k);
  if (error != std::errc() || stop != end || k == 0 || k > largest_k) {
    throw ArgumentError("the measure \"" + std::string(name.substr(0, 40)) +
                        "\" needs a number of ranks from 1 to 1000000000 after the @, as in " +
                        std::string(name.substr(0, name.find('@'))) + "@10");
  }
  return k;
}

void check_measure(const MeasureDefinition& definition) {
  const std::string& name = definition.name;
  const bool at_k = name.ends_with(ranks_suffix);
  const bool of_list = name.ends_with(list_suffix);
  const std::string stem = at_k || of_list ? name.substr(0, name.size() - ranks_suffix.size()) : name;
  if (stem.empty() || stem.find_first_of(" \t,@") != std::string::npos || name == other_name_of_map) {
    throw ArgumentError("\"" + name +
                        "\" cannot be the name of a measure: it is empty, reserved, or has a blank, a comma or an @ "
                        "(other than @k or @N at its end)");
  }
  if ((definition.value != nullptr) == at_k || (definition.value_at != nullptr) != at_k) {
    throw ArgumentError("the measure \"" + name +
                        "\" needs exactly one function: value_at if its name ends in @k, "
                        "otherwise value");
  }
}

}  // namespace

Registry<MeasureDefinition>& measure_definitions() {
  static Registry<MeasureDefinition> all("measure", builtin_measures(), has_functions<>, check_measure);
  return all;
}

Measure measure_of(std::string_view name) {
  if (name == other_name_of_map) name = "mAP";
  const std::size_t at = name.ends_with(list_suffix) ? std::string_view::npos : name.find('@');
  const std::string stem(name.substr(0, at));
  const MeasureDefinition* const definition =
      measure_definitions().find(at == std::string_view::npos ? stem : stem + std::string(ranks_suffix));
  if (definition == nullptr) {
    throw ArgumentError(unknown_word_message("measure", name, measure_definitions().names()));
  }
  const std::size_t k = at == std::string_view::npos ? 0 : ranks_of(name, name.substr(at + 1));
  return {.name = std::string(name), .definition = definition, .k = k};
}

std::vector<Measure> measures_of(std::span<const std::string> names) {
  std::vector<Measure> measures;
  measures.reserve(names.size());
  for (const std::string& name : names) {
    const Measure measure = measure_of(name);
    if (std::ranges::find(measures, measure.name, &Measure::name) != measures.end()) {
      throw ArgumentError("the measure \"" + measure.name + "\" is repeated; omit one");
    }
    measures.push_back(measure);
  }
  return measures;
}

std::vector<Measure> default_measures(Protocol protocol) {
  if (protocol == Protocol::trec) {
    return measures_of(std::vector<std::string>{"mAP", "P@10", "R@10", "MRR", "nDCG", "R-prec"});
  }
  return measures_of(std::vector<std::string>{"NN", "FT", "ST", "E", "DCG", "mAP"});
}

std::vector<Measure> default_measures(std::span<const Protocol> protocols) {
  std::vector<Measure> measures;
  for (const Protocol protocol : protocols) {
    for (const Measure& measure : default_measures(protocol)) {
      if (std::ranges::find(measures, measure.name, &Measure::name) == measures.end()) measures.push_back(measure);
    }
  }
  return measures;
}

}  // namespace shapegauge
