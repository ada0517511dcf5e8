// SPDX-License-Identifier: MIT
#include "image/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

namespace gnomon::image {
namespace {

/// A file that vanishes again unless it is renamed into place.
class TemporaryFile {
 public:
  /// Beside `target`, so that the rename stays within one file system. With the permissions of any new file,
  /// which mkstemp would not give. A left-over of a killed process is stepped over.
  explicit TemporaryFile(const std::string& target) {
    for (int attempt = 0; attempt < 100 && descriptor_ < 0; ++attempt) {
      path_ = fmt::format("{}.{}-{}.tmp", target, ::getpid(), attempt);
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && errno != EEXIST) break;
    }
    created_ = descriptor_ >= 0;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (created_ && !renamed_) ::unlink(path_.c_str());
  }

  [[nodiscard]] bool created() const { return created_; }

  [[nodiscard]] bool write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const ::ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return ::fsync(descriptor_) == 0;
  }

  [[nodiscard]] bool rename_to(const std::string& target) {
    renamed_ = ::close(std::exchange(descriptor_, -1)) == 0 && ::rename(path_.c_str(), target.c_str()) == 0;
    return renamed_;
  }

 private:
  std::string path_;
  int descriptor_ = -1;
  bool created_ = false;
  bool renamed_ = false;
};

Diagnostic cannot_write(const std::string& path, int error) {
  return {.file = path,
          .message = fmt::format("cannot write the file: {}", std::generic_category().message(error)),
          .failure = Failure::kMachine};
}

}  // namespace

Result<Done> write_file_atomically(const std::string& path, std::span<const std::byte> bytes) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) return cannot_write(path, EISDIR);
  // The rename would put an ordinary file in the place of a device such as /dev/null.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    return cannot_write(path, EINVAL);
  TemporaryFile file(path);
  if (!file.created() || !file.write(bytes) || !file.rename_to(path)) return cannot_write(path, errno);
  return Done{};
}

}  // namespace gnomon::image
