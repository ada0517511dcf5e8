// SPDX-License-Identifier: MIT
#include "gnomon/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

namespace gnomon {
namespace {

namespace fs = std::filesystem;

class OutputFile {
 public:
  OutputFile(const std::string& path, int flags)
      : descriptor_(::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666)) {}
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }

  [[nodiscard]] bool write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const ::ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      bytes = bytes.subspan(static_cast<size_t>(written));
    }
    return true;
  }
  [[nodiscard]] bool flush() { return ::fsync(descriptor_) == 0; }
  [[nodiscard]] bool close() { return ::close(std::exchange(descriptor_, -1)) == 0; }

 private:
  int descriptor_;
};

Diagnostic cannot_write(const std::string& path, int error) {
  return {.file = path,
          .message = "cannot write the file: " + std::generic_category().message(error),
          .failure = Failure::kMachine};
}

}  // namespace

Result<Done> write_file_atomically(const std::string& path, std::span<const std::byte> bytes) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) return cannot_write(path, EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    // A rename would put an ordinary file in the place of the device.
    OutputFile device(path, 0);
    if (!device.is_open() || !device.write(bytes) || !device.close()) return cannot_write(path, errno);
    return Done{};
  }
  const std::string target = fs::exists(status) ? fs::canonical(path, ignored).string() : path;
  // Beside the target, so that the rename stays within one file system.
  const std::string temporary = target + "." + std::to_string(::getpid()) + ".tmp";
  OutputFile file(temporary, O_CREAT | O_TRUNC);
  if (!file.is_open()) return cannot_write(path, errno);
  if (!file.write(bytes) || !file.flush() || !file.close() ||
      std::rename(temporary.c_str(), target.c_str()) != 0) {
    const int error = errno;
    ::unlink(temporary.c_str());
    return cannot_write(path, error);
  }
  return Done{};
}

}  // namespace gnomon
