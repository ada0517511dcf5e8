// SPDX-License-Identifier: MIT
#include "bindings.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace gnomon::compiler {
namespace {

// A resource and the numbers that it takes.
struct Place {
  std::string name;
  std::string kind;   // what it is
  std::string space;  // whose numbers it takes: those of all resources of the same space are one row
  int first;
  int count;
};

std::string kind_of(const Variable& texture) {
  if (texture.input_attachment_index) return "input attachment";
  if (texture.type == "sampler" || texture.type == "samplerShadow") return "sampler";
  return texture.type.find("image") == std::string::npos ? "texture" : "image";
}

std::string kind_of(const Block& block) {
  return block.kind == BlockKind::kStorage ? "storage block" : "uniform block";
}

// What the number stands behind. Vulkan has one row a set; HLSL has registers t (read), u (written), b
// (uniform) and s (samplers); Metal has one row of buffers; OpenGL has one for each kind.
std::string space_of(const std::string& kind, bool is_written, std::optional<int> set, const Target& target) {
  if (has_descriptor_sets(target)) return fmt::format("set {}, binding ", set.value_or(0));
  if (target.format == Format::kHlsl) {
    if (kind == "uniform block") return "register b";
    if (kind == "sampler") return "register s";
    return is_written ? "register u" : "register t";
  }
  if (target.format == Format::kMsl && kind.ends_with("block")) return "buffer ";
  if (target.format == Format::kMsl && kind == "image") return "texture ";
  return kind + " ";
}

std::vector<Place> places_of(const Reflection& reflection, const Target& target) {
  std::vector<Place> places;
  const auto add = [&](const auto& resource, const std::string& kind, bool is_written) {
    if (!resource.binding) return;
    // An array is one descriptor of Vulkan, and a place for each element elsewhere.
    const int count = has_descriptor_sets(target) ? 1 : std::max(resource.array_size, 1);
    places.push_back(
        {resource.name, kind, space_of(kind, is_written, resource.set, target), *resource.binding, count});
  };
  for (const Variable& texture : reflection.textures)
    add(texture, kind_of(texture), kind_of(texture) == "image");
  for (const Block& block : reflection.blocks)
    add(block, kind_of(block), block.kind == BlockKind::kStorage && !block.is_readonly);
  return places;
}

bool clash(const Place& a, const Place& b, const Target& target) {
  const bool apart = a.first + a.count <= b.first || b.first + b.count <= a.first;
  if (a.space != b.space || apart) return false;
  // Two descriptors of one kind may share a binding of Vulkan: that is how aliases are made.
  return !has_descriptor_sets(target) || a.kind != b.kind;
}

}  // namespace

bool has_descriptor_sets(const Target& target) {
  return target.rules == Rules::kVulkan && target.format == Format::kSpirv;
}

std::optional<SharedBinding> find_shared_binding(const Reflection& reflection, const Target& target) {
  const std::vector<Place> places = places_of(reflection, target);
  for (auto second = places.begin(); second != places.end(); ++second) {
    for (auto first = places.begin(); first != second; ++first) {
      if (!clash(*first, *second, target)) continue;
      return SharedBinding{
          second->name,
          fmt::format("'{}', a {}: its place for the target {}, {}{}, is also that of '{}', a {}: "
                      "give it another binding",
                      second->name, second->kind, target.name, second->space, second->first, first->name,
                      first->kind)};
    }
  }
  return std::nullopt;
}

}  // namespace gnomon::compiler
