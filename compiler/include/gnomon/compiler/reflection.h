// SPDX-License-Identifier: MIT
// What a program has to know to use a compiled shader. The order of every list is fixed, so that the same
// shader gives the same bytes on every machine.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gnomon/compiler/stage.h"

namespace gnomon::compiler {

/// An input or output of a stage, a uniform outside of blocks, a texture. A number that the target does not
/// have is absent: there the host binds by name.
struct Variable {
  std::string name;  ///< of a uniform in a structure its whole path: "lights[1].power"
  std::string type;  ///< as GLSL spells it, without the dimensions of an array: "vec3", "sampler2D"
  int array_size =
      0;  ///< elements of all dimensions, the last index first; 0: no array, or one without a size
  std::optional<int> location{};
  std::optional<int> set{};  ///< of textures, for Vulkan
  std::optional<int> binding{};
  std::optional<int> input_attachment_index{};
};

/// A variable in a block. Bytes are absent where the driver chooses the layout: in GLSL and ESSL, of a block
/// that is neither std140 nor std430.
struct Member {
  std::string name;  ///< "lights" for an array of structures, then "lights[0].power" for its first element
  std::string type;
  std::optional<int> offset{};         ///< bytes from the block's beginning
  int array_size = 0;                  ///< of all dimensions; 0: no array, or one without a size at the end
  std::optional<int> array_stride{};   ///< bytes from one element to the next, over all dimensions
  std::optional<int> matrix_stride{};  ///< bytes from one column to the next, or row where `is_row_major`
  bool is_row_major = false;
};

enum class BlockKind { kUniform, kStorage, kPushConstant };

/// "uniform", "storage", "push_constant".
[[nodiscard]] std::string_view kind_name(BlockKind kind);

struct Block {
  std::string name;
  BlockKind kind = BlockKind::kUniform;
  bool is_readonly = false;       ///< a storage block that the shader only reads
  int array_size = 0;             ///< of an array of blocks, which has a binding for each; 0: no array
  std::optional<int> size{};      ///< bytes to allocate; without the array at its end that has no size
  std::optional<int> set{};       ///< for Vulkan
  std::optional<int> binding{};   ///< of push constants in HLSL and MSL only
  std::vector<Member> members{};  ///< in the order of the source
};

/// A constant that is given a value when a SPIR-V module is loaded.
struct SpecializationConstant {
  std::string name;
  std::string type;
  int id = 0;
};

/// A function `gnomon_host_...` that main() reaches.
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
  std::vector<Variable> inputs{};                   ///< by location, then name; built-in ones too
  std::vector<Variable> outputs{};                  ///< by location, then name
  std::vector<Variable> uniforms{};                 ///< by name; active ones outside of blocks
  std::vector<Variable> textures{};                 ///< samplers and images, by name; active ones
  std::vector<Block> blocks{};                      ///< by name; active ones
  std::vector<SpecializationConstant> constants{};  ///< by id
  std::vector<HostFunction> host_functions{};       ///< by name
  std::vector<OptionValue> options{};               ///< by name
  std::vector<int> local_size{};                    ///< x, y, z of a compute shader
  std::optional<std::size_t> spirv_size{};          ///< bytes; absent for GLSL and ESSL
};

/// As JSON, with the keys of docs/reflection.schema.json, indented, with a line feed at its end.
[[nodiscard]] std::string to_json(const Reflection& reflection);

}  // namespace gnomon::compiler
