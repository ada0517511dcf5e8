// SPDX-License-Identifier: MIT
// What a program has to know to use a compiled shader. The order of every list is fixed, so that the same
// shader gives the same bytes on every machine.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "gnomon/compiler/stage.h"

namespace gnomon::compiler {

/// An input or output of a stage, a uniform outside of blocks, a texture. A number that the target does not
/// have is absent: there the host binds by name.
struct Variable {
  std::string name;
  std::string type;    ///< as GLSL spells it, without the array: "vec3", "sampler2D"
  int array_size = 0;  ///< 0: no array
  std::optional<int> location{};
  std::optional<int> set{};  ///< of textures, with Vulkan's rules
  std::optional<int> binding{};
};

/// A variable in a block.
struct Member {
  std::string name;
  std::string type;
  int offset = 0;        ///< bytes from the block's beginning
  int array_size = 0;    ///< 0: no array
  int array_stride = 0;  ///< bytes; 0: no array
};

struct Block {
  std::string name;
  bool is_storage = false;  ///< a buffer, which shaders may write; else a uniform block
  int size = 0;             ///< bytes; without the array at its end that has no size
  std::optional<int> set{};
  std::optional<int> binding{};
  std::vector<Member> members{};  ///< in the order of their offsets
};

/// A function `gnomon_host_...` that the shader calls.
struct HostFunction {
  std::string name;
  std::string file;  ///< where it is defined
};

/// A macro that the header comment of an included module names under "options:".
struct OptionValue {
  std::string name;
  std::string value;          ///< that it has in this shader
  std::string default_value;  ///< that the module states, such as "off"
};

struct Reflection {
  std::string target;
  Stage stage = Stage::kFragment;
  std::vector<Variable> inputs{};              ///< by location, then name; built-in ones too
  std::vector<Variable> outputs{};             ///< by location, then name
  std::vector<Variable> uniforms{};            ///< by name; active ones outside of blocks
  std::vector<Variable> textures{};            ///< samplers and images, by name; active ones
  std::vector<Block> blocks{};                 ///< by name
  std::vector<HostFunction> host_functions{};  ///< by name
  std::vector<OptionValue> options{};          ///< by name
  std::vector<int> local_size{};               ///< x, y, z of a compute shader
  std::optional<std::size_t> spirv_size{};     ///< bytes; absent for GLSL and ESSL
};

/// As JSON, with the keys of docs/reflection.schema.json, indented, with a line feed at its end.
[[nodiscard]] std::string to_json(const Reflection& reflection);

}  // namespace gnomon::compiler
