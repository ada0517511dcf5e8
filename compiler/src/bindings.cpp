// SPDX-License-Identifier: MIT
#include "bindings.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace gnomon::compiler {
namespace {

// A resource and the places it takes among those of its kind.
struct Place {
  std::string name;
  std::string kind;
  int first;
  int count;
};

// Metal numbers all buffers together; HLSL and OpenGL number uniform and storage blocks apart.
std::string kind_of(const Block& block, const Target& target) {
  if (target.format == Format::kMsl) return "buffer";
  return block.kind == BlockKind::kStorage ? "storage block" : "uniform block";
}

std::string kind_of(const Variable& texture) {
  return texture.type.find("image") == std::string::npos ? "texture" : "image";
}

std::vector<Place> places_of(const Reflection& reflection, const Target& target) {
  std::vector<Place> places;
  for (const Variable& texture : reflection.textures) {
    if (texture.binding)
      places.push_back({texture.name, kind_of(texture), *texture.binding, std::max(texture.array_size, 1)});
  }
  for (const Block& block : reflection.blocks) {
    if (block.binding)
      places.push_back({block.name, kind_of(block, target), *block.binding, std::max(block.array_size, 1)});
  }
  return places;
}

}  // namespace

std::optional<SharedBinding> find_shared_binding(const Reflection& reflection, const Target& target) {
  const std::vector<Place> places = places_of(reflection, target);
  for (auto second = places.begin(); second != places.end(); ++second) {
    for (auto first = places.begin(); first != second; ++first) {
      const bool apart =
          first->first + first->count <= second->first || second->first + second->count <= first->first;
      if (first->kind != second->kind || apart) continue;
      return SharedBinding{second->name,
                           fmt::format("'{}': its {} {} is also that of '{}', and the target {} has no "
                                       "descriptor sets to tell them apart: give it another binding",
                                       second->name, second->kind, second->first, first->name, target.name)};
    }
  }
  return std::nullopt;
}

}  // namespace gnomon::compiler
