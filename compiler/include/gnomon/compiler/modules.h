// SPDX-License-Identifier: MIT
// What the shader library offers, read from the headers of its modules.
#pragma once

#include <string>
#include <vector>

#include "gnomon/diagnostic.h"

namespace gnomon::compiler {

/// A module and the fields of its header comment; a field that the header lacks is empty.
struct Module {
  std::string name;     ///< path below the library without the extension: "relief/multilevel"
  std::string path;     ///< of the file
  std::string summary;  ///< one sentence
  std::string source;   ///< paper and equation, or the page of docs/
  std::string host;     ///< host functions that it calls
  std::string options;  ///< macros that change it, with defaults

  /// It is a ready-made host: it defines host functions, over textures or buffers.
  [[nodiscard]] bool defines_host() const { return host.starts_with("defines "); }
};

/// The fields of one file's header; its name stays empty. A field is `// key: text` in the comment that the
/// file begins with; a line of it that starts with two or more blanks and no key continues the field before.
/// Fails (kInvalid) where the file cannot be read.
[[nodiscard]] Result<Module> read_module(const std::string& path);

/// Every *.glsl below the directory but for programs/, sorted by name. Fails (kInvalid) where the directory
/// or a file cannot be read.
[[nodiscard]] Result<std::vector<Module>> list_modules(const std::string& library_directory);

/// One line a module: name, summary and source in columns.
[[nodiscard]] std::string to_table(const std::vector<Module>& modules);

}  // namespace gnomon::compiler
