#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// Work queue of numbered jobs, each handed out once, in order.
class Jobs {
 public:
  Jobs() = default;
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;
  Jobs(Jobs&&) = delete;
  Jobs& operator=(Jobs&&) = delete;
  virtual ~Jobs() = default;

  /// Returns the next job, if any. Thread-safe.
  virtual std::optional<std::size_t> next() = 0;
  /// Closes the queue. Thread-safe.
  virtual void stop() = 0;
  /// Returns the number of jobs handed out, as far as known on this rank.
  [[nodiscard]] virtual std::size_t handed_out() const = 0;
};

/// File written by all processes, each at its own offsets.
class SharedFile {
 public:
  SharedFile() = default;
  SharedFile(const SharedFile&) = delete;
  SharedFile& operator=(const SharedFile&) = delete;
  SharedFile(SharedFile&&) = delete;
  SharedFile& operator=(SharedFile&&) = delete;
  virtual ~SharedFile() = default;

  /// Writes the bytes at an offset. Throws std::runtime_error "cannot write <path>: <reason>".
  virtual void write(std::uint64_t offset, std::string_view bytes) = 0;
  /// Closes the file for all processes. Throws as write() does.
  virtual void close() = 0;
};

/// Communication between the processes (ranks) of a run. Collective functions must be called by all ranks in the same
/// order, and wait for the others. Messages may have any length.
class Communicator {
 public:
  Communicator() = default;
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;
  Communicator(Communicator&&) = delete;
  Communicator& operator=(Communicator&&) = delete;
  virtual ~Communicator() = default;

  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int size() const = 0;

  /// Sets a function that is called occasionally while waiting for other ranks; it may throw to stop waiting.
  void set_waiting(std::function<void()> waiting) { waiting_ = std::move(waiting); }

  /// Calls the work with `count` jobs shared by the ranks. Returns when all jobs are done. Collective.
  virtual void share_jobs(std::size_t count, const std::function<void(Jobs&)>& work) = 0;
  /// Returns the bytes of each rank on rank 0, and nothing elsewhere. Collective.
  virtual std::vector<std::string> gather(std::string bytes) = 0;
  /// Returns rank 0's bytes on all ranks. Collective.
  virtual std::string broadcast(std::string bytes) = 0;
  /// Sends each rank its bytes and returns those received from each rank. Collective.
  virtual std::vector<std::string> exchange(std::vector<std::string> to_ranks) = 0;
  /// Sends the bytes to the next rank (cyclically) and returns those of the previous one, while `meanwhile` runs.
  /// Collective.
  virtual std::string pass_on(std::string_view bytes, const std::function<void()>& meanwhile) = 0;
  /// Creates a file of that many bytes, replacing an existing one. Collective.
  virtual std::unique_ptr<SharedFile> create_file(const std::filesystem::path& path, std::uint64_t bytes) = 0;
  /// Terminates all processes at once, this one with the status; does not return.
  virtual void abort(int status) = 0;

 protected:
  void waiting() const {
    if (waiting_) waiting_();
  }

 private:
  std::function<void()> waiting_;
};

/// Makes a communicator for this process alone.
std::unique_ptr<Communicator> single_process();

/// Makes a communicator for the processes that this one was started with (mpirun, srun), or for this one alone. MPI is
/// loaded only if there are others, from its own module (built if MPI is installed): SHAPEGAUGE_MPI_MODULE in the
/// environment, or shapegauge_mpi.so beside the executable or in the library folder. Throws InputError if the module
/// cannot be loaded, or reports other processes than the environment.
std::unique_ptr<Communicator> started_processes();

/// Half-open range [first, last) of consecutive numbers.
struct RankRange {
  std::size_t first = 0;
  std::size_t last = 0;

  [[nodiscard]] std::size_t size() const { return last - first; }
};

/// Returns a rank's part of `count` consecutive items; all parts have about the same size.
RankRange part_of_rank(std::size_t count, int rank, int size);

}  // namespace shapegauge
