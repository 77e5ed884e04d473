#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/distributed/communicator.h"
#include "shapegauge/metrics/distance_overview.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/retrieval/distance_matrix.h"

/// Distances that nobody holds: they are computed some rows at a time, judged, written, and forgotten.

namespace shapegauge {

/// Signatures of many models, of which each process has some that follow each other (part_of_rank()).
struct SharedSignatures {
  const Signatures& rows;  ///< of this process
  std::size_t all = 0;     ///< how many there are
};

/// Takes rows of a distance matrix, from the row `first` on.
using RowVisitor = std::function<void(Eigen::Index first, const DistanceTable& rows)>;

/// Calls visit() with the rows of the distance matrix that belong to this process, some at a time, in order. The
/// signatures of the other processes pass by, a process's at a time: with P processes of N models of B numbers each, a
/// process holds 3 N B / P numbers of signatures and rows of at most 128 MiB. The same bits as distance_matrix().
/// Collective. In parallel. Throws SharedError for signatures that check_signatures() refuses, and what visit() throws.
void visit_distances(const NamedDistance& distance, const SharedSignatures& signatures, Communicator& ranks,
                     const RowVisitor& visit);

/// Collective. largest_finite() of the first row of the distance matrix.
double largest_of_first(const NamedDistance& distance, const SharedSignatures& signatures, Communicator& ranks);

/// What is asked of the distances of a method.
struct JudgedMethod {
  std::vector<EvaluationOptions> evaluations;
  bool overview = false;
  double largest = 0;          ///< largest_of_first(), where an overview of many models is wanted
  std::filesystem::path file;  ///< where the matrix goes, `.npy`; empty: nowhere
};

/// What was found of it; on rank 0.
struct Judgement {
  std::vector<Evaluation> evaluations;  ///< as asked for
  std::optional<DistanceOverview> overview;
};

/// Judges the distances of one method between models of these labels, by their rows, of which this process sees those
/// of `own`. All of it is collective but add().
class DistanceJudge {
 public:
  DistanceJudge(std::span<const int> labels, const Range& own, const JudgedMethod& wanted, Communicator& ranks);
  DistanceJudge(const DistanceJudge&) = delete;
  DistanceJudge& operator=(const DistanceJudge&) = delete;
  DistanceJudge(DistanceJudge&&) = delete;
  DistanceJudge& operator=(DistanceJudge&&) = delete;
  ~DistanceJudge() = default;

  /// Takes rows, from the row `first` on. In parallel.
  void add(Eigen::Index first, const DistanceTable& rows);

  /// What was found of all rows of all processes.
  Judgement finish();

  /// Seconds that evaluating has taken here.
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  RetrievalTask task_;
  std::vector<RowJudge> judges_;
  std::optional<PartialOverview> seen_;
  std::unique_ptr<SharedFile> file_;
  std::uint64_t file_begin_ = 0;  ///< of the numbers
  Communicator* ranks_;
  double seconds_ = 0;
};

}  // namespace shapegauge
