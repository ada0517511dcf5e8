// SPDX-License-Identifier: MIT
#include <glslang/MachineIndependent/LiveTraverser.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "block_layout.h"
#include "inspect.h"
#include "live_code.h"
#include "numbering.h"

namespace gnomon::compiler {
namespace {

using glslang::TIntermSymbol;
using glslang::TQualifier;
using glslang::TType;

// What the code that main() reaches uses of the outside world, and which functions those are.
class Uses : public LiveCode<glslang::TLiveTraverser, glslang::TIntermediate> {
 public:
  explicit Uses(const glslang::TIntermediate& code) : LiveCode(code) { traverse_live(); }

  void visitSymbol(TIntermSymbol* node) override { symbols.emplace(node->getName().c_str(), node); }
  bool visitBinary(glslang::TVisit, glslang::TIntermBinary* node) override {
    const glslang::TIntermTyped* owner = node->getLeft();
    while (owner->getAsBinaryNode() != nullptr) owner = owner->getAsBinaryNode()->getLeft();
    const auto* index = node->getRight()->getAsConstantUnion();
    if (node->getOp() == glslang::EOpIndexDirectStruct && owner->getAsSymbolNode() != nullptr &&
        index != nullptr)
      members[owner->getAsSymbolNode()->getName().c_str()].insert(index->getConstArray()[0].getIConst());
    return true;
  }

  bool visitAggregate(glslang::TVisit visit, glslang::TIntermAggregate* node) override {
    if (node->getOp() == glslang::EOpFunctionCall) called.insert(node->getName().c_str());
    return LiveCode::visitAggregate(visit, node);
  }

  std::map<std::string, TIntermSymbol*> symbols;
  std::set<std::string> called;                  // signatures
  std::map<std::string, std::set<int>> members;  // that are named, of blocks and structures
};

std::optional<int> location_of(const TType& type) {
  const TQualifier& qualifier = type.getQualifier();
  if (!qualifier.hasLocation()) return std::nullopt;
  return static_cast<int>(qualifier.layoutLocation);
}

class InterfaceReader {
 public:
  InterfaceReader(const Target& target, Reflection& into) : target_(target), into_(into) {}

  void read(const Uses& uses) {
    for (const auto& [name, symbol] : uses.symbols) {
      const TType& type = symbol->getType();
      const TQualifier& qualifier = type.getQualifier();
      if (qualifier.isPipeInput() || qualifier.isPipeOutput()) {
        read_pipe(name, type, uses, qualifier.isPipeInput() ? into_.inputs : into_.outputs);
      } else if (qualifier.isUniformOrBuffer()) {
        read_uniform(name, type);
      } else if (qualifier.hasSpecConstantId()) {
        into_.constants.push_back(
            {name, element_name(type), static_cast<int>(qualifier.layoutSpecConstantId)});
      }
    }
  }

 private:
  static void read_pipe(const std::string& name, const TType& type, const Uses& uses,
                        std::vector<Variable>& list) {
    const bool is_block = type.getBasicType() == glslang::EbtBlock;
    const bool is_builtin = is_block && type.getTypeName().compare(0, 3, "gl_") == 0;
    if (!is_builtin) {
      const bool is_anonymous = name.starts_with("anon@");
      list.push_back(variable(is_anonymous ? type.getTypeName().c_str() : name, type));
      list.back().location = location_of(type);
      return;
    }
    const auto used = uses.members.find(name);
    if (used == uses.members.end()) return;
    for (const int member : used->second) {
      const TType& field = *(*type.getStruct())[static_cast<size_t>(member)].type;
      list.push_back(variable(field.getFieldName().c_str(), field));
    }
  }

  void read_uniform(const std::string& name, const TType& type) {
    if (type.getBasicType() == glslang::EbtBlock) {
      into_.blocks.push_back(block(type));
    } else {
      std::optional<int> location = location_of(type);
      flatten(name, type, type.getQualifier(), location);
    }
  }

  // A structure's members each, since the host sets them each.
  void flatten(const std::string& name, const TType& type, const TQualifier& qualifier,
               std::optional<int>& location) {
    if (!type.isStruct()) return add_uniform(variable(name, type), type, qualifier, location);
    if (type.isArray()) {
      const TType element(type, 0);
      for (int i = 0; i < type.getOuterArraySize(); ++i)
        flatten(name + "[" + std::to_string(i) + "]", element, qualifier, location);
      return;
    }
    for (const glslang::TTypeLoc& member : *type.getStruct())
      flatten(name + "." + member.type->getFieldName().c_str(), *member.type, qualifier, location);
  }

  void add_uniform(Variable uniform, const TType& type, const TQualifier& qualifier,
                   std::optional<int>& location) {
    uniform.location = location;
    if (location) *location += static_cast<int>(uniform_locations(type));
    if (!type.isOpaque()) return into_.uniforms.push_back(std::move(uniform));
    uniform.set = set_of(qualifier);
    uniform.binding = binding_of(qualifier);
    if (qualifier.hasAttachment())
      uniform.input_attachment_index = static_cast<int>(qualifier.layoutAttachment);
    into_.textures.push_back(std::move(uniform));
  }

  [[nodiscard]] Block block(const TType& type) const {
    const TQualifier& qualifier = type.getQualifier();
    Block block{.name = type.getTypeName().c_str(), .array_size = array_size_of(type)};
    if (qualifier.storage == glslang::EvqBuffer) block.kind = BlockKind::kStorage;
    block.is_readonly = block.kind == BlockKind::kStorage && qualifier.isReadOnly();
    block.binding = binding_of(qualifier);
    if (qualifier.isPushConstant()) {
      block.kind = BlockKind::kPushConstant;
    } else {
      block.set = set_of(qualifier);
    }
    const bool is_fixed = target_.rules != Rules::kOpenGl || qualifier.layoutPacking == glslang::ElpStd140 ||
                          qualifier.layoutPacking == glslang::ElpStd430;
    read_members(type, is_fixed, block);
    return block;
  }

  static Variable variable(const std::string& name, const TType& type) {
    return {.name = name, .type = element_name(type), .array_size = array_size_of(type)};
  }

  [[nodiscard]] std::optional<int> set_of(const TQualifier& qualifier) const {
    if (target_.rules != Rules::kVulkan) return std::nullopt;
    return qualifier.hasSet() ? static_cast<int>(qualifier.layoutSet) : 0;
  }

  static std::optional<int> binding_of(const TQualifier& qualifier) {
    if (!qualifier.hasBinding()) return std::nullopt;
    return static_cast<int>(qualifier.layoutBinding);
  }

  const Target& target_;
  Reflection& into_;
};

void sort_by_location(std::vector<Variable>& variables) {
  std::ranges::sort(variables, [](const Variable& a, const Variable& b) {
    // Those without a location come last.
    return std::tuple(!a.location.has_value(), a.location, a.name) <
           std::tuple(!b.location.has_value(), b.location, b.name);
  });
}

}  // namespace

std::vector<std::string> find_unnumbered(const glslang::TIntermediate& code, Stage stage) {
  std::vector<std::string> names;
  for (const auto& [name, symbol] : Uses(code).symbols) {
    const TType& type = symbol->getType();
    const TQualifier& qualifier = type.getQualifier();
    const bool passes = (qualifier.isPipeInput() && stage != Stage::kVertex) ||
                        (qualifier.isPipeOutput() && stage != Stage::kFragment);
    const bool is_block = type.getBasicType() == glslang::EbtBlock;
    const bool is_builtin = qualifier.builtIn != glslang::EbvNone || name.starts_with("gl_") ||
                            (is_block && type.getTypeName().compare(0, 3, "gl_") == 0);
    const auto has_location = [](const glslang::TTypeLoc& m) { return m.type->getQualifier().hasLocation(); };
    const bool has_own = is_block && std::ranges::any_of(*type.getStruct(), has_location);
    if (!passes || is_builtin || qualifier.hasLocation() || has_own) continue;
    names.push_back(is_block ? type.getTypeName().c_str() : name);
  }
  return names;
}

std::string element_name(const TType& type) {
  TType element;
  element.shallowCopy(type);
  element.clearArraySizes();
  return read_type(element).name;
}

int array_size_of(const TType& type) {
  if (!type.isSizedArray()) return 0;
  int size = 1;
  for (int i = 0; i < type.getArraySizes()->getNumDims(); ++i) size *= type.getArraySizes()->getDimSize(i);
  return size;
}

void read_interface(const glslang::TIntermediate& code, Stage stage, const Target& target, Shader& shader) {
  const Uses uses(code);
  shader.reached.assign(uses.called.begin(), uses.called.end());
  Reflection& reflection = shader.interface;
  reflection = {.target = target.name, .stage = stage};
  InterfaceReader(target, reflection).read(uses);
  sort_by_location(reflection.inputs);
  sort_by_location(reflection.outputs);
  std::ranges::sort(reflection.uniforms, {}, &Variable::name);
  std::ranges::sort(reflection.textures, {}, &Variable::name);
  std::ranges::sort(reflection.blocks, {}, &Block::name);
  std::ranges::sort(reflection.constants, {}, &SpecializationConstant::id);
  for (int dimension = 0; stage == Stage::kCompute && dimension < 3; ++dimension)
    reflection.local_size.push_back(static_cast<int>(code.getLocalSize(dimension)));
}

}  // namespace gnomon::compiler
