#include "shapegauge/experiments/distributed/mpi_module.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <exception>
#include <fmt/format.h>
#include <mpi.h>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include "shapegauge/core/version.h"

// MPI's handles are macros that cast as C does.
#pragma GCC diagnostic ignored "-Wold-style-cast"

namespace shapegauge {

namespace {

/// Maximum size of a message: MPI counts in int, and several messages allow progress reports.
constexpr std::size_t piece_bytes = std::size_t{64} << 20;

/// Waiting strategy: polls at full speed at first and then with increasing pauses, which leaves the processor to ranks
/// that compute.
class Pause {
 public:
  void operator()() {
    const auto waited = std::chrono::steady_clock::now() - begin_;
    if (waited < std::chrono::milliseconds(1)) {
      std::this_thread::yield();
    } else {
      std::this_thread::sleep_for(std::min<std::chrono::nanoseconds>(waited / 32, std::chrono::milliseconds(1)));
    }
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// Pending requests; wait() completes all of them.
class Requests {
 public:
  void send(MPI_Comm ranks, std::string_view bytes, int to) {
    for (std::size_t at = 0; at < bytes.size(); at += piece_bytes) {
      const std::string_view piece = bytes.substr(at, piece_bytes);
      MPI_Isend(piece.data(), static_cast<int>(piece.size()), MPI_BYTE, to, 0, ranks, &requests_.emplace_back());
    }
  }
  void receive(MPI_Comm ranks, std::string& bytes, int from) {
    for (std::size_t at = 0; at < bytes.size(); at += piece_bytes) {
      MPI_Irecv(bytes.data() + at, static_cast<int>(std::min(piece_bytes, bytes.size() - at)), MPI_BYTE, from, 0, ranks,
                &requests_.emplace_back());
    }
  }
  template <typename Waiting>
  void wait(const Waiting& waiting) {
    for (MPI_Request& request : requests_) {
      Pause pause;
      for (int done = 0; done == 0;) {
        MPI_Test(&request, &done, MPI_STATUS_IGNORE);
        if (done != 0) break;
        waiting();
        pause();
      }
    }
    requests_.clear();
  }
  /// Returns a slot for a request made by the caller.
  MPI_Request* add() { return &requests_.emplace_back(); }

 private:
  std::vector<MPI_Request> requests_;
};

enum class Question : int { next, stop, finished };

/// Work queue of rank 0: serves local jobs directly and the other ranks through a thread.
class ServedJobs : public Jobs {
 public:
  ServedJobs(MPI_Comm ranks, int others, std::size_t count)
      : ranks_(ranks), busy_(others), count_(count), thread_([this] { serve(); }) {}
  ServedJobs(const ServedJobs&) = delete;
  ServedJobs& operator=(const ServedJobs&) = delete;
  ServedJobs(ServedJobs&&) = delete;
  ServedJobs& operator=(ServedJobs&&) = delete;
  ~ServedJobs() override {
    gives_up_ = true;
    thread_.join();
  }

  std::optional<std::size_t> next() override {
    const std::size_t job = next_++;
    if (job >= count_) return std::nullopt;
    return job;
  }
  void stop() override { next_ = count_; }
  [[nodiscard]] std::size_t handed_out() const override { return std::min(next_.load(), count_); }
  /// Returns true if other ranks have not finished.
  [[nodiscard]] bool is_busy() const { return busy_ > 0; }

 private:
  void serve() {
    Pause pause;
    while (busy_ > 0 && !gives_up_) {
      int waits = 0;
      MPI_Status status;
      MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, ranks_, &waits, &status);
      if (waits == 0) {
        pause();
        continue;
      }
      pause = Pause();
      auto question = Question::next;
      MPI_Recv(&question, 1, MPI_INT, status.MPI_SOURCE, 0, ranks_, MPI_STATUS_IGNORE);
      if (question == Question::stop) stop();
      if (question == Question::finished) --busy_;
      if (question != Question::next) continue;
      const auto answer = static_cast<std::int64_t>(next().value_or(count_));
      MPI_Send(&answer, 1, MPI_INT64_T, status.MPI_SOURCE, 0, ranks_);
    }
  }

  MPI_Comm ranks_;
  std::atomic<int> busy_;
  std::size_t count_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> gives_up_ = false;
  std::thread thread_;
};

/// Work queue of the other ranks, which request jobs from rank 0.
class AskedJobs : public Jobs {
 public:
  AskedJobs(MPI_Comm ranks, std::size_t count) : ranks_(ranks), count_(count) {}

  std::optional<std::size_t> next() override {
    const std::scoped_lock one_at_a_time(mutex_);
    if (asked_ >= count_) return std::nullopt;
    tell(Question::next);
    std::int64_t job = 0;
    Requests answer;
    MPI_Irecv(&job, 1, MPI_INT64_T, 0, 0, ranks_, answer.add());
    answer.wait([] {});
    asked_ = static_cast<std::size_t>(job);
    if (asked_ >= count_) return std::nullopt;
    return asked_;
  }
  void stop() override {
    const std::scoped_lock one_at_a_time(mutex_);
    tell(Question::stop);
  }
  void finish() { tell(Question::finished); }
  [[nodiscard]] std::size_t handed_out() const override { return asked_; }

 private:
  void tell(Question question) const { MPI_Send(&question, 1, MPI_INT, 0, 0, ranks_); }

  MPI_Comm ranks_;
  std::size_t count_;
  std::atomic<std::size_t> asked_ = 0;
  std::mutex mutex_;
};

class MpiFile : public SharedFile {
 public:
  MpiFile(MPI_Comm ranks, std::string path, std::uint64_t bytes) : path_(std::move(path)) {
    check(MPI_File_open(ranks, path_.c_str(), MPI_MODE_CREATE | MPI_MODE_WRONLY, MPI_INFO_NULL, &file_));
    check(MPI_File_set_size(file_, static_cast<MPI_Offset>(bytes)));
  }

  void write(std::uint64_t offset, std::string_view bytes) override {
    for (std::size_t at = 0; at < bytes.size(); at += piece_bytes) {
      const std::string_view piece = bytes.substr(at, piece_bytes);
      MPI_Status status;
      check(MPI_File_write_at(file_, static_cast<MPI_Offset>(offset) + static_cast<MPI_Offset>(at), piece.data(),
                              static_cast<int>(piece.size()), MPI_BYTE, &status));
      int written = 0;
      MPI_Get_count(&status, MPI_BYTE, &written);
      if (static_cast<std::size_t>(written) != piece.size()) fail("not all bytes could be written");
    }
  }

  void close() override { check(MPI_File_close(&file_)); }

 private:
  [[noreturn]] void fail(std::string_view reason) const {
    throw std::runtime_error(fmt::format("cannot write {}: {}", path_, reason));
  }
  void check(int error) const {
    if (error == MPI_SUCCESS) return;
    std::array<char, MPI_MAX_ERROR_STRING> reason{};
    int length = 0;
    MPI_Error_string(error, reason.data(), &length);
    fail(std::string_view(reason.data(), static_cast<std::size_t>(length)));
  }

  std::string path_;
  MPI_File file_ = MPI_FILE_NULL;
};

class MpiRanks : public Communicator {
 public:
  MpiRanks() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    MPI_Comm_dup(MPI_COMM_WORLD, &jobs_);
    if (provided < MPI_THREAD_SERIALIZED) throw std::runtime_error("this MPI library does not work with threads");
  }
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;
  MpiRanks(MpiRanks&&) = delete;
  MpiRanks& operator=(MpiRanks&&) = delete;
  ~MpiRanks() override {
    MPI_Comm_free(&jobs_);
    MPI_Finalize();
  }

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return size_; }

  void share_jobs(std::size_t count, const std::function<void(Jobs&)>& work) override {
    if (rank_ == 0) {
      ServedJobs jobs(jobs_, size_ - 1, count);
      work(jobs);
      for (Pause pause; jobs.is_busy(); pause()) waiting();
    } else {
      AskedJobs jobs(jobs_, count);
      work(jobs);
      jobs.finish();
    }
  }

  std::vector<std::string> gather(std::string bytes) override {
    std::vector<std::string> to_ranks{std::move(bytes)};
    to_ranks.resize(static_cast<std::size_t>(size_));
    std::vector<std::string> all = exchange(std::move(to_ranks));
    if (rank_ != 0) all.clear();
    return all;
  }

  std::string broadcast(std::string bytes) override {
    std::uint64_t size = bytes.size();
    Requests requests;
    MPI_Ibcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD, requests.add());
    wait(requests);
    bytes.resize(size);
    for (std::size_t at = 0; at < size; at += piece_bytes) {
      MPI_Ibcast(bytes.data() + at, static_cast<int>(std::min<std::size_t>(piece_bytes, size - at)), MPI_BYTE, 0,
                 MPI_COMM_WORLD, requests.add());
      wait(requests);
    }
    return bytes;
  }

  std::vector<std::string> exchange(std::vector<std::string> to_ranks) override {
    std::vector<std::uint64_t> given;
    for (const std::string& bytes : to_ranks) given.push_back(bytes.size());
    std::vector<std::uint64_t> sizes(to_ranks.size());
    Requests requests;
    MPI_Ialltoall(given.data(), 1, MPI_UINT64_T, sizes.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD, requests.add());
    wait(requests);
    std::vector<std::string> from_ranks(to_ranks.size());
    for (int other = 0; other < size_; ++other) {
      const auto i = static_cast<std::size_t>(other);
      if (other == rank_) {
        from_ranks[i] = std::move(to_ranks[i]);
        continue;
      }
      from_ranks[i].resize(sizes[i]);
      requests.receive(MPI_COMM_WORLD, from_ranks[i], other);
      requests.send(MPI_COMM_WORLD, to_ranks[i], other);
    }
    wait(requests);
    return from_ranks;
  }

  std::string pass_on(std::string_view bytes, const std::function<void()>& meanwhile) override {
    const int next = (rank_ + 1) % size_;
    const int previous = (rank_ + size_ - 1) % size_;
    const std::uint64_t given = bytes.size();
    std::uint64_t size = 0;
    Requests requests;
    MPI_Irecv(&size, 1, MPI_UINT64_T, previous, 0, MPI_COMM_WORLD, requests.add());
    MPI_Isend(&given, 1, MPI_UINT64_T, next, 0, MPI_COMM_WORLD, requests.add());
    wait(requests);
    std::string received(size, '\0');
    requests.receive(MPI_COMM_WORLD, received, previous);
    requests.send(MPI_COMM_WORLD, bytes, next);
    meanwhile();
    wait(requests);
    return received;
  }

  std::unique_ptr<SharedFile> create_file(const std::filesystem::path& path, std::uint64_t bytes) override {
    return std::make_unique<MpiFile>(MPI_COMM_WORLD, path.string(), bytes);
  }

  void abort(int status) override { MPI_Abort(MPI_COMM_WORLD, status); }

 private:
  void wait(Requests& requests) const {
    requests.wait([this] { waiting(); });
  }

  int rank_ = 0;
  int size_ = 1;
  MPI_Comm jobs_ = MPI_COMM_NULL;
};

}  // namespace

}  // namespace shapegauge

extern "C" shapegauge::Communicator* shapegauge_join_mpi(const char* build) {
  if (fmt::format("{} {}", shapegauge::version(), shapegauge::commit()) != build) return nullptr;
  return new shapegauge::MpiRanks;
}
