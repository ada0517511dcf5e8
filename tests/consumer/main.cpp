// SPDX-License-Identifier: MIT
// Uses generated headers and the compiler as a library: both have to make the same of a shader.
#include <gnomon/compiler/compiler.h>

#include <iostream>

#include "flat.frag.h"
#include "hill.frag.h"
#include "quad.vert.h"

// Usage: consumer SHADER_DIRECTORY LIBRARY_DIRECTORY
int main(int argc, char** argv) {
  if (argc != 3) return 2;
  namespace hill = gnomon_shaders::hill_frag;
  const std::string folder = argv[1];
  gnomon::compiler::Options options;
  options.library_directory = argv[2];
  options.include_directories = {folder};
  options.defines = {{"BLUE", BLUE}};
  options.target = "glsl330";
  const auto built = gnomon::compiler::build(folder + "/hill.frag", options);
  if (!built) {
    std::cerr << gnomon::to_string(built.diagnostics().front()) << "\n";
    return 1;
  }
  if (built->output != hill::glsl330::source) {
    std::cerr << "the library and gnomonc disagree\n";
    return 1;
  }
  std::cout << hill::stage << " " << hill::vulkan::spirv.size() << " words, "
            << gnomon_shaders::flat_frag::glsl330::source.size() << " and "
            << gnomon_shaders::quad_vert::glsl330::source.size() << " bytes\n";
}
