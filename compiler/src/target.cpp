// SPDX-License-Identifier: MIT
#include <algorithm>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

const std::vector<Target>& targets() {
  using enum Stage;
  static const std::vector<Target> table = {
      {.name = "glsl450",
       .version_line = "#version 450 core",
       .description = "GLSL 4.50 for desktop OpenGL",
       .format = Format::kGlsl,
       .rules = Rules::kOpenGl,
       .stages = {kVertex, kFragment, kGeometry, kCompute},
       .binds_by_name = false,
       .has_precisions = false,
       .has_images = true},
      {.name = "glsl330",
       .version_line = "#version 330 core",
       .description = "GLSL 3.30 for desktop OpenGL",
       .format = Format::kGlsl,
       .rules = Rules::kOpenGl,
       .stages = {kVertex, kFragment, kGeometry},
       .binds_by_name = true,
       .has_precisions = false,
       .has_images = false},
      {.name = "essl300",
       .version_line = "#version 300 es",
       .description = "ESSL 3.00 for OpenGL ES 3.0 and WebGL 2",
       .format = Format::kGlsl,
       .rules = Rules::kOpenGl,
       .stages = {kVertex, kFragment},
       .binds_by_name = true,
       .has_precisions = true,
       .has_images = false},
      {.name = "essl310",
       .version_line = "#version 310 es",
       .description = "ESSL 3.10 for OpenGL ES 3.1",
       .format = Format::kGlsl,
       .rules = Rules::kOpenGl,
       .stages = {kVertex, kFragment, kCompute},
       .binds_by_name = false,
       .has_precisions = true,
       .has_images = true},
      {.name = "vulkan",
       .version_line = "#version 450",
       .description = "SPIR-V 1.0 for Vulkan 1.0",
       .format = Format::kSpirv,
       .rules = Rules::kVulkan,
       .stages = {kVertex, kFragment, kGeometry, kCompute},
       .binds_by_name = false,
       .has_precisions = true,
       .has_images = true},
      {.name = "opengl",
       .version_line = "#version 450 core",
       .description = "SPIR-V 1.0 for OpenGL 4.5",
       .format = Format::kSpirv,
       .rules = Rules::kOpenGlSpirv,
       .stages = {kVertex, kFragment, kGeometry, kCompute},
       .binds_by_name = false,
       .has_precisions = true,
       .has_images = true},
      {.name = "hlsl50",
       .version_line = "#version 450",
       .description = "HLSL for shader model 5.0",
       .format = Format::kHlsl,
       .rules = Rules::kVulkan,
       .stages = {kVertex, kFragment, kCompute},
       .binds_by_name = false,
       .has_precisions = true,
       .has_images = true},
      {.name = "msl21",
       .version_line = "#version 450",
       .description = "Metal shading language 2.1",
       .format = Format::kMsl,
       .rules = Rules::kVulkan,
       .stages = {kVertex, kFragment, kCompute},
       .binds_by_name = false,
       .has_precisions = true,
       .has_images = true},
      {.name = "header",
       .version_line = "#version 450 core",
       .description = "a C++ header that holds the outputs of other targets, see --embed",
       .format = Format::kHeader,
       .rules = Rules::kOpenGl,
       .stages = {kVertex, kFragment, kGeometry, kCompute},
       .binds_by_name = false,
       .has_precisions = false,
       .has_images = true},
  };
  return table;
}

const Target* find_target(const std::string& name) {
  const auto row = std::ranges::find(targets(), name, &Target::name);
  return row == targets().end() ? nullptr : &*row;
}

}  // namespace gnomon::compiler
