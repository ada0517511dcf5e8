// SPDX-License-Identifier: MIT
#include "lacks.h"

#include <fmt/format.h>
#include <glslang/MachineIndependent/LiveTraverser.h>

#include <array>
#include <string_view>

#include "live_code.h"

namespace gnomon::compiler {
namespace {

using glslang::TIntermSymbol;
using glslang::TIntermTyped;
using glslang::TType;

// What to write instead; empty where there is nothing like it.
struct BuiltIn {
  Format format;
  glslang::TBuiltInVariable variable;
  std::string_view instead;
};

constexpr auto kBuiltIns = std::to_array<BuiltIn>({
    {Format::kHlsl, glslang::EbvPointSize, "draw a quad for each point"},
    {Format::kHlsl, glslang::EbvPointCoord, "draw a quad for each point and pass its corner"},
    {Format::kHlsl, glslang::EbvNumWorkGroups, "pass it as a uniform"},
    {Format::kHlsl, glslang::EbvHelperInvocation, ""},
    {Format::kHlsl, glslang::EbvSamplePosition, "pass the positions as a uniform array"},
    {Format::kHlsl, glslang::EbvViewportIndex, "pass it from the stage before"},
    {Format::kMsl, glslang::EbvPrimitiveId, "pass it from the stage before"},
    {Format::kMsl, glslang::EbvCullDistance, "use gl_ClipDistance"},
});

struct Operation {
  Format format;
  glslang::TOperator code;
  std::string_view name;
  std::string_view instead;
};

constexpr std::string_view kFourGathers = "write four textureGatherOffset";
constexpr std::string_view kHalves = "compute with halves of 16 bits";

constexpr auto kOperations = std::to_array<Operation>({
    {Format::kHlsl, glslang::EOpAddCarry, "uaddCarry", "the carry is a + b < a"},
    {Format::kHlsl, glslang::EOpSubBorrow, "usubBorrow", "the borrow is a < b"},
    {Format::kHlsl, glslang::EOpUMulExtended, "umulExtended", kHalves},
    {Format::kHlsl, glslang::EOpIMulExtended, "imulExtended", kHalves},
    {Format::kHlsl, glslang::EOpTextureGatherOffsets, "textureGatherOffsets", kFourGathers},
    {Format::kHlsl, glslang::EOpPackDouble2x32, "packDouble2x32", ""},
    {Format::kHlsl, glslang::EOpUnpackDouble2x32, "unpackDouble2x32", ""},
    {Format::kHlsl, glslang::EOpAsinh, "asinh", "write log(x + sqrt(x * x + 1.0))"},
    {Format::kHlsl, glslang::EOpAcosh, "acosh", "write log(x + sqrt(x * x - 1.0))"},
    {Format::kHlsl, glslang::EOpAtanh, "atanh", "write 0.5 * log((1.0 + x) / (1.0 - x))"},
    {Format::kMsl, glslang::EOpTextureGatherOffsets, "textureGatherOffsets", kFourGathers},
    {Format::kMsl, glslang::EOpTextureQueryLod, "textureQueryLod", "compute the level from derivatives"},
    {Format::kMsl, glslang::EOpInterpolateAtCentroid, "interpolateAtCentroid",
     "declare the input `centroid`"},
    {Format::kMsl, glslang::EOpInterpolateAtSample, "interpolateAtSample", "declare the input `sample`"},
    {Format::kMsl, glslang::EOpInterpolateAtOffset, "interpolateAtOffset",
     "add derivatives times the offset"},
    {Format::kMsl, glslang::EOpImageAtomicAdd, "imageAtomicAdd", "use a storage buffer"},
    {Format::kMsl, glslang::EOpImageAtomicMin, "imageAtomicMin", "use a storage buffer"},
    {Format::kMsl, glslang::EOpImageAtomicMax, "imageAtomicMax", "use a storage buffer"},
    {Format::kMsl, glslang::EOpImageAtomicAnd, "imageAtomicAnd", "use a storage buffer"},
    {Format::kMsl, glslang::EOpImageAtomicOr, "imageAtomicOr", "use a storage buffer"},
    {Format::kMsl, glslang::EOpImageAtomicXor, "imageAtomicXor", "use a storage buffer"},
    {Format::kMsl, glslang::EOpImageAtomicExchange, "imageAtomicExchange", "use a storage buffer"},
    {Format::kMsl, glslang::EOpImageAtomicCompSwap, "imageAtomicCompSwap", "use a storage buffer"},
});

bool is_block(const TType& type) {
  return type.getBasicType() == glslang::EbtBlock;
}

bool has_double(const TType& type) {
  return type.contains([](const TType* part) { return part->getBasicType() == glslang::EbtDouble; });
}

bool has_bool(const TType& type) {
  return type.contains([](const TType* part) { return part->getBasicType() == glslang::EbtBool; });
}

const TIntermSymbol* root_of(const TIntermTyped* node) {
  while (node->getAsBinaryNode() != nullptr) node = node->getAsBinaryNode()->getLeft();
  return node->getAsSymbolNode();
}

// The formats that shader model 5.0 loads from what it may write.
bool is_loaded_by_hlsl(glslang::TLayoutFormat format) {
  return format == glslang::ElfNone || format == glslang::ElfR32f || format == glslang::ElfR32i ||
         format == glslang::ElfR32ui;
}

// Whether an expression reads what is not known before the shader runs.
class InterfaceUse : public glslang::TIntermTraverser {
 public:
  explicit InterfaceUse(TIntermTyped& expression) { expression.traverse(this); }
  void visitSymbol(TIntermSymbol* node) override {
    found = found || node->getQualifier().isUniformOrBuffer() || node->getQualifier().isPipeInput();
  }
  bool found = false;
};

class LackFinder : public LiveCode<glslang::TLiveTraverser, glslang::TIntermediate> {
 public:
  LackFinder(const glslang::TIntermediate& code, const Target& target, DeclarationLines& lines)
      : LiveCode(code), target_(target), lines_(lines) {
    traverse_live();
  }

  void visitSymbol(TIntermSymbol* node) override {
    const TType& type = node->getType();
    const std::string name = node->getName().c_str();
    const int line = node->getLoc().line;
    check_builtin(type.getQualifier().builtIn, name, line);
    check_double(type, line);
    const bool passes = type.getQualifier().isPipeInput() || type.getQualifier().isPipeOutput();
    if (passes) check_passing(type, name);
    if (type.getQualifier().isUniformOrBuffer())
      check_uniform(type, is_block(type) ? type.getTypeName().c_str() : name);
  }

  bool visitBinary(glslang::TVisit, glslang::TIntermBinary* node) override {
    const TType& owner = node->getLeft()->getType();
    const auto* index = node->getRight()->getAsConstantUnion();
    const int line = node->getLoc().line;
    if (node->getOp() == glslang::EOpIndexDirectStruct && owner.isStruct() && index != nullptr) {
      const auto member = static_cast<size_t>(index->getConstArray()[0].getIConst());
      const TType& type = *(*owner.getStruct())[member].type;
      check_builtin(type.getQualifier().builtIn, type.getFieldName().c_str(), line);
    }
    // A counter of a loop is left to the HLSL compiler, which unrolls it.
    if (node->getOp() == glslang::EOpIndexIndirect && owner.isOpaque() && target_.format == Format::kHlsl &&
        InterfaceUse(*node->getRight()).found) {
      const TIntermSymbol* root = root_of(node);
      lack(line, root == nullptr ? "[]" : root->getName().c_str(),
           fmt::format("{} takes no index that the host gives into an array of textures", language()),
           "choose by if or switch");
    }
    check_double(node->getType(), line);
    return true;
  }

  bool visitUnary(glslang::TVisit, glslang::TIntermUnary* node) override {
    const int line = node->getLoc().line;
    if (node->getOp() == glslang::EOpArrayLength && target_.format == Format::kMsl)
      lack(line, "length()", "MSL does not tell how long a storage buffer is",
           "pass its length as a uniform");
    check_operation(node->getOp(), line);
    check_double(node->getType(), line);
    return true;
  }

  bool visitAggregate(glslang::TVisit visit, glslang::TIntermAggregate* node) override {
    const int line = node->getLoc().line;
    check_operation(node->getOp(), line);
    if (node->getOp() == glslang::EOpImageLoad) check_load(*node, line);
    check_comparison(*node, line);
    if (target_.format == Format::kHlsl && is_shadow_gather(*node))
      lack(line, "textureGather", "not translated to HLSL for samplers that compare",
           "compare by four texelFetch");
    return LiveCode::visitAggregate(visit, node);
  }

  std::optional<Message> first;

 private:
  [[nodiscard]] std::string_view language() const {
    switch (target_.format) {
      case Format::kHlsl:
        return "HLSL for shader model 5.0";
      case Format::kMsl:
        return "MSL 2.1";
      default:
        return target_.rules == Rules::kVulkan ? "Vulkan's SPIR-V" : "OpenGL's SPIR-V";
    }
  }

  void lack(int line, std::string_view name, std::string_view what, std::string_view instead) {
    if (first && first->line <= line) return;
    first = Message{line, fmt::format("'{}': {}{}{}", name, what, instead.empty() ? "" : ": ", instead)};
  }

  void lack_none(int line, std::string_view name, std::string_view instead) {
    lack(line, name, fmt::format("{} has none", language()), instead);
  }

  void check_builtin(glslang::TBuiltInVariable variable, const std::string& name, int line) {
    for (const BuiltIn& row : kBuiltIns) {
      if (row.format == target_.format && row.variable == variable) lack_none(line, name, row.instead);
    }
  }

  void check_operation(glslang::TOperator code, int line) {
    for (const Operation& row : kOperations) {
      if (row.format == target_.format && row.code == code) lack_none(line, row.name, row.instead);
    }
  }

  void check_double(const TType& type, int line) {
    if (target_.format != Format::kMsl || line == 0 || !has_double(type)) return;
    lack_none(line, "double", "use float");
  }

  static bool is_shadow_gather(const glslang::TIntermAggregate& node) {
    if (node.getOp() != glslang::EOpTextureGather && node.getOp() != glslang::EOpTextureGatherOffset)
      return false;
    const TType& type = node.getSequence().front()->getAsTyped()->getType();
    return type.getBasicType() == glslang::EbtSampler && type.getSampler().isShadow();
  }

  // Comparing with a bias or with gradients is of MSL 2.3.
  void check_comparison(const glslang::TIntermAggregate& node, int line) {
    const auto* first_argument =
        node.getSequence().empty() ? nullptr : node.getSequence().front()->getAsTyped();
    if (target_.format != Format::kMsl || first_argument == nullptr) return;
    const TType& type = first_argument->getType();
    if (type.getBasicType() != glslang::EbtSampler || !type.getSampler().isShadow()) return;
    // What a cube array compares with is an argument of its own.
    const bool is_cube_array = type.getSampler().dim == glslang::EsdCube && type.getSampler().isArrayed();
    if (node.getOp() == glslang::EOpTexture && node.getSequence().size() == 3 && !is_cube_array)
      lack(line, "texture", fmt::format("{} compares without a bias", language()), "give no third argument");
    if (node.getOp() == glslang::EOpTextureGrad || node.getOp() == glslang::EOpTextureGradOffset)
      lack(line, "textureGrad", fmt::format("{} compares without gradients", language()), "write textureLod");
  }

  void check_load(const glslang::TIntermAggregate& node, int line) {
    const TIntermSymbol* image = root_of(node.getSequence().front()->getAsTyped());
    if (target_.format != Format::kHlsl || image == nullptr) return;
    const glslang::TQualifier& qualifier = image->getType().getQualifier();
    if (qualifier.isReadOnly() || is_loaded_by_hlsl(qualifier.getFormat())) return;
    lack(line, image->getName().c_str(),
         fmt::format("{} loads from an image that it may write only where its format is r32f, r32i or r32ui",
                     language()),
         "declare it readonly, or change its format");
  }

  void check_passing(const TType& type, const std::string& name) {
    if (type.isArrayOfArrays() && target_.format == Format::kMsl)
      lack(lines_.of(name), name, fmt::format("{} passes no arrays of arrays between stages", language()),
           "give the array one dimension");
    const bool is_translated = target_.format == Format::kHlsl || target_.format == Format::kMsl;
    if (type.isArray() && type.isMatrix() && is_translated)
      lack(lines_.of(name), name, fmt::format("{} passes no arrays of matrices between stages", language()),
           "pass their columns");
  }

  void check_uniform(const TType& type, const std::string& name) {
    const auto object = [&](std::string_view what, std::string_view instead) {
      lack(lines_.of(name), name, what, instead);
    };
    if (target_.rules == Rules::kOpenGlSpirv && !is_block(type) && has_bool(type))
      object("a uniform of type bool has no form in OpenGL's SPIR-V", "make it an int or uint");
    if (target_.rules != Rules::kVulkan) return;
    const std::string none(language());
    const bool is_texture = type.isOpaque();
    if (is_texture && type.isArrayOfArrays())
      object(none + " has no arrays of arrays of textures", "give the array one dimension");
    if (is_block(type) && type.isArray() && target_.format == Format::kHlsl)
      object(none + " has no arrays of blocks", "make it an array in one block");
    if (is_block(type)) check_members(type);
    if (type.getBasicType() == glslang::EbtSampler) check_sampler(type.getSampler(), object);
  }

  // Uniforms outside of blocks have become members of one.
  void check_members(const TType& block) {
    for (const glslang::TTypeLoc& member : *block.getStruct()) {
      const std::string name = member.type->getFieldName().c_str();
      if (member.type->containsOpaque())
        lack(lines_.of(name), name, fmt::format("{} has no textures in structures", language()),
             "declare them outside");
    }
  }

  template <class Object>
  void check_sampler(const glslang::TSampler& sampler, const Object& object) {
    const std::string name = sampler.getString().c_str();
    const bool is_hlsl = target_.format == Format::kHlsl;
    const std::string none = fmt::format("{} has no {}", language(), name);
    if (sampler.dim == glslang::EsdRect) object(none, "use a sampler2D and divide by textureSize");
    if (is_hlsl && sampler.isImage() && sampler.dim == glslang::EsdCube)
      object(none, "use an image2DArray of six layers");
    if (is_hlsl && sampler.isImage() && sampler.isMultiSample()) object(none, "use a sampler2DMS");
    if (target_.format == Format::kMsl && sampler.isShadow() && sampler.dim == glslang::Esd1D)
      object(none, "use a sampler2DShadow of one row");
  }

  const Target& target_;
  DeclarationLines& lines_;
};

}  // namespace

std::optional<Message> find_lack(const glslang::TIntermediate& code, const Target& target,
                                 DeclarationLines& lines) {
  if (target.rules == Rules::kOpenGl) return std::nullopt;
  return LackFinder(code, target, lines).first;
}

}  // namespace gnomon::compiler
