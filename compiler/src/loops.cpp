// SPDX-License-Identifier: MIT
#include <glslang/Include/intermediate.h>

#include <cstdint>
#include <optional>
#include <set>

#include "inspect.h"

namespace gnomon::compiler {
namespace {

using VariableId = long long;

// The variable that an expression denotes or lies in: v of v, v.x, v[i].
const glslang::TIntermSymbol* variable_of(TIntermNode* node) {
  while (node != nullptr && node->getAsSymbolNode() == nullptr) {
    glslang::TIntermBinary* part = node->getAsBinaryNode();
    node = part == nullptr ? nullptr : part->getLeft();
  }
  return node == nullptr ? nullptr : node->getAsSymbolNode();
}

// Collects what a piece of code reads, modifies and calls.
class Effects : public glslang::TIntermTraverser {
 public:
  explicit Effects(TIntermNode* code) {
    if (code != nullptr) code->traverse(this);
  }

  void visitSymbol(glslang::TIntermSymbol* node) override {
    read.insert(node->getId());
    reads_global = reads_global || node->getQualifier().storage == glslang::EvqGlobal;
  }
  bool visitBinary(glslang::TVisit, glslang::TIntermBinary* node) override {
    if (node->modifiesState()) note(node->getLeft());
    return true;
  }
  bool visitUnary(glslang::TVisit, glslang::TIntermUnary* node) override {
    if (node->modifiesState()) note(node->getOperand());
    return true;
  }
  bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
    if (node->getOp() != glslang::EOpFunctionCall) return true;
    calls = calls || node->isUserDefined();
    for (size_t i = 0; i < node->getQualifierList().size(); ++i) {
      const glslang::TStorageQualifier passing = node->getQualifierList()[i];
      if (passing == glslang::EvqOut || passing == glslang::EvqInOut) note(node->getSequence()[i]);
    }
    return true;
  }

  std::set<VariableId> read;
  std::multiset<VariableId> modified;
  bool calls = false;
  bool reads_global = false;

  [[nodiscard]] size_t modifications_of(VariableId variable) const { return modified.count(variable); }

 private:
  void note(TIntermNode* target) {
    if (const auto* variable = variable_of(target)) modified.insert(variable->getId());
  }
};

// What the parts of one loop do.
struct LoopEffects {
  Effects initializer;  // of the statements before the loop in its own sequence
  Effects test;
  Effects step;
  Effects body;

  // Whether it calls functions of the shader, which may modify what is global.
  [[nodiscard]] bool calls() const { return test.calls || step.calls || body.calls; }
};

// A counter's change from one round to the next.
using Step = std::int64_t;

// The value of a constant whole number.
std::optional<std::int64_t> value_of(TIntermNode* node) {
  glslang::TIntermTyped* typed = node == nullptr ? nullptr : node->getAsTyped();
  glslang::TIntermConstantUnion* constant = typed == nullptr ? nullptr : typed->getAsConstantUnion();
  if (constant == nullptr || !typed->isScalar()) return std::nullopt;
  const glslang::TConstUnion& value = constant->getConstArray()[0];
  if (typed->getBasicType() == glslang::EbtInt) return value.getIConst();
  if (typed->getBasicType() == glslang::EbtUint) return value.getUConst();
  return std::nullopt;
}

bool is_variable(TIntermNode* node, VariableId id) {
  const auto* symbol = node == nullptr ? nullptr : node->getAsSymbolNode();
  return symbol != nullptr && symbol->getId() == id;
}

// "i = i + 2", "i = 2 + i", "i = i - 2".
std::optional<Step> step_of_assignment(TIntermNode* value, VariableId id) {
  glslang::TIntermBinary* sum = value->getAsBinaryNode();
  if (sum == nullptr) return std::nullopt;
  const bool adds = sum->getOp() == glslang::EOpAdd;
  if (!adds && sum->getOp() != glslang::EOpSub) return std::nullopt;
  if (is_variable(sum->getLeft(), id)) {
    const auto change = value_of(sum->getRight());
    return change && !adds ? -*change : change;
  }
  return adds && is_variable(sum->getRight(), id) ? value_of(sum->getLeft()) : std::nullopt;
}

// By how much an expression that is always reached changes the variable.
std::optional<Step> step_of(TIntermNode* node, VariableId id) {
  if (glslang::TIntermAggregate* list = node->getAsAggregate();
      list != nullptr && list->getOp() == glslang::EOpComma) {
    for (TIntermNode* part : list->getSequence()) {
      if (const auto step = step_of(part, id)) return step;
    }
    return std::nullopt;
  }
  if (glslang::TIntermUnary* unary = node->getAsUnaryNode()) {
    if (!is_variable(unary->getOperand(), id)) return std::nullopt;
    const glslang::TOperator op = unary->getOp();
    if (op == glslang::EOpPreIncrement || op == glslang::EOpPostIncrement) return 1;
    if (op == glslang::EOpPreDecrement || op == glslang::EOpPostDecrement) return -1;
    return std::nullopt;
  }
  glslang::TIntermBinary* binary = node->getAsBinaryNode();
  if (binary == nullptr || !is_variable(binary->getLeft(), id)) return std::nullopt;
  if (binary->getOp() == glslang::EOpAssign) return step_of_assignment(binary->getRight(), id);
  const auto change = value_of(binary->getRight());
  if (binary->getOp() == glslang::EOpAddAssign) return change;
  return change && binary->getOp() == glslang::EOpSubAssign ? std::optional(-*change) : std::nullopt;
}

// "counter OP limit", whichever of them stands on the left.
struct Comparison {
  glslang::TOperator op;
  const glslang::TIntermSymbol& counter;
  TIntermNode* limit;
};

glslang::TOperator mirrored(glslang::TOperator op) {
  switch (op) {
    case glslang::EOpLessThan:
      return glslang::EOpGreaterThan;
    case glslang::EOpLessThanEqual:
      return glslang::EOpGreaterThanEqual;
    case glslang::EOpGreaterThan:
      return glslang::EOpLessThan;
    case glslang::EOpGreaterThanEqual:
      return glslang::EOpLessThanEqual;
    default:
      return op;
  }
}

bool is_ordering(glslang::TOperator op) {
  return op == glslang::EOpLessThan || op == glslang::EOpLessThanEqual || op == glslang::EOpGreaterThan ||
         op == glslang::EOpGreaterThanEqual || op == glslang::EOpNotEqual;
}

// Whether a counter that goes by `step` comes to the limit before the end of its type, where it would begin
// anew. A limit that is unknown is taken to be a sensible one, but that of an unsigned counter may be zero.
bool comes_to_limit(const Comparison& test, Step step) {
  if (test.op == glslang::EOpNotEqual) return step == 1 || step == -1;
  const bool upwards = test.op == glslang::EOpLessThan || test.op == glslang::EOpLessThanEqual;
  if (step == 0 || upwards != (step > 0)) return false;
  const bool is_unsigned = test.counter.getBasicType() == glslang::EbtUint;
  const bool takes_limit = test.op == glslang::EOpLessThanEqual || test.op == glslang::EOpGreaterThanEqual;
  auto limit = value_of(test.limit);
  if (!limit && (upwards || !is_unsigned)) return true;
  // The last value for which the loop goes on.
  const std::int64_t last = limit.value_or(0) + (takes_limit ? 0 : upwards ? -1 : 1);
  if (upwards) return last + step <= (is_unsigned ? 0xFFFFFFFFll : 0x7FFFFFFFll);
  return last + step >= (is_unsigned ? 0ll : -0x80000000ll);
}

bool is_counter(const Comparison& test, TIntermNode& step, const LoopEffects& loop) {
  const glslang::TType& type = test.counter.getType();
  const bool is_whole = type.getBasicType() == glslang::EbtInt || type.getBasicType() == glslang::EbtUint;
  if (!is_whole || !type.isScalar()) return false;
  const VariableId id = test.counter.getId();
  if (loop.initializer.modifications_of(id) == 0 || loop.step.modifications_of(id) != 1) return false;
  if (loop.body.modifications_of(id) > 0 || loop.test.modifications_of(id) > 0) return false;
  const bool is_global = type.getQualifier().storage == glslang::EvqGlobal;
  if (is_global && loop.calls()) return false;
  const auto change = step_of(&step, id);
  return change && comes_to_limit(test, *change);
}

bool is_constant_in(TIntermNode* limit, const LoopEffects& loop) {
  const Effects effects(limit);
  if (effects.calls || !effects.modified.empty()) return false;
  if (effects.reads_global && loop.calls()) return false;
  for (const VariableId id : effects.read) {
    for (const Effects* part : {&loop.test, &loop.step, &loop.body}) {
      if (part->modifications_of(id) > 0) return false;
    }
  }
  return true;
}

bool is_bounding(TIntermNode* condition, TIntermNode& step, const LoopEffects& loop) {
  glslang::TIntermBinary* test = condition->getAsBinaryNode();
  if (test == nullptr) return false;
  TIntermNode* left = test->getLeft();
  TIntermNode* right = test->getRight();
  if (test->getOp() == glslang::EOpLogicalAnd)
    return is_bounding(left, step, loop) || is_bounding(right, step, loop);
  if (!is_ordering(test->getOp())) return false;
  const auto compares = [&](TIntermNode* counter, TIntermNode* limit, glslang::TOperator op) {
    const auto* symbol = counter->getAsSymbolNode();
    return symbol != nullptr && is_counter({op, *symbol, limit}, step, loop) && is_constant_in(limit, loop);
  };
  return compares(left, right, test->getOp()) || compares(right, left, mirrored(test->getOp()));
}

class LoopFinder : public glslang::TIntermTraverser {
 public:
  // glslang makes a sequence of a for's initializer and its loop.
  bool visitLoop(glslang::TVisit, glslang::TIntermLoop* node) override {
    glslang::TIntermAggregate* sequence =
        getParentNode() == nullptr ? nullptr : getParentNode()->getAsAggregate();
    const bool is_for = node->testFirst() && node->getTerminal() != nullptr && node->getTest() != nullptr;
    if (!is_for || sequence == nullptr ||
        !is_bounding(node->getTest(), *node->getTerminal(), effects_of(*node, *sequence))) {
      unbounded.push_back(node->getLoc().line);
    }
    return true;
  }

  std::vector<int> unbounded;

 private:
  static LoopEffects effects_of(glslang::TIntermLoop& loop, glslang::TIntermAggregate& sequence) {
    LoopEffects effects{Effects(nullptr), Effects(loop.getTest()), Effects(loop.getTerminal()),
                        Effects(loop.getBody())};
    for (TIntermNode* before : sequence.getSequence()) {
      if (before == &loop) break;
      before->traverse(&effects.initializer);
    }
    return effects;
  }
};

}  // namespace

std::vector<int> find_unbounded_loops(TIntermNode& root) {
  LoopFinder finder;
  root.traverse(&finder);
  return finder.unbounded;
}

}  // namespace gnomon::compiler
