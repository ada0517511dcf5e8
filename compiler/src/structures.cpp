// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "excess.h"

namespace gnomon::compiler {
namespace {

// glslang visits each of them several times for every declaration.
constexpr double kMostMembers = 10000;
// ... by recursion: a few thousand structures in each other overflow the stack.
constexpr int kDeepest = 200;

class Structures {
 public:
  explicit Structures(const std::vector<Token>& tokens) : tokens_(tokens) {}

  std::optional<Message> find_large() {
    for (size_t at = 0; at + 2 < tokens_.size(); ++at) {
      if (!tokens_[at].is("struct") || !tokens_[at + 2].is("{")) continue;
      const Token& name = tokens_[at + 1];
      const auto [members, depth] = measure(at + 3);
      Size& known = sizes_[name.text];
      known = {std::max(known.members, members), std::max(known.depth, depth)};
      if (depth > kDeepest)
        return Message{name.line, fmt::format("structure '{}' holds others more than {} deep: use fewer "
                                              "structures in each other",
                                              name.text, kDeepest)};
      if (members > kMostMembers)
        return Message{name.line,
                       fmt::format("structure '{}' has more than {:.0f} members, those of its members "
                                   "counted: use arrays, or fewer structures in each other",
                                   name.text, kMostMembers)};
    }
    return std::nullopt;
  }

 private:
  struct Size {
    double members = 0;
    int depth = 0;  // of structures in it, with itself
  };

  // From behind the brace that opens the structure.
  [[nodiscard]] Size measure(size_t at) const {
    Size sum{0, 1};
    double each = 1;  // of the type of this declaration
    double declarators = 1;
    for (; at < tokens_.size() && !tokens_[at].is("}"); ++at) {
      const auto type = sizes_.find(tokens_[at].text);
      if (type != sizes_.end()) {
        each = std::max(each, type->second.members);
        sum.depth = std::max(sum.depth, type->second.depth + 1);
      }
      if (tokens_[at].is(",")) ++declarators;
      if (!tokens_[at].is(";")) continue;
      sum.members += each * declarators;
      each = 1;
      declarators = 1;
    }
    return sum;
  }

  const std::vector<Token>& tokens_;
  std::map<std::string_view, Size> sizes_;
};

}  // namespace

std::optional<Message> find_large_structure(const std::vector<Token>& tokens) {
  return Structures(tokens).find_large();
}

}  // namespace gnomon::compiler
