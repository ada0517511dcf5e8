// SPDX-License-Identifier: MIT
#include "log.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "phrase.h"
#include "text.h"

namespace gnomon::compiler {
namespace {

// Takes "0:12:" off the text: the number of the string, always 0, and the line.
std::optional<int> take_line(std::string_view& text) {
  int line = 0;
  if (!text.starts_with("0:")) return std::nullopt;
  const auto [end, error] = std::from_chars(text.data() + 2, text.data() + text.size(), line);
  const auto length = static_cast<size_t>(end - text.data());
  if (error != std::errc{} || text.substr(length, 1) != ":") return std::nullopt;
  text.remove_prefix(length + 1);
  return line;
}

// An entry goes on in lines of its own where it lists extensions.
std::string take_entry(std::string_view& log) {
  std::string entry;
  do {
    const size_t length = std::min(log.find('\n'), log.size());
    const std::string_view part = trim(log.substr(0, length));
    if (!entry.empty() && !part.empty()) entry += ' ';
    entry += part;
    log.remove_prefix(std::min(length + 1, log.size()));
  } while (log.starts_with("GL_"));
  return entry;
}

}  // namespace

Log read_log(std::string_view log, const std::string& text) {
  Log result;
  std::optional<Phrasing> phrasing;
  while (!log.empty()) {
    const std::string line_of_log = take_entry(log);
    std::string_view entry = line_of_log;
    const bool is_error = entry.starts_with("ERROR: ");
    if (!is_error && !entry.starts_with("WARNING: ")) continue;
    if (is_error && result.error) continue;
    entry.remove_prefix(entry.find(' ') + 1);
    const auto line = take_line(entry);
    if (!line) continue;
    if (!phrasing) phrasing.emplace(text);
    Message message = phrasing->message(entry, *line);
    if (is_error) {
      result.error = std::move(message);
    } else {
      result.warnings.push_back(std::move(message));
    }
  }
  return result;
}

std::string first_line(std::string_view log) {
  log = trim(log);
  return std::string(trim(log.substr(0, std::min(log.find('\n'), log.size()))));
}

}  // namespace gnomon::compiler
