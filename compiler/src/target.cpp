// SPDX-License-Identifier: MIT
#include <algorithm>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

const std::vector<Target>& targets() {
  using enum Stage;
  static const std::vector<Target> table = {
      {"glsl450",
       "#version 450 core",
       "GLSL 4.50 for desktop OpenGL",
       Format::kGlsl,
       Rules::kOpenGl,
       {kVertex, kFragment, kGeometry, kCompute},
       false,
       false,
       true},
      {"glsl330",
       "#version 330 core",
       "GLSL 3.30 for desktop OpenGL",
       Format::kGlsl,
       Rules::kOpenGl,
       {kVertex, kFragment, kGeometry},
       true,
       false,
       false},
      {"essl300",
       "#version 300 es",
       "ESSL 3.00 for OpenGL ES 3.0 and WebGL 2",
       Format::kGlsl,
       Rules::kOpenGl,
       {kVertex, kFragment},
       true,
       true,
       false},
      {"essl310",
       "#version 310 es",
       "ESSL 3.10 for OpenGL ES 3.1",
       Format::kGlsl,
       Rules::kOpenGl,
       {kVertex, kFragment, kCompute},
       false,
       true,
       true},
      {"vulkan",
       "#version 450",
       "SPIR-V 1.0 for Vulkan 1.0",
       Format::kSpirv,
       Rules::kVulkan,
       {kVertex, kFragment, kGeometry, kCompute},
       false,
       true,
       true},
      {"opengl",
       "#version 450 core",
       "SPIR-V 1.0 for OpenGL 4.5",
       Format::kSpirv,
       Rules::kOpenGlSpirv,
       {kVertex, kFragment, kGeometry, kCompute},
       false,
       true,
       true},
      {"hlsl50",
       "#version 450",
       "HLSL for shader model 5.0",
       Format::kHlsl,
       Rules::kVulkan,
       {kVertex, kFragment, kCompute},
       false,
       true,
       true},
      {"msl21",
       "#version 450",
       "Metal shading language 2.1",
       Format::kMsl,
       Rules::kVulkan,
       {kVertex, kFragment, kCompute},
       false,
       true,
       true},
      {"header",
       "#version 450 core",
       "a C++ header that holds the outputs of other targets, see --embed",
       Format::kHeader,
       Rules::kOpenGl,
       {kVertex, kFragment, kGeometry, kCompute},
       false,
       false,
       true},
  };
  return table;
}

const Target* find_target(const std::string& name) {
  const auto row = std::ranges::find(targets(), name, &Target::name);
  return row == targets().end() ? nullptr : &*row;
}

}  // namespace gnomon::compiler
