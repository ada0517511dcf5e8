// SPDX-License-Identifier: MIT
#include "gnomon/compiler/graph.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace gnomon::compiler {
namespace {

class Tree {
 public:
  explicit Tree(const Assembled& assembled)
      : files_(assembled.files), included_(files_.size()), printed_(files_.size()) {
    for (const Include& include : assembled.includes)
      included_[static_cast<size_t>(include.includer)].push_back(static_cast<size_t>(include.included));
  }

  void print(size_t file, size_t depth) {
    text_.append(2 * depth, ' ').append(files_[file]).append("\n");
    if (printed_[file]) return;
    printed_[file] = true;
    for (const size_t included : included_[file]) print(included, depth + 1);
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  const std::vector<std::string>& files_;
  std::vector<std::vector<size_t>> included_;
  std::vector<bool> printed_;
  std::string text_;
};

std::string quoted(std::string_view path) {
  std::string text = "\"";
  for (const char c : path) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + '"';
}

}  // namespace

std::string to_tree(const Assembled& assembled) {
  Tree tree(assembled);
  tree.print(0, 0);
  return tree.text();
}

std::string to_dot(const Assembled& assembled) {
  std::string text = "digraph includes {\n  rankdir=LR;\n  node [shape=box];\n";
  for (const std::string& file : assembled.files) text.append("  ").append(quoted(file)).append(";\n");
  for (const Include& include : assembled.includes) {
    text.append("  ").append(quoted(assembled.files[static_cast<size_t>(include.includer)]));
    text.append(" -> ").append(quoted(assembled.files[static_cast<size_t>(include.included)]));
    text.append(";\n");
  }
  return text + "}\n";
}

}  // namespace gnomon::compiler
