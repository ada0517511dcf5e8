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
       false},
      {"glsl330",
       "#version 330 core",
       "GLSL 3.30 for desktop OpenGL",
       Format::kGlsl,
       Rules::kOpenGl,
       {kVertex, kFragment, kGeometry},
       true},
      {"essl300",
       "#version 300 es",
       "ESSL 3.00 for OpenGL ES 3.0 and WebGL 2",
       Format::kGlsl,
       Rules::kOpenGl,
       {kVertex, kFragment},
       true},
      {"essl310",
       "#version 310 es",
       "ESSL 3.10 for OpenGL ES 3.1",
       Format::kGlsl,
       Rules::kOpenGl,
       {kVertex, kFragment, kCompute},
       false},
      {"vulkan",
       "#version 450",
       "SPIR-V 1.0 for Vulkan 1.0",
       Format::kSpirv,
       Rules::kVulkan,
       {kVertex, kFragment, kGeometry, kCompute},
       false},
      {"opengl",
       "#version 450 core",
       "SPIR-V 1.0 for OpenGL 4.5",
       Format::kSpirv,
       Rules::kOpenGlSpirv,
       {kVertex, kFragment, kGeometry, kCompute},
       false},
      {"hlsl50",
       "#version 450",
       "HLSL for shader model 5.0",
       Format::kHlsl,
       Rules::kVulkan,
       {kVertex, kFragment, kCompute},
       false},
      {"msl21",
       "#version 450",
       "Metal shading language 2.1",
       Format::kMsl,
       Rules::kVulkan,
       {kVertex, kFragment, kCompute},
       false},
      {"header",
       "#version 450 core",
       "a C++ header that holds the outputs of other targets, see --embed",
       Format::kHeader,
       Rules::kOpenGl,
       {kVertex, kFragment, kGeometry, kCompute},
       false},
  };
  return table;
}

const Target* find_target(const std::string& name) {
  const auto row = std::ranges::find(targets(), name, &Target::name);
  return row == targets().end() ? nullptr : &*row;
}

}  // namespace gnomon::compiler
