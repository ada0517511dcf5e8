// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <glslang/Include/intermediate.h>

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "inspect.h"

namespace gnomon::compiler {
namespace {

// "vec" of float, "ivec" of int ...
std::string vector_prefix(const std::string& scalar) {
  return scalar == "float" ? "" : scalar.substr(0, 1);
}

// Takes one type apart.
class TypeReader {
 public:
  Type read(const glslang::TType& from) {
    if (from.isArray()) return array(from);
    if (from.isStruct()) return structure(from);
    if (from.getBasicType() == glslang::EbtSampler)
      return {Type::Kind::kOpaque, from.getSampler().getString().c_str(), {}};
    const std::string name = glslang::TType::getBasicString(from.getBasicType());
    if (from.getBasicType() == glslang::EbtVoid) return {Type::Kind::kVoid, name, {}};
    if (from.isMatrix()) return matrix(name, from.getMatrixCols(), from.getMatrixRows());
    return from.isVector() ? vector(name, from.getVectorSize()) : scalar(name);
  }

 private:
  // Whoever uses the type writes a line of text for every scalar.
  static constexpr int kMostScalars = 1024;

  Type scalar(const std::string& name) {
    ++scalars_;
    return {Type::Kind::kScalar, name, {}};
  }

  Type vector(const std::string& scalar_name, int size) {
    Type type{Type::Kind::kComposite, fmt::format("{}vec{}", vector_prefix(scalar_name), size), {}};
    for (int i = 0; i < size; ++i) type.parts.push_back({fmt::format("[{}]", i), scalar(scalar_name)});
    return type;
  }

  Type matrix(const std::string& scalar_name, int columns, int rows) {
    Type type{
        Type::Kind::kComposite, fmt::format("{}mat{}x{}", vector_prefix(scalar_name), columns, rows), {}};
    for (int i = 0; i < columns; ++i)
      type.parts.push_back({fmt::format("[{}]", i), vector(scalar_name, rows)});
    return type;
  }

  Type array(const glslang::TType& from) {
    const glslang::TType element_type(from, 0);
    Type element = read(element_type);
    // The outermost size comes first: two arrays of three are float[2][3].
    const size_t bracket = std::min(element.name.find('['), element.name.size());
    const int size = from.getOuterArraySize();
    Type type{element.kind == Type::Kind::kOpaque ? element.kind : Type::Kind::kComposite,
              fmt::format("{}[{}]{}", element.name.substr(0, bracket), size, element.name.substr(bracket)),
              {}};
    type.parts.push_back({"[0]", std::move(element)});
    for (int i = 1; i < size && scalars_ < kMostScalars; ++i) {
      type.parts.push_back({fmt::format("[{}]", i), read(element_type)});
    }
    return type;
  }

  Type structure(const glslang::TType& from) {
    Type type{Type::Kind::kComposite, from.getTypeName().c_str(), {}};
    if (type.name.empty()) type.name = "struct";
    for (const glslang::TTypeLoc& member : *from.getStruct()) {
      if (scalars_ >= kMostScalars) break;
      type.parts.push_back({std::string(".") + member.type->getFieldName().c_str(), read(*member.type)});
      if (type.parts.back().type.kind == Type::Kind::kOpaque) type.kind = Type::Kind::kOpaque;
    }
    return type;
  }

  int scalars_ = 0;
};

Passing read_passing(glslang::TStorageQualifier qualifier) {
  switch (qualifier) {
    case glslang::EvqConstReadOnly:
      return Passing::kConstIn;
    case glslang::EvqOut:
      return Passing::kOut;
    case glslang::EvqInOut:
      return Passing::kInOut;
    default:
      return Passing::kIn;
  }
}

// Result, name and line; `node` is a definition or a call.
Function read_function(glslang::TIntermAggregate& node) {
  Function function;
  function.signature = node.getName().c_str();
  function.name = function.signature.substr(0, function.signature.find('('));
  function.result = read_type(node.getType());
  function.line = node.getLoc().line;
  return function;
}

Function read_definition(glslang::TIntermAggregate& node) {
  Function function = read_function(node);
  for (TIntermNode* parameter : node.getSequence().front()->getAsAggregate()->getSequence()) {
    const glslang::TType& type = parameter->getAsTyped()->getType();
    function.parameters.push_back({read_type(type), read_passing(type.getQualifier().storage)});
  }
  return function;
}

Function read_call(glslang::TIntermAggregate& node) {
  Function function = read_function(node);
  for (size_t i = 0; i < node.getSequence().size(); ++i) {
    function.parameters.push_back({read_type(node.getSequence()[i]->getAsTyped()->getType()),
                                   read_passing(node.getQualifierList()[i])});
  }
  return function;
}

class FunctionFinder : public glslang::TIntermTraverser {
 public:
  bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
    if (node->getOp() == glslang::EOpFunction) {
      defined.push_back(read_definition(*node));
    } else if (node->getOp() == glslang::EOpFunctionCall && node->isUserDefined()) {
      // The first call tells all that is asked; programs have thousands.
      if (signatures_.insert(node->getName().c_str()).second) called.push_back(read_call(*node));
    }
    return true;
  }

  std::vector<Function> defined;
  std::vector<Function> called;  // each signature once

 private:
  std::unordered_set<std::string> signatures_;
};

}  // namespace

Type read_type(const glslang::TType& type) {
  return TypeReader().read(type);
}

void find_functions(TIntermNode& root, Shader& shader) {
  FunctionFinder finder;
  root.traverse(&finder);
  std::unordered_set<std::string> defined;
  for (const Function& function : finder.defined) defined.insert(function.signature);
  std::unordered_set<std::string> names;
  for (Function& call : finder.called) {
    if (names.insert(call.name).second) shader.called.push_back(call.name);
    if (!defined.contains(call.signature)) shader.undefined.push_back(std::move(call));
  }
  for (Function& function : finder.defined) {
    if (function.name == "main") {
      shader.has_main = true;
    } else {
      shader.defined.push_back(std::move(function));
    }
  }
}

}  // namespace gnomon::compiler
