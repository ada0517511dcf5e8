// SPDX-License-Identifier: MIT
// Goes through the code that main() reaches.
#pragma once

#include <glslang/MachineIndependent/LiveTraverser.h>

namespace gnomon::compiler {

/// Derive, override visits, and call traverse_live(). A derived visitAggregate() calls that of
/// TLiveTraverser, which finds the functions that are called.
class LiveCode : public glslang::TLiveTraverser {
 public:
  explicit LiveCode(const glslang::TIntermediate& code) : TLiveTraverser(code), code_(code) {}

  void traverse_live() {
    pushFunction(code_.getEntryPointMangledName().c_str());
    for (TIntermNode* global : code_.getTreeRoot()->getAsAggregate()->getSequence()) {
      const glslang::TIntermAggregate* aggregate = global->getAsAggregate();
      const bool is_initializer = aggregate == nullptr || aggregate->getOp() == glslang::EOpSequence;
      if (is_initializer) global->traverse(this);
    }
    while (!destinations.empty()) {
      TIntermNode* function = destinations.back();
      destinations.pop_back();
      function->traverse(this);
    }
  }

 private:
  const glslang::TIntermediate& code_;
};

}  // namespace gnomon::compiler
