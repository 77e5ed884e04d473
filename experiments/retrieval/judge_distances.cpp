#include "shapegauge/experiments/retrieval/judge_distances.h"

#include <algorithm>
#include <string>
#include <utility>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/experiments/distributed/agreement.h"
#include "shapegauge/experiments/distributed/packing.h"

namespace shapegauge {

namespace {

RankRange own_part(const SharedSignatures& signatures, const Communicator& ranks) {
  return part_of_rank(signatures.all, ranks.rank(), ranks.size());
}

std::string_view bytes_of(const Eigen::Ref<const Signatures>& rows) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): access to the bytes is intended
  return {reinterpret_cast<const char*>(rows.data()), static_cast<std::size_t>(rows.size()) * sizeof(float)};
}

/// Returns the rows of a rank from its bytes.
Eigen::Map<const Signatures> rows_in(const std::string& bytes, Eigen::Index length) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): they were made of such numbers
  const auto* const numbers = reinterpret_cast<const float*>(bytes.data());
  const auto count = static_cast<Eigen::Index>(bytes.size() / sizeof(float));
  return {numbers, length > 0 ? count / length : 0, length};
}

/// Returns the number of rows computed together: a compromise between communication and memory.
Eigen::Index rows_together(std::size_t all) {
  constexpr std::size_t most_bytes = std::size_t{128} << 20;
  return static_cast<Eigen::Index>(
      std::clamp<std::size_t>(most_bytes / sizeof(double) / std::max<std::size_t>(all, 1), 1, 4096));
}

/// Computes the distances in blocks of rows, which stay in the cache until they are stored.
void compute_rows(const NamedDistance& distance, const SignatureBlock& some, const SignatureBlock& others,
                  Eigen::Ref<DistanceMatrix> distances) {
  constexpr Eigen::Index together = 32;
  parallel_for(Eigen::Index{0}, (distances.rows() + together - 1) / together, [&](Eigen::Index group) {
    const Eigen::Index first = group * together;
    const Eigen::Index count = std::min(together, distances.rows() - first);
    distances.middleRows(first, count) =
        distances_between(distance, {some.signatures.middleRows(first, count), some.first + first}, others);
  });
}

/// Computes the distances of some own signatures to all, while those of the other ranks are received.
void compute_while_passing(const NamedDistance& distance, const SignatureBlock& some,
                           const SharedSignatures& signatures, Communicator& ranks,
                           Eigen::Ref<DistanceMatrix> distances) {
  if (ranks.size() == 1) return compute_rows(distance, some, {signatures.rows, 0}, distances);
  std::string passing(bytes_of(signatures.rows));
  for (int step = 0; step < ranks.size(); ++step) {
    const int from = (ranks.rank() - step + ranks.size()) % ranks.size();
    const auto now = [&] {
      const auto others = rows_in(passing, signatures.rows.cols());
      if (distances.rows() == 0 || others.rows() == 0) return;
      const auto first = static_cast<Eigen::Index>(part_of_rank(signatures.all, from, ranks.size()).first);
      compute_rows(distance, some, {others, first}, distances.middleCols(first, others.rows()));
    };
    if (step + 1 == ranks.size()) {
      now();
    } else {
      passing = ranks.pass_on(passing, now);
    }
  }
}

std::string bytes_of_scores(const QueryScores& scores) {
  Packer packer;
  packer.add(scores.measures).add(scores.precisions).add(scores.relevant).add(scores.tied).add(scores.first_tiers);
  return std::move(packer).bytes();
}

/// Concatenates the scores of all ranks.
QueryScores together(const std::vector<std::string>& parts) {
  std::vector<QueryScores> all(parts.size());
  Eigen::Index queries = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Unpacker unpacker(parts[i]);
    unpacker.take(all[i].measures).take(all[i].precisions).take(all[i].relevant).take(all[i].tied);
    unpacker.take(all[i].first_tiers);
    queries += all[i].measures.rows();
  }
  if (all.size() == 1) return std::move(all.front());
  QueryScores scores;
  scores.measures.resize(queries, all.front().measures.cols());
  scores.precisions.resize(queries, all.front().precisions.cols());
  scores.first_tiers.resize(queries, Eigen::NoChange);
  Eigen::Index first = 0;
  for (const QueryScores& part : all) {
    scores.measures.middleRows(first, part.measures.rows()) = part.measures;
    scores.precisions.middleRows(first, part.measures.rows()) = part.precisions;
    scores.first_tiers.middleRows(first, part.measures.rows()) = part.first_tiers;
    scores.relevant.insert(scores.relevant.end(), part.relevant.begin(), part.relevant.end());
    scores.tied.insert(scores.tied.end(), part.tied.begin(), part.tied.end());
    first += part.measures.rows();
  }
  return scores;
}

std::string bytes_of_overview(const PartialOverview& seen) {
  return std::move(
             Packer().add(seen.first).add(seen.sums).add(seen.entries).add(seen.nearest).add(seen.nearest_distances))
      .bytes();
}

/// Decodes the partial overview of another rank.
PartialOverview seen_in(const std::string& bytes, const PartialOverview& here) {
  PartialOverview seen;
  Unpacker(bytes).take(seen.first).take(seen.sums).take(seen.entries).take(seen.nearest).take(seen.nearest_distances);
  seen.unit = here.unit;
  seen.places = here.places;
  seen.block = here.block;
  seen.side = here.side;
  return seen;
}

}  // namespace

void visit_distances(const NamedDistance& distance, const SharedSignatures& signatures, Communicator& ranks,
                     const RowVisitor& visit) {
  const RankRange own = own_part(signatures, ranks);
  const auto own_first = static_cast<Eigen::Index>(own.first);
  on_all_ranks(ranks, [&] { check_signatures({signatures.rows, own_first}, distance); });
  const Eigen::Index at_once = rows_together(signatures.all);
  // All ranks take part in as many rounds as the first, which has the most rows.
  const auto rounds = static_cast<Eigen::Index>(part_of_rank(signatures.all, 0, ranks.size()).size());
  DistanceMatrix rows(std::min(at_once, signatures.rows.rows()), static_cast<Eigen::Index>(signatures.all));
  for (Eigen::Index first = 0; first < rounds; first += at_once) {
    const Eigen::Index begin = std::min(first, signatures.rows.rows());
    const Eigen::Index count = std::min(at_once, signatures.rows.rows() - begin);
    compute_while_passing(distance, {signatures.rows.middleRows(begin, count), own_first + begin}, signatures, ranks,
                          rows.topRows(count));
    if (count > 0) visit(own_first + begin, rows.topRows(count));
  }
}

double largest_of_first(const NamedDistance& distance, const SharedSignatures& signatures, Communicator& ranks) {
  const std::string first =
      ranks.broadcast(ranks.rank() == 0 ? std::string(bytes_of(signatures.rows.topRows(1))) : std::string());
  const auto own_first = static_cast<Eigen::Index>(own_part(signatures, ranks).first);
  const DistanceMatrix row =
      distances_between(distance, {rows_in(first, signatures.rows.cols()), 0}, {signatures.rows, own_first});
  double largest = largest_finite({row.data(), static_cast<std::size_t>(row.size())}, own_first == 0 ? 0 : -1);
  for (const std::string& part : ranks.gather(std::move(Packer().add(largest)).bytes())) {
    largest = std::max(largest, Unpacker(part).take_value<double>());
  }
  return Unpacker(ranks.broadcast(std::move(Packer().add(largest)).bytes())).take_value<double>();
}

DistanceJudge::DistanceJudge(std::span<const int> labels, const RankRange& own, const JudgedMethod& wanted,
                             Communicator& ranks)
    : task_(leave_one_out(labels)), ranks_(&ranks) {
  task_.query_subclasses = task_.target_subclasses = wanted.subclasses;
  const auto first = static_cast<Eigen::Index>(own.first);
  const auto last = static_cast<Eigen::Index>(own.last);
  on_all_ranks(ranks, [&] {
    for (const EvaluationOptions& options : wanted.evaluations) judges_.emplace_back(task_, options, first, last);
  });
  if (wanted.overview) seen_ = begin_overview(labels, wanted.largest, first, last);
  if (wanted.file.empty()) return;
  const std::string header = npy_header_of_matrix(labels.size(), labels.size());
  file_begin_ = header.size();
  file_ = ranks.create_file(wanted.file, header.size() + labels.size() * labels.size() * sizeof(double));
  if (ranks.rank() == 0) file_->write(0, header);
}

void DistanceJudge::add(Eigen::Index first, const DistanceTable& rows) {
  const Stopwatch stopwatch;
  for (RowJudge& judge : judges_) judge.judge(rows, first);
  seconds_ += stopwatch.seconds();
  if (seen_) accumulate(rows, first, *seen_);
  if (!file_) return;
  const auto place = static_cast<std::uint64_t>(first) * static_cast<std::uint64_t>(rows.cols()) * sizeof(double);
  file_->write(file_begin_ + place, npy_numbers({rows.data(), static_cast<std::size_t>(rows.size())}));
}

Judgement DistanceJudge::finish() {
  Judgement judgement;
  if (file_) file_->close();
  for (const RowJudge& judge : judges_) {
    const std::vector<std::string> parts = ranks_->gather(bytes_of_scores(judge.scores()));
    if (!parts.empty()) judgement.evaluations.push_back(judge.evaluation_of(together(parts)));
  }
  if (!seen_) return judgement;
  std::vector<PartialOverview> all;
  for (const std::string& part : ranks_->gather(bytes_of_overview(*seen_))) all.push_back(seen_in(part, *seen_));
  if (!all.empty()) judgement.overview = overview_of(all);
  return judgement;
}

}  // namespace shapegauge
