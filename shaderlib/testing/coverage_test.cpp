// SPDX-License-Identifier: MIT
// Every function of a module x.glsl is tested in the x_test.cpp beside it.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "testing/defined_functions.h"

namespace gnomon::modules {
namespace {

TEST(Coverage, EveryFunctionIsCalledInTheTestBesideItsModule) {
  const std::string library = GNOMON_SOURCE_SHADERLIB;
  const auto functions = defined_functions(library);
  ASSERT_TRUE(functions) << to_string(functions.diagnostics().front());
  EXPECT_GT(functions->size(), 20u);
  for (const auto& [module, name] : *functions) {
    std::ifstream file(library + "/" + module + "_test.cpp");
    const std::string test{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(test.find("." + name + "("), std::string::npos)
        << "shaderlib/" << module << "_test.cpp does not call " << name;
  }
}

}  // namespace
}  // namespace gnomon::modules
