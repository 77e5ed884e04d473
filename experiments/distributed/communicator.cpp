#include "shapegauge/experiments/distributed/communicator.h"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <fmt/format.h>
#include <stdexcept>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/distributed/agreement.h"

namespace shapegauge {

namespace {

class CountedJobs : public Jobs {
 public:
  explicit CountedJobs(std::size_t count) : count_(count) {}

  std::optional<std::size_t> next() override {
    const std::size_t job = next_++;
    if (stopped_ || job >= count_) return std::nullopt;
    return job;
  }
  void stop() override { stopped_ = true; }
  [[nodiscard]] std::size_t handed_out() const override { return std::min(count_, next_.load()); }

 private:
  std::size_t count_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stopped_ = false;
};

class OwnFile : public SharedFile {
 public:
  OwnFile(std::filesystem::path path, std::uint64_t bytes)
      : path_(std::move(path)), descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0 || ::ftruncate(descriptor_, static_cast<off_t>(bytes)) != 0) fail();
  }
  OwnFile(const OwnFile&) = delete;
  OwnFile& operator=(const OwnFile&) = delete;
  OwnFile(OwnFile&&) = delete;
  OwnFile& operator=(OwnFile&&) = delete;
  ~OwnFile() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  void write(std::uint64_t offset, std::string_view bytes) override {
    while (!bytes.empty()) {
      const ssize_t count = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail();
      bytes.remove_prefix(static_cast<std::size_t>(count));
      offset += static_cast<std::uint64_t>(count);
    }
  }

  void close() override {
    if (::close(std::exchange(descriptor_, -1)) != 0) fail();
  }

 private:
  [[noreturn]] void fail() const {
    throw InputError(fmt::format("cannot write {}: {}", path_.string(), std::generic_category().message(errno)));
  }

  std::filesystem::path path_;
  int descriptor_;
};

class SingleProcess : public Communicator {
 public:
  [[nodiscard]] int rank() const override { return 0; }
  [[nodiscard]] int size() const override { return 1; }
  void share_jobs(std::size_t count, const std::function<void(Jobs&)>& work) override {
    CountedJobs jobs(count);
    work(jobs);
  }
  std::vector<std::string> gather(std::string bytes) override { return exchange({std::move(bytes)}); }
  std::string broadcast(std::string bytes) override { return bytes; }
  std::vector<std::string> exchange(std::vector<std::string> to_ranks) override { return to_ranks; }
  std::string pass_on(std::string_view bytes, const std::function<void()>& meanwhile) override {
    meanwhile();
    return std::string(bytes);
  }
  std::unique_ptr<SharedFile> create_file(const std::filesystem::path& path, std::uint64_t bytes) override {
    return std::make_unique<OwnFile>(path, bytes);
  }
  void abort(int status) override { std::_Exit(status); }
};

}  // namespace

std::unique_ptr<Communicator> single_process() { return std::make_unique<SingleProcess>(); }

RankRange part_of_rank(std::size_t count, int rank, int size) {
  const auto ranks = static_cast<std::size_t>(size);
  const auto begin = [&](std::size_t of) { return count / ranks * of + std::min(of, count % ranks); };
  return {.first = begin(static_cast<std::size_t>(rank)), .last = begin(static_cast<std::size_t>(rank) + 1)};
}

void agree_on(const std::string& error, Communicator& ranks) {
  std::string first;
  for (const std::string& of_rank : ranks.gather(error)) {
    if (first.empty()) first = of_rank;
  }
  const std::string agreed = ranks.broadcast(first);
  if (!agreed.empty()) throw SharedError(agreed);
}

}  // namespace shapegauge
