// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <glslang/Include/intermediate.h>

#include <algorithm>

#include "inspect.h"

namespace gnomon::compiler {
namespace {

// The validator of SPIR-V needs seconds for more: its effort grows with the square of the depth, or faster.
constexpr int kDeepestLoops = 64;
constexpr int kDeepestStatements = 256;

class NestingFinder : public glslang::TIntermTraverser {
 public:
  NestingFinder() : TIntermTraverser(true, false, true) {}

  bool visitLoop(glslang::TVisit visit, glslang::TIntermLoop* node) override {
    step(visit, loops_, kDeepestLoops, "loops", *node);
    return true;
  }
  bool visitSelection(glslang::TVisit visit, glslang::TIntermSelection* node) override {
    step(visit, statements_, kDeepestStatements, "conditions, 'else if' among them,", *node);
    return true;
  }
  bool visitSwitch(glslang::TVisit visit, glslang::TIntermSwitch* node) override {
    step(visit, statements_, kDeepestStatements, "conditions", *node);
    return true;
  }

  std::optional<Message> excess;

 private:
  void step(glslang::TVisit visit, int& depth, int limit, const char* what, const TIntermNode& node) {
    depth += visit == glslang::EvPreVisit ? 1 : -1;
    if (depth <= limit || excess) return;
    excess = Message{
        std::max(node.getLoc().line, 1),
        fmt::format("{} are nested more than {} deep: move the inner ones into a function", what, limit)};
  }

  int loops_ = 0;
  int statements_ = 0;
};

}  // namespace

std::optional<Message> find_deep_nesting(TIntermNode& root) {
  NestingFinder finder;
  root.traverse(&finder);
  return finder.excess;
}

}  // namespace gnomon::compiler
