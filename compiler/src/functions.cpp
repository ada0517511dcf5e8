// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <glslang/Include/intermediate.h>

#include <algorithm>
#include <utility>

#include "inspect.h"

namespace gnomon::compiler {
namespace {

std::string scalar_name(const glslang::TType& type) {
  return glslang::TType::getBasicString(type.getBasicType());
}

// "vec" of float, "ivec" of int ...
std::string vector_prefix(const std::string& scalar) {
  return scalar == "float" ? "" : scalar.substr(0, 1);
}

void add_parts(Type& type, int count, const Type& part) {
  for (int i = 0; i < count; ++i) type.parts.push_back({fmt::format("[{}]", i), part});
}

Type vector_of(const std::string& scalar, int size) {
  Type type{fmt::format("{}vec{}", vector_prefix(scalar), size)};
  add_parts(type, size, Type{scalar});
  return type;
}

Type matrix_of(const glslang::TType& from) {
  const std::string scalar = scalar_name(from);
  Type type{fmt::format("{}mat{}x{}", vector_prefix(scalar), from.getMatrixCols(), from.getMatrixRows())};
  add_parts(type, from.getMatrixCols(), vector_of(scalar, from.getMatrixRows()));
  return type;
}

Type read_type(const glslang::TType& from) {
  if (from.isArray()) {
    const Type element = read_type(glslang::TType(from, 0));
    const int size = from.getOuterArraySize();
    // The outermost size comes first: an array of 2 arrays of 3 is float[2][3].
    const size_t bracket = std::min(element.name.find('['), element.name.size());
    Type type{fmt::format("{}[{}]{}", element.name.substr(0, bracket), size, element.name.substr(bracket)),
              element.opaque};
    add_parts(type, size, element);
    return type;
  }
  if (from.getBasicType() == glslang::EbtSampler) return {from.getSampler().getString().c_str(), true, {}};
  if (from.isStruct()) {
    Type type{from.getTypeName().c_str()};
    for (const glslang::TTypeLoc& member : *from.getStruct()) {
      type.parts.push_back({std::string(".") + member.type->getFieldName().c_str(), read_type(*member.type)});
    }
    return type;
  }
  if (from.isMatrix()) return matrix_of(from);
  if (from.isVector()) return vector_of(scalar_name(from), from.getVectorSize());
  return {scalar_name(from)};
}

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
      called.push_back(read_call(*node));
    }
    return true;
  }

  std::vector<Function> defined;
  std::vector<Function> called;
};

bool has(const std::vector<Function>& functions, const Function& function) {
  return std::ranges::find(functions, function.signature, &Function::signature) != functions.end();
}

}  // namespace

void find_functions(TIntermNode& root, Shader& shader) {
  FunctionFinder finder;
  root.traverse(&finder);
  for (Function& call : finder.called) {
    if (!has(finder.defined, call) && !has(shader.undefined, call))
      shader.undefined.push_back(std::move(call));
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
