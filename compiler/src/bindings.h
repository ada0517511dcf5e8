// SPDX-License-Identifier: MIT
// Which numbers the resources of a shader take, and which they cannot.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gnomon/compiler/compiler.h"
#include "resource.h"

namespace gnomon::compiler {

/// Whether the target has Vulkan's descriptor sets.
[[nodiscard]] bool has_descriptor_sets(const Target& target);

/// The rows of numbers that a resource takes one in, each as it is called before a number: "register t" and
/// "register s" of HLSL for a texture with its sampler.
[[nodiscard]] std::vector<std::string> rows_of(const Resource& resource, const Target& target);

/// Numbers that a resource takes in each of its rows: an array is one descriptor of Vulkan, and a number for
/// each element elsewhere.
[[nodiscard]] int numbers_of(const Resource& resource, const Target& target);

/// Numbers that are taken in rows.
class Numbers {
 public:
  void take(const std::string& row, int first, int count);
  /// The lowest number, `from` or above, with which `count` of them are free in every row.
  [[nodiscard]] int lowest_free(const std::vector<std::string>& rows, int count, int from) const;

 private:
  struct Range {
    int first;
    int end;
  };
  std::map<std::string, std::vector<Range>> taken_;
};

/// A resource whose number cannot stay.
struct WrongBinding {
  std::string name;
  std::string message;  ///< what is wrong with the number, and what to do
};

/// The first two resources for which a target has one place only.
[[nodiscard]] std::optional<WrongBinding> find_shared_binding(const std::vector<Resource>& resources,
                                                              const Target& target);

/// The first resource with a number that HLSL for shader model 5.0 or Metal does not have, or that a fragment
/// shader's outputs take. `outputs`: fragment outputs, SV_Target0 ... .
[[nodiscard]] std::optional<WrongBinding> find_binding_beyond(const std::vector<Resource>& resources,
                                                              int outputs, const Target& target);

}  // namespace gnomon::compiler
