// SPDX-License-Identifier: MIT
#include <glslang/Include/intermediate.h>

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

  void visitSymbol(glslang::TIntermSymbol* node) override { read.insert(node->getId()); }
  bool visitBinary(glslang::TVisit, glslang::TIntermBinary* node) override {
    if (node->modifiesState()) note(node->getLeft(), node->getOp());
    return true;
  }
  bool visitUnary(glslang::TVisit, glslang::TIntermUnary* node) override {
    if (node->modifiesState()) note(node->getOperand(), node->getOp());
    return true;
  }
  bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
    if (node->getOp() != glslang::EOpFunctionCall) return true;
    calls = calls || node->isUserDefined();
    for (size_t i = 0; i < node->getQualifierList().size(); ++i) {
      const glslang::TStorageQualifier passing = node->getQualifierList()[i];
      if (passing == glslang::EvqOut || passing == glslang::EvqInOut)
        note(node->getSequence()[i], glslang::EOpAssign);
    }
    return true;
  }

  struct Modification {
    VariableId variable;
    glslang::TOperator how;
  };
  std::set<VariableId> read;
  std::vector<Modification> modified;
  bool calls = false;

  [[nodiscard]] const Modification* modification_of(VariableId variable) const {
    for (const Modification& modification : modified) {
      if (modification.variable == variable) return &modification;
    }
    return nullptr;
  }

 private:
  void note(TIntermNode* target, glslang::TOperator how) {
    if (const auto* variable = variable_of(target)) modified.push_back({variable->getId(), how});
  }
};

// What the parts of one loop do.
struct LoopEffects {
  Effects initializer;  // of the statements before the loop in its own sequence
  Effects test;
  Effects step;
  Effects body;
};

enum class Direction { kUp, kDown, kEither };

Direction direction_of_comparison(glslang::TOperator op, bool counter_is_left) {
  if (op == glslang::EOpNotEqual) return Direction::kEither;
  const bool less = op == glslang::EOpLessThan || op == glslang::EOpLessThanEqual;
  return less == counter_is_left ? Direction::kUp : Direction::kDown;
}

Direction direction_of_step(glslang::TOperator op) {
  switch (op) {
    case glslang::EOpPreIncrement:
    case glslang::EOpPostIncrement:
    case glslang::EOpAddAssign:
      return Direction::kUp;
    case glslang::EOpPreDecrement:
    case glslang::EOpPostDecrement:
    case glslang::EOpSubAssign:
      return Direction::kDown;
    default:
      return Direction::kEither;
  }
}

bool is_ordering(glslang::TOperator op) {
  return op == glslang::EOpLessThan || op == glslang::EOpLessThanEqual || op == glslang::EOpGreaterThan ||
         op == glslang::EOpGreaterThanEqual || op == glslang::EOpNotEqual;
}

bool is_counter(const glslang::TIntermSymbol& candidate, Direction wanted, const LoopEffects& loop) {
  const VariableId id = candidate.getId();
  const auto* step = loop.step.modification_of(id);
  if (step == nullptr || loop.initializer.modification_of(id) == nullptr) return false;
  if (loop.body.modification_of(id) != nullptr || loop.test.modification_of(id) != nullptr) return false;
  const Direction taken = direction_of_step(step->how);
  return taken == wanted || taken == Direction::kEither || wanted == Direction::kEither;
}

bool is_constant_in(TIntermNode* limit, const LoopEffects& loop) {
  const Effects effects(limit);
  if (effects.calls || !effects.modified.empty()) return false;
  for (const VariableId id : effects.read) {
    for (const Effects* part : {&loop.test, &loop.step, &loop.body}) {
      if (part->modification_of(id) != nullptr) return false;
    }
  }
  return true;
}

bool is_bounding(TIntermNode* condition, const LoopEffects& loop) {
  glslang::TIntermBinary* test = condition->getAsBinaryNode();
  if (test == nullptr) return false;
  TIntermNode* left = test->getLeft();
  TIntermNode* right = test->getRight();
  if (test->getOp() == glslang::EOpLogicalAnd) return is_bounding(left, loop) || is_bounding(right, loop);
  if (!is_ordering(test->getOp())) return false;
  const auto compares = [&](TIntermNode* counter, TIntermNode* limit, bool counter_is_left) {
    const auto* symbol = counter->getAsSymbolNode();
    return symbol != nullptr &&
           is_counter(*symbol, direction_of_comparison(test->getOp(), counter_is_left), loop) &&
           is_constant_in(limit, loop);
  };
  return compares(left, right, true) || compares(right, left, false);
}

class LoopFinder : public glslang::TIntermTraverser {
 public:
  // glslang makes a sequence of a for's initializer and its loop.
  bool visitLoop(glslang::TVisit, glslang::TIntermLoop* node) override {
    glslang::TIntermAggregate* sequence =
        getParentNode() == nullptr ? nullptr : getParentNode()->getAsAggregate();
    const bool is_for = node->testFirst() && node->getTerminal() != nullptr && node->getTest() != nullptr;
    if (!is_for || sequence == nullptr || !is_bounding(node->getTest(), effects_of(*node, *sequence))) {
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
