// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "excess.h"

namespace gnomon::compiler {
namespace {

// glslang visits each of them several times for every declaration.
constexpr double kMostMembers = 10000;

class Structures {
 public:
  explicit Structures(const std::vector<Token>& tokens) : tokens_(tokens) {}

  std::optional<Message> find_large() {
    for (size_t at = 0; at + 2 < tokens_.size(); ++at) {
      if (!tokens_[at].is("struct") || !tokens_[at + 2].is("{")) continue;
      const Token& name = tokens_[at + 1];
      const double members = count_members(at + 3);
      double& known = members_[name.text];
      known = std::max(known, members);
      if (members > kMostMembers)
        return Message{name.line,
                       fmt::format("structure '{}' has more than {:.0f} members, those of its members "
                                   "counted: use arrays, or fewer structures in each other",
                                   name.text, kMostMembers)};
    }
    return std::nullopt;
  }

 private:
  // From behind the brace that opens the structure.
  [[nodiscard]] double count_members(size_t at) const {
    double sum = 0;
    double each = 1;  // of the type of this declaration
    double declarators = 1;
    for (; at < tokens_.size() && !tokens_[at].is("}"); ++at) {
      const auto type = members_.find(tokens_[at].text);
      if (type != members_.end()) each = std::max(each, type->second);
      if (tokens_[at].is(",")) ++declarators;
      if (!tokens_[at].is(";")) continue;
      sum += each * declarators;
      each = 1;
      declarators = 1;
    }
    return sum;
  }

  const std::vector<Token>& tokens_;
  std::map<std::string_view, double> members_;
};

}  // namespace

std::optional<Message> find_large_structure(const std::vector<Token>& tokens) {
  return Structures(tokens).find_large();
}

}  // namespace gnomon::compiler
