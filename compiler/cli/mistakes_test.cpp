// SPDX-License-Identifier: MIT
// Every folder of compiler/mistakes holds one planted mistake and what gnomonc says of it; see its README.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "src/run_in.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

class Mistake : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] static std::string replace_all(std::string text, const std::string& from,
                                               const std::string& to) {
    for (size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
    return text;
  }

  TemporaryTree tree;
};

std::vector<std::string> cases() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(GNOMON_MISTAKES)) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

TEST(Mistakes, ThereAreEnough) {
  EXPECT_GE(cases().size(), 30u);
}

TEST_P(Mistake, IsToldAsExpected) {
  fs::copy(fs::path(GNOMON_MISTAKES) / GetParam(), tree.path(""), fs::copy_options::recursive);
  std::string program = GNOMONC;
  if (fs::exists(tree.path("share"))) {  // a library of its own, found beside the program's folder
    program = tree.path("bin/gnomonc");
    fs::create_directory(tree.path("bin"));
    fs::copy(GNOMONC, program);
  }
  const std::string expected = tree.read("expected.txt");
  const std::string first_line = expected.substr(0, expected.find('\n') + 1);
  const std::string prompt = "$ gnomonc ";
  ASSERT_EQ(first_line.substr(0, prompt.size()), prompt) << "expected.txt has to begin with the command";

  const std::string arguments = first_line.substr(prompt.size(), first_line.size() - prompt.size() - 1);
  const Outcome outcome = run_in(tree, program, arguments);
  const std::string told = replace_all(outcome.err, GNOMON_SOURCE_SHADERLIB, "shaderlib");
  EXPECT_EQ(first_line + told + "exit code " + std::to_string(outcome.code) + "\n", expected);
}

INSTANTIATE_TEST_SUITE_P(Corpus, Mistake, testing::ValuesIn(cases()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace gnomon
