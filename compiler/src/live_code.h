// SPDX-License-Identifier: MIT
// Goes through the code that main() reaches.
#pragma once

namespace gnomon::compiler {

/// Over `Traverser`, which is glslang::TLiveTraverser, whose header only .cpp files include. Derive, override
/// visits, and call traverse_live(). A derived visitAggregate() calls that of TLiveTraverser, which finds the
/// functions that are called.
template <class Traverser, class Code>
class LiveCode : public Traverser {
 public:
  explicit LiveCode(const Code& code) : Traverser(code), code_(code) {}

  void traverse_live() {
    this->pushFunction(code_.getEntryPointMangledName().c_str());
    for (auto* global : code_.getTreeRoot()->getAsAggregate()->getSequence()) {
      const auto* aggregate = global->getAsAggregate();
      const bool is_initializer = aggregate == nullptr || aggregate->getOp() == glslang::EOpSequence;
      if (is_initializer) global->traverse(this);
    }
    while (!this->destinations.empty()) {
      auto* function = this->destinations.back();
      this->destinations.pop_back();
      function->traverse(this);
    }
  }

 private:
  const Code& code_;
};

}  // namespace gnomon::compiler
