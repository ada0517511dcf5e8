// SPDX-License-Identifier: MIT
// Failures as values: what went wrong, where, and what to do, returned instead of thrown or printed.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gnomon {

/// Which exit code a failure leads to (see docs/cli.md, "Exit codes").
enum class Failure {
  kFailed = 1,        ///< a test failed, images differ, a shader does not compile
  kInvalid = 2,       ///< wrong usage; an input that is unreadable, invalid or unsupported
  kSkipped = 77,      ///< a required capability is missing
  kMachine = 99,      ///< no GL context, disk full, output not writable
  kInterrupted = 130  ///< stopped by the user
};

/// One located message. `line` and `column` count from 1; 0 means that the file as a whole is meant.
struct Diagnostic {
  std::string file{};     ///< path as the user gave it, "--set KEY", or empty
  int line = 0;           ///< 1-based, 0 = none
  int column = 0;         ///< 1-based, in bytes, 0 = none
  std::string message{};  ///< one sentence: what happened, what was expected, what to do
  Failure failure = Failure::kInvalid;
  bool warning = false;              ///< reported, but nothing fails because of it
  std::vector<std::string> notes{};  ///< further lines, such as the include chain
};

using Diagnostics = std::vector<Diagnostic>;

/// Either a value or at least one Diagnostic that says why there is none.
template <class T>
class Result {
 public:
  Result(T value) : state_(std::move(value)) {}
  Result(Diagnostic diagnostic) : state_(Diagnostics{std::move(diagnostic)}) {}
  Result(Diagnostics diagnostics) : state_(std::move(diagnostics)) {}

  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  [[nodiscard]] const T& value() const& { return std::get<0>(state_); }
  [[nodiscard]] T& value() & { return std::get<0>(state_); }
  [[nodiscard]] T&& value() && { return std::get<0>(std::move(state_)); }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

  [[nodiscard]] const Diagnostics& diagnostics() const { return std::get<1>(state_); }

 private:
  std::variant<T, Diagnostics> state_;
};

/// The result of something that yields nothing but success.
struct Done {};

/// "PATH:LINE:COL: error: TEXT" (gcc style), followed by one line for each note.
[[nodiscard]] inline std::string to_string(const Diagnostic& d) {
  std::string text = d.file;
  if (d.line > 0) text.append(":").append(std::to_string(d.line));
  if (d.line > 0 && d.column > 0) text.append(":").append(std::to_string(d.column));
  if (!text.empty()) text += ": ";
  text += d.warning ? "warning: " : "error: ";
  text += d.message;
  for (const std::string& note : d.notes) text.append("\n  ").append(note);
  return text;
}

}  // namespace gnomon
