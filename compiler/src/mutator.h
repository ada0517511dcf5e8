// SPDX-License-Identifier: MIT
// Damages sources at random, the way people and broken disks do, for compiler_mutation_test.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace gnomon::compiler {

class Mutator {
 public:
  /// `donors`: whole files that chunks are taken from; `names`: what an #include may be made to ask for, with
  /// its quotes or brackets. Both have to outlive the mutator and must not be empty.
  Mutator(std::uint64_t seed, const std::vector<std::string>& donors, const std::vector<std::string>& names)
      : random_(seed), donors_(donors), names_(names) {}

  /// `text` after one to eight random mistakes.
  [[nodiscard]] std::string mutate(std::string text);

  /// A number below `count`, which is not 0. The same on every machine, unlike the standard's distributions.
  [[nodiscard]] size_t below(size_t count) { return static_cast<size_t>(random_() % count); }

 private:
  void mutate_bytes(std::string& text);
  void mutate_lines(std::string& text);
  void mutate_includes(std::string& text);
  void mutate_tokens(std::string& text);
  void splice(std::string& text);

  std::mt19937_64 random_;
  const std::vector<std::string>& donors_;
  const std::vector<std::string>& names_;
};

}  // namespace gnomon::compiler
