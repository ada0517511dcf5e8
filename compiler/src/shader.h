// SPDX-License-Identifier: MIT
// What the GLSL compiler found out about one text, as plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gnomon/compiler/compiler.h"
#include "resource.h"

namespace gnomon::compiler {

/// A GLSL type, taken apart.
struct Type {
  enum class Kind {
    kVoid,
    kScalar,
    kComposite,  ///< a vector, matrix, array or structure
    kOpaque      ///< a sampler or image, or something that holds one: only a uniform can be one
  };
  struct Part;
  Kind kind = Kind::kScalar;
  std::string name;         ///< as GLSL spells it: "float", "ivec2", "GnomonMap", "float[3]", "void"
  std::vector<Part> parts;  ///< of a composite; of a very large one only the first
};
struct Type::Part {
  std::string accessor;  ///< ".size" of a structure, "[1]" of a vector, matrix or array
  Type type;
};

enum class Passing { kIn, kConstIn, kOut, kInOut };

struct Parameter {
  Type type;
  Passing passing = Passing::kIn;
};

struct Function {
  std::string signature;  ///< distinguishes overloads
  std::string name;
  Type result;
  std::vector<Parameter> parameters;
  int line =
      0;  ///< of the definition, or of the first call of an undefined one; 1-based in the compiled text
};

/// A message of the GLSL compiler at a line of the compiled text.
struct Message {
  int line = 0;  ///< 1-based
  std::string text;
  int related = 0;  ///< line of the earlier declaration that it collides with, 0 for none
};

struct Shader {
  std::optional<Message> error;  ///< the first; without it the text is valid
  std::vector<Message> warnings;
  bool has_main = false;             ///< a text without main is compiled but not linked
  std::vector<Function> defined;     ///< in the order of the text, main excepted
  std::vector<Function> undefined;   ///< called, but declared only
  std::vector<std::string> called;   ///< names of functions of the text, in the order of their first calls
  std::vector<int> unbounded_loops;  ///< lines, see build()
  std::vector<std::string> reached;  ///< signatures of the functions that main() calls, and they
  std::optional<Message> objection;  ///< why the target cannot express a text that is valid
  std::vector<Resource> resources;   ///< that main() reaches, in the order of the text
  int outputs = 0;                   ///< of a fragment shader: its highest location and one
  Reflection interface;              ///< what glslang knows of it, for a text with main
  std::vector<std::uint32_t> spirv;  ///< for a text with main and a target with rules for SPIR-V
};

/// Parses and links `text` (which has its #version) with glslang, by the rules of the target.
[[nodiscard]] Shader compile(const std::string& text, Stage stage, const Target& target);

/// What glslang's HLSL front end finds wrong with a text made for a target; nothing for a valid one.
[[nodiscard]] std::optional<std::string> defect_of_hlsl(const std::string& text, Stage stage);

/// `text` with its macros expanded, by the rules of the target. Of a text that compiles.
[[nodiscard]] std::string preprocess(const std::string& text, Stage stage, const Target& target);

}  // namespace gnomon::compiler
