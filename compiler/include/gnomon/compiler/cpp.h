// SPDX-License-Identifier: MIT
// Shader modules as C++.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

struct CppHeader {
  std::string text;
  std::vector<std::string> files;  ///< that were read
};

/// A C++17 header with the functions of the modules at `paths` and of what they include, for GLM: the very
/// code that the GPU runs, for tests, tools and debuggers. It defines
///
///     namespace gnomon { struct Modules; }      // or Options::name
///
/// whose members are the modules' types and functions. A function that is only declared, such as
/// gnomon_host_height, is pure virtual: derive from Modules and define it, so that every object has a height
/// map of its own. Macros of the modules stay macros. #line directives lead compilers and debuggers to the
/// modules; files of the library are called gnomon/..., on every machine.
///
/// Each module is checked first, see check(). Fails as that does, and (kInvalid) for a file with main().
/// The modules have to keep to the part of GLSL that is C++ (docs/architecture.md). Refused (kFailed) is what
/// would compile and mean something else, and what is most often forgotten: floats without an f, array
/// constructors, variables outside of functions, declarations by macros; the rest is the C++ compiler's to
/// judge. Precisions are left out.
[[nodiscard]] Result<CppHeader> cpp_header(const std::vector<std::string>& paths, const Options& options);

/// Whether a namespace or class may be called so: an identifier that is no word of C++ and not reserved.
[[nodiscard]] bool is_cpp_name(std::string_view name);

}  // namespace gnomon::compiler
