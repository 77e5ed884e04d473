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

/// Jobs with numbers from 0 on, each of which is handed out once, in order, to whoever asks next.
class Jobs {
 public:
  Jobs() = default;
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;
  Jobs(Jobs&&) = delete;
  Jobs& operator=(Jobs&&) = delete;
  virtual ~Jobs() = default;

  /// The next job; nothing where there is none left. Any thread.
  virtual std::optional<std::size_t> next() = 0;
  /// Hands out no more. Any thread.
  virtual void stop() = 0;
  /// How many have been handed out, as far as is known here.
  [[nodiscard]] virtual std::size_t handed_out() const = 0;
};

/// A file that all processes write to, each in its own places.
class SharedFile {
 public:
  SharedFile() = default;
  SharedFile(const SharedFile&) = delete;
  SharedFile& operator=(const SharedFile&) = delete;
  SharedFile(SharedFile&&) = delete;
  SharedFile& operator=(SharedFile&&) = delete;
  virtual ~SharedFile() = default;

  /// Writes the bytes at that place. Throws std::runtime_error "cannot write <path>: <reason>".
  virtual void write(std::uint64_t offset, std::string_view bytes) = 0;
  /// Ends the writing, of all processes. Throws as write().
  virtual void close() = 0;
};

/// The processes (ranks) of a run, one of which is this. What all must call, in the same order, is collective; it waits
/// for the others. Bytes are of any length.
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

  /// Called now and then while it waits for others; may throw to end the waiting.
  void set_waiting(std::function<void()> waiting) { waiting_ = std::move(waiting); }

  /// Collective. Calls the work with `count` jobs that the ranks share. Returns when all jobs are done.
  virtual void share_jobs(std::size_t count, const std::function<void(Jobs&)>& work) = 0;
  /// Collective. On rank 0 the bytes of each rank, elsewhere nothing.
  virtual std::vector<std::string> gather(std::string bytes) = 0;
  /// Collective. Rank 0's bytes, on all ranks.
  virtual std::string broadcast(std::string bytes) = 0;
  /// Collective. Gives each rank its bytes; returns what each rank has given this one.
  virtual std::vector<std::string> exchange(std::vector<std::string> to_ranks) = 0;
  /// Collective. Gives the bytes to the next rank (the first comes after the last) and returns those of the one before,
  /// while `meanwhile` is done here.
  virtual std::string pass_on(std::string_view bytes, const std::function<void()>& meanwhile) = 0;
  /// Collective. A new file of so many bytes, in place of one that is there.
  virtual std::unique_ptr<SharedFile> create_file(const std::filesystem::path& path, std::uint64_t bytes) = 0;
  /// Ends all processes at once, this one with the status; does not return.
  virtual void abort(int status) = 0;

 protected:
  void waiting() const {
    if (waiting_) waiting_();
  }

 private:
  std::function<void()> waiting_;
};

/// A run of this process alone.
std::unique_ptr<Communicator> single_process();

/// The processes that this one was started with (mpirun, srun), or this one alone. MPI is loaded only where there are
/// others, from a module of its own (built where MPI is installed): SHAPEGAUGE_MPI_MODULE in the environment, or
/// shapegauge_mpi.so beside the executable or in the folder of libraries. Throws InputError where it cannot be loaded,
/// or knows of other processes than the environment says.
std::unique_ptr<Communicator> started_processes();

/// Consecutive numbers from first to before last.
struct Range {
  std::size_t first = 0;
  std::size_t last = 0;

  [[nodiscard]] std::size_t size() const { return last - first; }
};

/// The part of `count` things in a row that belongs to a rank: all parts are about as large.
Range part_of_rank(std::size_t count, int rank, int size);

}  // namespace shapegauge
