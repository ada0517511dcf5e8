// SPDX-License-Identifier: MIT
// The shader compiler as a library: assembles includes, validates with glslang, reports at the original file
// and line. Usable any number of times in a process, after failures too; not from several threads at once.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gnomon/compiler/reflection.h"
#include "gnomon/compiler/stage.h"
#include "gnomon/diagnostic.h"

namespace gnomon::compiler {

/// What a target's output is.
enum class Format {
  kGlsl,    ///< the assembled text itself
  kSpirv,   ///< words of 32 bits, in the byte order of the machine
  kHlsl,    ///< text by SPIRV-Cross
  kMsl,     ///< text by SPIRV-Cross
  kHeader,  ///< a C++ header that holds the outputs of other targets
};

/// Whose rules the text has to keep, beside those of its #version.
enum class Rules { kOpenGl, kOpenGlSpirv, kVulkan };

/// The dialects and formats that `build` writes. A new target is a row of the table in src/target.cpp, a
/// suffix in cmake/GnomonShaders.cmake, a value of `target` in docs/reflection.schema.json and a row in
/// docs/compiler.md; a test compares them.
struct Target {
  std::string name;           ///< "glsl450"
  std::string version_line;   ///< "#version 450 core": of the text that is validated
  std::string description;    ///< one sentence, for --help
  Format format;              ///< what `build` yields
  Rules rules;                ///< what glslang validates the text for
  std::vector<Stage> stages;  ///< that the target has
  bool binds_by_name;   ///< it lacks `binding`, and `location` but for vertex inputs and fragment outputs
  bool has_precisions;  ///< types have one: in ESSL, and in SPIR-V, where glslang reads them
  bool has_images;      ///< images and multisampled textures
};
[[nodiscard]] const std::vector<Target>& targets();

/// The target of that name, or null.
[[nodiscard]] const Target* find_target(const std::string& name);

struct Define {
  std::string name;
  std::string value;  ///< "1" where the user gave none
};

/// Reads "NAME" or "NAME=VALUE". Fails (kInvalid) for a name that is not an identifier or that GLSL reserves
/// (gl_..., GL_..., a double underscore, `defined`), and for a value that would reach beyond its own line.
[[nodiscard]] Result<Define> parse_define(std::string_view text);

struct Options {
  std::string library_directory;  ///< the folder that <gnomon/...> names; its `core/`, `relief/` ...
  std::vector<std::string> include_directories;  ///< -I, in order
  std::vector<Define> defines;                   ///< -D, in order; from parse_define
  std::string target = "glsl450";
  std::vector<std::string> embedded = {
      "glsl450"};    ///< of target "header": the targets whose outputs it holds
  std::string name;  ///< of target "header" and cpp_header(): of what the header defines; empty: the default
  std::optional<Stage> stage;  ///< absent: from the file's extension
};

/// One inlining of a file into the text. The main file is inclusion 0.
struct Inclusion {
  int file = 0;     ///< index into Assembled::files
  int parent = -1;  ///< index into Assembled::inclusions of the file with the #include, -1 for the main file
  int line = 0;     ///< 1-based line of that #include
  bool in_library = false;  ///< the file lies in the library
};

/// File `includer` includes file `included`: both index Assembled::files.
struct Include {
  int includer = 0;
  int included = 0;
  friend bool operator==(const Include&, const Include&) = default;
};

/// Where a line of the assembled text comes from.
struct LineOrigin {
  int inclusion = 0;  ///< index into Assembled::inclusions
  int line = 0;       ///< 1-based; 0 for a line that stands for a -D option or was added for the target

  bool operator==(const LineOrigin&) const = default;
};

/// One self-contained source text without #include and #line. `origins[n]` belongs to line n + 1 of `text`.
struct Assembled {
  std::string text;
  std::vector<std::string> files;  ///< every file read, the main one first, each once; what a depfile names
  std::vector<Inclusion> inclusions;
  std::vector<Include> includes;  ///< each pair once, also where a guarded file is not inlined again
  std::vector<LineOrigin> origins;
  Diagnostics warnings{};  ///< from build and check, located like errors
};

/// A failure (kFailed) at line `line` (1-based) of the assembled text, located at its original file and line
/// with the include chain as notes. Lines outside the text mean the nearest one. For messages of a driver or
/// another compiler.
[[nodiscard]] Diagnostic locate(const Assembled& assembled, int line, std::string message);

/// Inlines includes, replaces #version by the target's, puts the defines after it.
/// * `#include "x"` is looked for beside the including file, then in `include_directories`; `<gnomon/x>` in
/// the library,
///   then in `include_directories`; any other `<x>` there only.
/// * Conditionals are left to the GLSL compiler, so an include inside one is inlined whether it holds or not;
/// only what
///   stands under a literal `#if 0` is left alone. A file that includes itself, at whatever distance, is an
///   error.
/// * A file wrapped in an include guard is inlined where it is first included outside of all conditionals,
/// and not again.
/// * #pragma once is an include guard.
/// * Lines joined by a backslash become one line; #line and the #extension of include directives are dropped.
/// Fails (kInvalid) where `path` itself cannot be read or the target is unknown, (kFailed) for a missing
/// include, a cycle, an unterminated conditional or comment, bytes that are not UTF-8 text, a #version that
/// GLSL does not have or that does not come first.
[[nodiscard]] Result<Assembled> assemble(const std::string& path, const Options& options);

/// The files that assemble() reads, the main one first, each once, in its failure too: what the result
/// depends on. Where an include is missing, the place where it was first looked for is the last of them, so
/// that a build system that knows it to be missing tries again. Empty where the target is unknown.
[[nodiscard]] std::vector<std::string> files_read(const std::string& path, const Options& options);

/// What a shader became for one target.
struct Compiled {
  Assembled source;               ///< the text that was validated; for HLSL and MSL what they were made from
  std::string output;             ///< text, or the bytes of SPIR-V
  Format format = Format::kGlsl;  ///< of the output
  bool is_module = false;         ///< it has no main() of its own; only check() takes that
  Reflection reflection;          ///< of target "header": that of the first embedded target
};

/// Assembles the shader for the target, has glslang validate it, and makes the target's output of it. No pass
/// changes the order of an operation on floats. Fails (kFailed) with one clean first error at its original
/// file and line, the include chain in the notes; where other targets take what this one refuses, the message
/// names them. A file without main() is kInvalid ("use gnomonc check"), so is one whose stage neither its
/// extension nor the options tell.
///
/// What the text of a target lacks is taken out of its layout qualifiers: `set` outside of Vulkan, `binding`
/// and the `location` of uniforms and of varyings in GLSL 3.30 and ESSL 3.00, where the host binds by name.
/// ESSL gets `precision highp` for every type that has a precision. SPIR-V, HLSL and MSL get the bindings and
/// locations that the source does not give, around those that it gives; for Vulkan, HLSL and MSL uniforms
/// outside of blocks become the block `gnomon_uniforms`.
///
/// A loop without a bound is an error in a file below the library directory, a warning elsewhere. Bounded is
/// a `for`
/// * that initialises its counter, an int or uint, and steps it in its header by a constant other than 0 (++,
/// --, +=, -=, i = i + 2), and does not modify it in its body;
/// * whose condition compares that counter by < <= > >= with a limit that lies in the direction of the step,
/// or by != where the step is 1 or -1; other conditions may be joined to the comparison by &&;
/// * whose limit is an expression that the loop does not modify and that calls no function of the shader, and
/// that the counter cannot jump over at the end of its type: i <= 2147483647 always holds, and so does
/// i >= n for a uint where n may be 0.
/// Every `while` and `do` counts as unbounded, and so does a loop over floats: a small step may change
/// nothing. What is global counts as modified where the loop calls functions of the shader.
[[nodiscard]] Result<Compiled> build(const std::string& path, const Options& options);

/// Like build, but also takes a file without main(), a module, alone (as a fragment shader where nothing
/// tells the stage): a generated entry point calls every function that it and its includes define, with
/// arguments that the compiler cannot know, and uses every result, so that nothing is dropped as unused;
/// functions that are declared but not defined (the host's) get a body.
[[nodiscard]] Result<Compiled> check(const std::string& path, const Options& options);

/// The version of glslang that validates, such as "12.0.0".
[[nodiscard]] std::string glslang_version();
/// Likewise of what judges and translates SPIR-V.
[[nodiscard]] std::string spirv_tools_version();
[[nodiscard]] std::string spirv_cross_version();

}  // namespace gnomon::compiler
