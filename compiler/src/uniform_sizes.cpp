// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <glslang/Include/intermediate.h>

#include "inspect.h"

namespace gnomon::compiler {
namespace {

// glslang lists every member of every element by its name.
constexpr double kMostMembers = 65536;

double count_members(const glslang::TType& type) {
  if (!type.isStruct()) return 1;
  double sum = 0;
  for (const glslang::TTypeLoc& member : *type.getStruct()) sum += count_members(*member.type);
  if (type.isSizedArray()) {
    for (int i = 0; i < type.getArraySizes()->getNumDims(); ++i) sum *= type.getArraySizes()->getDimSize(i);
  }
  return sum;
}

class UniformFinder : public glslang::TIntermTraverser {
 public:
  void visitSymbol(glslang::TIntermSymbol* node) override {
    const bool is_interface = node->getQualifier().isUniformOrBuffer();
    if (oversized || !is_interface || count_members(node->getType()) <= kMostMembers) return;
    oversized =
        Message{node->getLoc().line,
                fmt::format("'{}' has more than {:.0f} members, those of each array element counted: use "
                            "smaller arrays, or arrays in a structure instead of an array of structures",
                            node->getAccessName().c_str(), kMostMembers)};
  }

  std::optional<Message> oversized;
};

}  // namespace

std::optional<Message> find_oversized_uniform(TIntermNode& root) {
  UniformFinder finder;
  root.traverse(&finder);
  return finder.oversized;
}

}  // namespace gnomon::compiler
