#include "tests/support/thread_ranks.h"

#include <atomic>
#include <barrier>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace shapegauge::test {

namespace {

/// State shared by the ranks.
struct Table {
  explicit Table(int size) : all_here(size), letters(static_cast<std::size_t>(size)) {}

  std::barrier<> all_here;
  std::vector<std::vector<std::string>> letters;  ///< by rank, to each
  std::atomic<std::size_t> next_job = 0;
  std::shared_ptr<SharedFile> file;
};

class TableJobs : public Jobs {
 public:
  TableJobs(std::atomic<std::size_t>& next, std::size_t count) : next_(&next), count_(count) {}
  std::optional<std::size_t> next() override {
    const std::size_t job = (*next_)++;
    if (job >= count_) return std::nullopt;
    return job;
  }
  void stop() override { *next_ = count_; }
  [[nodiscard]] std::size_t handed_out() const override { return std::min(next_->load(), count_); }

 private:
  std::atomic<std::size_t>* next_;
  std::size_t count_;
};

/// A file opened by rank 0.
class TableFile : public SharedFile {
 public:
  TableFile(std::shared_ptr<SharedFile> file, std::barrier<>& all_here, bool closes)
      : file_(std::move(file)), all_here_(&all_here), closes_(closes) {}
  void write(std::uint64_t offset, std::string_view bytes) override { file_->write(offset, bytes); }
  void close() override {
    all_here_->arrive_and_wait();
    if (closes_) file_->close();
    all_here_->arrive_and_wait();
  }

 private:
  std::shared_ptr<SharedFile> file_;
  std::barrier<>* all_here_;
  bool closes_;
};

class ThreadRank : public Communicator {
 public:
  ThreadRank(Table& table, int rank) : table_(&table), rank_(rank) {}
  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return static_cast<int>(table_->letters.size()); }

  void share_jobs(std::size_t count, const std::function<void(Jobs&)>& work) override {
    if (rank_ == 0) table_->next_job = 0;
    table_->all_here.arrive_and_wait();
    TableJobs jobs(table_->next_job, count);
    work(jobs);
    table_->all_here.arrive_and_wait();
  }
  std::vector<std::string> gather(std::string bytes) override {
    std::vector<std::string> to_ranks{std::move(bytes)};
    to_ranks.resize(table_->letters.size());
    std::vector<std::string> all = exchange(std::move(to_ranks));
    if (rank_ != 0) all.clear();
    return all;
  }
  std::string broadcast(std::string bytes) override {
    return exchange(std::vector<std::string>(table_->letters.size(), bytes)).front();
  }
  std::vector<std::string> exchange(std::vector<std::string> to_ranks) override {
    const auto me = static_cast<std::size_t>(rank_);
    table_->letters[me] = std::move(to_ranks);
    table_->all_here.arrive_and_wait();
    std::vector<std::string> from_ranks;
    for (const std::vector<std::string>& letters : table_->letters) from_ranks.push_back(letters.at(me));
    table_->all_here.arrive_and_wait();
    return from_ranks;
  }
  std::string pass_on(std::string_view bytes, const std::function<void()>& meanwhile) override {
    const auto ranks = table_->letters.size();
    std::vector<std::string> to_ranks(ranks);
    const auto me = static_cast<std::size_t>(rank_);
    to_ranks[(me + 1) % ranks] = bytes;
    meanwhile();
    return exchange(std::move(to_ranks)).at((me + ranks - 1) % ranks);
  }
  std::unique_ptr<SharedFile> create_file(const std::filesystem::path& path, std::uint64_t bytes) override {
    if (rank_ == 0) table_->file = single_process()->create_file(path, bytes);
    table_->all_here.arrive_and_wait();
    auto file = std::make_unique<TableFile>(table_->file, table_->all_here, rank_ == 0);
    table_->all_here.arrive_and_wait();
    return file;
  }
  void abort(int status) override { std::_Exit(status); }

 private:
  Table* table_;
  int rank_;
};

}  // namespace

void on_thread_ranks(int size, const std::function<void(Communicator&)>& work) {
  Table table(size);
  std::exception_ptr failure;
  std::mutex mutex;
  std::vector<std::thread> threads;
  for (int rank = 0; rank < size; ++rank) {
    threads.emplace_back([&, rank] {
      try {
        ThreadRank here(table, rank);
        work(here);
      } catch (...) {
        const std::scoped_lock lock(mutex);
        failure = std::current_exception();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace shapegauge::test
