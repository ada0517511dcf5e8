// SPDX-License-Identifier: MIT
// One file, read and cut into logical lines whose directives are known.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gnomon/diagnostic.h"

namespace gnomon::compiler {

/// A line with its continuations joined.
struct SourceLine {
  std::string text;               ///< as written, comments included
  int line = 0;                   ///< 1-based, of its first physical line
  std::string directive;          ///< "include", "version" ...; empty for other lines
  std::string argument;           ///< what follows the directive, without comments
  bool blank = false;             ///< nothing but comments
  bool opens_in_comment = false;  ///< a block comment is open where the line begins
  bool ends_in_comment = false;   ///< ... where it ends
  bool dead = false;              ///< under a literal `#if 0`
  bool conditional = false;       ///< under a conditional that is not the file's include guard
};

struct SourceFile {
  std::vector<SourceLine> lines;
  bool guarded = false;  ///< nothing stands outside of the file's include guard, or it has #pragma once
  bool once = false;     ///< it has #pragma once
  std::string guard;     ///< the macro of its include guard; empty where it has none
};

[[nodiscard]] bool is_pragma_once(const SourceLine& line);

/// The bytes of an ordinary file; none where it cannot be read or is a folder, a pipe or a device.
[[nodiscard]] std::optional<std::string> read_bytes(const std::string& path);

/// Cuts `bytes` into lines: a byte order mark is dropped, CRLF and CR end a line like LF. Fails (kFailed),
/// located in `path`, where a comment or conditional does not end, an #else or #endif has no #if, or the
/// bytes are not UTF-8 text.
[[nodiscard]] Result<SourceFile> scan(const std::string& path, std::string bytes);

}  // namespace gnomon::compiler
