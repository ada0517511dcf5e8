// SPDX-License-Identifier: MIT
#include "numbering.h"

#include <fmt/format.h>
#include <glslang/MachineIndependent/LiveTraverser.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>

#include "inspect.h"
#include "live_code.h"

namespace gnomon::compiler {
namespace {

using glslang::TIntermSymbol;
using glslang::TQualifier;
using glslang::TType;

// Beyond every limit, and far from overflowing.
constexpr int kVeryMany = 1 << 24;

int clamped(double count) {
  return static_cast<int>(std::min(count, static_cast<double>(kVeryMany)));
}

// Elements of all dimensions; of one that the text gives no size as many as it indexes.
double elements_of(const TType& type) {
  if (!type.isArray()) return 1;
  double count = type.isUnsizedArray() ? std::max(type.getImplicitArraySize(), 1) : 1;
  const glslang::TArraySizes& sizes = *type.getArraySizes();
  for (int i = type.isUnsizedArray() ? 1 : 0; i < sizes.getNumDims(); ++i)
    count *= std::max(sizes.getDimSize(i), 1);
  return count;
}

bool is_long_vector(const TType& type) {
  return type.getBasicType() == glslang::EbtDouble && (type.getVectorSize() > 2 || type.getMatrixRows() > 2);
}

// Of a vertex input or fragment output. Vectors of three and four doubles take two, as Vulkan has it; OpenGL
// lets them take one.
double locations_between_stages(const TType& type) {
  double count = 0;
  if (type.isStruct()) {
    for (const glslang::TTypeLoc& member : *type.getStruct()) count += locations_between_stages(*member.type);
  } else {
    count = (type.isMatrix() ? type.getMatrixCols() : 1) * (is_long_vector(type) ? 2 : 1);
  }
  return count * elements_of(type);
}

bool is_block(const TType& type) {
  return type.getBasicType() == glslang::EbtBlock;
}

ResourceKind kind_of(const TType& type) {
  const TQualifier& qualifier = type.getQualifier();
  if (is_block(type)) {
    if (qualifier.isPushConstant()) return ResourceKind::kPushConstant;
    return qualifier.storage == glslang::EvqBuffer ? ResourceKind::kStorageBlock
                                                   : ResourceKind::kUniformBlock;
  }
  if (type.getBasicType() != glslang::EbtSampler)
    return type.isAtomic() ? ResourceKind::kAtomicCounter : ResourceKind::kTexture;
  const glslang::TSampler& sampler = type.getSampler();
  if (sampler.isSubpass()) return ResourceKind::kInputAttachment;
  if (sampler.isPureSampler()) return ResourceKind::kSampler;
  return sampler.isImage() ? ResourceKind::kImage : ResourceKind::kTexture;
}

Resource resource_of(const std::string& name, const TType& type) {
  const TQualifier& qualifier = type.getQualifier();
  Resource resource{.name = is_block(type) ? type.getTypeName().c_str() : name, .kind = kind_of(type)};
  const bool is_sampler = type.getBasicType() == glslang::EbtSampler;
  resource.has_sampler = resource.kind == ResourceKind::kTexture && is_sampler &&
                         type.getSampler().isCombined() && !type.getSampler().isBuffer();
  const bool can_be_written =
      resource.kind == ResourceKind::kImage || resource.kind == ResourceKind::kStorageBlock;
  resource.is_written = can_be_written && !qualifier.isReadOnly();
  if (qualifier.hasSet()) resource.set = static_cast<int>(qualifier.layoutSet);
  if (qualifier.hasBinding()) resource.binding = static_cast<int>(qualifier.layoutBinding);
  resource.count = clamped(elements_of(type));
  return resource;
}

class LiveSymbols : public LiveCode<glslang::TLiveTraverser, glslang::TIntermediate> {
 public:
  explicit LiveSymbols(const glslang::TIntermediate& code) : LiveCode(code) { traverse_live(); }
  void visitSymbol(TIntermSymbol* node) override { ids.insert(node->getId()); }
  std::set<long long> ids;
};

// Gives all nodes of a symbol its number.
class Writer : public glslang::TIntermTraverser {
 public:
  explicit Writer(const std::map<long long, TQualifier>& qualifiers) : qualifiers_(qualifiers) {}
  void visitSymbol(TIntermSymbol* node) override {
    const auto found = qualifiers_.find(node->getId());
    if (found == qualifiers_.end()) return;
    TQualifier& qualifier = node->getQualifier();
    qualifier.layoutLocation = found->second.layoutLocation;
    qualifier.layoutBinding = found->second.layoutBinding;
    qualifier.layoutSet = found->second.layoutSet;
  }

 private:
  const std::map<long long, TQualifier>& qualifiers_;
};

class Numbering {
 public:
  Numbering(glslang::TIntermediate& code, Stage stage, const Target& target, DeclarationLines& lines)
      : code_(code), stage_(stage), target_(target), lines_(lines) {}

  Numbered number() {
    collect();
    take_given();
    if (target_.rules != Rules::kOpenGl && !result_.objection) {
      give_locations(true);
      give_locations(false);
      give_bindings(true);
      if (target_.format == Format::kSpirv) give_bindings(false);  // translations leave out what is not used
      Writer writer(qualifiers_);
      code_.getTreeRoot()->traverse(&writer);
    }
    for (const Variable& variable : variables_) {
      if (variable.is_resource && variable.is_live) result_.resources.push_back(variable.resource);
    }
    result_.outputs = outputs_;
    return std::move(result_);
  }

 private:
  // A global variable that takes numbers.
  struct Variable {
    long long id;
    std::string name;
    std::string row;  // of locations; empty for resources
    int count;
    bool is_resource;
    bool is_live;
    Resource resource;
  };

  void collect() {
    const LiveSymbols live(code_);
    const glslang::TIntermAggregate* linked = code_.findLinkerObjects();
    if (linked == nullptr) return;
    for (TIntermNode* node : linked->getSequence()) {
      const TIntermSymbol* symbol = node->getAsSymbolNode();
      if (symbol == nullptr || qualifiers_.contains(symbol->getId())) continue;
      add(*symbol, live.ids.contains(symbol->getId()));
    }
  }

  void add(const TIntermSymbol& symbol, bool is_live) {
    const TType& type = symbol.getType();
    TQualifier qualifier = type.getQualifier();
    const std::string name = symbol.getName().c_str();
    Variable variable{symbol.getId(), name, row_of(name, type), 1, false, is_live, {}};
    variable.is_resource = qualifier.isUniformOrBuffer() && (is_block(type) || type.isOpaque());
    if (!variable.is_resource && variable.row.empty()) return;
    if (variable.is_resource) {
      variable.resource = resource_of(name, type);
      // A location means nothing there: a texture's place is its binding.
      if (target_.rules != Rules::kOpenGl) qualifier.layoutLocation = TQualifier::layoutLocationEnd;
      if (target_.rules == Rules::kVulkan && !qualifier.hasSet() &&
          variable.resource.kind != ResourceKind::kPushConstant)
        qualifier.layoutSet = 0;
    }
    if (!variable.row.empty()) {
      variable.count =
          clamped(variable.row == "uniform" ? uniform_locations(type) : locations_between_stages(type));
    }
    qualifiers_.emplace(variable.id, qualifier);
    variables_.push_back(std::move(variable));
  }

  [[nodiscard]] std::string row_of(const std::string& name, const TType& type) const {
    const TQualifier& qualifier = type.getQualifier();
    if (qualifier.builtIn != glslang::EbvNone || name.starts_with("gl_")) return {};
    if (qualifier.isPipeInput()) return stage_ == Stage::kVertex ? "input" : "";
    if (qualifier.isPipeOutput()) return stage_ == Stage::kFragment ? "output" : "";
    const bool has_locations = target_.rules != Rules::kVulkan && !target_.binds_by_name;
    const bool is_loose = qualifier.isUniform() && !is_block(type);
    const bool is_texture = type.isOpaque() && target_.rules == Rules::kOpenGlSpirv;
    return has_locations && is_loose && !is_texture && !type.isAtomic() ? "uniform" : "";
  }

  void take_given() {
    for (const Variable& variable : variables_) {
      const TQualifier& qualifier = qualifiers_.at(variable.id);
      if (variable.is_resource) {
        take_binding(variable.resource);
      }
      if (!variable.row.empty() && qualifier.hasLocation()) {
        take_location(variable, static_cast<int>(qualifier.layoutLocation));
      }
    }
    for (const Variable& variable : variables_) {
      if (variable.row == "uniform") find_overlap(variable);
    }
  }

  void take_binding(const Resource& resource) {
    if (!resource.binding) return;
    for (const std::string& row : rows_of(resource, target_))
      numbers_.take(row, *resource.binding, numbers_of(resource, target_));
  }

  void take_location(const Variable& variable, int location) {
    numbers_.take(variable.row, location, variable.count);
    // Of two sources for one target the second has the slot behind the first.
    const TQualifier& qualifier = qualifiers_.at(variable.id);
    const int second = qualifier.hasIndex() ? static_cast<int>(qualifier.layoutIndex) : 0;
    if (variable.row == "output") outputs_ = std::max(outputs_, location + variable.count + second);
  }

  // glslang sees those of inputs and outputs.
  void find_overlap(const Variable& variable) {
    if (!qualifiers_.at(variable.id).hasLocation()) return;
    const int first = static_cast<int>(qualifiers_.at(variable.id).layoutLocation);
    for (const Variable& other : variables_) {
      if (other.id == variable.id) return;  // those before it only
      const TQualifier& qualifier = qualifiers_.at(other.id);
      if (result_.objection || other.row != variable.row || !qualifier.hasLocation()) continue;
      const int start = static_cast<int>(qualifier.layoutLocation);
      if (start + other.count <= first || first + variable.count <= start) continue;
      result_.objection =
          Message{lines_.of(variable.name),
                  fmt::format("'{}': its {} is also that of '{}', which takes {} to {}: give it another",
                              variable.name, place(first, variable.count), other.name, start,
                              start + other.count - 1),
                  lines_.of(other.name)};
    }
  }

  static std::string place(int first, int count) {
    return count == 1 ? fmt::format("location {}", first)
                      : fmt::format("one of the locations {} to {}", first, first + count - 1);
  }

  // What passes through a stage keeps its place in every output, used or not.
  void give_locations(bool live) {
    for (const Variable& variable : variables_) {
      TQualifier& qualifier = qualifiers_.at(variable.id);
      if (variable.row.empty() || variable.is_live != live || qualifier.hasLocation()) continue;
      give_location(variable, qualifier);
    }
  }

  void give_bindings(bool live) {
    for (Variable& variable : variables_) {
      if (variable.is_resource && variable.is_live == live)
        give_binding(variable.resource, qualifiers_.at(variable.id));
    }
  }

  void give_location(const Variable& variable, TQualifier& qualifier) {
    const int location = numbers_.lowest_free({variable.row}, variable.count, 0);
    if (location < static_cast<int>(TQualifier::layoutLocationEnd)) {
      qualifier.layoutLocation = static_cast<unsigned>(location) & 0xFFFU;
      return take_location(variable, location);
    }
    object(variable.name, "location");
  }

  void give_binding(Resource& resource, TQualifier& qualifier) {
    const std::vector<std::string> rows = rows_of(resource, target_);
    if (resource.binding || rows.empty()) return;
    // Direct3D 11 has one row of slots for what a fragment shader writes, outputs first.
    const int from = rows.front() == "register u" ? outputs_ : 0;
    const int count = numbers_of(resource, target_);
    const int binding = numbers_.lowest_free(rows, count, from);
    if (binding >= static_cast<int>(TQualifier::layoutBindingEnd)) return object(resource.name, "binding");
    resource.binding = binding;
    // SPIR-V takes none of a push constant block; whoever translates it is told.
    if (resource.kind != ResourceKind::kPushConstant)
      qualifier.layoutBinding = static_cast<std::uint16_t>(binding);
    take_binding(resource);
  }

  void object(const std::string& name, const char* what) {
    if (!result_.objection)
      result_.objection =
          Message{lines_.of(name), fmt::format("'{}': there is no {} left for it", name, what)};
  }

  glslang::TIntermediate& code_;
  Stage stage_;
  const Target& target_;
  DeclarationLines& lines_;
  std::vector<Variable> variables_;
  std::map<long long, TQualifier> qualifiers_;
  Numbers numbers_;
  int outputs_ = 0;
  Numbered result_;
};

}  // namespace

double uniform_locations(const TType& type) {
  double count = type.isStruct() ? 0 : 1;
  if (type.isStruct()) {
    for (const glslang::TTypeLoc& member : *type.getStruct()) count += uniform_locations(*member.type);
  }
  return count * elements_of(type);
}

Numbered number(glslang::TIntermediate& code, Stage stage, const Target& target, DeclarationLines& lines) {
  return Numbering(code, stage, target, lines).number();
}

}  // namespace gnomon::compiler
