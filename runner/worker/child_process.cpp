// SPDX-License-Identifier: MIT
#include "worker/child_process.h"

#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

namespace gnomon::worker {
namespace {

Diagnostic no_process(const char* what) {
  return {.message = std::string("cannot start a worker process: ") + what + ": " + std::strerror(errno),
          .failure = Failure::kMachine};
}

[[noreturn]] void become(const std::string& executable, std::vector<char*>& arguments, int socket) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // a worker never outlives its parent, however that ends
  // Both reach the whole process group; the parent decides what becomes of its workers.
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  dup2(socket, STDIN_FILENO);
  dup2(socket, STDOUT_FILENO);
  execv(executable.c_str(), arguments.data());
  _exit(127);
}

/// A child that ended by itself keeps its own cause of death; only a running one is killed. One that has
/// closed its side is about to end: its files are closed a moment before it can be waited for.
int wait_or_kill(pid_t process, bool closed) {
  int status = 0;
  for (int i = 0; i < (closed ? 200 : 1); ++i) {
    if (waitpid(process, &status, WNOHANG) != 0) return status;
    if (closed) usleep(5000);
  }
  kill(process, SIGKILL);
  waitpid(process, &status, 0);
  return status;
}

}  // namespace

Result<ChildProcess> ChildProcess::spawn(const std::string& executable,
                                         const std::vector<std::string>& arguments) {
  std::vector<std::string> words{executable};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return no_process("socketpair");
  const pid_t process = fork();
  if (process == 0) become(executable, pointers, ends[1]);
  close(ends[1]);
  if (process < 0) {
    close(ends[0]);
    return no_process("fork");
  }
  return ChildProcess(process, ends[0]);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      socket_(std::exchange(other.socket_, -1)),
      closed_(other.closed_),
      received_(std::move(other.received_)) {}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  std::swap(process_, other.process_);
  std::swap(socket_, other.socket_);
  std::swap(closed_, other.closed_);
  std::swap(received_, other.received_);
  return *this;
}

ChildProcess::~ChildProcess() {
  (void)end();
}

bool ChildProcess::send_line(const std::string& line) const {
  const std::string text = line + "\n";
  std::size_t sent = 0;
  while (sent < text.size()) {
    const ssize_t now = send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (now < 0 && errno == EINTR) continue;
    if (now <= 0) return false;
    sent += static_cast<std::size_t>(now);
  }
  return true;
}

bool ChildProcess::receive() {
  std::array<char, 65536> bytes{};
  const ssize_t now = recv(socket_, bytes.data(), bytes.size(), 0);
  if (now > 0) received_.append(bytes.data(), static_cast<std::size_t>(now));
  closed_ = now == 0 || (now < 0 && errno != EINTR);
  return !closed_;
}

std::optional<std::string> ChildProcess::take_line() {
  const std::size_t newline = received_.find('\n');
  if (newline == std::string::npos) return std::nullopt;
  std::string line = received_.substr(0, newline);
  received_.erase(0, newline + 1);
  return line;
}

std::string ChildProcess::end() {
  if (process_ < 0) return "not running";
  const int status = wait_or_kill(process_, closed_);
  process_ = -1;
  close(std::exchange(socket_, -1));
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    return "ended by signal " + std::to_string(number) + " (" + strsignal(number) + ")";
  }
  return "exited with code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace gnomon::worker
