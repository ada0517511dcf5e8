// SPDX-License-Identifier: MIT
#include "bindings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace gnomon::compiler {
namespace {

std::string title_of(ResourceKind kind) {
  switch (kind) {
    case ResourceKind::kImage:
      return "an image";
    case ResourceKind::kSampler:
      return "a sampler";
    case ResourceKind::kInputAttachment:
      return "an input attachment";
    case ResourceKind::kUniformBlock:
      return "a uniform block";
    case ResourceKind::kStorageBlock:
      return "a storage block";
    case ResourceKind::kPushConstant:
      return "a push constant block";
    case ResourceKind::kAtomicCounter:
      return "an atomic counter";
    case ResourceKind::kTexture:
      break;
  }
  return "a texture";
}

bool is_block(ResourceKind kind) {
  return kind == ResourceKind::kUniformBlock || kind == ResourceKind::kStorageBlock ||
         kind == ResourceKind::kPushConstant;
}

// Registers t (read), u (written), b (uniform) and s (samplers).
std::vector<std::string> rows_of_hlsl(const Resource& resource) {
  if (resource.kind == ResourceKind::kUniformBlock || resource.kind == ResourceKind::kPushConstant)
    return {"register b"};
  if (resource.kind == ResourceKind::kSampler) return {"register s"};
  if (resource.is_written) return {"register u"};
  if (resource.has_sampler) return {"register t", "register s"};
  return {"register t"};
}

std::vector<std::string> rows_of_msl(const Resource& resource) {
  if (is_block(resource.kind)) return {"buffer "};
  if (resource.kind == ResourceKind::kSampler) return {"sampler "};
  if (resource.has_sampler) return {"texture ", "sampler "};
  return {"texture "};
}

// OpenGL numbers each kind by itself. Counters of one buffer have offsets.
std::vector<std::string> rows_of_opengl(ResourceKind kind) {
  switch (kind) {
    case ResourceKind::kImage:
      return {"image unit "};
    case ResourceKind::kUniformBlock:
      return {"uniform block "};
    case ResourceKind::kStorageBlock:
      return {"storage block "};
    case ResourceKind::kAtomicCounter:
    case ResourceKind::kPushConstant:
      return {};
    default:
      return {"texture unit "};
  }
}

struct Range {
  int first;
  int end;
};

std::optional<Range> range_of(const Resource& resource, const Target& target) {
  if (!resource.binding) return std::nullopt;
  return Range{*resource.binding, *resource.binding + numbers_of(resource, target)};
}

// The row in which both take the same number.
std::optional<std::string> clash(const Resource& a, const Resource& b, const Target& target) {
  const auto first = range_of(a, target);
  const auto second = range_of(b, target);
  if (!first || !second || first->end <= second->first || second->end <= first->first) return std::nullopt;
  // Two descriptors of one kind may share a binding of Vulkan: that is how aliases are made.
  if (has_descriptor_sets(target) && a.kind == b.kind) return std::nullopt;
  const std::vector<std::string> rows = rows_of(a, target);
  for (const std::string& row : rows_of(b, target)) {
    if (std::ranges::find(rows, row) != rows.end()) return row;
  }
  return std::nullopt;
}

// Numbers that a row has, from 0.
std::optional<int> length_of_row(std::string_view row, const Target& target) {
  struct Row {
    Format format;
    std::string_view name;
    int length;
  };
  // Of shader model 5.0 on Direct3D 11.0: D3D11_COMMONSHADER_..._SLOT_COUNT and
  // D3D11_PS_CS_UAV_REGISTER_COUNT; of Metal on macOS: argument tables in the Metal feature set tables.
  static constexpr std::array<Row, 7> rows = {{{Format::kHlsl, "register t", 128},
                                               {Format::kHlsl, "register s", 16},
                                               {Format::kHlsl, "register b", 14},
                                               {Format::kHlsl, "register u", 8},
                                               {Format::kMsl, "buffer ", 31},
                                               {Format::kMsl, "texture ", 128},
                                               {Format::kMsl, "sampler ", 16}}};
  for (const Row& known : rows) {
    if (known.format == target.format && known.name == row) return known.length;
  }
  return std::nullopt;
}

std::string quoted(const Resource& resource) {
  return fmt::format("'{}', {}", resource.name, title_of(resource.kind));
}

std::optional<std::string> find_beyond(const Resource& resource, int outputs, const Target& target) {
  const auto range = range_of(resource, target);
  if (!range) return std::nullopt;
  for (const std::string& row : rows_of(resource, target)) {
    const auto length = length_of_row(row, target);
    if (length && range->end > *length)
      return fmt::format(
          "{}: its place for the target {}, {}{}, is beyond the last one, {}{}: give it a "
          "lower binding, or bind less",
          quoted(resource), target.name, row, range->end - 1, row, *length - 1);
    if (row == "register u" && range->first < outputs)
      return fmt::format(
          "{}: its place for the target {}, {}{}, is also that of the output SV_Target{}: "
          "give it a binding from {} upwards",
          quoted(resource), target.name, row, range->first, range->first, outputs);
  }
  return std::nullopt;
}

}  // namespace

bool has_descriptor_sets(const Target& target) {
  return target.rules == Rules::kVulkan && target.format == Format::kSpirv;
}

std::vector<std::string> rows_of(const Resource& resource, const Target& target) {
  if (has_descriptor_sets(target)) {
    if (resource.kind == ResourceKind::kPushConstant) return {};
    return {fmt::format("set {}, binding ", resource.set)};
  }
  if (target.format == Format::kHlsl) return rows_of_hlsl(resource);
  if (target.format == Format::kMsl) return rows_of_msl(resource);
  return rows_of_opengl(resource.kind);
}

int numbers_of(const Resource& resource, const Target& target) {
  return has_descriptor_sets(target) ? 1 : std::max(resource.count, 1);
}

void Numbers::take(const std::string& row, int first, int count) {
  taken_[row].push_back({first, first + count});
}

int Numbers::lowest_free(const std::vector<std::string>& rows, int count, int from) const {
  int first = from;
  for (bool moved = true; moved;) {
    moved = false;
    for (const std::string& row : rows) {
      const auto taken = taken_.find(row);
      if (taken == taken_.end()) continue;
      for (const Range& range : taken->second) {
        if (range.end <= first || first + count <= range.first) continue;
        first = range.end;
        moved = true;
      }
    }
  }
  return first;
}

std::optional<WrongBinding> find_shared_binding(const std::vector<Resource>& resources,
                                                const Target& target) {
  for (auto second = resources.begin(); second != resources.end(); ++second) {
    for (auto first = resources.begin(); first != second; ++first) {
      const auto row = clash(*first, *second, target);
      if (!row) continue;
      const int number = std::max(first->binding.value_or(0), second->binding.value_or(0));
      return WrongBinding{
          second->name,
          fmt::format("{}: its place for the target {}, {}{}, is also that of {}: give it another binding",
                      quoted(*second), target.name, *row, number, quoted(*first))};
    }
  }
  return std::nullopt;
}

std::optional<WrongBinding> find_binding_beyond(const std::vector<Resource>& resources, int outputs,
                                                const Target& target) {
  for (const Resource& resource : resources) {
    if (auto message = find_beyond(resource, outputs, target))
      return WrongBinding{resource.name, *std::move(message)};
  }
  return std::nullopt;
}

}  // namespace gnomon::compiler
