// SPDX-License-Identifier: MIT
#include "source_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "text.h"

namespace gnomon::compiler {
namespace {

Diagnostic failure(const std::string& path, int line, std::string message) {
  return {.file = path, .line = line, .message = std::move(message), .failure = Failure::kFailed};
}

// Ends every line in LF alone.
std::string with_plain_line_ends(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  std::string text;
  text.reserve(bytes.size());
  for (size_t i = 0; i < bytes.size(); ++i) {
    if (bytes[i] != '\r') {
      text += bytes[i];
    } else if (bytes.substr(i + 1, 1) != "\n") {
      text += '\n';
    }
  }
  return text;
}

std::vector<SourceLine> logical_lines(std::string_view text) {
  std::vector<SourceLine> lines;
  bool joins = false;
  for (int number = 1; !text.empty(); ++number) {
    const size_t length = std::min(text.find('\n'), text.size());
    std::string_view physical = text.substr(0, length);
    text.remove_prefix(std::min(length + 1, text.size()));
    if (!joins) lines.push_back({.text = {}, .line = number, .directive = {}, .argument = {}});
    joins = physical.ends_with('\\');
    if (joins) physical.remove_suffix(1);
    lines.back().text += physical;
  }
  return lines;
}

// Fills in the directives. Yields the line of the block comment that is still open at the end, 0 where none
// is.
int find_directives(std::vector<SourceLine>& lines) {
  bool in_comment = false;
  int opened = 0;
  for (SourceLine& line : lines) {
    line.opens_in_comment = in_comment;
    const std::string code = without_comments(line.text, in_comment);
    line.ends_in_comment = in_comment;
    std::string_view rest = trim(code);
    line.blank = rest.empty();
    if (in_comment && !(line.opens_in_comment && line.blank)) opened = line.line;
    if (!rest.starts_with('#')) continue;
    rest = trim(rest.substr(1));
    line.directive = take_word(rest);
    line.argument = rest;
  }
  return in_comment ? opened : 0;
}

// The conditionals that are open while the lines of a file go by.
class Conditionals {
 public:
  // What is wrong with the directive; empty where nothing is.
  std::string step(SourceLine& line, bool is_guard) {
    const std::string& name = line.directive;
    if (name == "if" || name == "ifdef" || name == "ifndef") {
      open_.push_back({line.line, name, false, name == "if" && line.argument == "0", is_guard});
    } else if (name == "elif" || name == "else") {
      if (open_.empty()) return "#" + name + " without #if: both have to be in the same file";
      if (open_.back().has_else)
        return "#" + name + " after the #else of the #" + open_.back().name + " in line " +
               std::to_string(open_.back().line);
      open_.back().has_else = name == "else";
      open_.back().dead = false;
    } else if (name == "endif") {
      if (open_.empty()) return "#endif without #if: both have to be in the same file";
      open_.pop_back();
    }
    line.dead = std::ranges::any_of(open_, &Open::dead);
    line.conditional = !std::ranges::all_of(open_, &Open::is_guard);
    return {};
  }

  [[nodiscard]] size_t depth() const { return open_.size(); }
  [[nodiscard]] int line() const { return open_.back().line; }
  [[nodiscard]] const std::string& name() const { return open_.back().name; }

 private:
  struct Open {
    int line;
    std::string name;
    bool has_else;
    bool dead;
    bool is_guard;
  };
  std::vector<Open> open_;
};

// NAME where the first directives of the file are #ifndef NAME and #define NAME, with no code before them.
std::string_view find_guard(const std::vector<SourceLine>& lines) {
  std::string_view guard;
  for (const SourceLine& line : lines) {
    if (line.blank) continue;
    if (guard.empty()) {
      if (line.directive != "ifndef") return {};
      guard = line.argument;
    } else {
      std::string_view defined = line.argument;
      return line.directive == "define" && take_word(defined) == guard ? guard : std::string_view{};
    }
  }
  return {};
}

// Fills in `dead` and `conditional`, and whether the guard, if any, holds everything.
std::optional<Diagnostic> find_conditionals(const std::string& path, SourceFile& file) {
  file.guard = find_guard(file.lines);
  bool guard_expected = !file.guard.empty();
  file.guarded = guard_expected;
  bool guard_closed = false;
  Conditionals conditionals;
  for (SourceLine& line : file.lines) {
    if (guard_closed && !line.blank) file.guarded = false;
    const bool is_guard = guard_expected && line.directive == "ifndef";
    if (is_guard) guard_expected = false;
    const std::string defect = conditionals.step(line, is_guard);
    if (!defect.empty()) return failure(path, line.line, defect);
    if (conditionals.depth() == 1 && (line.directive == "else" || line.directive == "elif"))
      file.guarded = false;
    if (conditionals.depth() == 0 && line.directive == "endif") guard_closed = true;
  }
  if (conditionals.depth() == 0) return std::nullopt;
  return failure(path, conditionals.line(),
                 "unterminated #" + conditionals.name() + ": no #endif follows in this file");
}

}  // namespace

bool is_pragma_once(const SourceLine& line) {
  return line.directive == "pragma" && line.argument == "once";
}

std::optional<std::string> read_bytes(const std::string& path) {
  // A pipe could be read once only, and a device without an end.
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return std::nullopt;
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  if (!stream.is_open() || bytes.bad()) return std::nullopt;
  return std::move(bytes).str();
}

Result<SourceFile> scan(const std::string& path, std::string bytes) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    return failure(path, 1, "the file is UTF-16: save it as UTF-8");
  const std::string text = with_plain_line_ends(bytes);
  const size_t bad = first_bad_byte(text);
  if (bad < text.size()) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(bad), '\n');
    return failure(path, static_cast<int>(line),
                   text[bad] == '\0' ? "this line has a NUL character: the file is not text, or is damaged"
                                     : "this line has a byte that is not UTF-8: save the file as UTF-8");
  }
  SourceFile file{logical_lines(text)};
  const int open_comment = find_directives(file.lines);
  if (open_comment > 0)
    return failure(path, open_comment, "unterminated comment: no */ follows in this file");
  if (auto defect = find_conditionals(path, file)) return *std::move(defect);
  file.once = std::ranges::any_of(file.lines,
                                  [](const SourceLine& line) { return is_pragma_once(line) && !line.dead; });
  file.guarded = file.guarded || file.once;
  return file;
}

}  // namespace gnomon::compiler
