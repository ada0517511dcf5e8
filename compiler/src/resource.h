// SPDX-License-Identifier: MIT
// What a shader binds, as plain data.
#pragma once

#include <optional>
#include <string>

namespace gnomon::compiler {

enum class ResourceKind {
  kTexture,
  kImage,
  kSampler,
  kInputAttachment,
  kUniformBlock,
  kStorageBlock,
  kPushConstant,
  kAtomicCounter,
};

/// A texture, sampler, image or block.
struct Resource {
  std::string name;  ///< of a block that of the block, not of its instance
  ResourceKind kind = ResourceKind::kTexture;
  bool has_sampler = false;      ///< a texture and its sampler in one: sampler2D
  bool is_written = false;       ///< an image or storage block that is not readonly
  int set = 0;                   ///< of Vulkan
  std::optional<int> binding{};  ///< of the first element
  int count = 1;                 ///< elements of all dimensions of an array
};

}  // namespace gnomon::compiler
