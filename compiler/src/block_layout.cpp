// SPDX-License-Identifier: MIT
#include "block_layout.h"

#include <glslang/MachineIndependent/localintermediate.h>

#include "inspect.h"

namespace gnomon::compiler {
namespace {

using glslang::TType;

class Layout {
 public:
  Layout(glslang::TLayoutPacking packing, bool with_bytes, std::vector<Member>& members)
      : packing_(packing), with_bytes_(with_bytes), members_(members) {}

  // Whether what was read last ends with an array that has no size.
  [[nodiscard]] bool is_open() const { return open_; }

  // Bytes of the structure.
  int read(const glslang::TTypeList& list, const std::string& prefix, int base, bool row_major) {
    int end = 0;
    for (const glslang::TTypeLoc& entry : list) {
      const TType& type = *entry.type;
      const glslang::TQualifier& qualifier = type.getQualifier();
      const bool rows = qualifier.layoutMatrix == glslang::ElmNone
                            ? row_major
                            : qualifier.layoutMatrix == glslang::ElmRowMajor;
      int size = 0;
      int stride = 0;
      const int alignment = glslang::TIntermediate::getMemberAlignment(type, size, stride, packing_, rows);
      const int offset =
          qualifier.hasOffset() ? qualifier.layoutOffset : (end + alignment - 1) / alignment * alignment;
      add(type, prefix + type.getFieldName().c_str(), base + offset, rows);
      end = offset + (type.isUnsizedArray() ? 0 : size);
      open_ = type.isUnsizedArray();
    }
    return end;
  }

 private:
  void add(const TType& type, const std::string& name, int offset, bool rows) {
    Member member{.name = name, .type = element_name(type), .array_size = array_size_of(type)};
    if (with_bytes_) {
      member.offset = offset;
      if (type.isArray()) member.array_stride = innermost_stride(type, rows);
      if (type.isMatrix()) member.matrix_stride = matrix_stride(type, rows);
    }
    member.is_row_major = rows && type.isMatrix();
    members_.push_back(std::move(member));
    if (!type.isStruct()) return;
    std::string first = name;
    for (int i = 0; type.isArray() && i < type.getArraySizes()->getNumDims(); ++i) first += "[0]";
    read(*type.getStruct(), first + ".", offset, rows);
  }

  // Elements of all dimensions follow each other at the same distance.
  [[nodiscard]] int innermost_stride(const TType& type, bool rows) const {
    TType inner;
    inner.shallowCopy(type);
    glslang::TArraySizes sizes;
    sizes.addInnerSize(1);
    inner.clearArraySizes();
    inner.transferArraySizes(&sizes);
    int size = 0;
    int stride = 0;
    glslang::TIntermediate::getMemberAlignment(inner, size, stride, packing_, rows);
    return stride;
  }

  [[nodiscard]] int matrix_stride(const TType& type, bool rows) const {
    TType matrix;
    matrix.shallowCopy(type);
    matrix.clearArraySizes();
    int size = 0;
    int stride = 0;
    glslang::TIntermediate::getMemberAlignment(matrix, size, stride, packing_, rows);
    return stride;
  }

  glslang::TLayoutPacking packing_;
  bool with_bytes_;
  bool open_ = false;
  std::vector<Member>& members_;
};

}  // namespace

void read_members(const TType& type, bool with_bytes, Block& block) {
  const glslang::TQualifier& qualifier = type.getQualifier();
  const bool states =
      qualifier.layoutPacking == glslang::ElpStd140 || qualifier.layoutPacking == glslang::ElpStd430;
  const auto packing = states ? qualifier.layoutPacking : glslang::ElpStd140;
  Layout layout(packing, with_bytes, block.members);
  const int size = layout.read(*type.getStruct(), "", 0, qualifier.layoutMatrix == glslang::ElmRowMajor);
  // A uniform block ends on a multiple of a vec4's size, as structures do in std140.
  const int unit = packing == glslang::ElpStd140 && !layout.is_open() ? 16 : 1;
  if (with_bytes) block.size = (size + unit - 1) / unit * unit;
}

}  // namespace gnomon::compiler
