#include "shapegauge/experiments/results/folder_lock.h"

#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include "shapegauge/core/error.h"
#include "shapegauge/experiments/results/result_folder.h"

namespace shapegauge {

namespace {

/// Whether the open file is still the one of that name.
bool is_file_of(int descriptor, const std::filesystem::path& path) {
  struct stat opened = {};
  struct stat named = {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) : path_(folder / ".shapegauge-lock") {
  make_folder(folder);
  while (true) {
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      throw InputError(
          fmt::format("cannot write to the folder {}: {}", folder.string(), std::generic_category().message(errno)));
    }
    const int error = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    if (error == EWOULDBLOCK) {
      ::close(descriptor_);
      throw InputError(
          fmt::format("another run is under way in {}; wait until it has ended, or give another folder with --output",
                      folder.string()));
    }
    // Whoever had it before removes the file at last: a lock on a file that is gone keeps nobody out.
    if (error != 0 || is_file_of(descriptor_, path_)) return;
    ::close(descriptor_);
  }
}

FolderLock::~FolderLock() {
  ::unlink(path_.c_str());
  ::close(descriptor_);
}

}  // namespace shapegauge
