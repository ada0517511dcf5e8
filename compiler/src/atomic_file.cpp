// SPDX-License-Identifier: MIT
#include "gnomon/atomic_file.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <list>
#include <random>
#include <system_error>
#include <utility>

namespace gnomon {
namespace {

namespace fs = std::filesystem;

// Keeps an interrupt from leaving a temporary file, or one of two outputs, behind.
class BlockedInterrupts {
 public:
  BlockedInterrupts() {
    sigset_t interrupts;
    sigemptyset(&interrupts);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&interrupts, signal);
    pthread_sigmask(SIG_BLOCK, &interrupts, &before_);
  }
  BlockedInterrupts(const BlockedInterrupts&) = delete;
  BlockedInterrupts& operator=(const BlockedInterrupts&) = delete;
  ~BlockedInterrupts() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

class OutputFile {
 public:
  OutputFile(const std::string& path, int flags)
      : descriptor_(::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666)) {}
  explicit OutputFile(int duplicate) : descriptor_(duplicate) {}
  OutputFile(OutputFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
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
  [[nodiscard]] bool set_mode(::mode_t mode) { return ::fchmod(descriptor_, mode) == 0; }
  [[nodiscard]] bool flush() { return ::fsync(descriptor_) == 0; }
  [[nodiscard]] bool close() { return ::close(std::exchange(descriptor_, -1)) == 0; }

 private:
  int descriptor_;
};

// Where a path leads to, through symbolic links; the last of them may lead to nothing yet. A link in the
// folder of a process's descriptors is not followed: what it leads to belongs to whoever opened it. Empty for
// links that go round.
std::string end_of_links(fs::path path) {
  constexpr int kMostLinks = 40;
  std::error_code error;
  for (int i = 0; i < kMostLinks; ++i) {
    const fs::path folder = fs::canonical(fs::absolute(path, error).parent_path(), error);
    if (folder.string().starts_with("/proc/")) return (folder / path.filename()).string();
    if (!fs::is_symlink(path, error)) return path.string();
    const fs::path target = fs::read_symlink(path, error);
    path = path.parent_path() / target;
  }
  return {};
}

// N of ".../fd/N" in the folder of this process's descriptors, -1 for other paths.
int descriptor_of(const fs::path& path) {
  const std::string name = path.filename().string();
  int descriptor = -1;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), descriptor);
  const bool is_number = error == std::errc{} && end == name.data() + name.size();
  std::error_code ignored;
  return is_number && path.parent_path() == fs::canonical("/proc/self/fd", ignored) ? descriptor : -1;
}

// One of the files, with the temporary one that is to take its place.
class Replacement {
 public:
  explicit Replacement(const FileContent& content) : content_(content) {}
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;
  ~Replacement() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }

  // Writes all that can be taken back; false with errno set.
  [[nodiscard]] bool prepare() {
    is_direct_ = content_.path.empty();
    if (is_direct_) return true;
    target_ = end_of_links(content_.path);
    struct ::stat status {};
    const bool exists = ::stat(target_.c_str(), &status) == 0;
    if (target_.empty() || (exists && S_ISDIR(status.st_mode))) {
      errno = target_.empty() ? ELOOP : EISDIR;
      return false;
    }
    // A rename would put an ordinary file in the place of the device.
    is_direct_ = exists && (!S_ISREG(status.st_mode) || target_.starts_with("/proc/"));
    if (exists && ::access(target_.c_str(), W_OK) != 0) return false;
    if (is_direct_) return true;
    OutputFile file = create_temporary();
    if (!file.is_open()) return false;
    return (!exists || file.set_mode(status.st_mode & 07777)) && file.write(content_.bytes) && file.flush() &&
           file.close();
  }

  [[nodiscard]] bool is_direct() const { return is_direct_; }

  [[nodiscard]] bool finish() {
    if (is_direct_) return write_directly();
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) return false;
    temporary_.clear();
    return true;
  }

  [[nodiscard]] const std::string& path() const { return content_.path; }

 private:
  // Beside the target, so that the rename stays within one file system. Under a name that nobody foresees and
  // nothing has, so that no link that waits there is followed.
  [[nodiscard]] OutputFile create_temporary() {
    constexpr int kMostTries = 100;
    const fs::path folder = fs::path(target_).parent_path();
    std::random_device random;
    for (int i = 1;; ++i) {
      const std::string name = (folder / (".gnomon-" + std::to_string(random()) + ".tmp")).string();
      OutputFile file(name, O_CREAT | O_EXCL | O_NOFOLLOW);
      if (file.is_open()) temporary_ = name;
      if (file.is_open() || errno != EEXIST || i == kMostTries) return file;
    }
  }

  // Through a descriptor itself, so that what its owner writes next follows.
  [[nodiscard]] bool write_directly() const {
    const int descriptor = content_.path.empty() ? STDOUT_FILENO : descriptor_of(target_);
    OutputFile device = descriptor >= 0 ? OutputFile(::dup(descriptor)) : OutputFile(target_, O_APPEND);
    return device.is_open() && device.write(content_.bytes) && device.close();
  }

  const FileContent& content_;
  std::string target_;
  std::string temporary_;
  bool is_direct_ = false;
};

Diagnostic cannot_write(const std::string& path, int error) {
  const bool is_stdout = path.empty();
  return {.file = path,
          .message = (is_stdout ? "cannot write to standard output: " : "cannot write the file: ") +
                     std::generic_category().message(error),
          .failure = Failure::kMachine};
}

}  // namespace

Result<Done> write_files_atomically(std::span<const FileContent> files) {
  const BlockedInterrupts blocked;
  std::list<Replacement> replacements;
  for (const FileContent& file : files) {
    if (!replacements.emplace_back(file).prepare()) return cannot_write(file.path, errno);
  }
  // What cannot be taken back, and may fail, comes before what hardly can.
  for (const bool direct : {true, false}) {
    for (Replacement& replacement : replacements) {
      if (replacement.is_direct() == direct && !replacement.finish())
        return cannot_write(replacement.path(), errno);
    }
  }
  return Done{};
}

Result<Done> write_file_atomically(const std::string& path, std::span<const std::byte> bytes) {
  const FileContent file{path, bytes};
  return write_files_atomically({&file, 1});
}

}  // namespace gnomon
