// SPDX-License-Identifier: MIT
// A child process that is spoken to in lines over its standard input and output.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "gnomon/diagnostic.h"

namespace gnomon::worker {

/// Move-only owner: what is still running when the owner goes is killed.
class ChildProcess {
 public:
  /// Fails with kMachine if no process can be made. The child ignores the terminal's interrupt: its parent
  /// decides.
  [[nodiscard]] static Result<ChildProcess> spawn(const std::string& executable,
                                                  const std::vector<std::string>& arguments);

  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;
  ~ChildProcess();

  /// False where the child no longer reads.
  [[nodiscard]] bool send_line(const std::string& line) const;
  /// Readable when the child has said something or has ended; for poll().
  [[nodiscard]] int descriptor() const { return socket_; }
  /// Takes in what has arrived. False at the end: the child has closed its side.
  [[nodiscard]] bool receive();
  [[nodiscard]] std::optional<std::string> take_line();

  /// Kills what still runs, waits, and tells how it ended: "ended by signal 11 (Segmentation fault)".
  [[nodiscard]] std::string end();

 private:
  ChildProcess(pid_t process, int socket) : process_(process), socket_(socket) {}
  pid_t process_ = -1;
  int socket_ = -1;
  bool closed_ = false;  // by the child
  std::string received_;
};

}  // namespace gnomon::worker
