// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/io/file_bytes.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

/// Open file, closed on destruction.
class Descriptor {
 public:
  explicit Descriptor(const fs::path& path) : value_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&&) = delete;
  Descriptor& operator=(Descriptor&&) = delete;
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  [[nodiscard]] int get() const { return value_; }

 private:
  int value_;
};

[[noreturn]] void fail_reading(const fs::path& path, std::string_view reason) {
  throw InputError(fmt::format("cannot read {}: {}", path.string(), reason));
}

[[noreturn]] void fail_reading(const fs::path& path, int error) {
  fail_reading(path, std::generic_category().message(error));
}

[[noreturn]] void fail_writing(const fs::path& path, int error) {
  throw InputError(fmt::format("cannot write {}: {}", path.string(), std::generic_category().message(error)));
}

struct NewFile {
  int descriptor;
  fs::path path;
};

/// Creates a new file next to `path` under a unique name: other threads and processes may write to the same folder.
NewFile create_temporary(const fs::path& path, mode_t mode) {
  static std::atomic<unsigned> counter = 0;
  while (true) {
    // With part of the name only, as names have at most 255 bytes.
    const fs::path name = path.parent_path() /
                          fmt::format("{}.{}-{}.part", path.filename().string().substr(0, 200), ::getpid(), counter++);
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (descriptor >= 0) return {descriptor, name};
    if (errno != EEXIST) fail_writing(path, errno);
  }
}

/// Files that must not exist when they are published.
class NewFiles {
 public:
  void set(const fs::path& path, bool is_new) {
    const std::scoped_lock lock(mutex_);
    if (is_new) {
      paths_.insert(key_of(path));
    } else {
      paths_.erase(key_of(path));
    }
  }
  bool take(const fs::path& path) {
    const std::scoped_lock lock(mutex_);
    return paths_.erase(key_of(path)) > 0;
  }

 private:
  static fs::path key_of(const fs::path& path) { return fs::absolute(path).lexically_normal(); }

  std::mutex mutex_;
  std::set<fs::path> paths_;
};

NewFiles& new_files() {
  static NewFiles files;
  return files;
}

/// Moves a file to a name that no file may have. Returns 0 or the error.
int move_to_new(const fs::path& from, const fs::path& to) {
  if (::link(from.c_str(), to.c_str()) != 0) {
    // File systems without hard links.
    return errno == EEXIST || ::rename(from.c_str(), to.c_str()) != 0 ? errno : 0;
  }
  return ::unlink(from.c_str()) != 0 ? errno : 0;
}

/// Returns the size of an open file. Throws InputError if it is not a regular file, or empty.
std::size_t checked_size(const Descriptor& file, const fs::path& path) {
  if (file.get() < 0) fail_reading(path, errno);
  struct stat status = {};
  if (::fstat(file.get(), &status) != 0) fail_reading(path, errno);
  if (S_ISDIR(status.st_mode)) fail_reading(path, "it is a folder");
  if (!S_ISREG(status.st_mode)) fail_reading(path, "it is not a regular file");
  if (status.st_size == 0) fail_reading(path, "the file is empty");
  return static_cast<std::size_t>(status.st_size);
}

}  // namespace

std::string read_file_bytes(const fs::path& path, std::size_t limit) {
  const Descriptor file(path);
  std::string bytes(std::min(limit, checked_size(file, path)), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::read(file.get(), bytes.data() + done, bytes.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_reading(path, errno);
    if (got == 0) break;  // the file shrank meanwhile
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

MappedBytes map_file(const fs::path& path) {
  const Descriptor file(path);
  const std::size_t size = checked_size(file, path);
  void* begin = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.get(), 0);
  if (begin == MAP_FAILED) {
    const auto read = std::make_shared<const std::string>(read_file_bytes(path));
    return {.memory = read, .bytes = *read};
  }
  return {.memory = {begin, [size](void* mapped) { ::munmap(mapped, size); }},
          .bytes = {static_cast<const char*>(begin), size}};
}

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path_, ignored);
  if (fs::is_directory(status)) fail_writing(path_, EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail_writing(path_, errno);
    return;
  }
  fs::path target = fs::exists(status) ? fs::canonical(path_, ignored) : path_;
  target_ = target.empty() ? path_ : std::move(target);
  constexpr mode_t by_umask = 0666;
  const auto mode = static_cast<mode_t>(status.permissions() & fs::perms::mask);
  NewFile file = create_temporary(target_, fs::exists(status) ? mode : by_umask);
  descriptor_ = file.descriptor;
  unfinished_ = std::move(file.path);
  // An existing file keeps its permissions, whatever the umask.
  if (fs::exists(status) && ::fchmod(descriptor_, mode) != 0) fail_writing(path_, errno);
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!unfinished_.empty()) ::unlink(unfinished_.c_str());
}

void AtomicFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      fail_writing(path_, errno);
    }
  }
}

void AtomicFile::publish(Flush flush) {
  const bool is_new = !unfinished_.empty();
  int error = is_new && flush == Flush::yes && ::fsync(descriptor_) != 0 ? errno : 0;
  // Quotas and network file systems report some errors only on closing.
  if (::close(std::exchange(descriptor_, -1)) != 0 && error == 0) error = errno;
  if (error == 0 && is_new && new_files().take(path_)) {
    error = move_to_new(unfinished_, target_);
  } else if (error == 0 && is_new && ::rename(unfinished_.c_str(), target_.c_str()) != 0) {
    error = errno;
  }
  if (error != 0) fail_writing(path_, error);
  unfinished_.clear();
}

void expect_new_file(const fs::path& path, bool is_new) { new_files().set(path, is_new); }

void write_file_atomically(const fs::path& path, std::string_view bytes, Flush flush) {
  AtomicFile file(path);
  file.write(bytes);
  file.publish(flush);
}

}  // namespace shapegauge
