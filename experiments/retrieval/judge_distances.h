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

/// Streamed distances: blocks of rows are computed, evaluated, written and discarded.

namespace shapegauge {

/// Signatures of many models, distributed over processes as consecutive parts (part_of_rank()).
struct SharedSignatures {
  const Signatures& rows;  ///< of this process
  std::size_t all = 0;     ///< total number
};

/// Receives rows of a distance matrix, from the row `first` on.
using RowVisitor = std::function<void(Eigen::Index first, const DistanceTable& rows)>;

/// Calls visit() with this process's rows of the distance matrix, in blocks, in order. Signatures of the other
/// processes are received one process at a time. With P processes of N models of B numbers each, a process holds 3 N B
/// / P numbers of signatures and rows of at most 128 MiB. Equal to distance_matrix() to the bit. Collective and
/// parallel. Throws SharedError for signatures that check_signatures() rejects, and the errors of visit().
void visit_distances(const NamedDistance& distance, const SharedSignatures& signatures, Communicator& ranks,
                     const RowVisitor& visit);

/// Returns largest_finite() of the first row of the distance matrix. Collective.
double largest_of_first(const NamedDistance& distance, const SharedSignatures& signatures, Communicator& ranks);

/// Requested evaluations of the distances of a method.
struct JudgedMethod {
  std::vector<EvaluationOptions> evaluations;
  bool overview = false;
  std::vector<int> subclasses = {};  ///< of the models, see numbered_subclasses()
  double largest = 0;                ///< largest_of_first(), for an overview of many models
  std::filesystem::path file;        ///< `.npy` file for the matrix; not written if empty
};

/// Results of judging a method's distances; on rank 0.
struct Judgement {
  std::vector<Evaluation> evaluations;  ///< as requested
  std::optional<DistanceOverview> overview;
};

/// Evaluates the distances of one method between labelled models by rows. This process handles the rows of `own`. All
/// functions but add() are collective.
class DistanceJudge {
 public:
  DistanceJudge(std::span<const int> labels, const RankRange& own, const JudgedMethod& wanted, Communicator& ranks);
  DistanceJudge(const DistanceJudge&) = delete;
  DistanceJudge& operator=(const DistanceJudge&) = delete;
  DistanceJudge(DistanceJudge&&) = delete;
  DistanceJudge& operator=(DistanceJudge&&) = delete;
  ~DistanceJudge() = default;

  /// Accumulates rows, from the row `first` on. Parallel.
  void add(Eigen::Index first, const DistanceTable& rows);

  /// Returns the results of all rows of all processes.
  Judgement finish();

  /// Returns the seconds of evaluation on this rank.
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  RetrievalTask task_;
  std::vector<RowJudge> judges_;
  std::optional<PartialOverview> seen_;
  std::unique_ptr<SharedFile> file_;
  std::uint64_t file_begin_ = 0;  ///< offset of the numbers
  Communicator* ranks_;
  double seconds_ = 0;
};

}  // namespace shapegauge
