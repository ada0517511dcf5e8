// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <glslang/Include/intermediate.h>

#include <algorithm>

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

// Sizes, offsets and strides are ints, here and in glslang.
constexpr double kMostBytes = 2147483647;

// At most, by the rules of std140 or std430.
double count_bytes(const glslang::TType& type, bool is_std430) {
  double bytes = 0;
  const double scalar = type.getBasicType() == glslang::EbtDouble ? 8 : 4;
  const int dimensions = type.isSizedArray() ? type.getArraySizes()->getNumDims() : 0;
  if (type.isStruct()) {
    for (const glslang::TTypeLoc& member : *type.getStruct())
      bytes += count_bytes(*member.type, is_std430) + 4 * scalar;  // and a gap
  } else if (type.isMatrix()) {
    bytes = 4 * scalar * std::max(type.getMatrixCols(), type.getMatrixRows());
  } else {
    const bool is_padded = type.isArray() && !is_std430;
    bytes = scalar * (is_padded || type.getVectorSize() == 3 ? 4 : type.getVectorSize());
  }
  for (int i = 0; i < dimensions; ++i) bytes *= type.getArraySizes()->getDimSize(i);
  return bytes;
}

class UniformFinder : public glslang::TIntermTraverser {
 public:
  explicit UniformFinder(DeclarationLines& lines) : lines_(lines) {}

  void visitSymbol(glslang::TIntermSymbol* node) override {
    if (oversized || !node->getQualifier().isUniformOrBuffer()) return;
    const bool is_std430 = node->getQualifier().layoutPacking == glslang::ElpStd430;
    if (count_members(node->getType()) > kMostMembers) {
      oversized =
          Message{line_of(*node),
                  fmt::format("'{}' has more than {:.0f} members, those of each array element counted: use "
                              "smaller arrays, or arrays in a structure instead of an array of structures",
                              node->getAccessName().c_str(), kMostMembers)};
    } else if (count_bytes(node->getType(), is_std430) > kMostBytes) {
      oversized = Message{line_of(*node), fmt::format("'{}' takes more than {:.0f} bytes: use smaller arrays",
                                                      node->getAccessName().c_str(), kMostBytes)};
    }
  }

  std::optional<Message> oversized;

 private:
  int line_of(const glslang::TIntermSymbol& symbol) {
    const bool is_block = symbol.getBasicType() == glslang::EbtBlock;
    return lines_.of(is_block ? symbol.getType().getTypeName().c_str() : symbol.getName().c_str());
  }

  DeclarationLines& lines_;
};

}  // namespace

std::optional<Message> find_oversized_uniform(TIntermNode& root, DeclarationLines& lines) {
  UniformFinder finder(lines);
  root.traverse(&finder);
  return finder.oversized;
}

}  // namespace gnomon::compiler
